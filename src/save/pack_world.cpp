// SPDX-License-Identifier: MIT
// From a world to the bytes of a .firma file: faces in order of id; each exact face, edge, vertex and plane once,
// numbered in the order in which faces lead to them. How faces are kept and found is not in it.
#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "firma/save.h"
#include "save/anchor_bytes.h"
#include "save/face_packer.h"
#include "save/pack_cells.h"
#include "save/pack_matters.h"
#include "save/sections.h"
#include "world/world_data.h"

namespace firma {
namespace {

struct FaceOfRoom {
    FaceId id;
    FacetPlace place;
    std::uint32_t room;
};

class Packer {
public:
    Packer(const World& world, const SaveOptions& options)
        : data_(world.data()),
          tree_options_(options.index ? data_.tree_options : TreeOptions{}),
          exact_(options.exact),
          face_packer_(options.exact ? &exact_packer_ : nullptr) {}

    std::vector<std::byte> pack() {
        pack_data();
        if (data_.rules) pack_rules(*data_.rules);
        pack_faces();
        // Their faces are numbered behind those of the solid.
        const CellsVersion needed = add_cells(data_.cells, exact_ ? &exact_packer_ : nullptr, cells_);
        needs_version_3_ |= needed == CellsVersion::kThree;
        if (exact_) exact_packer_.pack();
        if (data_.anchors) put_anchors(anchors_, *data_.anchors);
        if (data_.textures) pack_textures(*data_.textures);
        needs_version_3_ |= bool(data_.matters);
        return write_container(sections(), needs_version_3_ ? 3 : 2);
    }

private:
    void pack_data() {
        const bool portals = data_.cells.portal_count() > 0;
        world_.u64(data_.version);
        world_.u64(data_.face_count());
        world_.u32(data_.next_face());
        world_.u32(data_.edits());
        // Without its faces there is no solid, and no end to what would be rock.
        const bool rock_outside = data_.rock_outside() && exact_;
        world_.u32((rock_outside ? kRockOutside : 0) | (exact_ ? kExactPart : 0) | (data_.rules ? kHasRules : 0) |
                   (data_.cells.known() ? kHasRoomRecords : 0) | (portals ? kHasPortals : 0));
        world_.u32(data_.cells.room_count());
        world_.f64(data_.tolerance.contact_offset);
        world_.u32(std::uint32_t(tree_options_.split));
        world_.i32(tree_options_.max_depth);
        world_.i32(tree_options_.faces_per_leaf);
        world_.u32(0);
        world_.f64(tree_options_.min_node_volume);
    }

    void pack_rules(const CarveRules& rules) {
        if (rules.merge_share > 0) {
            merge_.f64(rules.merge_share);
            needs_version_3_ = true;
        }
        if (!rules.open_faces) {
            open_faces_.u32(0);
            needs_version_3_ = true;
        }
        rules_.u32(std::uint32_t(rules.zones.size()));
        rules_.u32(std::uint32_t(rules.hardness.size()));
        for (const std::size_t most : {rules.max_faces, rules.max_candidate_faces, rules.max_new_faces,
                                       rules.max_cutter_triangles, rules.max_pairs, rules.max_corners})
            rules_.u64(most);
        rules_.f64(rules.max_cutter_size);
        for (const double hardness : rules.hardness) rules_.f64(hardness);
        for (const CarveZone& zone : rules.zones) {
            for (const Vec3& corner : {zone.box.low, zone.box.high})
                for (int axis = 0; axis < 3; ++axis) rules_.f64(corner[axis]);
            rules_.f64(zone.hardness);
            rules_.u64(zone.name.size());
        }
        for (const CarveZone& zone : rules.zones) put_text_bytes(rules_, zone.name);
    }

    /// In order of id, so that how faces are kept does not show.
    void pack_faces() {
        for_each_block_of(data_, [&](const Block& block) {
            for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot)
                all_.push_back({block.faces[slot].id, {&block, slot}, data_.cells.current_room(block.part)});
        });
        sort_range(all_, [](const FaceOfRoom& a, const FaceOfRoom& b) { return a.id < b.id; });
        for (const FaceOfRoom& face : all_) face_packer_.add(face.place, face.room);
    }

    void pack_textures(const FaceTextures& textures) {
        for (const TextureProjection& map : textures.projections()) {
            for (const auto& [axis, offset] : {std::pair(map.u_axis, map.u_offset), {map.v_axis, map.v_offset}}) {
                for (int k = 0; k < 3; ++k) texture_maps_.f64(axis[k]);
                texture_maps_.f64(offset);
            }
            texture_maps_.u32(std::uint32_t(map.unit));
            texture_maps_.u32(0);
        }
        for (const FaceTextures::Entry& face : textures.entries()) {
            textured_faces_.u32(face.source);
            textured_faces_.u32(face.projection);
            textured_faces_.u32(face.corner_count);
        }
        // Those of the entries one after the other, as they are made.
        for (const GridPoint& corner : textures.corners()) put_point(texture_outlines_, corner);
    }

    std::vector<NewSection> sections() {
        std::vector<NewSection> all;
        const auto add = [&](SectionType type, ByteWriter& content) {
            all.push_back({type, kRequiredSection, std::move(content)});
        };
        add(kWorldSection, world_);
        add_materials(data_, all);
        if (data_.rules) add(kRulesSection, rules_);
        if (data_.rules && data_.rules->merge_share > 0) add(kMergeSection, merge_);
        if (data_.rules && !data_.rules->open_faces) add(kOpenFacesSection, open_faces_);
        face_packer_.add_to(all);
        for (NewSection& section : cells_)
            if (needs_version_3_ || section.type != kPortalFacesSection) all.push_back(std::move(section));
        if (exact_) exact_packer_.add_to(all);
        if (data_.matters)
            for (NewSection& section : pack_matters(*data_.matters)) all.push_back(std::move(section));
        const auto add_optional = [&](SectionType type, ByteWriter& content) {
            all.push_back({type, 0, std::move(content)});
        };
        if (data_.anchors) add_optional(kAnchorsSection, anchors_);
        if (data_.textures) {
            add_optional(kTextureMapsSection, texture_maps_);
            add_optional(kTexturedFacesSection, textured_faces_);
            add_optional(kTextureOutlinesSection, texture_outlines_);
        }
        return all;
    }

    const WorldData& data_;
    const TreeOptions tree_options_;
    const bool exact_;
    std::vector<FaceOfRoom> all_;  ///< in order of id
    bool needs_version_3_ = false;
    ExactPacker exact_packer_;
    FacePacker face_packer_;
    std::vector<NewSection> cells_;
    ByteWriter world_, rules_, merge_, open_faces_, anchors_;
    ByteWriter texture_maps_, textured_faces_, texture_outlines_;
};

}  // namespace

std::vector<std::byte> pack_world(const World& world, const SaveOptions& options) {
    return Packer(world, options).pack();
}

}  // namespace firma
