// SPDX-License-Identifier: MIT
// Makes a level of the meshes that stand in a glTF file's scene, and a world of that, in rooms.
#include "firma/read_gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "firma/level.h"
#include "firma/rooms.h"
#include "gltf/accessor.h"
#include "gltf/gltf_file.h"
#include "gltf/node_meaning.h"
#include "gltf/placement.h"
#include "gltf/scene_nodes.h"
#include "gltf/triangle_list.h"
#include "level/fit_texture.h"
#include "level/level_builder.h"
#include "level/message.h"
#include "level/portal_polygons.h"
#include "level/read_file.h"
#include "level/shared_vertices.h"

namespace firma {
namespace {

using gltf::Placement;
using gltf::SceneNode;
using gltf::TriangleList;

constexpr std::string_view kCut = " (cut)";  // what write_glb() puts behind the name of a material that cuts left

/// Corners of a face are farther from its plane than this only when it is not flat: a step of the grid, which floats
/// far from zero are off by.
constexpr double kFlat = 1 / kInputSteps;

bool is_flat(std::span<const Vec3> outline) {
    Vec3 normal;  // Newell's: twice the area long
    for (std::size_t k = 0; k < outline.size(); ++k)
        normal = normal + cross(outline[k] - outline[0], outline[(k + 1) % outline.size()] - outline[0]);
    const double twice_area = length(normal);
    if (!(twice_area > 0) || !is_finite(twice_area)) return false;
    for (const Vec3& corner : outline)
        if (!(std::fabs(dot(corner - outline[0], normal)) <= kFlat * twice_area)) return false;
    return true;
}

class LevelMaker {
public:
    LevelMaker(const gltf::GltfFile& file, const GltfOptions& options)
        : file_(file), options_(options), accessors_(file), builder_(file.name), vertices_(builder_) {}

    Result<GltfLevel> make() {
        builder_.mend_what_is_dropped();
        const Placement root = gltf::placement_of_file(options_.up, options_.scale);
        const Result<std::vector<SceneNode>> nodes = gltf::scene_nodes(file_, root, options_.parts, notes_);
        if (!nodes) return nodes.error();
        for (const SceneNode& node : nodes.value()) {
            const tinygltf::Node& from = file_.model.nodes[node.index];
            made_.nodes.push_back(
                {node.index, from.name, node.placement.column[3], file_.rest.node_extras[node.index]});
            if (node.part != gltf::kNoNode) continue;
            if (std::optional<Error> error = add_node(node)) return *std::move(error);
        }
        for (const SceneNode& node : nodes.value()) {
            if (node.part != node.index) continue;
            if (std::optional<Error> error = add_part(node, nodes.value(), root)) return *std::move(error);
        }
        if (sources_ == 0) return Error{ErrorCode::kMalformed, file_.name, "has no triangle in its scene"};
        made_.level = builder_.finish(sources_, ignored_ + file_.rest.cameras + file_.rest.animations, omissions());
        made_.level.matters = std::move(matters_);
        find_note_places();
        note_what_is_left_out();
        return std::move(made_);
    }

private:
    Error fail(ErrorCode code, const std::string& place, std::string reason) const {
        return {code, place, std::move(reason)};
    }

    std::optional<Error> add_node(const SceneNode& node) {
        const tinygltf::Node& from = file_.model.nodes[node.index];
        if (from.mesh < 0) return std::nullopt;
        if (std::size_t(from.mesh) >= file_.model.meshes.size())
            return fail(ErrorCode::kMalformed, file_.name + ": node " + std::to_string(node.index),
                        "names mesh " + std::to_string(from.mesh) + " of " + std::to_string(file_.model.meshes.size()));
        const tinygltf::Mesh& mesh = file_.model.meshes[std::size_t(from.mesh)];
        node_ = &node;
        info_ = {};
        info_.group = builder_.group(from.name.empty() ? mesh.name : from.name);
        info_.mask = node.mask;
        // What stops less than a wall is no rock: castable only, from both sides.
        thin_ = (node.mask & kStopsSolid) != kStopsSolid;
        portal_.clear();
        for (std::size_t k = 0; k < mesh.primitives.size(); ++k) {
            place_ = file_.name + ": mesh " + std::to_string(from.mesh) + ", primitive " + std::to_string(k);
            if (std::optional<Error> error = add_primitive(mesh.primitives[k])) return error;
        }
        if (node.portal) add_portal(node);
        return std::nullopt;
    }

