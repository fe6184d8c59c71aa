// SPDX-License-Identifier: MIT
// The facets of a solid at any pose, as a solid on the input grid.
#include <algorithm>
#include <map>
#include <set>

#include "base/decimal.h"
#include "base/point_numbers.h"
#include "carve/cutter_data.h"
#include "carve/mend_mesh.h"
#include "carve/place_solid.h"
#include "firma/level.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

using Triangle = CutterTriangle;
using Side = std::pair<std::uint32_t, std::uint32_t>;  ///< of a triangle, the lower number first

Side side_of(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Triangles on the input grid that together bound what the facets do, where they are still apart.
class SnappedMesh {
public:
    std::uint32_t add(const GridPoint& point) { return points_.number(point); }
    void add(const Triangle& triangle) {
        const auto& [a, b, c] = triangle;
        if (a != b && b != c && c != a) triangles_.push_back(triangle);
    }

    /// @return how many triangles went, see mend_mesh()
    int mend() {
        std::vector<InputPoint> points;
        for (std::uint32_t p = 0; p < points_.count(); ++p) points.push_back(point(p));
        return mend_mesh(points, triangles_);
    }

    /// Polygons with area: triangles, with corners of such without area on their sides.
    Level level(const std::string& name) {
        cancel();
        leave_out_flat();
        Level made;
        made.name = name;
        made.materials = made.groups = {""};
        for (std::uint32_t p = 0; p < points_.count(); ++p) made.vertices.push_back(points_.point(p));
        for (const Triangle& triangle : triangles_) {
            LevelFace face;
            face.first_corner = std::uint32_t(made.corners.size());
            for (std::size_t k = 0; k < 3; ++k) append_side(triangle[k], triangle[k < 2 ? k + 1 : 0], made.corners);
            face.corner_count = std::uint32_t(made.corners.size()) - face.first_corner;
            face.source = std::uint32_t(made.faces.size());
            made.faces.push_back(face);
        }
        made.source_faces = std::uint32_t(made.faces.size());
        return made;
    }

private:
    /// Two triangles of the same corners that look at each other enclose nothing.
    void cancel() {
        // Of each triangle its corners, in order of number, and whether that order runs against it.
        std::map<Triangle, std::vector<std::pair<std::uint32_t, bool>>> same;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            Triangle sorted = triangles_[t];
            std::sort(sorted.begin(), sorted.end());
            const auto at =
                std::size_t(std::find(triangles_[t].begin(), triangles_[t].end(), sorted[0]) - triangles_[t].begin());
            same[sorted].push_back({t, triangles_[t][(at + 1) % 3] != sorted[1]});
        }
        std::vector<bool> gone(triangles_.size(), false);
        for (const auto& [corners, uses] : same)
            for (std::size_t k = 0; k < uses.size(); ++k)
                for (std::size_t j = k + 1; j < uses.size() && !gone[uses[k].first]; ++j)
                    if (uses[k].second != uses[j].second && !gone[uses[j].first])
                        gone[uses[k].first] = gone[uses[j].first] = true;
        drop(gone);
    }

    void drop(const std::vector<bool>& gone) {
        std::size_t kept = 0;
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            if (!gone[t]) triangles_[kept++] = triangles_[t];
        triangles_.resize(kept);
    }

    /// Of a triangle whose corners lie in a row the middle one comes to lie on the opposite side, for all who use that.
    /// What is on that side is then on the two others as well, and the other way around.
    void leave_out_flat() {
        std::vector<bool> flat(triangles_.size(), false);
        std::vector<Triangle> rows;  // the middle corner second
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const auto& [a, b, c] = triangles_[t];
            const AreaVector n = area_vector(point(a), point(b), point(c));
            if ((n.x | n.y | n.z) != 0) continue;
            flat[t] = true;
            rows.push_back(between(a, b, c)   ? Triangle{a, b, c}
                           : between(b, c, a) ? Triangle{b, c, a}
                                              : Triangle{c, a, b});
        }
        for (bool more = true; more;) {
            more = false;
            for (const auto& [a, b, c] : rows) {
                std::set<std::uint32_t> all = on_side_[side_of(a, c)];
                for (const Side& half : {side_of(a, b), side_of(b, c)})
                    if (const auto found = on_side_.find(half); found != on_side_.end())
                        all.insert(found->second.begin(), found->second.end());
                all.insert(b);
                more |= put(a, c, all);
                more |= put(a, b, all);
                more |= put(b, c, all);
            }
        }
        drop(flat);
    }

    /// Those of some points in a row that lie within a side. Returns whether any is new.
    bool put(std::uint32_t a, std::uint32_t c, const std::set<std::uint32_t>& points) {
        std::set<std::uint32_t>& on = on_side_[side_of(a, c)];
        const std::size_t before = on.size();
        for (const std::uint32_t p : points)
            if (between(a, p, c)) on.insert(p);
        return on.size() > before;
    }

    /// Of points in a row.
    bool between(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return along(a, b, c) > 0 && along(c, b, a) > 0;
    }
    /// (b - a) . (c - a); differences have 27 bits.
    std::int64_t along(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const InputPoint p = point(a), q = point(b), r = point(c);
        std::int64_t sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            sum += (std::int64_t(q[axis]) - p[axis]) * (std::int64_t(r[axis]) - p[axis]);
        return sum;
    }

    void append_side(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& corners) const {
        corners.push_back(a);
        const auto found = on_side_.find(side_of(a, b));
        if (found == on_side_.end()) return;
        const std::size_t first = corners.size();
        corners.insert(corners.end(), found->second.begin(), found->second.end());
        std::sort(corners.begin() + std::ptrdiff_t(first), corners.end(),
                  [&](std::uint32_t p, std::uint32_t q) { return along(a, p, b) < along(a, q, b); });
    }

    InputPoint point(std::uint32_t number) const { return to_input(points_.point(number)); }

    PointNumbers points_;
    std::vector<Triangle> triangles_;
    std::map<Side, std::set<std::uint32_t>> on_side_;  ///< corners that came to lie within a side
};

