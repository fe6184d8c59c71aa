// SPDX-License-Identifier: MIT
// The painter's method in bands of depth: one path of fills and one of edges a band keeps the file small.
#include "draw/draw_faces.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/room_colours.h"

namespace firma::draw {

namespace {

constexpr int kBands = 32;
constexpr int kShades = 3;           // by steepness within a band
constexpr double kLeastArea = 0.05;  // square pixels; smaller faces are not drawn
constexpr double kLeastEdge = 0.4;   // pixels
constexpr double kLeastCut = 0.1;    // pixels
constexpr double kCrease = 0.966;    // cosine of 15 degrees: surfaces that turn more have an edge
constexpr std::size_t kCornerBytes = 12;

struct Corner {
    Vec3 point;
    bool edge = false;  ///< whether the side from here to the next corner is drawn
};

/// A face as seen, ready to be drawn.
struct Shape {
    std::vector<PagePoint> outline;
    std::vector<bool> edges;
    double area = 0;      ///< square pixels
    double nearness = 0;  ///< metres
    int band = 0, shade = 0;
    std::uint32_t tint = 0;
};

const Face* find(std::span<const Face> faces, FaceId id) {
    const auto found =
        std::lower_bound(faces.begin(), faces.end(), id, [](const Face& f, FaceId i) { return f.id < i; });
    return found != faces.end() && found->id == id ? &*found : nullptr;
}

bool seen(const View& view, const Face& face) {
    return view.sees(face.normal, face.two_sided);
}

/// Whether the surface turns, ends or vanishes at the edge to a neighbour. A soft edge is drawn by neither face, a
/// crease between two seen faces by the one of lower id.
bool is_drawn_edge(const View& view, std::span<const Face> faces, const Face& face, FaceId neighbour) {
    const Face* other = neighbour.valid() ? find(faces, neighbour) : nullptr;
    if (other == nullptr || !seen(view, *other)) return true;
    return dot(face.normal, other->normal) < kCrease && face.id < other->id;
}

std::vector<Corner> corners_of(const View& view, const World& world, std::span<const Face> faces, const Face& face) {
    std::vector<Corner> corners;
    for (std::uint32_t k = 0; k < face.corners.size(); ++k) {
        const FaceId neighbour = other_face(world, face.ref(), k);
        corners.push_back({face.corners[k], is_drawn_edge(view, faces, face, neighbour)});
    }
    return corners;
}

/// Keeps what lies beyond the cut. Sides along the cut are not drawn: the cut's own lines are.
std::vector<Corner> beyond_cut(const View& view, const std::vector<Corner>& corners, double cut) {
    const double limit = view.toward * cut;
    std::vector<Corner> kept;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Corner& here = corners[k];
        const Corner& next = corners[(k + 1) % corners.size()];
        const double a = limit - view.nearness(here.point), b = limit - view.nearness(next.point);
        if (a >= 0) kept.push_back(here);
        if ((a >= 0) == (b >= 0)) continue;
        kept.push_back({here.point + (next.point - here.point) * (a / (a - b)), a < 0 && here.edge});
    }
    return kept;
}

double length_of(const PagePoint& a, const PagePoint& b) {
    const double x = b.x - a.x, y = b.y - a.y;
    return std::sqrt(x * x + y * y);
}

double area_of(const std::vector<PagePoint>& outline) {
    double twice = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const PagePoint &a = outline[k], &b = outline[(k + 1) % outline.size()];
        twice += (a.x - outline[0].x) * (b.y - outline[0].y) - (b.x - outline[0].x) * (a.y - outline[0].y);
    }
    return std::fabs(twice) / 2;
}

Shape shape_of(const View& view, const Face& face, const std::vector<Corner>& corners, std::uint32_t tint) {
    Shape shape;
    double sum = 0;
    for (const Corner& corner : corners) {
        shape.outline.push_back(view.place(corner.point));
        shape.edges.push_back(corner.edge);
        sum += view.nearness(corner.point);
    }
    shape.area = area_of(shape.outline);
    shape.nearness = sum / double(corners.size());
    shape.shade = std::clamp(int((1 - std::fabs(view.facing(face.normal))) * kShades), 0, kShades - 1);
    shape.tint = tint;
    return shape;
}

/// What is worth drawing, and how much is not.
std::vector<Shape> collect_shapes(const View& view, const World& world, std::span<const Face> faces,
                                  const FaceLook& look, FacesDrawn& counts) {
    std::vector<Shape> shapes;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const Face& face = faces[k];
        if (!seen(view, face)) continue;
        std::vector<Corner> corners = corners_of(view, world, faces, face);
        if (look.cut) corners = beyond_cut(view, corners, *look.cut);
        if (corners.size() < 3) continue;
        Shape shape = shape_of(view, face, corners, look.tint_of[k]);
        if (shape.area >= kLeastArea) {
            shapes.push_back(std::move(shape));
        } else {
            ++counts.left_out;
        }
    }
    return shapes;
}

/// Leaves out the smallest shapes until the rest fits.
void keep_to_budget(std::vector<Shape>& shapes, std::size_t max_bytes, FacesDrawn& counts) {
    std::sort(shapes.begin(), shapes.end(), [](const Shape& a, const Shape& b) { return a.area > b.area; });
    std::size_t bytes = 0, kept = 0;
    while (kept < shapes.size() && bytes < max_bytes) {
        bytes += shapes[kept].outline.size() * kCornerBytes;
        for (const bool edge : shapes[kept].edges) bytes += edge ? 2 * kCornerBytes : 0;
        ++kept;
    }
    counts.left_out += shapes.size() - kept;
    counts.drawn = kept;
    shapes.resize(kept);
}

