// SPDX-License-Identifier: MIT
// Reads the lumps that brushes are made of, and cuts out their faces in double.
#include <algorithm>
#include <utility>

#include "brush/bsp_planes.h"
#include "brush/parse_map.h"
#include "level/message.h"

namespace firma {
namespace {

// Ten times the most seen in fifty maps. Sides can be shared by brushes, so counts of records are no limit.
constexpr std::size_t kMostBspSides = std::size_t(1) << 20;

// Units. Compilers make the planes they add from rounded edges, so these cut off slivers of up to some tenths of a unit
// in width, yet of next to no depth.
constexpr double kNarrow = 0.5;      // a wider face is never left out
constexpr double kDepth = 1.0 / 64;  // nor one without which the brush would reach farther by more

std::optional<Error> read_planes(const BspFile& file, std::vector<FloatPlane>& planes) {
    const auto records = file.records<BspPlane>();
    planes.reserve(records.size());
    for (std::size_t k = 0; k < records.size(); ++k) {
        const auto [normal, distance] = records[k];
        FloatPlane plane{{normal[0], normal[1], normal[2]}, distance};
        if (!is_finite(plane.normal) || !is_finite(plane.distance)) {
            return file.fault(ErrorCode::kOutOfRange, BspLump::kPlanes, k, "a number is not finite");
        }
        const double size = length(plane.normal);
        if (size > 0) plane = {plane.normal * (1 / size), plane.distance / size};
        planes.push_back(plane);
    }
    return std::nullopt;
}

class BrushGatherer {
public:
    BrushGatherer(const BspFile& file, double scale) : file_(file), reach_(2 * kWorldRim / scale) {}

    std::optional<Error> gather() {
        if (auto error = read_planes(file_, out.planes)) return error;
        const auto brushes = file_.records<BspBrush>();
        for (std::size_t k = 0; k < brushes.size(); ++k)
            if (auto error = add(k, brushes[k])) return error;
        for (const BspSolid& brush : out.brushes) cut_faces(brush);
        return std::nullopt;
    }

    BspBrushes out;

private:
    std::optional<Error> add(std::size_t entry, const BspBrush& brush) {
        const auto sides = file_.records<BspBrushSide>();
        const auto fault = [&](ErrorCode code, std::string reason) {
            return file_.fault(code, BspLump::kBrushes, entry, std::move(reason));
        };
        if (const auto bad = bad_range("brush sides", brush.first_side, brush.side_count, sides.size())) {
            return fault(ErrorCode::kMalformed, *bad);
        }
        if (!in_range(brush.shader, BspLump::kShaders, BspShader::kBytes)) {
            return fault(ErrorCode::kMalformed, of("shader", brush.shader, BspLump::kShaders, BspShader::kBytes));
        }
        const auto count = std::uint32_t(brush.side_count);
        if (count > kMostBrushSides) {
            return fault(ErrorCode::kTooLarge,
                         std::to_string(count) + " sides, more than " + std::to_string(kMostBrushSides));
        }
        pairs_ += std::uint64_t(count) * count;
        if (out.sides.size() + count > kMostBspSides || pairs_ > kMostSidePairs) {
            return fault(ErrorCode::kTooLarge, "brushes have more than " + std::to_string(kMostBspSides) +
                                                   " sides, or more than 2^26 pairs of them");
        }
        out.brushes.push_back({std::uint32_t(out.sides.size()), count, std::uint32_t(brush.shader)});
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t at = std::size_t(brush.first_side) + k;
            if (auto error = add_side(at, sides[at])) return error;
        }
        return std::nullopt;
    }

