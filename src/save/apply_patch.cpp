// SPDX-License-Identifier: MIT
// From a world and a hostile patch to another world, or to the reason why not.
#include <algorithm>
#include <utility>

#include "base/flat_map.h"
#include "carve/gather.h"
#include "firma/world_patch.h"
#include "save/anchor_bytes.h"
#include "save/check_whole.h"
#include "save/entries.h"
#include "save/patch_sections.h"
#include "save/unpack_data.h"
#include "save/unpack_exact.h"
#include "save/unpack_faces.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

std::vector<SectionType> sections_of_patch() {
    std::vector<SectionType> known(std::begin(kSectionsOfPatches), std::end(kSectionsOfPatches));
    known.insert(known.end(), std::begin(kSectionsOfBoth), std::end(kSectionsOfBoth));
    known.push_back(kPortalFacesSection);
    known.insert(known.end(), std::begin(kSectionsOfAnchors), std::end(kSectionsOfAnchors));
    return known;
}

class PatchReader {
public:
    PatchReader(const World& world, std::vector<Section> all, const std::string& name)
        : world_(world), data_(world.data()), damage_(name), sections_(std::move(all), damage_) {}

    Result<World> apply() {
        const std::vector<SectionType> known = sections_of_patch();
        sections_.refuse_unknown(known);
        if (!damage_.error() && read_head() && read_counters() && read_removed() && read_imports() && read_exact() &&
            read_cells() && read_faces() && read_anchors()) {
            sections_.refuse_unused(known);
            if (!damage_.error()) build();
        }
        if (damage_.error()) return *damage_.error();
        return made_;
    }

private:
    bool read_head() {
        const Entries head = sections_.entries(kPatchSection, kPatchBytes);
        if (damage_.error()) return false;
        if (head.count() != 1) return damage_.report(head.type(), "is not 24 bytes long");
        const std::byte* at = head.at(0);
        const std::uint32_t version = read_u32(at), flags = read_u32(at + 4);
        if (version != kPatchVersion)
            return damage_.report(
                ErrorCode::kUnsupported, "",
                "it is a patch of version " + std::to_string(version) + "; this Firma reads version 1");
        if (flags & ~kPatchHasCells) return damage_.report(head.type(), "has flags that mean nothing");
        has_cells_ = flags & kPatchHasCells;
        if (read_u64(at + 8) != hash_world(world_))
            return damage_.report(ErrorCode::kInvalid, "", "the patch was made for another world");
        hash_after_ = read_u64(at + 16);
        return true;
    }

    bool read_counters() {
        unpacked_ = unpack_data(sections_, damage_);
        if (damage_.error()) return false;
        StoredWorld& after = unpacked_.world;
        if (!unpacked_.exact) return damage_.report(kWorldSection, "has no exact part");
        if (after.rules) return damage_.report(kWorldSection, "has rules");
        if (after.tolerance.contact_offset != data_.tolerance.contact_offset)
            return damage_.report(kWorldSection, "has another contact offset");
        return true;
    }

    bool read_cells() {
        if (has_cells_) {
            unpack_portals(sections_, unpacked_, &exact_, damage_);
            if (damage_.error()) return false;
            cells_ = cells_of(unpacked_.world);
        } else {
            cells_ = data_.cells;
            if (unpacked_.rooms != 1 || unpacked_.has_records || unpacked_.has_portals)
                return damage_.report(kWorldSection, "has rooms, and says that it has none");
            unpacked_.rooms = data_.cells.room_count();
        }
        return true;
    }

    bool read_removed() {
        const Entries places = sections_.entries(kPatchRegionsSection, kPointBytes);
        const Entries removed = sections_.entries(kPatchRemovedSection, 4);
        if (damage_.error()) return false;
        std::vector<Region> regions;
        for (std::size_t k = 0; k < places.count(); ++k) {
            regions.push_back(region_at(places.at(k)));
            if (k > 0 && !(regions[k - 1] < regions[k]))
                return damage_.report(places.type(), k, "is not above the one before");
        }
        const std::vector<FacetPlace> there = facets_in(data_, regions);
        auto next = there.begin();
        for (std::size_t k = 0; k < removed.count(); ++k) {
            const FaceId id{read_u32(removed.at(k))};
            while (next != there.end() && next->record().id < id) ++next;
            if (next == there.end() || next->record().id != id)
                return damage_.report(removed.type(), k, "is no face of the regions, or out of order");
            const FaceOwner* owner = next->block->owner_of(next->record());
            if (owner) {
                std::uint32_t& left = facets_left_.at(reinterpret_cast<std::uintptr_t>(owner));
                if (left == FlatMap::kNone) {
                    left = owner->facets;
                    owners_.push_back(owner);
                }
                --left;
            }
            removed_.push_back(*next++);
        }
        for (const FaceOwner* owner : owners_)
            if (facets_left_.find(reinterpret_cast<std::uintptr_t>(owner)) != 0)
                return damage_.report(removed.type(), "takes a part of an exact face away");
        return true;
    }

