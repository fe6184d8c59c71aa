// SPDX-License-Identifier: MIT
// From a world to the bytes of a .firma file: faces in order of id; each exact face, edge, vertex and plane once,
// numbered in the order in which faces lead to them; then the index, which may be missing.
#include <algorithm>
#include <utility>

#include "base/flat_map.h"
#include "base/point_numbers.h"
#include "base/sort.h"
#include "firma/save.h"
#include "save/sections.h"
#include "solid/solid_face.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Numbers for objects, from 0, by address: in the order they are asked for, so that no address shows.
template <class Object>
class Numbers {
public:
    std::uint32_t operator()(const Object* object) {
        std::uint32_t& known = number_of_.at(reinterpret_cast<std::uintptr_t>(object));
        if (known == FlatMap::kNone) {
            known = std::uint32_t(objects_.size());
            objects_.push_back(object);
        }
        return known;
    }
    const std::vector<const Object*>& objects() const { return objects_; }

private:
    FlatMap number_of_;
    std::vector<const Object*> objects_;
};

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
          index_(options.index && options.exact) {}

    std::vector<std::byte> pack() {
        pack_data();
        pack_materials();
        if (data_.rules) pack_rules(*data_.rules);
        pack_faces();
        if (data_.cells.known()) pack_records();
        if (data_.cells.portal_count() > 0) pack_portals();
        if (exact_) pack_exact();
        if (data_.anchors) pack_anchors(*data_.anchors);
        if (data_.textures) pack_textures(*data_.textures);
        if (index_) pack_index();
        return write_container(sections());
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

    void pack_materials() {
        static const std::vector<std::string> kNone;
        const std::vector<std::string>& names = data_.materials ? *data_.materials : kNone;
        materials_.u32(std::uint32_t(names.size()));
        for (const std::string& name : names) materials_.u32(std::uint32_t(name.size()));
        for (const std::string& name : names) add_text(materials_, name);
    }

    void pack_rules(const CarveRules& rules) {
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
        for (const CarveZone& zone : rules.zones) add_text(rules_, zone.name);
    }

    static void add_text(ByteWriter& out, const std::string& text) {
        for (const char c : text) out.u8(static_cast<unsigned char>(c));
    }

    /// In order of id, so that how faces are kept does not show.
    void pack_faces() {
        for_each_block_of(data_, [&](const Block& block) {
            for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot)
                all_.push_back({block.faces[slot].id, {&block, slot}, data_.cells.current_room(block.part)});
        });
        sort_range(all_, [](const FaceOfRoom& a, const FaceOfRoom& b) { return a.id < b.id; });
        for (const FaceOfRoom& face : all_) pack_face(face);
    }

    void pack_face(const FaceOfRoom& placed) {
        const FaceRecord& face = placed.place.record();
        const auto* owner = static_cast<const SolidFace*>(placed.place.block->owner_of(face));
        for (const std::uint32_t number :
             {face.id.value, face.source, face.edit, face.material, face.mask, placed.room})
            faces_.u32(number);
        faces_.u32(exact_ && owner ? exact_faces_(owner) : kOwnFace);
        faces_.u8(face.corner_count);
        faces_.u8(std::uint8_t((face.two_sided ? kTwoSidedFace : 0) | (face.solid && exact_ ? kSolidFace : 0)));
        faces_.u16(0);
        for (std::uint32_t k = 0; k < face.corner_count; ++k) corners_.u32(vertex(placed.place.block->corner(face, k)));
    }

    /// Numbered in order of first use.
    std::uint32_t vertex(const GridPoint& point) {
        const std::size_t before = points_.count();
        const std::uint32_t number = points_.number(point);
        if (points_.count() > before) add_point(vertices_, point);
        return number;
    }

    void pack_records() {
        const Cells& cells = data_.cells;
        for (std::uint32_t room = 0; room < cells.room_count(); ++room) {
            const RoomRecord& record = cells.room(room);
            records_.u32(std::uint32_t(record.name.size()));
            records_.u32(record.exterior ? kExteriorRoom : 0);
            records_.u32(record.merged_into);
        }
        for (std::uint32_t room = 0; room < cells.room_count(); ++room) add_text(records_, cells.room(room).name);
    }

    void pack_portals() {
        const Cells& cells = data_.cells;
        portals_.u32(cells.portal_count());
        for (std::uint32_t k = 0; k < cells.portal_count(); ++k) {
            const Portal& portal = cells.portal(k);
            for (const RoomId room : cells.rooms_of(portal)) portals_.u32(room.value);
            portals_.u32(portal.material);
            portals_.u32(portal.mask);
            portals_.u32(cells.is_closed(k) ? kClosedPortal : 0);
            portals_.u32(std::uint32_t(portal.polygons().size()));
            portals_.u32(std::uint32_t(portal.name.size()));
            portals_.u32(0);
            for (const PortalPolygon& polygon : portal.polygons()) {
                portal_polygons_.u32(std::uint32_t(polygon.corners.size()));
                for (const GridPoint& corner : polygon.corners) add_point(portal_corners_, corner);
            }
        }
        for (std::uint32_t k = 0; k < cells.portal_count(); ++k) add_text(portals_, cells.portal(k).name);
    }

    /// Blocks and nodes, each once, children before what holds them.
    void pack_index() {
        const SolidData& solid = data_.solid.data();
        for (const Ref<const Node>* root : {&solid.faces.root, &data_.castable.root}) pack_root(root->get());
        data_.room_faces.for_each(
            [&](std::uint32_t, const Ref<const RoomFaces>& room) { pack_root(room->tree.get()); });
    }

    void pack_root(const Node* root) { roots_.u32(root ? pack_node(*root) : kNoEntry); }

    std::uint32_t pack_node(const Node& node) {
        const std::uint32_t known = number_of_node_.find(reinterpret_cast<std::uintptr_t>(&node));
        if (known != FlatMap::kNone) return known;
        std::vector<std::uint32_t> children;
        for (const Ref<const Node>& child : node.children) children.push_back(pack_node(*child));
        nodes_.u16(std::uint16_t(node.bins.size()));
        nodes_.u16(std::uint16_t(children.size()));
        nodes_.u32(node.is_leaf() ? pack_block(block_of(node)) : kNoEntry);
        for (const Bin& bin : node.bins) {
            for (const float coordinate : bin.box.low) bins_.f32(coordinate);
            for (const float coordinate : bin.box.high) bins_.f32(coordinate);
            bins_.u32(bin.first);
            bins_.u32(bin.count);
        }
        for (const std::uint32_t child : children) children_.u32(child);
        number_of_node_.at(reinterpret_cast<std::uintptr_t>(&node)) = node_count_;
        return node_count_++;
    }

    std::uint32_t pack_block(const Block& block) {
        std::uint32_t& known = number_of_block_.at(reinterpret_cast<std::uintptr_t>(&block));
        if (known != FlatMap::kNone) return known;
        known = block_count_++;
        blocks_.u32(std::uint32_t(block.faces.size()));
        for (const FaceRecord& face : block.faces) {
            const auto at = std::lower_bound(all_.begin(), all_.end(), face.id,
                                             [](const FaceOfRoom& other, FaceId id) { return other.id < id; });
            block_faces_.u32(std::uint32_t(at - all_.begin()));
        }
        return known;
    }

    template <class Point>
    static void add_point(ByteWriter& out, const Point& point) {
        for (int axis = 0; axis < 3; ++axis) out.i32(point[axis]);
    }

    void pack_exact() {
        for (const SolidFace* face : exact_faces_.objects()) pack_exact_face(*face);
        // Vertices are numbered through, those of the grid first; which are how many is known only now.
        Numbers<SolidVertex> on_grid, met;
        for (const SolidEdge* edge : edges_.objects())
            for (const Ref<const SolidVertex>& vertex : edge->vertex)
                (vertex->point.on_grid() ? on_grid : met)(vertex.get());
        const auto first_met = std::uint32_t(on_grid.objects().size());
        for (const SolidEdge* edge : edges_.objects()) {
            for (const Ref<const SolidVertex>& vertex : edge->vertex)
                edge_data_.u32(vertex->point.on_grid() ? on_grid(vertex.get()) : first_met + met(vertex.get()));
            for (const Ref<const SolidPlane>& plane : edge->plane) edge_data_.u32(planes_(plane.get()));
            edge_data_.u32(edge->doubled ? kDoubledEdge : 0);
        }
        for (const SolidVertex* vertex : on_grid.objects()) add_point(grid_points_, vertex->point.grid());
        for (const SolidVertex* vertex : met.objects())
            for (int k = 0; k < 3; ++k) meet_points_.u32(planes_(vertex->plane(k)));
        for (const SolidPlane* plane : planes_.objects()) pack_plane(plane->plane);
    }

    void pack_exact_face(const SolidFace& face) {
        exact_data_.u32(planes_(face.plane.get()));
        exact_data_.u32(std::uint32_t(face.uses.size()));
        exact_data_.u32(std::uint32_t(face.loop_ends().size()));
        for (int axis = 0; axis < 3; ++axis) exact_data_.f64(face.normal[axis]);
        for (const SolidUse& use : face.uses) uses_.u32(edges_(&use.edge()) << 1 | std::uint32_t(use.reversed()));
        for (const std::uint32_t end : face.loop_ends()) loops_.u32(end);
    }

    void pack_anchors(const Anchors& anchors) {
        const auto add = [&](std::uint32_t kind, std::uint32_t edit, std::uint32_t value) {
            for (const std::uint32_t number : {kind, edit, value}) anchors_.u32(number);
        };
        for (const std::uint32_t material : anchors.materials) add(kMaterialHolds, 0, material);
        for (const std::uint32_t source : anchors.sources) add(kSourceHolds, 0, source);
        for (const std::uint32_t edit : anchors.edits) add(kEditHolds, 0, edit);
        for (const std::uint64_t key : anchors.hanging)
            add(kHangingHolds, std::uint32_t(key >> 32), std::uint32_t(key));
        std::uint32_t number = 0;  // of a coordinate
        for (const GridBox& volume : anchors.volumes)
            for (const GridPoint& corner : {volume.low, volume.high})
                for (int axis = 0; axis < 3; ++axis) add(kVolumeHolds, number++, std::uint32_t(corner[axis]));
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
        for (const GridPoint& corner : textures.corners()) add_point(texture_outlines_, corner);
    }

    void pack_plane(const Plane& plane) {
        for (const std::int64_t n : plane.normal) plane_data_.u64(std::uint64_t(n));
        plane_data_.u64(std::uint64_t(plane.offset()));
        plane_data_.u64(std::uint64_t(plane.offset() >> 64));
    }

    std::vector<NewSection> sections() {
        std::vector<NewSection> all;
        const auto add = [&](SectionType type, ByteWriter& content) {
            all.push_back({type, kRequiredSection, std::move(content)});
        };
        add(kWorldSection, world_);
        add(kMaterialsSection, materials_);
        if (data_.rules) add(kRulesSection, rules_);
        add(kFacesSection, faces_);
        add(kVerticesSection, vertices_);
        add(kCornersSection, corners_);
        if (data_.cells.known()) add(kRoomRecordsSection, records_);
        if (data_.cells.portal_count() > 0) {
            add(kPortalsSection, portals_);
            add(kPortalPolygonsSection, portal_polygons_);
            add(kPortalCornersSection, portal_corners_);
        }
        if (exact_) {
            add(kPlanesSection, plane_data_);
            add(kGridPointsSection, grid_points_);
            add(kMeetPointsSection, meet_points_);
            add(kEdgesSection, edge_data_);
            add(kExactFacesSection, exact_data_);
            add(kUsesSection, uses_);
            add(kLoopsSection, loops_);
        }
        const auto add_optional = [&](SectionType type, ByteWriter& content) {
            all.push_back({type, 0, std::move(content)});
        };
        if (data_.anchors) add_optional(kAnchorsSection, anchors_);
        if (data_.textures) {
            add_optional(kTextureMapsSection, texture_maps_);
            add_optional(kTexturedFacesSection, textured_faces_);
            add_optional(kTextureOutlinesSection, texture_outlines_);
        }
        if (!index_) return all;
        add_optional(kIndexBlocksSection, blocks_);
        add_optional(kIndexFacesSection, block_faces_);
        add_optional(kIndexNodesSection, nodes_);
        add_optional(kIndexBinsSection, bins_);
        add_optional(kIndexChildrenSection, children_);
        add_optional(kIndexRootsSection, roots_);
        return all;
    }

    const WorldData& data_;
    const TreeOptions tree_options_;
    const bool exact_, index_;
    std::vector<FaceOfRoom> all_;  ///< in order of id
    ByteWriter world_, materials_, rules_, faces_, vertices_, corners_;
    ByteWriter records_, portals_, portal_polygons_, portal_corners_;
    ByteWriter plane_data_, grid_points_, meet_points_, edge_data_, exact_data_, uses_, loops_;
    ByteWriter anchors_;
    ByteWriter texture_maps_, textured_faces_, texture_outlines_;
    ByteWriter blocks_, block_faces_, nodes_, bins_, children_, roots_;
    FlatMap number_of_node_, number_of_block_;
    PointNumbers points_;
    std::uint32_t node_count_ = 0, block_count_ = 0;
    Numbers<SolidFace> exact_faces_;
    Numbers<SolidEdge> edges_;
    Numbers<SolidPlane> planes_;
};

}  // namespace

std::vector<std::byte> pack_world(const World& world, const SaveOptions& options) {
    return Packer(world, options).pack();
}

}  // namespace firma
