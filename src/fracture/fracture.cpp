// SPDX-License-Identifier: MIT
// A solid broken into pieces: the piece that is most too large is divided next, until none is or there are enough.
#include "firma/fracture.h"

#include <utility>

#include "base/random.h"
#include "body/surface_points.h"
#include "firma/chunk.h"
#include "fracture/choose_crack.h"
#include "fracture/split_solid.h"

namespace firma {
namespace {

/// Cracks tried in a piece before it stays whole.
constexpr int kTriesAPiece = 4;

std::optional<Error> judge_pattern(const FracturePattern& pattern, const FractureOptions& options) {
    const auto invalid = [](const char* reason) { return Error{ErrorCode::kInvalid, {}, reason}; };
    if (pattern.style > CrackStyle::kShards) return invalid("the pattern's style is none");
    for (int axis = 0; axis < 3; ++axis)
        if (!is_finite(pattern.size[axis]) || !(pattern.size[axis] >= 1 / 1024.0))
            return invalid("the pattern's size is not finite or below a millimetre");
    if (!is_finite(pattern.growth) || pattern.growth < 0)
        return invalid("the pattern's growth is not finite or negative");
    if (!(pattern.crooked >= 0 && pattern.crooked <= 1)) return invalid("the pattern's crooked is not within 0 to 1");
    if (pattern.axes) {
        double square = 0;
        for (const double part : *pattern.axes) square += part * part;
        if (!is_finite(square) || !(square > 0)) return invalid("the pattern's axes are zero or not finite");
    }
    if (pattern.brick_corner && !is_finite(*pattern.brick_corner))
        return invalid("the pattern's brick_corner is not finite");
    if (options.impact && !is_finite(*options.impact)) return invalid("the impact is not finite");
    if (options.max_pieces < 1 || options.max_pieces > kMaxPieces) return invalid("max_pieces is not within 1 to 4096");
    if (!is_finite(options.min_volume) || options.min_volume < 0)
        return invalid("min_volume is not finite or negative");
    if (!is_finite(options.density) || options.density < 0) return invalid("the density is not finite or negative");
    return std::nullopt;
}

/// A piece while it may still be divided.
struct Lump {
    FracturePiece piece;
    CrackCell cell;
    double excess = 0;         ///< below kWorthDividing: it stays
    std::uint64_t number = 0;  ///< in the order in which pieces came about
};

class Breaker {
public:
    Breaker(const Solid& solid, const FracturePattern& pattern, const FractureOptions& options) : options_(options) {
        const Box box = solid.bounds();
        centre_ = (box.low + box.high) * 0.5;
        // A little more than the corners: cracks are snapped to the grid.
        radius_ = length(box.high - box.low) * 0.5 + 1.0 / 64;
        field_.pattern = pattern;
        const Quaternion axes = pattern.axes ? normalised(*pattern.axes) : fracture_axes(solid, pattern.style);
        frame_ = matrix_of(axes);
        field_.hit = options.impact.has_value();
        add_bodies(solid, {});
        Box around;
        for (const Lump& lump : lumps_) around.add(lump.cell.low), around.add(lump.cell.high);
        field_.impact = options.impact ? frame_.back(*options.impact) : (around.low + around.high) * 0.5;
        field_.brick_corner = pattern.brick_corner ? frame_.back(*pattern.brick_corner) : around.low;
        for (Lump& lump : lumps_) set_excess(lump);
    }

    /// Whether its cracks stay within the world.
    bool fits() const {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 normal;
            normal[axis] = 1;
            if (!crack_plane(centre_, normal, centre_, radius_ * 2)) return false;
        }
        return true;
    }

    Fracture run() {
        while (lumps_.size() < options_.max_pieces) {
            const std::size_t worst = most_excessive();
            if (worst == lumps_.size()) break;
            if (!divide(worst)) lumps_[worst].excess = 0;
        }
        for (Lump& lump : lumps_) result_.pieces.push_back(std::move(lump.piece));
        return std::move(result_);
    }

private:
    /// Puts the bodies of a solid at the end.
    void add_bodies(const Solid& solid, const CrackSector& sector) {
        for (Solid& body : connected_pieces(solid)) {
            Lump lump;
            lump.cell.sector = sector;
            for (const Vec3& corner : corners_of(triangles_of(body))) lump.cell.corners.push_back(frame_.back(corner));
            if (lump.cell.corners.empty()) lump.cell.corners.push_back({});
            measure_cell(lump.cell);
            lump.piece.mass = mass_properties(body, options_.density);
            lump.piece.solid = std::move(body);
            lump.number = next_number_++;
            lumps_.push_back(std::move(lump));
        }
    }

    void set_excess(Lump& lump) const {
        const bool small = lump.piece.mass.volume < options_.min_volume;
        lump.excess = small ? 0 : excess_of(field_, lump.cell);
    }

    /// @return their number where none wants to be divided
    std::size_t most_excessive() const {
        std::size_t worst = lumps_.size();
        double most = kWorthDividing;
        for (std::size_t k = 0; k < lumps_.size(); ++k) {
            const double excess = lumps_[k].excess;
            if (excess > most || (excess == most && worst == lumps_.size())) most = excess, worst = k;
        }
        return worst;
    }

    /// The first part takes the place of the whole, others come to the end.
    bool divide(std::size_t which) {
        for (std::uint64_t tried = 0; tried < kTriesAPiece; ++tried) {
            const std::uint64_t seed = mix_bits(mix_bits(options_.seed + lumps_[which].number) + tried);
            const std::optional<CrackChoice> crack = choose_crack(field_, lumps_[which].cell, seed);
            if (!crack) return false;
            const auto plane = crack_plane(frame_ * crack->point, frame_ * crack->normal, centre_, radius_);
            if (!plane) continue;
            const SolidHalves halves = split_solid(lumps_[which].piece.solid, *plane, options_.material);
            if (halves.outcome == SolidHalves::Outcome::kRefused && result_.refused++ == 0)
                result_.refusal = halves.error;
            if (halves.outcome != SolidHalves::Outcome::kSplit) continue;
            ++result_.cracks;
            const std::size_t first = lumps_.size();
            add_bodies(halves.front, crack->in_front);
            add_bodies(halves.back, crack->behind);
            for (std::size_t k = first; k < lumps_.size(); ++k) set_excess(lumps_[k]);
            lumps_[which] = std::move(lumps_.back());
            lumps_.pop_back();
            return true;
        }
        return false;
    }

    const FractureOptions& options_;
    CrackField field_;
    TurnMatrix frame_;  ///< of the pattern's axes
    Vec3 centre_;
    double radius_ = 0;
    std::vector<Lump> lumps_;
    std::uint64_t next_number_ = 0;
    Fracture result_;
};

}  // namespace

Result<Fracture> fracture(const Solid& solid, const FracturePattern& pattern, const FractureOptions& options) {
    if (solid.face_count() == 0) return Error{ErrorCode::kInvalid, {}, "a solid without faces has no pieces"};
    if (solid.rock_outside()) return Error{ErrorCode::kInvalid, {}, "rock that reaches to infinity has no pieces"};
    if (auto error = judge_pattern(pattern, options)) return *std::move(error);
    Breaker breaker(solid, pattern, options);
    if (!breaker.fits()) return Error{ErrorCode::kOutOfRange, {}, "the solid is too large or too near the world's rim"};
    Fracture result = breaker.run();
    if (result.cracks == 0 && result.refused > 0) return result.refusal;
    return result;
}

}  // namespace firma
