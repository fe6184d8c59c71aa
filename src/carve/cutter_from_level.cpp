// SPDX-License-Identifier: MIT
// A cutter from a level file: corners are welded by position, convex faces become triangles with area.
#include <string>
#include <utility>
#include <vector>

#include "base/sort.h"
#include "carve/level_triangles.h"
#include "firma/cutter.h"
#include "geometry/exact_integer.h"

namespace firma {
namespace {

/// Of a LevelFace.
constexpr std::uint32_t kMostCorners = 64;

/// Whether three points lie on one line. Differences have 33 bits.
bool collinear(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    for (int u = 0; u < 3; ++u) {
        const int v = u == 2 ? 0 : u + 1;
        const auto part = [](std::int32_t from, std::int32_t to) { return std::int64_t(to) - from; };
        if (Int128(part(a[u], b[u])) * part(a[v], c[v]) != Int128(part(a[v], b[v])) * part(a[u], c[u])) return false;
    }
    return true;
}

class LevelMesh {
public:
    explicit LevelMesh(const Level& level) : level_(level) {}

    std::optional<Error> build() {
        std::uint64_t triangle_count = 0;
        for (const LevelFace& face : level_.faces) {
            if (face.corner_count < 3 || face.corner_count > kMostCorners ||
                face.first_corner > level_.corners.size() ||
                face.corner_count > level_.corners.size() - face.first_corner)
                return error(face, ErrorCode::kMalformed, "names corners that are not there, or not 3 to 64 of them");
            triangle_count += face.corner_count - 2;
        }
        if (triangle_count > kMaxCutterTriangles)
            return Error{ErrorCode::kTooLarge, level_.name,
                         std::to_string(triangle_count) + " triangles; a cutter has at most " +
                             std::to_string(kMaxCutterTriangles)};
        weld();
        made_.triangles.reserve(triangle_count);
        for (const LevelFace& face : level_.faces)
            if (auto fault = divide(face)) return fault;
        return std::nullopt;
    }

    LevelTriangles take() { return std::move(made_); }

private:
    Error error(const LevelFace& face, ErrorCode code, std::string reason) const {
        return {code, level_.name + ": face " + std::to_string(face.source), std::move(reason)};
    }

    /// Each vertex gets the number of the first one at its position.
    void weld() {
        std::vector<std::uint32_t> order(level_.vertices.size());
        for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
        sort_range(order, [&](std::uint32_t a, std::uint32_t b) {
            const auto by_position = level_.vertices[a] <=> level_.vertices[b];
            return by_position != 0 ? by_position < 0 : a < b;
        });
        welded_.resize(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            const bool same = k > 0 && level_.vertices[order[k]] == level_.vertices[order[k - 1]];
            welded_[order[k]] = same ? welded_[order[k - 1]] : order[k];
        }
        for (const GridPoint& v : level_.vertices) made_.vertices.push_back(to_metres(v));
    }

    const GridPoint& at(std::uint32_t vertex) const { return level_.vertices[vertex]; }

    bool has_area(const std::vector<std::uint32_t>& outline) const {
        for (std::size_t k = 2; k < outline.size(); ++k)
            if (!collinear(at(outline[0]), at(outline[k - 1]), at(outline[k]))) return true;
        return false;
    }

    /// Cuts corners off a convex outline that may have corners along its sides: such a corner is none to cut off, nor
    /// is one whose loss would leave the others on a line.
    std::optional<Error> divide(const LevelFace& face) {
        std::vector<std::uint32_t> outline;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const std::uint32_t vertex = level_.corners[face.first_corner + k];
            if (vertex >= welded_.size()) return error(face, ErrorCode::kMalformed, "names a vertex that is not there");
            outline.push_back(welded_[vertex]);
        }
        std::size_t k = 1, tries = 0;
        while (outline.size() > 3 && tries < outline.size()) {
            const std::size_t n = outline.size();
            k %= n;
            const std::uint32_t before = outline[(k + n - 1) % n], corner = outline[k], after = outline[(k + 1) % n];
            bool ear = !collinear(at(before), at(corner), at(after));
            if (ear) {
                outline.erase(outline.begin() + std::ptrdiff_t(k));
                ear = has_area(outline);
                if (!ear) outline.insert(outline.begin() + std::ptrdiff_t(k), corner);
            }
            if (ear) {
                made_.triangles.push_back({before, corner, after});
                tries = 0;  // k is the next corner now
            } else {
                ++k;
                ++tries;
            }
        }
        if (outline.size() > 3 || !has_area(outline)) return error(face, ErrorCode::kMalformed, "has no area");
        made_.triangles.push_back({outline[0], outline[1], outline[2]});
        return std::nullopt;
    }

    const Level& level_;
    LevelTriangles made_;
    std::vector<std::uint32_t> welded_;
};

}  // namespace

Result<LevelTriangles> level_triangles(const Level& level) {
    LevelMesh mesh(level);
    if (auto error = mesh.build()) return std::move(*error);
    return mesh.take();
}

Result<Cutter> cutter_from_level(const Level& level) {
    const Result<LevelTriangles> mesh = level_triangles(level);
    if (!mesh) return mesh.error();
    return make_cutter(mesh.value().vertices, mesh.value().triangles, level.name);
}

}  // namespace firma
