// SPDX-License-Identifier: MIT
// A solid divided until all is convex, or near enough; then pieces that are convex together become one.
#include "firma/convex_pieces.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/sort.h"
#include "convex/choose_plane.h"
#include "convex/convex_output.h"
#include "convex/overhang.h"

namespace firma {
namespace {

/// As many times as many parts as pieces are asked for may be on the way: some are merged at the end.
constexpr std::size_t kPartsAPiece = 4;

Error invalid(const char* reason) {
    return {ErrorCode::kInvalid, {}, reason};
}

const char* const kCrossing = "the solid's surface crosses itself, or has faces without area";

std::optional<Error> judge_convex_options(const ConvexOptions& options) {
    if (options.max_pieces < 1 || options.max_pieces > kMaxConvexPieces)
        return invalid("max_pieces is not within 1 to 16384");
    if (!is_finite(options.max_concavity) || options.max_concavity < 0)
        return invalid("max_concavity is not finite or negative");
    if (options.max_concavity > 0 && options.max_concavity < 1e-4)
        return invalid("max_concavity is below a tenth of a millimetre: 0 makes all pieces convex");
    if (!is_finite(options.density) || options.density < 0) return invalid("the density is not finite or negative");
    return std::nullopt;
}

class ConvexDivider {
public:
    explicit ConvexDivider(const ConvexOptions& options) : options_(options) {}

    Result<ConvexPieces> run(const Solid& solid) {
        FaceSides sides;
        if (!sides_of_solid(space_, solid, sides)) return invalid(kCrossing);
        straighten_sides(space_, sides);
        SolidSides whole;
        if (!pair_sides(space_, sides, whole)) return invalid(kCrossing);
        result_.reflex_edges = count_reflex(whole);
        std::uint32_t count = 0;
        const std::vector<std::uint32_t> part = parts_of_sides(space_, whole, count);
        todo_.resize(count);
        for (std::size_t k = 0; k < whole.size(); ++k) todo_[part[k]].push_back(whole.sides[k]);
        std::reverse(todo_.begin(), todo_.end());
        while (!todo_.empty()) {
            if (todo_.size() + shapes_.size() + hulls_.size() > options_.max_pieces * kPartsAPiece) return too_many();
            const FaceSides next = std::move(todo_.back());
            todo_.pop_back();
            if (!take(next)) return invalid(kCrossing);
        }
        result_.merged = merge_convex(space_, shapes_);
        if (shapes_.size() + hulls_.size() > options_.max_pieces) return too_many();
        return write();
    }

private:
    static Result<ConvexPieces> make_error(ErrorCode code, std::string reason) {
        return Error{code, {}, std::move(reason)};
    }

    Result<ConvexPieces> too_many() const {
        return make_error(ErrorCode::kTooLarge, "takes more than max_pieces (" + std::to_string(options_.max_pieces) +
                                                    ") convex pieces, of " + std::to_string(result_.reflex_edges) +
                                                    " reflex edges; max_concavity makes fewer");
    }

    bool take(const FaceSides& sides) {
        SolidSides solid;
        if (!pair_sides(space_, sides, solid)) return false;
        if (count_reflex(solid) == 0) return keep_convex(solid);
        ReflexWeights weights(solid.size(), 0);
        for (std::size_t k = 0; k < solid.size(); ++k) weights[k] = solid.bend[k] < 0;
        if (options_.max_concavity > 0) {
            GridHull hull = hull_of(corners_of_sides(space_, solid.sides));
            const std::optional<double> overhang =
                overhang_within(SidesDistance(space_, solid), hull, options_.max_concavity);
            if (overhang) {
                hulls_.push_back({std::move(solid), std::move(hull), *overhang, number_++});
                return true;
            }
            weigh(solid, hull, weights);
        }
        std::vector<FaceSides> parts;
        if (!divide_best(space_, solid, weights, parts)) return false;
        ++result_.cuts;
        for (std::size_t k = parts.size(); k-- > 0;) todo_.push_back(std::move(parts[k]));
        return true;
    }

    /// All edges are convex: so it is, unless it is several.
    bool keep_convex(const SolidSides& solid) {
        std::vector<PlaneId> planes;
        std::vector<std::uint32_t> points;
        for (const FaceSide& side : solid.sides) {
            planes.push_back(side.plane);
            points.push_back(side.from);
        }
        sort_once(planes);
        sort_once(points);
        for (const PlaneId plane : planes)
            for (const std::uint32_t point : points)
                if (space_.tables.points.side(plane, point) > 0) return false;
        ConvexShape shape;
        if (!make_convex_shape(space_, std::move(planes), shape)) return false;
        shape.number = number_++;
        shapes_.push_back(std::move(shape));
        return true;
    }

    /// By how deep under the hull an edge lies: dividing there makes hulls fit.
    void weigh(const SolidSides& solid, const GridHull& hull, ReflexWeights& weights) const {
        for (std::size_t k = 0; k < solid.size(); ++k) {
            if (solid.bend[k] >= 0) continue;
            const Vec3 a = to_metres(space_.point(solid.sides[k].from).rounded());
            const Vec3 b = to_metres(space_.point(solid.sides[k].to).rounded());
            double most = 0;
            for (const Vec3& at : {a, (a + b) * 0.5, b}) {
                double depth = options_.max_concavity * 64;
                for (const GridHull::Triangle& triangle : hull.triangles)
                    depth = std::min(depth, triangle.offset - dot(triangle.normal, at));
                most = std::max(most, depth);
            }
            weights[k] = most / options_.max_concavity;
        }
    }

    Result<ConvexPieces> write() {
        // In the order in which they came about, whatever they are.
        std::vector<std::pair<std::uint32_t, ConvexBody>> bodies;
        for (const ConvexShape& shape : shapes_) {
            std::optional<ConvexBody> body = piece_of_shape(space_, shape, options_.density);
            if (!body) return invalid(kCrossing);
            bodies.emplace_back(shape.number, *std::move(body));
        }
        for (const HullPart& part : hulls_)
            bodies.emplace_back(part.number,
                                piece_of_hull(space_, part.solid, part.hull, part.overhang, options_.density));
        std::sort(bodies.begin(), bodies.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (auto& [number, body] : bodies) result_.pieces.push_back(std::move(body));
        result_.exact = shapes_.size();
        return std::move(result_);
    }

    struct HullPart {
        SolidSides solid;
        GridHull hull;
        double overhang = 0;
        std::uint32_t number = 0;
    };

    const ConvexOptions options_;
    ConvexSpace space_;
    ConvexPieces result_;
    std::vector<FaceSides> todo_;
    std::vector<ConvexShape> shapes_;
    std::vector<HullPart> hulls_;
    std::uint32_t number_ = 0;
};

}  // namespace

Result<ConvexPieces> convex_pieces(const Solid& solid, const ConvexOptions& options) {
    if (solid.face_count() == 0) return invalid("a solid without faces has no pieces");
    if (solid.rock_outside()) return invalid("rock that reaches to infinity has no pieces");
    if (auto error = judge_convex_options(options)) return *std::move(error);
    return ConvexDivider(options).run(solid);
}

}  // namespace firma
