// SPDX-License-Identifier: MIT
// Draws docs/pictures/contacts.svg: what carve() and fill() do with a cutter that touches, a row for each kind of
// contact.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "firma/firma.h"

namespace {

using firma::Vec3;
using Corners = std::vector<Vec3>;

constexpr double kPanelWidth = 190, kPanelHeight = 150, kLabelWidth = 190, kHeader = 28, kPixels = 19;

// The viewer's axes: seen from 35 degrees off x, 30 degrees above the ground.
constexpr double kCos = 0.819152, kSin = 0.573576, kUp = 0.866025;
constexpr Vec3 kRight{-kSin, kCos, 0}, kTop{-kCos / 2, -kSin / 2, kUp}, kToViewer{kCos * kUp, kSin* kUp, 0.5};

struct Shape {
    Corners vertices;
    std::vector<firma::CutterTriangle> triangles;
};

Shape block(const Vec3& low, const Vec3& high) {
    Shape made;
    for (int k = 0; k < 8; ++k)
        made.vertices.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    made.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return made;
}

/// On its tip.
Shape pyramid(const Vec3& tip, double half, double height) {
    const double top = tip.z + height;
    return {{tip,
             {tip.x - half, tip.y - half, top},
             {tip.x + half, tip.y - half, top},
             {tip.x + half, tip.y + half, top},
             {tip.x - half, tip.y + half, top}},
            {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}}};
}

firma::CarveResult cut(const firma::World& world, const Shape& shape, bool fill) {
    const firma::Cutter cutter = firma::make_cutter(shape.vertices, shape.triangles, "contact").value();
    return fill ? firma::fill(world, cutter, {}, {.material = "rock"})
                : firma::carve(world, cutter, {}, {.material = "cut"});
}

std::string pixel(double x, double y) {
    char text[64];
    std::snprintf(text, sizeof text, "%.1f,%.1f", x, y);
    return text;
}

struct Panel {
    double x, y;  ///< where the origin of the world is drawn

    std::string at(const Vec3& p) const { return pixel(x + kPixels * dot(p, kRight), y - kPixels * dot(p, kTop)); }
    std::string polygon(const Corners& corners, const std::string& style) const {
        std::string points;
        for (const Vec3& p : corners) points += at(p) + ' ';
        points.pop_back();
        return "<polygon points=\"" + points + "\" " + style + "/>\n";
    }
    std::string line(const Vec3& a, const Vec3& b, const std::string& style) const {
        return "<path d=\"M" + at(a) + " L" + at(b) + "\" " + style + "/>\n";
    }
};

struct Drawn {
    Corners corners;
    Vec3 normal;
    std::uint32_t edit = 0;
    bool cut = false;
    std::vector<bool> edge;  ///< from each corner: whether it is one of the face, not of its division into facets
};

bool coplanar(const Drawn& a, const Drawn& b) {
    if (!(dot(a.normal, b.normal) > 1 - 1e-9)) return false;
    return std::abs(dot(a.normal, b.corners[0] - a.corners[0])) < 1e-6;
}

/// Lines within one plane that one edit made are not shown: they divide a face into convex facets.
void find_edges(std::vector<Drawn>& faces) {
    for (Drawn& face : faces) {
        face.edge.assign(face.corners.size(), true);
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            const Vec3 a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()];
            for (const Drawn& other : faces)
                for (std::size_t j = 0; j < other.corners.size(); ++j)
                    if (other.corners[j] == b && other.corners[(j + 1) % other.corners.size()] == a &&
                        other.edit == face.edit && other.cut == face.cut && coplanar(face, other))
                        face.edge[k] = false;
        }
    }
}

/// On the page, and farther than in a line.
bool overlap_seen(const Corners& a, const Corners& b) {
    for (const Corners* of : {&a, &b})
        for (std::size_t k = 0; k < of->size(); ++k) {
            const Vec3 side = (*of)[(k + 1) % of->size()] - (*of)[k];
            const double x = -dot(side, kTop), y = dot(side, kRight);
            const auto reach = [&](const Corners& corners) {
                std::array<double, 2> range{1e9, -1e9};
                for (const Vec3& p : corners) {
                    const double at = x * dot(p, kRight) + y * dot(p, kTop);
                    range = {std::min(range[0], at), std::max(range[1], at)};
                }
                return range;
            };
            const auto of_a = reach(a), of_b = reach(b);
            if (of_a[1] < of_b[0] + 1e-6 || of_b[1] < of_a[0] + 1e-6) return false;
        }
    return true;
}