    /// A part's level, by a maker of its own; triangles of all count against one limit.
    std::optional<Error> add_part(const SceneNode& part, const std::vector<SceneNode>& nodes, const Placement& root) {
        const gltf::Frame frame = gltf::frame_of(part.placement, root);
        LevelMaker maker(file_, options_);
        maker.builder_.mend_what_is_dropped();
        maker.taken_ = taken_;
        for (const SceneNode& node : nodes) {
            if (node.part != part.index) continue;
            if (node.portal) notes_.insert("portals in parts are left out");
            SceneNode inside = node;
            inside.placement = frame.inside(node.placement);
            if (std::optional<Error> error = node.portal ? std::nullopt : maker.add_node(inside)) return error;
        }
        taken_ = maker.taken_;
        notes_.insert(maker.notes_.begin(), maker.notes_.end());
        if (maker.sources_ == 0) {
            notes_.insert("a part without triangles is left out");
            return std::nullopt;
        }
        Level level = maker.builder_.finish(maker.sources_, maker.ignored_, {});
        level.matters = std::move(maker.matters_);
        made_.parts.push_back({name_of(part), part.index, frame.position, frame.rotation(), std::move(level)});
        return std::nullopt;
    }

    std::string name_of(const SceneNode& node) const {
        return node.named == gltf::kNoNode ? std::string() : file_.model.nodes[node.named].name;
    }

    void add_portal(const SceneNode& node) {
        std::vector<std::vector<GridPoint>> polygons = portal_polygons(portal_);
        if (polygons.empty()) {
            notes_.insert("a portal without area is left out");
            ++empty_portals_;
            return;
        }
        made_.portals.push_back({name_of(node), node.index, std::move(polygons)});
    }

    std::optional<Error> add_primitive(const tinygltf::Primitive& primitive) {
        const Result<TriangleList> opened = TriangleList::open(primitive, accessors_, place_);
        if (!opened) return opened.error();
        const TriangleList& triangles = opened.value();
        if (!triangles.is_drawn()) {
            ++ignored_;
            return std::nullopt;
        }
        taken_ += triangles.size();
        if (taken_ > options_.max_triangles)
            return fail(ErrorCode::kTooLarge, place_,
                        "makes more than " + std::to_string(options_.max_triangles) + " triangles of all nodes");
        if (std::optional<Error> error = take_material(primitive.material)) return error;
        if (triangles.has_broken_uvs()) notes_.insert("texture coordinates that cannot be read are left out");
        return node_->portal ? add_to_portal(triangles) : add_faces(triangles);
    }

    std::optional<Error> take_material(int index) {
        info_.material = builder_.material("");
        info_.two_sided = thin_;
        if (index < 0) return std::nullopt;
        const auto& materials = file_.model.materials;
        if (std::size_t(index) >= materials.size())
            return fail(ErrorCode::kMalformed, place_,
                        "names material " + std::to_string(index) + " of " + std::to_string(materials.size()));
        const tinygltf::Material& material = materials[std::size_t(index)];
        std::string_view name = material.name;
        if (file_.rest.cut_materials[std::size_t(index)]) {
            if (name == kCut.substr(1)) name = "";
            if (name.ends_with(kCut)) name.remove_suffix(kCut.size());
        }
        info_.material = builder_.material(name);
        if (matters_.size() <= info_.material) matters_.resize(info_.material + 1);
        if (matters_[info_.material].empty()) matters_[info_.material] = file_.rest.matters[std::size_t(index)];
        info_.two_sided = thin_ || material.doubleSided;
        return std::nullopt;
    }

