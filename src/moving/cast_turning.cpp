// SPDX-License-Identifier: MIT
// A mover against a part that turns: pieces of time, in each the faces near the way, of each the first touch.
#include "moving/cast_turning.h"

#include "moving/touch_turning.h"
#include "world/invalid_hit.h"

namespace firma {
namespace {

/// Radians: boxes around ways are not made of larger turns.
constexpr double kPieceTurn = 0.5;
/// With no more faces than this near its way a piece is not divided further.
constexpr int kFewFaces = 8;
constexpr int kMaxHalvings = 7;
/// Steps of a cast: more are never needed but for numbers that make no sense, such as a capsule longer than the world.
/// What is left then counts as met.
constexpr std::int64_t kSpareSteps = 200'000, kStepsAFace = 64;
/// Rounding, metres: of places up to kMaxPartReach away. Far below what kPartTouch leaves.
constexpr double kPlaceRounding = 1e-6;

/// The fractions at which a ball, that goes straight, reaches into a ball around the origin.
struct TimeInReach {
    double from = 0, to = -1;  ///< to < from: never

    TimeInReach(const Vec3& start, const Vec3& path, double reach, double latest) {
        const double square = dot(path, path);
        const double nearest = square > 0 ? -dot(start, path) / square : 0;
        const Vec3 at = start + path * nearest;
        const double spare = reach * reach - dot(at, at);
        if (!(spare >= 0)) return;
        const double half = square > 0 ? std::sqrt(spare / square) : 0;
        from = square > 0 && nearest - half > 0 ? nearest - half : 0;
        to = square > 0 && nearest + half < latest ? nearest + half : latest;
    }
};

class TurningCast {
public:
    TurningCast(const PartNow& part, const TurningShape& shape, const CastOptions& options)
        : part_(part), shape_(shape), options_(options) {}

    /// @param first  replaced by a touch between two times; kept where none is earlier
    void between(double from, double to, int halvings, TurningTouch& first, FaceInfo& which) const {
        const double bend = shape_.bend(from, to);
        const Box box = box_of_way(from, to, bend);
        const int near = count_faces(box);
        if (near == 0) return;
        const bool large = shape_.angle * (to - from) > kPieceTurn;
        if ((large || near > kFewFaces) && halvings < kMaxHalvings) {
            const double middle = (from + to) * 0.5;
            between(from, middle, halvings + 1, first, which);
            if (!first.found) between(middle, to, halvings + 1, first, which);
            return;
        }
        each_face(part_.world(), box, [&](const FaceView& face) {
            if (face.mask & options_.mask) touch(face, from, to, bend, first, which);
            return true;
        });
    }

private:
    /// Around all places of the shape, and what is in touch with it.
    Box box_of_way(double from, double to, double bend) const {
        Box box;
        for (const double t : {from, to}) {
            const ShapeAt there(shape_, t);
            for (const Vec3& corner : there.corners()) box.add(corner);
        }
        // Between its ends an arc is off its chord by no more than |y''| (t1 - t0)^2 / 8.
        const double bulge = bend * (to - from) * (to - from) * (1.0 / 8);
        const double more = bulge + shape_.radius + 2 * kPartTouch + kPlaceRounding;
        box.low = box.low - Vec3{more, more, more};
        box.high = box.high + Vec3{more, more, more};
        return box;
    }

    /// More than kFewFaces: not all are counted.
    int count_faces(const Box& box) const {
        int count = 0;
        each_face(part_.world(), box, [&](const FaceView& face) {
            if (face.mask & options_.mask) ++count;
            return count <= kFewFaces;
        });
        return count;
    }

    void touch(const FaceView& face, double from, double to, double bend, TurningTouch& first, FaceInfo& which) const {
        if (options_.counts) ++options_.counts->faces;
        const bool two_sided = face.two_sided || options_.sides == Sides::kBoth;
        const double until = first.found && first.time < to ? first.time : to;
        steps_ += kStepsAFace;
        const TurningTouch found =
            touch_turning(shape_, make_shape(face.corners), two_sided, from, until, bend, steps_);
        if (!found.found) return;
        if (first.found && !(found.time < first.time || (found.time == first.time && face.id < which.id))) return;
        first = found;
        which = face;
    }

    const PartNow& part_;
    const TurningShape& shape_;
    const CastOptions& options_;
    mutable std::int64_t steps_ = kSpareSteps;  ///< that may still be made
};

/// What a touch says in the world.
Hit hit_of(const PartNow& part, const MoverCore& mover, const Vec3& path, const TurningTouch& found,
           const FaceInfo& face, const CastOptions& options) {
    Hit hit;
    const PartFrame frame(part.motion, found.time);
    hit.status = found.time > 0 ? Status::kHit : Status::kInitialOverlap;
    hit.fraction = found.time;
    hit.face = face.ref();
    hit.material = face.material;
    // Anew, as no outline outlives a visit: the one face of this id whose box holds its corner.
    const Vec3 corner = to_metres(face.corner);
    each_face(part.world(), Box{corner, corner}, [&](const FaceView& view) {
        if (view.id != face.id) return true;
        const ClosestPoint near = closest_point(found.point, view.corners);
        hit.point = frame.out(near.point);
        hit.feature = near.feature;
        hit.feature_index = near.feature_index;
        return false;
    });
    hit.centre = mover.middle + path * found.time;
    // Within the face the way from there is the plane's normal, without what is lost between points so near.
    const double side = dot(found.normal, face.normal) < 0 ? -1 : 1;
    hit.normal = frame.direction_out(hit.feature == Feature::kFace ? face.normal * side : found.normal);
    hit.face_normal = frame.direction_out(face.normal);
    const double offset = options.contact_offset < 0 ? part.world().tolerance().contact_offset : options.contact_offset;
    const double back = found.speed < 0 ? offset / -found.speed : 1;
    hit.safe_fraction = back < hit.fraction ? hit.fraction - back : 0;
    return hit;
}

double far_corner(const Box& box) {
    const Vec3 far{std::fmax(-box.low.x, box.high.x), std::fmax(-box.low.y, box.high.y),
                   std::fmax(-box.low.z, box.high.z)};
    return length(far);
}

}  // namespace

Hit cast_turning(const PartNow& part, const MoverCore& mover, const Vec3& path, double latest,
                 const CastOptions& options) {
    const Vec3 start = mover.middle - part.motion.position, way = path - part.motion.path;
    if (!(max_abs(start) <= kMaxPartReach) || !(max_abs(way) <= kMaxPartReach) || !(mover.reach <= kMaxPartReach))
        return invalid_hit(mover.middle);
    Hit none;
    none.centre = mover.middle + path;
    if (part.bounds().empty()) return none;
    const double reach = far_corner(part.bounds()) + mover.reach + 4 * kPartTouch;
    const TimeInReach time(start, way, reach * (1 + 0x1p-30), latest);
    if (!(time.from <= time.to)) return none;
    const TurningShape shape(part.motion, mover.corner.all(), mover.radius, path);
    TurningTouch first;
    FaceInfo which;
    TurningCast(part, shape, options).between(time.from, time.to, 0, first, which);
    return first.found ? hit_of(part, mover, path, first, which, options) : none;
}

}  // namespace firma