    std::optional<Error> add_side(std::size_t entry, const BspBrushSide& record) {
        const auto malformed = [&](std::string reason) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kBrushSides, entry, std::move(reason));
        };
        if (!in_range(record.shader, BspLump::kShaders, BspShader::kBytes)) {
            return malformed(of("shader", record.shader, BspLump::kShaders, BspShader::kBytes));
        }
        if (!in_range(record.plane, BspLump::kPlanes, BspPlane::kBytes)) {
            return malformed(of("plane", record.plane, BspLump::kPlanes, BspPlane::kBytes));
        }
        if (out.planes[std::size_t(record.plane)].normal == Vec3{}) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kPlanes, std::size_t(record.plane),
                               "a plane without a normal is used");
        }
        BspSide side;
        side.plane = std::uint32_t(record.plane);
        side.shader = std::uint32_t(record.shader);
        out.sides.push_back(side);
        return std::nullopt;
    }

    bool in_range(std::int32_t index, BspLump which, std::size_t record) const {
        return index >= 0 && std::size_t(index) < file_.lump(which).size() / record;
    }

    std::string of(std::string_view what, std::int32_t index, BspLump which, std::size_t record) const {
        return std::string(what) + " " + std::to_string(index) + " of " +
               std::to_string(file_.lump(which).size() / record);
    }

    void cut_faces(const BspSolid& brush) {
        const std::span<BspSide> sides = std::span(out.sides).subspan(brush.first_side, brush.side_count);
        cut(sides);
        // Twice: without the planes that only touch, corners where four and more planes met are cleaner.
        if (leave_out_touching(sides)) cut(sides);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (!sides[k].bounds) continue;
            sides[k].area = area(faces_[k]);
            sides[k].first_corner = std::uint32_t(out.corners.size());
            sides[k].corner_count = std::uint32_t(faces_[k].size());
            out.corners.insert(out.corners.end(), faces_[k].begin(), faces_[k].end());
        }
    }

    // The faces of all sides that bound.
    void cut(std::span<const BspSide> sides) {
        faces_.assign(sides.size(), {});
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (sides[k].bounds) faces_[k] = face_of(sides, k, sides.size());
        }
    }

    // Of side `which`, as if side `without` were not there.
    std::vector<Vec3> face_of(std::span<const BspSide> sides, std::size_t which, std::size_t without) {
        planes_.clear();
        std::size_t at = 0;
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (!sides[k].bounds || k == without) continue;
            if (k == which) at = planes_.size();
            planes_.push_back(out.planes[sides[k].plane]);
        }
        std::vector<Vec3> corners = winding(planes_, at, reach_);
        merge_corners(corners, kSameCorner);
        if (corners.size() < 3) corners.clear();
        return corners;
    }

    bool leave_out_touching(std::span<BspSide> sides) {
        bool any = false;
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (!is_narrow(faces_[k]) || !may_try(sides.size())) continue;
            const double growth = growth_without(sides, k);
            if (growth > kDepth) continue;
            out.growth = std::max(out.growth, growth);
            sides[k].bounds = false;
            any = true;
        }
        return any;
    }

    // Each try takes as long as all faces of the brush: in a file made to hurt they come to an end.
    bool may_try(std::size_t sides) {
        tried_pairs_ += std::uint64_t(sides) * sides;
        return tried_pairs_ <= kMostSidePairs;
    }

    static bool is_narrow(const std::vector<Vec3>& face) {
        double longest = 0;
        for (const Vec3& corner : face) longest = std::max(longest, length(corner - face[0]));
        return face.size() < 3 || area(face) <= kNarrow * longest;
    }

    // How far beyond side k the brush would reach without it; nothing bounded by the others alone: not at all.
    double growth_without(std::span<const BspSide> sides, std::size_t k) {
        const FloatPlane& plane = out.planes[sides[k].plane];
        double growth = 0;
        for (std::size_t other = 0; other < sides.size(); ++other) {
            if (other == k || !sides[other].bounds) continue;
            for (const Vec3& corner : face_of(sides, other, k)) {
                growth = std::max(growth, dot(plane.normal, corner) - plane.distance);
            }
        }
        return growth;
    }

    const BspFile& file_;
    double reach_;  // units
    std::uint64_t pairs_ = 0, tried_pairs_ = 0;
    std::vector<FloatPlane> planes_;        // of the brush at hand
    std::vector<std::vector<Vec3>> faces_;  // by side
};

}  // namespace

Result<BspBrushes> gather_bsp_brushes(const BspFile& file, double scale) {
    BrushGatherer gatherer(file, scale);
    if (auto error = gatherer.gather()) return *std::move(error);
    return std::move(gatherer.out);
}

}  // namespace firma