/// Whether all of `face` lies on one side of the other's plane: +1 the viewer's, -1 the far one, 0 neither.
int side_of(const Drawn& face, const Drawn& other) {
    bool near = true, far = true;
    for (const Vec3& p : face.corners) {
        const double height = dot(other.normal, p - other.corners[0]);
        near = near && height > -1e-6;
        far = far && height < 1e-6;
    }
    return near == far ? 0 : near ? 1 : -1;
}

bool goes_before(const Drawn& face, const Drawn& other) {
    if (!overlap_seen(face.corners, other.corners)) return false;
    if (const int side = side_of(face, other)) return side < 0;
    return side_of(other, face) > 0;
}

/// From back to front.
std::vector<Drawn> in_order(std::vector<Drawn> faces) {
    std::vector<Drawn> ordered;
    while (!faces.empty()) {
        std::size_t next = 0;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const bool waits = std::any_of(faces.begin(), faces.end(), [&](const Drawn& other) {
                return &other != &faces[k] && goes_before(other, faces[k]);
            });
            if (waits) continue;
            next = k;
            break;
        }
        ordered.push_back(faces[next]);
        faces.erase(faces.begin() + std::ptrdiff_t(next));
    }
    return ordered;
}

std::string draw_faces(const Panel& panel, const std::vector<Drawn>& faces, const char* see_through) {
    static const char* const kRock[3] = {"#8f9492", "#a9adab", "#d3d6d4"};
    static const char* const kCut[3] = {"#9a6a3e", "#b67d49", "#d89f68"};
    std::vector<Drawn> seen;
    std::string hidden, text;
    for (const Drawn& face : faces) {
        if (dot(face.normal, kToViewer) > 1e-9) seen.push_back(face);
        for (std::size_t k = 0; *see_through && face.cut && k < face.corners.size(); ++k)
            if (face.edge[k])
                hidden += panel.line(face.corners[k], face.corners[(k + 1) % face.corners.size()], see_through);
    }
    for (const Drawn& face : in_order(seen)) {
        const std::size_t shade = face.normal.z > 0.4 ? 2 : std::abs(face.normal.x) > std::abs(face.normal.y) ? 1 : 0;
        const std::string colour = face.cut ? kCut[shade] : kRock[shade];
        text += panel.polygon(face.corners, "fill=\"" + colour + "\" stroke=\"" + colour + "\" stroke-width=\"0.5\"");
        for (std::size_t k = 0; k < face.corners.size(); ++k)
            if (face.edge[k])
                text += panel.line(face.corners[k], face.corners[(k + 1) % face.corners.size()],
                                   "stroke=\"#222\" stroke-width=\"1\" stroke-linecap=\"round\"");
    }
    return text + hidden;
}

std::string draw_world(const Panel& panel, const firma::World& world, bool see_through) {
    std::vector<Drawn> faces;
    for (const firma::Face& face : world.faces())
        faces.push_back({face.corners, face.normal, face.source_edit, world.material_name(face.material) == "cut", {}});
    find_edges(faces);
    return draw_faces(panel, faces, see_through ? "stroke=\"#9a5a1e\" stroke-dasharray=\"3,2\" fill=\"none\"" : "");
}

std::string draw_cutter(const Panel& panel, const Shape& shape) {
    std::vector<Drawn> faces;
    for (const firma::CutterTriangle& triangle : shape.triangles) {
        Drawn face;
        for (const std::uint32_t corner : triangle) face.corners.push_back(shape.vertices[corner]);
        face.normal = cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
        face.normal = face.normal * (1 / length(face.normal));
        faces.push_back(face);
    }
    find_edges(faces);
    std::string text, lines;
    for (const Drawn& face : faces) {
        const bool front = dot(face.normal, kToViewer) > 1e-9;
        if (front) text += panel.polygon(face.corners, "fill=\"#f07820\" fill-opacity=\"0.3\"");
        for (std::size_t k = 0; k < face.corners.size(); ++k)
            if (face.edge[k])
                lines += panel.line(face.corners[k], face.corners[(k + 1) % face.corners.size()],
                                    front ? "stroke=\"#d04a00\" stroke-width=\"1.6\""
                                          : "stroke=\"#d04a00\" stroke-width=\"0.8\" stroke-dasharray=\"3,2\"");
    }
    return text + lines;
}

