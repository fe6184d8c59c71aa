// SPDX-License-Identifier: MIT
// From a world and a hostile patch to another world, or to the reason why not.
#include "save/apply_patch.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/flat_map.h"
#include "base/sort.h"
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
#include "solid/check_boundary.h"
#include "solid/hash_face.h"
#include "world/check_exchange.h"

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
    PatchReader(const World& world, std::vector<Section> all, const std::string& name, const PatchChecks& checks)
        : world_(world),
          data_(world.data()),
          checks_(checks),
          damage_(name),
          sections_(std::move(all), damage_),
          solid_after_(data_.solid.data().faces),
          castable_after_(data_.castable),
          solid_edit_(solid_after_, data_.tree_options),
          castable_edit_(castable_after_, data_.tree_options) {}

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
        if (flags & ~(kPatchHasCells | kPatchNoAnchors))
            return damage_.report(head.type(), "has flags that mean nothing");
        has_cells_ = flags & kPatchHasCells;
        no_anchors_ = flags & kPatchNoAnchors;
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
        if (!no_anchors_)
            anchors_ = sections_.has(kAnchorsSection) ? unpack_anchors(sections_, damage_) : data_.anchors;
        return !damage_.error();
    }

    StoreEdit& edit_of(bool solid) { return solid ? solid_edit_ : castable_edit_; }

    /// Faces of both kinds exchanged.
    void exchange() {
        for (const FacetPlace& facet : removed_) edit_of(facet.record().solid).remove(facet);
        for (const bool solid : {true, false}) {
            FaceSet some;
            for (const FaceSet::Entry& face : added_.faces)
                if (face.solid == solid) append_face(added_, face, some);
            const auto of_kind = [&](const FacetPlace& facet) { return facet.record().solid == solid; };
            if (some.faces.empty() && std::none_of(removed_.begin(), removed_.end(), of_kind)) continue;
            edit_of(solid).add(std::move(some));
            while (edit_of(solid).step()) {
            }
            (solid ? solid_after_ : castable_after_) = edit_of(solid).result();
        }
        find_added();
    }

    /// The faces added, in the blocks made.
    void find_added() {
        const auto is_added = [&](FaceId id) {
            const auto found = std::lower_bound(added_.faces.begin(), added_.faces.end(), id,
                                                [](const FaceSet::Entry& face, FaceId of) { return face.id < of; });
            return found != added_.faces.end() && found->id == id;
        };
        for (const StoreEdit* edit : {&solid_edit_, &castable_edit_})
            for (const Ref<const Node>& leaf : edit->added()) {
                const Block& block = block_of(*leaf);
                for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot)
                    if (is_added(block.faces[slot].id)) made_facets_.push_back({&block, slot});
            }
    }

    Solid solid_after() {
        auto solid = std::make_shared<SolidData>(data_.solid.data());
        solid->faces = solid_after_;
        solid->rock_outside = unpacked_.world.rock_outside;
        solid->next_face = unpacked_.world.next_face;
        solid->edits = unpacked_.world.edits;
        PointHash points;
        add_points(removed_, -1, points);
        add_points(made_facets_, 1, points);
        const SumsByKey& sums = points.finish();
        sums.add_to(solid->points);
        solid->point_sum += sums.total();
        return Solid(std::move(solid));
    }

    static void add_points(std::span<const FacetPlace> facets, int sign, PointHash& points) {
        FlatMap owners;
        for (const FacetPlace& facet : facets) {
            if (!facet.record().solid) continue;
            if (const FaceOwner* owner = facet.block->owner_of(facet.record())) {
                std::uint32_t& known = owners.at(reinterpret_cast<std::uintptr_t>(owner));
                if (known != FlatMap::kNone) continue;
                known = 0;
            }
            add_face(*facet.block, facet.record(), sign, points);
        }
    }

    /// Of the rooms that have faces exchanged, and of new ones; others are shared.
    RoomFacesMap changed_rooms(const WorldData& after) const {
        struct Change {
            NodeEdit nodes;
            Ref<RoomFaces> faces{new RoomFaces};
        };
        std::map<std::uint32_t, Change> changes;
        const auto change_of = [&](std::uint32_t part) -> Change& {
            const std::uint32_t room = after.cells.current_room(part);
            const bool is_old = room < data_.cells.room_count();
            const auto [at, is_new] =
                changes.try_emplace(room, Change{NodeEdit(is_old ? data_.faces_of(room).tree : Ref<const Node>())});
            if (is_new && is_old) {
                at->second.faces->count = data_.faces_of(room).count;
                at->second.faces->hash = data_.faces_of(room).hash;
            }
            return at->second;
        };
        for (const StoreEdit* edit : {&solid_edit_, &castable_edit_}) {
            for (const PartChange& change : edit->parts()) {
                RoomFaces& faces = *change_of(change.part).faces;
                faces.count += std::size_t(change.faces);
                faces.hash += change.hash;
            }
            for (const Block* block : edit->removed()) change_of(block->part).nodes.remove(block, block->box());
            for (const Ref<const Node>& leaf : edit->added()) change_of(block_of(*leaf).part).nodes.add(leaf);
        }
        RoomFacesMap rooms = data_.room_faces;
        for (std::uint32_t room = data_.cells.room_count(); room < after.cells.room_count(); ++room)
            rooms.set(room, Ref<const RoomFaces>(new RoomFaces));
        for (auto& [room, change] : changes) {
            const Ref<const Node>&solid = solid_after_.root, &castable = castable_after_.root;
            if (after.cells.room_count() == 1 && !(solid && castable)) {
                change.faces->tree = solid ? solid : castable;
            } else {
                while (change.nodes.step()) {
                }
                change.faces->tree = change.nodes.result();
            }
            rooms.set(room, Ref<const RoomFaces>(change.faces.get()));
        }
        return rooms;
    }

    void build() {
        const StoredWorld& after = unpacked_.world;
        for (const FaceSet::Entry& face : added_.faces)
            if (face.part != cells_.current_room(face.part)) {
                damage_.report(kFacesSection, "has a face in a room that is part of another");
                return;
            }
        exchange();
        auto data = std::make_shared<WorldData>(data_);
        data->solid = solid_after();
        data->castable = castable_after_;
        data->cells = cells_;
        data->materials = after.materials;
        data->version = after.version;
        data->anchors = anchors_;
        if (!checks_.whole && rooms_stay(data_, *data)) {
            data->set_faces(changed_rooms(*data));
            made_ = World(data);
            // What a world lacks that was not sound before, only all of it tells.
            if (!part_is_sound()) check_whole(made_, true, damage_);
        } else {
            if (!find_all_rooms(*data)) return;
            made_ = World(data);
            check_whole(made_, true, damage_);
        }
        if (!damage_.error() && checks_.hash && hash_world(made_) != hash_after_)
            damage_.report(ErrorCode::kMalformed, "", "the world that it makes is not the one that it says");
    }

    /// Where faces that stay may be in other rooms.
    bool find_all_rooms(WorldData& data) {
        const BuiltStore solid = parts_of(data.solid.data().faces), castable = parts_of(data.castable);
        for (const BuiltStore* store : {&solid, &castable})
            for (const PartIndex& part : store->parts)
                if (part.part >= cells_.room_count())
                    return damage_.report(kPatchSection, "leaves faces in a room that is not there");
        data.set_faces(faces_of_rooms(data.cells, {&solid, &castable}));
        return true;
    }

    /// What was exchanged, and its border.
    bool part_is_sound() const {
        if (check_exchange(data_, made_.data(), !has_cells_, removed_, made_facets_)) return false;
        std::vector<FacetPlace> added, removed, near;
        for (const FacetPlace& facet : removed_)
            if (facet.record().solid) removed.push_back(facet);
        const Node* root = data_.solid.data().faces.root.get();
        for (const FacetPlace& facet : made_facets_) {
            if (!facet.record().solid) continue;
            added.push_back(facet);
            const FaceOwner* owner = facet.block->owner_of(facet.record());
            if (root) gather_facets(root, owner ? owner->box : facet.block->box_of(facet.record()), near);
        }
        sort_range(near, [](const FacetPlace& a, const FacetPlace& b) {
            return a.record().id != b.record().id ? a.record().id < b.record().id : a.slot < b.slot;
        });
        near.erase(std::unique(near.begin(), near.end()), near.end());
        return !check_exchange(std::move(added), removed, near);
    }

    const World& world_;
    const WorldData& data_;
    const PatchChecks checks_;
    Damage damage_;
    Sections sections_;
    FaceStore solid_after_, castable_after_;  ///< until exchange(): before
    StoreEdit solid_edit_, castable_edit_;
    bool has_cells_ = false, no_anchors_ = false;
    std::uint64_t hash_after_ = 0;
    UnpackedData unpacked_;
    Cells cells_;
    std::vector<FacetPlace> removed_;
    std::vector<const FaceOwner*> owners_;  ///< of those, each once
    FlatMap facets_left_;                   ///< of each, by address: how many are not removed
    ExactImports imports_;
    std::vector<Ref<SolidFace>> exact_;
    FaceSet added_;
    std::shared_ptr<const Anchors> anchors_;  ///< of the world that it makes
    std::vector<FacetPlace> made_facets_;     ///< the faces added, in blocks
    World made_;
};

}  // namespace

Result<World> apply_patch(const World& world, std::span<const std::byte> patch, std::string name,
                          const PatchChecks& checks) {
    Result<std::vector<Section>> read = read_container(patch, name);
    if (!read) return read.error();
    return PatchReader(world, std::move(read).value(), name, checks).apply();
}

Result<World> apply_patch(const World& world, std::span<const std::byte> patch, std::string name) {
    return apply_patch(world, patch, std::move(name), PatchChecks{});
}

}  // namespace firma
