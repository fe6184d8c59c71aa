// SPDX-License-Identifier: MIT
// Lists of faces, and patches from them: which faces go, which come, and what of the faces around these share.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/sort.h"
#include "carve/gather.h"
#include "firma/world_patch.h"
#include "save/anchor_bytes.h"
#include "save/entries.h"
#include "save/face_packer.h"
#include "save/pack_cells.h"
#include "save/patch_sections.h"
#include "solid/region.h"

namespace firma {
namespace {

struct ListedFace {
    FaceId id;
    std::uint64_t hash = 0;
};

/// What one world knows of another.
struct FaceList {
    std::uint64_t world = 0, cells = 0;
    std::vector<Region> regions;    ///< ascending
    std::vector<ListedFace> faces;  ///< by id
};

FaceList list_of(const World& world, std::span<const Region> regions) {
    FaceList list;
    list.world = hash_world(world);
    list.cells = hash_cells(world.data().cells);
    list.regions.assign(regions.begin(), regions.end());
    sort_range(list.regions);
    list.regions.erase(std::unique(list.regions.begin(), list.regions.end()), list.regions.end());
    for (const FacetPlace& facet : facets_in(world.data(), list.regions))
        list.faces.push_back({facet.record().id, hash_listed(world.data(), facet)});
    return list;
}

FaceList unpack_list(Sections& sections, Damage& damage) {
    FaceList list;
    const Entries head = sections.entries(kListSection, kListBytes);
    const Entries regions = sections.entries(kListRegionsSection, kPointBytes);
    const Entries faces = sections.entries(kListFacesSection, kListFaceBytes);
    if (damage.error()) return list;
    if (head.count() != 1) {
        damage.report(head.type(), "is not 16 bytes long");
        return list;
    }
    list.world = read_u64(head.at(0));
    list.cells = read_u64(head.at(0) + 8);
    for (std::size_t k = 0; k < regions.count(); ++k) {
        list.regions.push_back(region_at(regions.at(k)));
        if (k > 0 && !(list.regions[k - 1] < list.regions[k])) {
            damage.report(regions.type(), k, "is not above the one before");
            return list;
        }
    }
    for (std::size_t k = 0; k < faces.count(); ++k) {
        list.faces.push_back({{read_u32(faces.at(k))}, read_u64(faces.at(k) + 4)});
        if (k > 0 && !(list.faces[k - 1].id < list.faces[k].id)) {
            damage.report(faces.type(), k, "does not have a higher id than the last");
            return list;
        }
    }
    return list;
}

class PatchPacker {
public:
    /// @param same_anchors  whether pieces are held by the same in the other world
    PatchPacker(const World& world, FaceList list, bool same_anchors)
        : world_(world),
          data_(world.data()),
          list_(std::move(list)),
          has_cells_(hash_cells(data_.cells) != list_.cells),
          same_anchors_(same_anchors),
          faces_(&exact_) {}

    std::vector<std::byte> pack() {
        compare();
        complete_owners();
        import_neighbours();
        for (const FacetPlace& facet : added_) faces_.add(facet, data_.cells.current_room(facet.block->part));
        if (has_cells_) add_cells(data_.cells, &exact_, cells_);
        exact_.pack();
        return write_container(sections());
    }

private:
    static bool by_id(const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; }
    const Node* solid() const { return data_.solid.data().faces.root.get(); }

    /// Two lists in order of id.
    void compare() {
        auto theirs = list_.faces.begin();
        const auto removed_below = [&](FaceId id) {
            for (; theirs != list_.faces.end() && theirs->id < id; ++theirs) removed_.push_back(theirs->id);
        };
        for (const FacetPlace& own : facets_in(data_, list_.regions)) {
            const FaceId id = own.record().id;
            removed_below(id);
            const bool both = theirs != list_.faces.end() && theirs->id == id;
            if (both && theirs++->hash == hash_listed(data_, own)) continue;
            if (both) removed_.push_back(id);
            added_.push_back(own);
        }
        removed_below(FaceId());
    }