std::string words(double x, double y, const std::string& text, const char* style = "") {
    char place[64];
    std::snprintf(place, sizeof place, "<text x=\"%.1f\" y=\"%.1f\" ", x, y);
    return place + std::string(style) + ">" + text + "</text>\n";
}

std::string said_of(const firma::CarveResult& result) {
    if (result.status == firma::CarveStatus::kNothing) return "nothing";
    if (!result.done()) return "refused: " + result.error.text();
    char text[64];
    const double volume = result.report.volume;
    std::snprintf(text, sizeof text, "%.4g m\u00b3 %s%s", volume < 0 ? -volume : volume,
                  volume < 0 ? "added" : "removed", result.world.face_count() == 0 ? ", no face left" : "");
    return text;
}

struct Row {
    std::vector<std::string> name;
    firma::World before;
    Shape cutter;
    bool see_through = false;
};

std::vector<Row> rows() {
    const Shape slab = block({0, 0, 0}, {4, 4, 2});
    const auto filled = [](const firma::World& world, const Shape& shape) { return cut(world, shape, true).world; };
    const firma::World rock = filled(firma::World(), slab);
    const firma::World apart = filled(filled(firma::World(), block({0, 0, 0}, {2, 2, 2})), block({2, 2, 0}, {4, 4, 2}));
    const Shape pit = block({1, 1, 1}, {3, 3, 2}), one = block({2, 1, 1}, {4, 2, 2}),
                next = block({2, 2, 1}, {4, 3, 2});
    return {
        {{"Faces in one plane", "that look the same way"}, rock, block({2, 1, 1}, {4, 3, 2})},
        {{"Faces in one plane", "that look at each other"}, rock, block({1, 2, 2}, {4, 4, 3})},
        {{"Edge on edge"}, rock, block({4, 1, 2}, {5, 3, 3})},
        {{"Vertex on face"}, rock, pyramid({2, 2, 2}, 1, 1.5)},
        {{"At an edge where", "two solids touch"}, apart, block({1, 1, 1}, {3, 3, 3})},
        {{"Equal"}, rock, slab},
        {{"Inside,", "on the bottom's plane"}, rock, block({1, 1, 0}, {3, 3, 1}), true},
        {{"Around,", "on the bottom's plane"}, rock, block({-0.5, -0.5, 0}, {4.5, 4.5, 2.5})},
        {{"The same cutter again"}, cut(rock, pit, false).world, pit},
        {{"Beside an earlier cut:", "the seam goes"}, cut(rock, one, false).world, next},
    };
}

}  // namespace

int main() {
    const std::vector<Row> all = rows();
    const double width = kLabelWidth + 3 * kPanelWidth, height = kHeader + kPanelHeight * double(all.size());
    std::printf(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
        width, height);
    const char* const bold = "font-weight=\"bold\" text-anchor=\"middle\"";
    const char* const heads[3] = {"before, and the cutter", "carve", "fill"};
    for (int k = 0; k < 3; ++k)
        std::fputs(words(kLabelWidth + (k + 0.5) * kPanelWidth, 19, heads[k], bold).c_str(), stdout);
    double y = kHeader;
    for (const Row& row : all) {
        std::string text;
        char line[96];
        std::snprintf(line, sizeof line, "<path d=\"M0,%.1f H%.1f\" stroke=\"#ccc\"/>\n", y, width);
        text += line;
        for (std::size_t k = 0; k < row.name.size(); ++k) text += words(12, y + 70 + 18 * double(k), row.name[k]);
        const auto panel = [&](int column) { return Panel{kLabelWidth + (column + 0.5) * kPanelWidth, y + 62}; };
        text += draw_world(panel(0), row.before, false) + draw_cutter(panel(0), row.cutter);
        for (int column = 1; column < 3; ++column) {
            const firma::CarveResult result = cut(row.before, row.cutter, column == 2);
            text += draw_world(panel(column), result.world, row.see_through && column == 1);
            text += words(kLabelWidth + (column + 0.5) * kPanelWidth, y + kPanelHeight - 8, said_of(result),
                          "text-anchor=\"middle\" fill=\"#444\" font-size=\"12\"");
        }
        std::fputs(text.c_str(), stdout);
        y += kPanelHeight;
    }
    std::puts("</svg>");
}