    std::optional<Error> add_to_portal(const TriangleList& triangles) {
        for (std::uint64_t k = 0; k < triangles.size(); ++k) {
            const Result<TriangleList::Triangle> vertices = triangles.at(k);
            if (!vertices) return vertices.error();
            if (std::optional<Error> error = take_outline(triangles, vertices.value())) return error;
            if (node_->placement.mirrors()) std::swap(points_[1], points_[2]);
            portal_.push_back({points_[0], points_[1], points_[2]});
        }
        return std::nullopt;
    }

    /// Faces that the file has in fans as the outlines they were; all other triangles alone.
    std::optional<Error> add_faces(const TriangleList& triangles) {
        for (std::uint64_t k = 0; k < triangles.size();) {
            const Result<std::vector<std::uint32_t>> fan = triangles.fan_from(k);
            if (!fan) return fan.error();
            const std::vector<std::uint32_t>& outline = fan.value();
            if (std::optional<Error> error = take_outline(triangles, outline)) return error;
            take_uvs(triangles, outline);
            const std::uint32_t count = std::uint32_t(outline.size() - 2);
            if (count == 1 || (is_flat(metres_) && has_one_map())) {
                add_face(points_, uvs_, sources_);
            } else {
                for (std::uint32_t c = 0; c < count; ++c) {
                    const std::array points{points_[0], points_[c + 1], points_[c + 2]};
                    if (uvs_.empty())
                        add_face(points, {}, sources_ + c);
                    else
                        add_face(points, std::array{uvs_[0], uvs_[c + 1], uvs_[c + 2]}, sources_ + c);
                }
            }
            sources_ += count;
            k += count;
            if (builder_.corner_count() > LevelBuilder::kMaxCount || sources_ > LevelBuilder::kMaxCount)
                return fail(ErrorCode::kTooLarge, place_, "makes more than 2^31 corners of faces");
        }
        return std::nullopt;
    }

    /// The outline's corners, in metres and snapped.
    std::optional<Error> take_outline(const TriangleList& triangles, std::span<const std::uint32_t> outline) {
        metres_.clear();
        points_.clear();
        for (const std::uint32_t vertex : outline) {
            const Vec3 metres = node_->placement.of(triangles.position(vertex));
            const std::optional<GridPoint> point = snap(metres);
            if (!point)
                return fail(ErrorCode::kOutOfRange, place_ + ", vertex " + std::to_string(vertex),
                            is_finite(metres) ? "lies outside the world, which spans 8192 m to each side, at node " +
                                                    std::to_string(node_->index)
                                              : "is not finite at node " + std::to_string(node_->index));
            metres_.push_back(metres);
            points_.push_back(*point);
        }
        return std::nullopt;
    }

    /// The outline's texture coordinates; none where one is no number.
    void take_uvs(const TriangleList& triangles, std::span<const std::uint32_t> outline) {
        uvs_.clear();
        if (!triangles.has_uvs()) return;
        for (const std::uint32_t vertex : outline) uvs_.push_back(triangles.uv(vertex));
        const auto finite = [](const TexturePoint& uv) { return is_finite(uv[0]) && is_finite(uv[1]); };
        if (!std::all_of(uvs_.begin(), uvs_.end(), finite)) uvs_.clear();
    }

    /// Whether the outline is one face to who looks at its picture.
    bool has_one_map() const {
        if (uvs_.empty()) return true;
        std::vector<Vec3> snapped;
        for (const GridPoint& point : points_) snapped.push_back(to_metres(point));
        return fit_texture(snapped, uvs_).has_value();
    }

    void add_face(std::span<const GridPoint> points, std::span<const TexturePoint> uvs, std::uint32_t source) {
        outline_.clear();
        for (const GridPoint& point : points) outline_.push_back(vertices_.at(point));
        outline_uvs_.assign(uvs.begin(), uvs.end());
        if (node_->placement.mirrors()) {
            std::reverse(outline_.begin(), outline_.end());
            std::reverse(outline_uvs_.begin(), outline_uvs_.end());
        }
        info_.source = source;
        builder_.add_face(outline_, info_, outline_uvs_);
        first_points_.emplace_back(source, points[0]);
    }