    /// What is shared with faces that stay.
    bool read_imports() {
        const Entries section = sections_.entries(kPatchImportsSection, kImportBytes);
        if (damage_.error()) return false;
        std::vector<FacetPlace> near;
        for (std::size_t k = 0; k < section.count(); ++k) {
            const std::byte* at = section.at(k);
            const FaceId id{read_u32(at)};
            GridBox place;
            place.add(GridPoint{read_i32(at + 4), read_i32(at + 8), read_i32(at + 12)});
            near.clear();
            if (const Node* root = data_.solid.data().faces.root.get()) gather_facets(root, place, near);
            const auto found = std::find_if(near.begin(), near.end(),
                                            [&](const FacetPlace& facet) { return facet.record().id == id; });
            if (found == near.end()) return damage_.report(section.type(), k, "is a face that is not there");
            const auto* owner = static_cast<const SolidFace*>(found->block->owner_of(found->record()));
            if (!owner || owner->hash != read_u64(at + 16))
                return damage_.report(section.type(), k, "has not the exact form that it is said to have");
            if (facets_left_.find(reinterpret_cast<std::uintptr_t>(owner)) != FlatMap::kNone)
                return damage_.report(section.type(), k, "is a face that is removed");
            imports_.add(*owner);
        }
        return true;
    }

    bool read_exact() {
        exact_ = unpack_exact(sections_, damage_, std::move(imports_));
        return !damage_.error();
    }

    bool read_faces() {
        added_ = unpack_faces(sections_, unpacked_, exact_, damage_);
        return !damage_.error();
    }

    bool read_anchors() {
        anchors_ = unpack_anchors(sections_, damage_);
        return !damage_.error();
    }

    /// Faces of one kind exchanged.
    FaceStore exchanged(const FaceStore& before, bool solid) const {
        StoreEdit edit(before, data_.tree_options);
        bool any = false;
        for (const FacetPlace& facet : removed_) {
            if (facet.record().solid != solid) continue;
            edit.remove(facet);
            any = true;
        }
        FaceSet some;
        for (const FaceSet::Entry& face : added_.faces)
            if (face.solid == solid) append_face(added_, face, some);
        any |= !some.faces.empty();
        if (!any) return before;
        edit.add(std::move(some));
        while (edit.step()) {
        }
        return edit.result();
    }

    void build() {
        const StoredWorld& after = unpacked_.world;
        for (const FaceSet::Entry& face : added_.faces)
            if (face.part != cells_.current_room(face.part)) {
                damage_.report(kFacesSection, "has a face in a room that is part of another");
                return;
            }
        auto data = std::make_shared<WorldData>(data_);
        data->solid = solid_of(exchanged(data_.solid.data().faces, true), after.rock_outside, after.next_face,
                               after.edits, data_.tree_options);
        data->castable = exchanged(data_.castable, false);
        data->cells = cells_;
        data->materials = after.materials;
        data->version = after.version;
        if (anchors_) data->anchors = anchors_;
        const BuiltStore solid = parts_of(data->solid.data().faces), castable = parts_of(data->castable);
        for (const BuiltStore* store : {&solid, &castable})
            for (const PartIndex& part : store->parts)
                if (part.part >= cells_.room_count()) {
                    damage_.report(kPatchSection, "leaves faces in a room that is not there");
                    return;
                }
        data->set_faces(faces_of_rooms(data->cells, {&solid, &castable}));
        made_ = World(std::move(data));
        check_whole(made_, true, damage_);
        if (!damage_.error() && hash_world(made_) != hash_after_)
            damage_.report(ErrorCode::kMalformed, "", "the world that it makes is not the one that it says");
    }

    const World& world_;
    const WorldData& data_;
    Damage damage_;
    Sections sections_;
    bool has_cells_ = false;
    std::uint64_t hash_after_ = 0;
    UnpackedData unpacked_;
    Cells cells_;
    std::vector<FacetPlace> removed_;
    std::vector<const FaceOwner*> owners_;  ///< of those, each once
    FlatMap facets_left_;                   ///< of each, by address: how many are not removed
    ExactImports imports_;
    std::vector<Ref<SolidFace>> exact_;
    FaceSet added_;
    std::shared_ptr<const Anchors> anchors_;  ///< null: as they were
    World made_;
};

}  // namespace

Result<World> apply_patch(const World& world, std::span<const std::byte> patch, std::string name) {
    Result<std::vector<Section>> read = read_container(patch, name);
    if (!read) return read.error();
    return PatchReader(world, std::move(read).value(), name).apply();
}

}  // namespace firma