    /// All facets of an exact face are added, or none: those that lie in other regions, where the worlds are alike, are
    /// removed and added.
    void complete_owners() {
        std::vector<FacetPlace> of_owners;
        FlatMap known;
        for (const FacetPlace& facet : added_) {
            const FaceOwner* owner = facet.block->owner_of(facet.record());
            if (!owner) continue;
            std::uint32_t& mark = known.at(reinterpret_cast<std::uintptr_t>(owner));
            if (mark == FlatMap::kNone && owner->facets > 1) gather_face(solid(), facet, of_owners);
            mark = 0;
        }
        sort_range(of_owners, by_id);
        const std::vector<FacetPlace> before = added_;
        for (const FacetPlace& facet : of_owners) {
            if (std::binary_search(before.begin(), before.end(), facet, by_id)) continue;
            added_.push_back(facet);
            removed_.push_back(facet.record().id);
            list_.regions.push_back(place_of_region(region_of(lowest_corner(*facet.block, facet.record()))));
        }
        sort_range(added_, by_id);
        sort_range(removed_);
        removed_.erase(std::unique(removed_.begin(), removed_.end()), removed_.end());
        sort_range(list_.regions);
        list_.regions.erase(std::unique(list_.regions.begin(), list_.regions.end()), list_.regions.end());
    }

    /// Calls `function(address)` for each edge and vertex of a face.
    template <class Function>
    static void for_each_object(const SolidFace& face, const Function& function) {
        for (const SolidUse& use : face.uses) {
            function(reinterpret_cast<std::uintptr_t>(use.address()));
            function(reinterpret_cast<std::uintptr_t>(&use.from()));
        }
    }

    template <class Function>
    void for_each_portal_face(const Function& function) const {
        data_.cells.portals().for_each([&](std::uint32_t, const PortalState& state) {
            for (std::size_t k = 0; k < state.portal->all_polygons().size(); ++k)
                if (const SolidFace* face = state.portal->exact(k)) function(*face);
        });
    }

    /// Exact faces that stay, and share edges or vertices with those added, or with portals'. Where portals share some
    /// with faces added, they go along, though they be the same: those that the reader has share with what it removes.
    void import_neighbours() {
        FlatMap wanted;  // addresses of edges and vertices of faces added
        FlatMap added;   // addresses of these
        std::vector<FacetPlace> near;
        const auto want = [&](const SolidFace& face) {
            for_each_object(face, [&](std::uintptr_t address) { wanted.at(address) = 0; });
            gather_facets(solid(), face.box, near);
        };
        for (const FacetPlace& facet : added_) {
            const auto* owner = static_cast<const SolidFace*>(facet.block->owner_of(facet.record()));
            if (!owner) continue;
            std::uint32_t& mark = added.at(reinterpret_cast<std::uintptr_t>(owner));
            if (mark != FlatMap::kNone) continue;
            mark = 0;
            want(*owner);
        }
        for_each_portal_face([&](const SolidFace& face) {
            for_each_object(face, [&](std::uintptr_t address) { has_cells_ |= wanted.find(address) == 0; });
        });
        if (has_cells_) for_each_portal_face(want);
        sort_range(near, [](const FacetPlace& a, const FacetPlace& b) {
            return a.record().id != b.record().id ? a.record().id < b.record().id : a.slot < b.slot;
        });
        near.erase(std::unique(near.begin(), near.end()), near.end());
        for (const FacetPlace& facet : near) {
            const auto* owner = static_cast<const SolidFace*>(facet.block->owner_of(facet.record()));
            if (!owner) continue;
            std::uint32_t& mark = added.at(reinterpret_cast<std::uintptr_t>(owner));
            if (mark != FlatMap::kNone) continue;
            mark = 0;
            bool shares = false;
            for_each_object(*owner, [&](std::uintptr_t address) {
                if (wanted.find(address) != 0) return;
                shares = true;
                wanted.at(address) = 1;  // one face that brings it is enough
            });
            if (!shares) continue;
            exact_.import(*owner);
            imports_.push_back({facet.record().id, facet.block->corner(facet.record(), 0), owner->hash});
        }
    }

