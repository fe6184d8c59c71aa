// SPDX-License-Identifier: MIT
// Compares each face as written with the same face on the grid, both judged exactly; in double where that is certain.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "geometry/judge_outline.h"
#include "geometry/polygon_shape.h"
#include "level/check_mesh_parts.h"
#include "level/divide_polygon.h"
#include "level/exact_points.h"

namespace firma {
namespace {

using GridJudge = OutlineJudge<std::int64_t, Int128, std::span<const GridPoint>>;

/// A face as written.
struct WrittenFace {
    bool has_area = false;
    bool flat_and_convex = false;
    bool turned = false;  ///< its normal points away from the snapped face's
};

template <class Coord, class Wide, class Point>
WrittenFace judge_exactly(std::span<const Point> outline, const GridJudge::Normal& snapped_normal) {
    const OutlineJudge<Coord, Wide, std::span<const Point>> judge(outline);
    const OutlineForm form = judge.form();
    WrittenFace face;
    face.has_area = form != OutlineForm::kNoArea;
    face.flat_and_convex = form == OutlineForm::kConvex;
    BigInt dot = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) dot += BigInt(judge.normal()[axis]) * BigInt(snapped_normal[axis]);
    face.turned = dot < 0;
    return face;
}

/// A corner twice in a row, and two sides that run back over each other, enclose nothing. Whether without them no
/// outline is left.
bool collapses(std::span<const std::uint32_t> positions) {
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t position : positions) {
        if (!kept.empty() && kept.back() == position) continue;
        if (kept.size() >= 2 && kept[kept.size() - 2] == position) {
            kept.pop_back();
        } else {
            kept.push_back(position);
        }
    }
    // The same where the end meets the beginning.
    std::size_t begin = 0, end = kept.size();
    while (end - begin >= 3) {
        if (kept[end - 1] == kept[begin] || kept[end - 2] == kept[begin]) {
            --end;
        } else if (kept[end - 1] == kept[begin + 1]) {
            ++begin;
        } else {
            return false;
        }
    }
    return true;
}

class FaceChecker {
public:
    FaceChecker(const ExactMesh& mesh, const WeldedPositions& welded) : mesh_(mesh), welded_(welded) {}

    std::vector<MeshNotePlace> notes() {
        for (const ExactMesh::Face& face : mesh_.faces) check(face);
        return std::move(notes_);
    }

private:
    void check(const ExactMesh::Face& face);
    WrittenFace judge(std::span<const std::uint32_t> vertices, const GridJudge::Normal& snapped_normal);
    bool certain(std::span<const std::uint32_t> vertices, const GridJudge::Normal& snapped_normal) const;

    const ExactMesh& mesh_;
    const WeldedPositions& welded_;
    std::vector<MeshNotePlace> notes_;
    std::vector<GridPoint> outline_;
    std::vector<SmallPoint> small_;
    std::vector<BigPoint> big_;
};

void FaceChecker::check(const ExactMesh::Face& face) {
    const auto vertices = std::span(mesh_.corners).subspan(face.first_corner, face.corner_count);
    outline_.clear();
    for (const std::uint32_t vertex : vertices) outline_.push_back(mesh_.snapped[vertex]);
    const GridJudge::Normal normal = GridJudge(outline_).normal();
    const Division::What what = divide_polygon(outline_).what;
    if (what == Division::What::kWhole && certain(vertices, normal)) return;

    const WrittenFace written = judge(vertices, normal);
    const auto note = [&](MeshNote which) {
        notes_.push_back({which, face.source, face.line, mesh_.nearest[vertices[0]]});
    };
    const auto positions = std::span(welded_.of_corner).subspan(face.first_corner, face.corner_count);
    if (!written.has_area || collapses(positions)) {
        note(MeshNote::kNoArea);
    } else if (what == Division::What::kNoArea) {
        note(MeshNote::kDropped);
    } else if (what != Division::What::kWhole) {
        const bool bent = written.flat_and_convex && vertices.size() <= std::size_t(kMaxCorners);
        note(bent ? MeshNote::kBent : MeshNote::kDivided);
    }
    if (written.turned) note(MeshNote::kTurned);
}

/// Exactly, by the narrowest numbers that hold what OutlineJudge needs.
WrittenFace FaceChecker::judge(std::span<const std::uint32_t> vertices, const GridJudge::Normal& snapped_normal) {
    if (!to_small_points(mesh_, vertices, small_)) {
        to_big_points(mesh_, vertices, big_);
        return judge_exactly<BigInt, BigInt, BigPoint>(big_, snapped_normal);
    }
    const int bits = 3 * (bits_of(small_) + 1) + int(std::bit_width(6 * vertices.size())) + 1;
    if (bits <= 127) return judge_exactly<std::int64_t, Int128, SmallPoint>(small_, snapped_normal);
    return judge_exactly<std::int64_t, BoostInt256, SmallPoint>(small_, snapped_normal);
}

/// Whether doubles leave no doubt that a face has area as written and is not turned.
bool FaceChecker::certain(std::span<const std::uint32_t> vertices, const GridJudge::Normal& snapped_normal) const {
    const Vec3& first = mesh_.nearest[vertices[0]];
    double size = 0;
    Vec3 normal;
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        const Vec3 a = mesh_.nearest[vertices[k]] - first, b = mesh_.nearest[vertices[k + 1]] - first;
        normal = normal + cross(a, b);
        size = std::max({size, max_abs(a), max_abs(b)});
    }
    const double rim = max_abs(first) + size;
    if (!(rim >= 1e-100 && rim <= 1e100)) return false;
    // A difference is off by at most 2^-51 rim, a product of two by 2^-50 rim size and a little: six of them a corner.
    const double error = 0x1p-44 * rim * size * double(vertices.size());
    const Vec3 snapped{double(snapped_normal[0]), double(snapped_normal[1]), double(snapped_normal[2])};
    return dot(normal, snapped) > 4 * error * max_abs(snapped);
}

}  // namespace

std::vector<MeshNotePlace> check_faces(const ExactMesh& mesh, const WeldedPositions& welded) {
    return FaceChecker(mesh, welded).notes();
}

}  // namespace firma
