// SPDX-License-Identifier: MIT
// Walks the trees of nodes, without recursion: a file may nest them as deeply as it likes.
#include "gltf/scene_nodes.h"

#include <algorithm>

#include "gltf/node_meaning.h"

namespace firma::gltf {
namespace {

class Walk {
public:
    Walk(const GltfFile& file, const std::vector<std::string>& parts, std::set<std::string>& notes)
        : file_(file), nodes_(file.model.nodes), parts_(parts), notes_(notes), seen_(nodes_.size()) {}

    Result<std::vector<SceneNode>> from(const SceneNode& above) {
        if (std::optional<Error> error = push_roots(above)) return *error;
        while (!waiting_.empty()) {
            SceneNode node = std::move(waiting_.back());
            waiting_.pop_back();
            const tinygltf::Node& entry = nodes_[node.index];
            const std::optional<Placement> own = placement_of(entry);
            if (!own)
                return fail("node " + std::to_string(node.index),
                            entry.matrix.empty() ? "has a rotation that is none" : "has a matrix that is not affine");
            node.placement = node.placement * *own;
            take_meaning(node);
            if (std::optional<Error> error = push(entry.children, node)) return *error;
            done_.push_back(std::move(node));
        }
        return std::move(done_);
    }

private:
    Error fail(const std::string& place, std::string reason) const {
        return {ErrorCode::kMalformed, file_.name + ": " + place, std::move(reason)};
    }

    std::optional<Error> push_roots(const SceneNode& above) {
        const tinygltf::Model& model = file_.model;
        if (!model.scenes.empty() || model.defaultScene >= 0) {
            const std::size_t scene = model.defaultScene < 0 ? 0 : std::size_t(model.defaultScene);
            if (scene >= model.scenes.size())
                return fail("scene " + std::to_string(scene),
                            "is not there; there are " + std::to_string(model.scenes.size()));
            return push(model.scenes[scene].nodes, above);
        }
        std::vector<bool> is_child(nodes_.size());
        for (const tinygltf::Node& node : nodes_)
            for (const int child : node.children)
                if (std::size_t(child) < nodes_.size()) is_child[std::size_t(child)] = true;
        std::vector<int> roots;
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            if (!is_child[k]) roots.push_back(int(k));
        return push(roots, above);
    }

    /// The first of them on top.
    std::optional<Error> push(const std::vector<int>& list, const SceneNode& above) {
        for (auto child = list.rbegin(); child != list.rend(); ++child) {
            const std::size_t index = std::size_t(*child);
            const std::string place = "node " + std::to_string(index);
            if (index >= nodes_.size()) return fail(place, "is not there; there are " + std::to_string(nodes_.size()));
            if (seen_[index]) return fail(place, "is in the scene twice; nodes must make trees");
            seen_[index] = true;
            waiting_.push_back(above);
            waiting_.back().index = std::uint32_t(index);
        }
        return std::nullopt;
    }

    void take_meaning(SceneNode& node) const {
        const std::string& name = nodes_[node.index].name;
        const NodeMeaning meaning = meaning_of(name, file_.rest.node_extras[node.index], notes_);
        node.portal = meaning.portal.value_or(node.portal);
        node.mask = meaning.mask.value_or(node.mask);
        const bool is_named = std::find(parts_.begin(), parts_.end(), name) != parts_.end();
        if (meaning.part.value_or(is_named)) node.part = node.index;
        if (meaning.part == false) node.part = kNoNode;
        if (!name.empty()) node.named = node.index;
    }

    const GltfFile& file_;
    const std::vector<tinygltf::Node>& nodes_;
    const std::vector<std::string>& parts_;
    std::set<std::string>& notes_;
    std::vector<bool> seen_;
    std::vector<SceneNode> waiting_, done_;
};

}  // namespace

Result<std::vector<SceneNode>> scene_nodes(const GltfFile& file, const Placement& root,
                                           const std::vector<std::string>& parts, std::set<std::string>& notes) {
    SceneNode above;
    above.placement = root;
    return Walk(file, parts, notes).from(above);
}

}  // namespace firma::gltf
