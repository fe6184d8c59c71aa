// SPDX-License-Identifier: MIT
// From a world to the bytes of a .firma file: each block once, children before what holds them; each exact face, edge,
// vertex and plane once, numbered in the order in which blocks lead to them.
#include "base/flat_map.h"
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

class Packer {
public:
    Packer(const World& world, const SaveOptions& options) : data_(world.data()), exact_(options.exact) {}

    std::vector<std::byte> pack() {
        pack_data();
        pack_materials();
        if (data_.rules) pack_rules(*data_.rules);
        pack_rooms();
        if (data_.room_records) pack_records(*data_.room_records);
        if (data_.portals) pack_portals(*data_.portals);
        if (exact_) pack_exact();
        return write_container(sections());
    }

private:
    void pack_data() {
        world_.u64(data_.version);
        world_.u64(data_.face_count);
        world_.u32(data_.next_face);
        world_.u32(data_.edits);
        // Without its faces there is no solid, and no end to what would be rock.
        const bool rock_outside = data_.rock_outside && exact_;
        world_.u32((rock_outside ? kRockOutside : 0) | (exact_ ? kExactPart : 0) | (data_.rules ? kHasRules : 0) |
                   (data_.room_records ? kHasRoomRecords : 0) | (data_.portals ? kHasPortals : 0));
        world_.u32(std::uint32_t(data_.rooms.size()));
        world_.f64(data_.tolerance.skin);
        world_.u32(std::uint32_t(data_.tree_options.split));
        world_.i32(data_.tree_options.max_depth);
        world_.i32(data_.tree_options.faces_per_bin);
        world_.u32(0);
        world_.f64(data_.tree_options.min_bin_volume);
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
        for (const std::size_t most : {rules.most_faces, rules.most_faces_looked_at, rules.most_new_faces,
                                       rules.most_cutter_triangles, rules.most_pairs, rules.most_corners})
            rules_.u64(most);
        rules_.f64(rules.largest_cutter);
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

    void pack_rooms() {
        for (const Ref<const Room>& room : data_.rooms) {
            const std::size_t before = blocks_.size();
            if (room->tree) pack_block(*room->tree);
            rooms_.u32(std::uint32_t((blocks_.size() - before) / kBlockBytes));
        }
    }

    void pack_records(const std::vector<RoomRecord>& records) {
        for (const RoomRecord& record : records) {
            records_.u32(std::uint32_t(record.name.size()));
            records_.u32(record.exterior ? kExteriorRoom : 0);
            records_.u32(record.merged_into);
        }
        for (const RoomRecord& record : records) add_text(records_, record.name);
    }

    void pack_portals(const PortalSet& portals) {
        portals_.u32(std::uint32_t(portals.portals().size()));
        for (std::size_t k = 0; k < portals.portals().size(); ++k) {
            const Portal& portal = portals.portals()[k];
            for (const RoomId room : portal.rooms) portals_.u32(room.value);
            portals_.u32(portal.material);
            portals_.u32(portal.mask);
            portals_.u32(data_.closed && data_.closed->is_closed[k] ? kClosedPortal : 0);
            portals_.u32(portal.polygon_count);
            portals_.u32(std::uint32_t(portal.name.size()));
            portals_.u32(0);
            for (const PortalPolygon& polygon : portals.polygons_of(portal)) {
                portal_polygons_.u32(std::uint32_t(polygon.corners.size()));
                for (const GridPoint& corner : polygon.corners) add_point(portal_corners_, corner);
            }
        }
        for (const Portal& portal : portals.portals()) add_text(portals_, portal.name);
    }

    void pack_block(const Block& block) {
        for (const Ref<const Block>& child : block.children) pack_block(*child);
        const std::size_t owners = exact_ ? block.owners.size() : 0;
        for (const std::size_t count : {block.bins.size(), block.children.size(), block.faces.size(),
                                        block.vertices.size(), block.corner_vertices.size(), owners})
            blocks_.u16(std::uint16_t(count));
        for (const Bin& bin : block.bins) {
            for (const float coordinate : bin.box.low) bins_.f32(coordinate);
            for (const float coordinate : bin.box.high) bins_.f32(coordinate);
            bins_.u32(bin.first);
            bins_.u32(bin.count);
        }
        for (const FaceRecord& face : block.faces) pack_face(face);
        for (const GridPoint& vertex : block.vertices) add_point(vertices_, vertex);
        for (const std::uint16_t corner : block.corner_vertices) corners_.u16(corner);
        for (std::size_t k = 0; k < owners; ++k)
            owners_.u32(exact_faces_(static_cast<const SolidFace*>(block.owners[k].get())));
    }

    void pack_face(const FaceRecord& face) {
        faces_.u32(face.id.value);
        faces_.u32(face.source);
        faces_.u32(face.edit);
        faces_.u32(face.material);
        faces_.u32(face.mask);
        faces_.u16(face.first_corner);
        faces_.u16(exact_ ? face.owner : kNoOwner);
        faces_.u8(face.corner_count);
        faces_.u8(std::uint8_t((face.two_sided ? kTwoSidedFace : 0) | (face.solid && exact_ ? kSolidFace : 0)));
        faces_.u16(0);
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
        add(kRoomsSection, rooms_);
        add(kBlocksSection, blocks_);
        add(kBinsSection, bins_);
        add(kFacesSection, faces_);
        add(kVerticesSection, vertices_);
        add(kCornersSection, corners_);
        if (data_.room_records) add(kRoomRecordsSection, records_);
        if (data_.portals) {
            add(kPortalsSection, portals_);
            add(kPortalPolygonsSection, portal_polygons_);
            add(kPortalCornersSection, portal_corners_);
        }
        if (!exact_) return all;
        add(kOwnersSection, owners_);
        add(kPlanesSection, plane_data_);
        add(kGridPointsSection, grid_points_);
        add(kMeetPointsSection, meet_points_);
        add(kEdgesSection, edge_data_);
        add(kExactFacesSection, exact_data_);
        add(kUsesSection, uses_);
        add(kLoopsSection, loops_);
        return all;
    }

    const WorldData& data_;
    const bool exact_;
    ByteWriter world_, materials_, rules_, rooms_, blocks_, bins_, faces_, vertices_, corners_, owners_;
    ByteWriter records_, portals_, portal_polygons_, portal_corners_;
    ByteWriter plane_data_, grid_points_, meet_points_, edge_data_, exact_data_, uses_, loops_;
    Numbers<SolidFace> exact_faces_;
    Numbers<SolidEdge> edges_;
    Numbers<SolidPlane> planes_;
};

}  // namespace

std::vector<std::byte> pack_world(const World& world, const SaveOptions& options) {
    return Packer(world, options).pack();
}

}  // namespace firma
