// SPDX-License-Identifier: MIT
// Portals' polygons, made of exact faces.
#include "world/portal_sheets.h"

#include "solid/own_face.h"

namespace firma {

void SheetMaker::add(const Ref<const SolidPlane>& plane, std::span<const SolidUse> uses,
                     std::span<const std::uint32_t> ends, PortalPart& part) {
    points_.clear();
    for (const SolidUse& use : uses) points_.push_back(use.from().point.rounded());
    const FlatView view = plane->plane.front_view();
    if (!facet_maker_.make(points_, ends, view, facets_)) {
        exact_.clear();
        for (const SolidUse& use : uses) exact_.push_back(use.from().point.approximate());
        facet_maker_.make_folded(points_, exact_, ends, view, facets_);
    }
    Ref<SolidFace> face(new SolidFace);
    face->plane = plane;
    face->uses.reserve(uses.size());
    for (const SolidUse& use : uses) face->uses.push_back(use);
    face->set_loop_ends(ends);
    face->normal = plane->plane.unit_normal();
    for (const GridPoint& p : points_) face->box.add(p);
    face->facets = std::uint32_t(facets_.count());
    face->set_hash();
    part.exact.resize(part.polygons.size());
    for (std::size_t k = 0; k < facets_.count(); ++k) {
        std::vector<GridPoint>& polygon = part.polygons.emplace_back();
        for (std::uint32_t c = facets_.first[k]; c < facets_.first[k + 1]; ++c)
            polygon.push_back(points_[facets_.corners[c]]);
        part.exact.emplace_back(face.get());
    }
}

namespace {

InputPoint grid_corner(const PortalPolygon& polygon, std::size_t k) {
    return to_input(polygon.corners[k % polygon.corners.size()]);
}

class PortalDivider {
public:
    PortalDivider(const Portal& portal, CutJob& cut, SheetMaker& maker) : portal_(portal), cut_(cut), maker_(maker) {}

    std::optional<PortalPart> divide() {
        PortalPart part = portal_.part();
        part.polygons.clear();
        part.exact.clear();
        const auto polygons = portal_.all_polygons();
        for (std::size_t first = 0, end = 0; first < polygons.size(); first = end) {
            const SolidFace* face = portal_.exact(first);
            end = first + 1;
            while (face && end < polygons.size() && portal_.exact(end) == face) ++end;
            if (face ? divide_face(*face) : divide_polygon(polygons[first])) {
                any_ = true;
                maker_.add(plane_, uses_, ends_, part);
                continue;
            }
            part.exact.resize(part.polygons.size());
            for (std::size_t k = first; k < end; ++k) {
                part.polygons.emplace_back(polygons[k].corners.begin(), polygons[k].corners.end());
                part.exact.emplace_back(face);
            }
        }
        if (!any_) return {};
        return part;
    }

private:
    bool divide_face(const SolidFace& face) {
        plane_ = face.plane;
        uses_.clear();
        ends_.clear();
        bool any = false;
        std::size_t k = 0;
        for (const std::uint32_t end : face.loop_ends()) {
            for (; k < end; ++k) {
                if (cut_.divide_edge(face.uses[k], uses_))
                    any = true;
                else
                    uses_.push_back(face.uses[k]);
            }
            ends_.push_back(std::uint32_t(uses_.size()));
        }
        return any;
    }

    /// One that is its own exact face.
    bool divide_polygon(const PortalPolygon& polygon) {
        uses_.clear();
        const auto corner = [&](std::size_t k) { return grid_corner(polygon, k); };
        std::vector<std::size_t> whole;  // sides that stay, by place in uses_
        std::vector<std::size_t> sides;
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            if (cut_.divide_edge(corner(k), corner(k + 1), uses_)) continue;
            whole.push_back(uses_.size());
            sides.push_back(k);
            uses_.emplace_back();
        }
        if (whole.size() == polygon.corners.size()) return false;
        plane_ = plane_of_corners(polygon.corners);
        for (std::size_t k = 0; k < whole.size(); ++k)
            uses_[whole[k]] = side_between(corner(sides[k]), corner(sides[k] + 1), plane_);
        ends_.assign(1, std::uint32_t(uses_.size()));
        return true;
    }

    const Portal& portal_;
    CutJob& cut_;
    SheetMaker& maker_;
    bool any_ = false;
    Ref<const SolidPlane> plane_;
    std::vector<SolidUse> uses_;
    std::vector<std::uint32_t> ends_;
};

}  // namespace

void append_sheets(const Portal& portal, std::uint32_t number, std::array<RoomId, 2> air,
                   std::vector<CutSheet>& sheets) {
    const auto polygons = portal.all_polygons();
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        const SolidFace* face = portal.exact(k);
        if (face && k > 0 && portal.exact(k - 1) == face) continue;
        CutSheet& sheet = sheets.emplace_back();
        sheet.portal = number;
        for (int side = 0; side < 2; ++side) sheet.air[side] = air[std::size_t(side)].value;
        if (face) {
            sheet.plane = face->plane;
            sheet.uses.assign(face->uses.begin(), face->uses.end());
            sheet.ends.assign(face->loop_ends().begin(), face->loop_ends().end());
            continue;
        }
        sheet.plane = plane_of_corners(polygons[k].corners);
        for (std::size_t c = 0; c < polygons[k].corners.size(); ++c)
            sheet.uses.push_back(
                side_between(grid_corner(polygons[k], c), grid_corner(polygons[k], c + 1), sheet.plane));
        sheet.ends.push_back(std::uint32_t(sheet.uses.size()));
    }
}

std::optional<PortalPart> divide_portal(const Portal& portal, CutJob& cut, SheetMaker& maker) {
    return PortalDivider(portal, cut, maker).divide();
}

}  // namespace firma