    void find_note_places() {
        auto face = first_points_.begin();
        for (const LevelNote& note : made_.level.notes) {
            while (face->first < note.source) ++face;
            made_.note_places.push_back(to_metres(face->second));
        }
    }

    std::vector<Omission> omissions() const {
        std::vector<Omission> omissions;
        const auto add = [&](const char* what, std::uint64_t count) {
            if (count > 0) omissions.push_back({what, count, ""});
        };
        add("primitives of points, lines or nothing", ignored_);
        add("portals without area", empty_portals_);
        add("skins", file_.rest.skins);
        add("primitives' morph targets", file_.rest.morphs);
        add("animations", file_.rest.animations);
        add("uses of EXT_mesh_gpu_instancing", file_.rest.gpu_instances);
        return omissions;
    }

    void note_what_is_left_out() {
        const auto note = [&](std::size_t count, const char* what) {
            if (count > 0) notes_.insert(std::to_string(count) + " " + what);
        };
        note(ignored_, "primitives of points, lines or nothing are left out");
        note(file_.rest.skins, "skins are left out: what they move stands as it was modelled");
        note(file_.rest.morphs, "primitives have morph targets, which are left out");
        note(file_.rest.animations, "animations are left out");
        if (file_.rest.gpu_instances) notes_.insert("instances by EXT_mesh_gpu_instancing are left out");
        made_.notes.assign(notes_.begin(), notes_.end());
    }

    const gltf::GltfFile& file_;
    std::vector<std::string> matters_;  ///< as Level::matters
    const GltfOptions options_;
    gltf::Accessors accessors_;
    LevelBuilder builder_;
    SharedVertices vertices_;
    GltfLevel made_;
    std::set<std::string> notes_;
    std::uint64_t taken_ = 0, ignored_ = 0, empty_portals_ = 0;
    std::uint32_t sources_ = 0;
    std::vector<std::pair<std::uint32_t, GridPoint>> first_points_;  ///< of each face, for notes

    // Of the node and primitive at hand.
    const SceneNode* node_ = nullptr;
    bool thin_ = false;
    std::string place_;
    LevelBuilder::FaceInfo info_;
    std::vector<std::array<GridPoint, 3>> portal_;
    std::vector<Vec3> metres_;
    std::vector<GridPoint> points_;
    std::vector<std::uint32_t> outline_;
    std::vector<TexturePoint> uvs_, outline_uvs_;  ///< of the points, of the outline; or none
};

}  // namespace

Result<GltfLevel> read_gltf(std::span<const std::byte> bytes, std::string name, const GltfOptions& options,
                            const std::string& folder) {
    if (!(options.scale > 0) || !is_finite(options.scale))
        return Error{ErrorCode::kInvalid, name, "the scale must be a finite number above zero"};
    if (options.up < 0 || options.up > 2) return Error{ErrorCode::kInvalid, name, "up must be an axis, 0 to 2"};
    const bool needs_slash = !folder.empty() && !folder.ends_with('/');
    const Result<gltf::GltfFile> file = gltf::open_gltf(bytes, name, needs_slash ? folder + "/" : folder);
    if (!file) return file.error();
    return LevelMaker(file.value(), options).make();
}

Result<GltfLevel> read_gltf(const std::string& path, const GltfOptions& options) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    const std::size_t slash = path.rfind('/');
    return read_gltf(std::as_bytes(std::span(bytes.value())), path, options,
                     slash == path.npos ? "./" : path.substr(0, slash + 1));
}

Result<World> make_world(const GltfLevel& gltf, const WorldOptions& options, GltfRooms* report) {
    std::vector<LevelPortal> portals;
    for (const GltfPortal& portal : gltf.portals) portals.push_back({portal.name, portal.polygons});
    return make_divided_world(gltf.level, portals, options, report);
}

}  // namespace firma