/// Spreads the bands over the depth that is seen.
void set_bands(std::vector<Shape>& shapes) {
    double far = INFINITY, near = -INFINITY;
    for (const Shape& shape : shapes) {
        far = std::min(far, shape.nearness);
        near = std::max(near, shape.nearness);
    }
    for (Shape& shape : shapes) {
        const double share = near > far ? (shape.nearness - far) / (near - far) : 0;
        shape.band = std::clamp(int(share * kBands), 0, kBands - 1);
    }
}

/// The tint of a band, darker where faces are steep.
std::string colour_of(const Tint& tint, int band, int shade) {
    const double share = double(band) / (kBands - 1), light = 1 - 0.07 * shade;
    return hex_colour(mixed(tint.far, tint.near, share) * light);
}

void draw_fills(SvgText& svg, const std::vector<const Shape*>& shapes, const std::string& colour) {
    if (shapes.empty()) return;
    svg.raw("<path fill=\"").raw(colour).raw("\" stroke=\"").raw(colour).raw("\" stroke-width=\".6\" d=\"");
    for (const Shape* shape : shapes) {
        for (std::size_t k = 0; k < shape->outline.size(); ++k) svg.raw(k == 0 ? "M" : " ").point(shape->outline[k]);
        svg.raw("Z");
    }
    svg.raw("\"/>\n");
}

void draw_edges(SvgText& svg, const std::vector<const Shape*>& shapes) {
    SvgText lines;
    for (const Shape* shape : shapes) {
        const std::size_t count = shape->outline.size();
        bool pen_down = false;
        for (std::size_t k = 0; k < count; ++k) {
            const PagePoint &a = shape->outline[k], &b = shape->outline[(k + 1) % count];
            const bool drawn = shape->edges[k] && length_of(a, b) >= kLeastEdge;
            if (drawn && !pen_down) lines.raw("M").point(a);
            if (drawn) lines.raw(" ").point(b);
            pen_down = drawn;
        }
    }
    if (lines.size() > 0) svg.raw("<path class=\"edge\" d=\"").raw(lines.text()).raw("\"/>\n");
}

/// Where a convex face meets a plane across an axis. A corner in the plane counts as beyond it, so neighbours agree.
struct CutLine {
    Vec3 from, to;
};
std::optional<CutLine> cut_of(const Face& face, int axis, double at) {
    Vec3 ends[2];
    int found = 0;
    for (std::size_t k = 0; k < face.corners.size() && found < 2; ++k) {
        const Vec3 &a = face.corners[k], &b = face.corners[(k + 1) % face.corners.size()];
        const double before = a[axis] - at, after = b[axis] - at;
        if ((before >= 0) != (after >= 0)) ends[found++] = a + (b - a) * (before / (before - after));
    }
    if (found < 2) return std::nullopt;
    return CutLine{ends[0], ends[1]};
}

}  // namespace

FacesDrawn draw_faces(SvgText& svg, const View& view, const World& world, std::span<const Face> faces,
                      const FaceLook& look) {
    FacesDrawn counts;
    std::vector<Shape> shapes = collect_shapes(view, world, faces, look, counts);
    keep_to_budget(shapes, look.max_bytes, counts);
    set_bands(shapes);
    const std::size_t kinds = kShades * look.tints.size();
    std::vector<std::vector<const Shape*>> groups(kBands * kinds);
    for (const Shape& shape : shapes)
        groups[std::size_t(shape.band) * kinds + shape.tint * kShades + std::size_t(shape.shade)].push_back(&shape);
    for (int band = 0; band < kBands; ++band) {
        const std::span group(&groups[std::size_t(band) * kinds], kinds);
        for (std::size_t kind = 0; kind < kinds; ++kind)
            draw_fills(svg, group[kind], colour_of(look.tints[kind / kShades], band, int(kind % kShades)));
        for (const std::vector<const Shape*>& kind : group) draw_edges(svg, kind);
    }
    return counts;
}

std::size_t cut_width(const View& view, std::span<const Face> faces, double cut) {
    std::vector<bool> columns(std::size_t(view.width() / 2) + 1);
    const auto column = [&](const Vec3& p) {
        const double pixels = view.place(p).x - view.corner.x;
        return std::size_t(std::clamp(pixels / 2, 0.0, double(columns.size() - 1)));
    };
    for (const Face& face : faces) {
        const std::optional<CutLine> line = cut_of(face, view.depth, cut);
        if (!line) continue;
        const std::size_t a = column(line->from), b = column(line->to);
        for (std::size_t k = std::min(a, b); k <= std::max(a, b); ++k) columns[k] = true;
    }
    return std::size_t(std::count(columns.begin(), columns.end(), true));
}

std::size_t draw_cut_lines(SvgText& svg, const View& view, std::span<const Face> faces, double cut) {
    std::size_t count = 0;
    SvgText lines, new_lines;
    for (const Face& face : faces) {
        const std::optional<CutLine> line = cut_of(face, view.depth, cut);
        if (!line) continue;
        ++count;
        const PagePoint from = view.place(line->from), to = view.place(line->to);
        if (length_of(from, to) < kLeastCut) continue;
        (face.source_edit != 0 ? new_lines : lines).raw("M").point(from).raw(" ").point(to);
    }
    if (lines.size() > 0) svg.raw("<path class=\"cut\" d=\"").raw(lines.text()).raw("\"/>\n");
    if (new_lines.size() > 0) svg.raw("<path class=\"cut new\" d=\"").raw(new_lines.text()).raw("\"/>\n");
    return count;
}

}  // namespace firma::draw
