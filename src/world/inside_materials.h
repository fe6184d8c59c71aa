// SPDX-License-Identifier: MIT
// Materials that an edit may give to new faces: names the world knows, and ones that are added once a face has them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "solid/face_set.h"
#include "solid/matter_pieces.h"

namespace firma {

class InsideMaterials {
public:
    using Names = std::shared_ptr<const std::vector<std::string>>;

    explicit InsideMaterials(Names known) : known_(std::move(known)) {}

    /// The index of a material's name, or one behind the known ones, by which take_up() knows it.
    std::uint32_t index(const std::string& name) {
        const auto at = std::find(known_->begin(), known_->end(), name);
        if (at != known_->end()) return std::uint32_t(at - known_->begin());
        const auto other = std::find(more_.begin(), more_.end(), name);
        const auto place = std::uint32_t(other - more_.begin());
        if (other == more_.end()) more_.push_back(name);
        return std::uint32_t(known_->size()) + place;
    }

    /// Of every matter of a table.
    std::vector<std::uint32_t> of_matters(const MatterTable& table) {
        std::vector<std::uint32_t> indices;
        for (const Matter& matter : table.matters) indices.push_back(index(matter.inside));
        return indices;
    }

    /// The number that a material has in the names, which it gets now if it had none.
    std::uint32_t number(std::uint32_t material) {
        const auto first = std::uint32_t(known_->size());
        if (material < first) return material;
        numbers_.resize(more_.size(), ~0u);
        std::uint32_t& taken = numbers_[material - first];
        if (taken == ~0u) {
            taken = first + std::uint32_t(used_.size());
            used_.push_back(material - first);
        }
        return taken;
    }

    /// Numbers those that faces have, in their order.
    void see(const FaceSet& faces) {
        for (const FaceSet::Entry& face : faces.faces) number(face.material);
    }

    /// Numbers those that faces have, and the one at `always`, in the order in which faces have them.
    /// @return the names, with all that were numbered at the end
    Names take_up(FaceSet& faces, std::uint32_t always) {
        for (FaceSet::Entry& face : faces.faces) face.material = number(face.material);
        if (always != ~0u) number(always);
        if (used_.empty()) return known_;
        auto longer = std::make_shared<std::vector<std::string>>(*known_);
        for (const std::uint32_t k : used_) longer->push_back(more_[k]);
        return longer;
    }

private:
    const Names known_;
    std::vector<std::string> more_;
    std::vector<std::uint32_t> numbers_;  ///< of each of `more_`; ~0u: none has it yet
    std::vector<std::uint32_t> used_;     ///< indices into `more_`, in the order of their numbers
};

}  // namespace firma