    std::vector<NewSection> sections() {
        std::vector<NewSection> all;
        const auto add = [&](SectionType type, ByteWriter& content) {
            all.push_back({type, kRequiredSection, std::move(content)});
        };
        ByteWriter head, regions, removed, imports, counters;
        head.u32(kPatchVersion);
        head.u32((has_cells_ ? kPatchHasCells : 0) | (!data_.anchors && !same_anchors_ ? kPatchNoAnchors : 0));
        head.u64(list_.world);
        head.u64(hash_world(world_));
        put_regions(regions, list_.regions);
        for (const FaceId id : removed_) removed.u32(id.value);
        for (const PatchImport& import : imports_) {
            imports.u32(import.id.value);
            put_point(imports, import.corner);
            imports.u64(import.hash);
        }
        put_counters(counters);
        add(kPatchSection, head);
        add(kPatchRegionsSection, regions);
        add(kPatchRemovedSection, removed);
        add(kPatchImportsSection, imports);
        add(kWorldSection, counters);
        add_materials(data_, all);
        if (data_.anchors && !same_anchors_) {
            ByteWriter anchors;
            put_anchors(anchors, *data_.anchors);
            add(kAnchorsSection, anchors);
        }
        for (NewSection& section : cells_) all.push_back(std::move(section));
        faces_.add_to(all);
        exact_.add_to(all);
        return all;
    }

    void put_counters(ByteWriter& out) const {
        const bool records = has_cells_ && data_.cells.known(), portals = has_cells_ && data_.cells.portal_count() > 0;
        out.u64(data_.version);
        out.u64(added_.size());
        out.u32(data_.next_face());
        out.u32(data_.edits());
        out.u32((data_.rock_outside() ? kRockOutside : 0) | kExactPart | (records ? kHasRoomRecords : 0) |
                (portals ? kHasPortals : 0));
        out.u32(records ? data_.cells.room_count() : 1);
        out.f64(data_.tolerance.contact_offset);
        for (int k = 0; k < 6; ++k) out.u32(0);  // options of trees are the reader's own
    }

    const World& world_;
    const WorldData& data_;
    FaceList list_;
    bool has_cells_;
    const bool same_anchors_;
    std::vector<NewSection> cells_;
    std::vector<FaceId> removed_;
    std::vector<FacetPlace> added_;  ///< by id
    std::vector<PatchImport> imports_;
    ExactPacker exact_;
    FacePacker faces_;
};

}  // namespace

std::vector<Region> differing_regions(std::span<const RegionHash> a, std::span<const RegionHash> b) {
    std::vector<RegionHash> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    sort_range(all, [](const RegionHash& x, const RegionHash& y) { return x.region < y.region; });
    std::vector<Region> regions;
    for (std::size_t k = 0; k < all.size();) {
        const bool pair = k + 1 < all.size() && all[k].region == all[k + 1].region;
        if (!pair || !(all[k] == all[k + 1])) regions.push_back(all[k].region);
        k += pair ? 2 : 1;
    }
    return regions;
}

std::vector<std::byte> list_faces(const World& world, std::span<const Region> regions) {
    const FaceList list = list_of(world, regions);
    ByteWriter head, places, faces;
    head.u64(list.world);
    head.u64(list.cells);
    put_regions(places, list.regions);
    for (const ListedFace& face : list.faces) {
        faces.u32(face.id.value);
        faces.u64(face.hash);
    }
    std::vector<NewSection> sections;
    sections.push_back({kListSection, kRequiredSection, std::move(head)});
    sections.push_back({kListRegionsSection, kRequiredSection, std::move(places)});
    sections.push_back({kListFacesSection, kRequiredSection, std::move(faces)});
    return write_container(sections);
}

Result<std::vector<std::byte>> make_patch(const World& world, std::span<const std::byte> bytes, std::string name) {
    Result<std::vector<Section>> read = read_container(bytes, name);
    if (!read) return read.error();
    Damage damage(name);
    Sections sections(std::move(read).value(), damage);
    sections.refuse_unknown(kSectionsOfLists);
    FaceList list;
    if (!damage.error()) list = unpack_list(sections, damage);
    if (damage.error()) return *damage.error();
    return PatchPacker(world, std::move(list), false).pack();
}

std::vector<std::byte> make_patch(const World& from, const World& to) {
    const auto &held = from.data().anchors, &held_after = to.data().anchors;
    const bool same_anchors = held == held_after || (held && held_after && *held == *held_after);
    return PatchPacker(to, list_of(from, differing_regions(hash_regions(from), hash_regions(to))), same_anchors).pack();
}

}  // namespace firma