std::string place_text(const Vec3& at) {
    const GridPoint p = *snap(at);
    return exact_decimal(p.x) + ' ' + exact_decimal(p.y) + ' ' + exact_decimal(p.z);
}

/// Of a whole level, or the reason why it bounds no solid.
Result<Solid> solid_of(const Level& level, const std::string& name) {
    const auto refuse = [&](const std::string& reason) {
        return cutter_error(name, "", ErrorCode::kInvalid,
                            reason + "; by quarter turns and at scale 1 it would be placed exactly");
    };
    if (level.faces.empty()) return refuse("encloses no volume on the grid of 1/4096 m");
    Result<Solid> made = make_solid(level);
    if (!made) return made;
    if (made.value().face_count() == level.faces.size() && !made.value().rock_outside()) return made;
    const LevelSolidity judged = level_solidity(level);
    const std::string place = judged.notes.empty() ? "" : " near " + place_text(judged.notes[0].at);
    return refuse("its facets, turned and snapped to the grid of 1/4096 m, cross or touch each other" + place);
}

}  // namespace

Result<Solid> snap_solid(const Cutter& cutter, const Pose& pose, int* mended) {
    const Result<PoseTurn> turn = judge_pose(cutter, pose);
    if (!turn) return turn.error();
    const CutterData& data = *cutter.data();
    SnappedMesh mesh;
    std::vector<std::uint32_t> number;
    for (std::size_t k = 0; k < data.vertices.size(); ++k) {
        const std::optional<GridPoint> snapped = snap(turn.value().turned(data.vertices[k]) + pose.position);
        if (!snapped) return outside_world(data.name, k);
        number.push_back(mesh.add(*snapped));
    }
    for (const auto& [a, b, c] : data.triangles) mesh.add(Triangle{number[a], number[b], number[c]});
    SnappedMesh as_snapped = mesh;
    Result<Solid> made = solid_of(as_snapped.level(data.name), data.name);
    if (made || !mended) return made;
    *mended = mesh.mend();
    return solid_of(mesh.level(data.name), data.name);
}

}  // namespace firma
