// SPDX-License-Identifier: MIT
// Divides the air of a level of faces into rooms: portals are cut where faces cross them, parts in the solid go, faces
// are cut at what is left; then the arrangement tells which sides see each other.
#include "level/divide_mesh.h"

#include <algorithm>

#include "firma/rooms.h"
#include "index/box_tree.h"
#include "join/portal_cutter.h"

namespace firma {
namespace {

constexpr std::size_t kMostParts = std::size_t(1) << 14;  // of portals; each cut may double those of a bad one

class Divider {
public:
    Divider(const Level& level, std::span<const LevelPortal> portals, const LevelSolids& solids, const World& plain)
        : level_(level),
          portals_(portals),
          solids_(solids),
          plain_(plain),
          made_(std::make_unique<DividedMesh>()),
          cutter_(made_->tables) {}

    std::unique_ptr<DividedMesh> divide() {
        make_faces();
        if (!cut_portals()) return failed("its portals are cut into too many parts");
        cutter_.divide_at_portals(made_->portals);
        cutter_.divide_at_portals(made_->faces);
        cutter_.merge_between_portals(made_->portals);

        std::vector<ConvexPiece> portals;
        for (const JoinPiece& portal : made_->portals) portals.push_back(portal.piece);
        std::vector<OpenEdge> open;
        made_->arrangement = arrange(tables(), made_->faces, portals, open);
        if (!open.empty()) return failed("its faces do not bound a solid where they were cut");
        std::vector<PlaneId> planes;
        for (const JoinPiece& face : made_->faces) planes.push_back(face.piece.plane);
        for (const ConvexPiece& portal : portals) planes.push_back(portal.plane);
        made_->facets = make_join_facets(tables(), planes, made_->arrangement);
        if (!made_->facets.unsound.empty()) return failed("a portal cuts a face too thin for the grid");

        const RoomFinder finder(made_->faces.size(), portals.size(), made_->facets, solids_.rock_outside);
        made_->rooms = finder.find(made_->arrangement.seen_together);
        add_loose(finder);
        return std::move(made_);
    }

private:
    ExactTables& tables() { return made_->tables; }

    std::unique_ptr<DividedMesh> failed(const char* fault) {
        made_->fault = fault;
        return std::move(made_);
    }

    GridBox box_of(const JoinPiece& piece) const { return piece.piece.box(made_->tables.points); }

    JoinPiece piece_of(std::uint32_t index) {
        const LevelFace& face = level_.faces[index];
        std::vector<InputPoint> corners;
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            corners.push_back(to_input(level_.vertices[level_.corners[face.first_corner + k]]));
        return {piece_of_corners(tables(), corners), index, face.material, face.mask};
    }

    void make_faces() {
        std::vector<GridBox> boxes;
        for (std::uint32_t k = 0; k < level_.faces.size(); ++k) {
            if (!solids_.solid[k]) continue;
            made_->faces.push_back(piece_of(k));
            boxes.push_back(box_of(made_->faces.back()));
        }
        face_tree_ = BoxTree(boxes);
    }

    /// Of each portal the parts in the air; of several in one place the first.
    bool cut_portals() {
        for (std::uint32_t k = 0; k < portals_.size(); ++k)
            for (const std::vector<GridPoint>& polygon : portals_[k].polygons) {
                std::vector<InputPoint> corners;
                for (const GridPoint& point : polygon) corners.push_back(to_input(point));
                std::vector<ConvexPiece> parts{piece_of_corners(tables(), corners)};
                if (!cut_by_faces(parts) || !cut_by_portals(parts)) return false;
                for (ConvexPiece& part : parts)
                    if (in_air(part)) made_->portals.push_back({std::move(part), k, k, 0});
                if (made_->portals.size() > kMostParts) return false;
            }
        cutter_.set_portals(made_->portals);
        return true;
    }

    /// By the planes of faces that are near, and by the sides of those that it lies on.
    bool cut_by_faces(std::vector<ConvexPiece>& parts) {
        for (std::size_t k = 0; k < parts.size(); ++k) {
            near_.clear();
            face_tree_.for_each_meeting(parts[k].box(tables().points), [&](std::uint32_t face) {
                near_.push_back(face);
                return false;
            });
            std::sort(near_.begin(), near_.end());
            for (const std::uint32_t face : near_) {
                const ConvexPiece& wall = made_->faces[face].piece;
                if (!same_plane(wall.plane, parts[k].plane)) {
                    cut(parts, k, wall.plane);
                } else {
                    for (const PieceSide& side : wall.sides) cut(parts, k, side.plane);
                }
                if (parts.size() > kMostParts) return false;
            }
        }
        return true;
    }

    /// Leaves out what lies on parts of portals that there are.
    bool cut_by_portals(std::vector<ConvexPiece>& parts) {
        for (const JoinPiece& portal : made_->portals) {
            const GridBox box = box_of(portal);
            for (std::size_t k = 0; k < parts.size(); ++k) {
                if (!same_plane(portal.piece.plane, parts[k].plane) || !boxes_meet(box, parts[k].box(tables().points)))
                    continue;
                for (const PieceSide& side : portal.piece.sides) cut(parts, k, side.plane);
                if (parts.size() > kMostParts) return false;
            }
            std::erase_if(parts, [&](const ConvexPiece& part) { return lies_on(part, portal.piece); });
        }
        return true;
    }

    bool lies_on(const ConvexPiece& part, const ConvexPiece& other) const {
        if (!same_plane(part.plane, other.plane)) return false;
        for (const PieceSide& side : other.sides)
            for (const PieceSide& corner : part.sides)
                if (made_->tables.points.side(side.plane, corner.corner) > 0) return false;
        return true;
    }

    /// What lies in front goes to the end, and comes to its turn.
    void cut(std::vector<ConvexPiece>& parts, std::size_t k, PlaneId by) {
        ConvexPiece behind, front;
        firma::divide(tables(), parts[k], by, behind, front);
        if (behind.sides.empty() || front.sides.empty()) return;
        parts[k] = std::move(behind);
        parts.push_back(std::move(front));
    }

    bool in_air(const ConvexPiece& part) const {
        Vec3 middle;
        for (const PieceSide& side : part.sides)
            middle = middle + to_metres(made_->tables.points.point(side.corner).rounded());
        middle = middle * (1.0 / double(part.sides.size()));
        return locate(plain_, middle).where == Where::kAir;
    }

    /// Faces that bound no solid, each part in the room that its front looks into.
    void add_loose(const RoomFinder& finder) {
        for (std::uint32_t k = 0; k < level_.faces.size(); ++k) {
            if (solids_.solid[k]) continue;
            std::vector<JoinPiece> pieces{piece_of(k)};
            cutter_.divide_at_portals(pieces);
            for (LooseFacet& facet : make_loose_facets(tables(), pieces)) {
                facet.two_sided = level_.faces[k].two_sided;
                facet.room = finder.room_of(made_->rooms, facet.corners);
                made_->loose.push_back(std::move(facet));
            }
        }
    }

    const Level& level_;
    const std::span<const LevelPortal> portals_;
    const LevelSolids& solids_;
    const World& plain_;
    std::unique_ptr<DividedMesh> made_;
    PortalCutter cutter_;
    BoxTree face_tree_;
    std::vector<std::uint32_t> near_;
};

}  // namespace

std::unique_ptr<DividedMesh> divide_mesh(const Level& level, std::span<const LevelPortal> portals,
                                         const LevelSolids& solids, const World& plain) {
    return Divider(level, portals, solids, plain).divide();
}

}  // namespace firma
