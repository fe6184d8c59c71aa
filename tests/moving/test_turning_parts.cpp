// SPDX-License-Identifier: MIT
// Casts against parts that turn: never late and hardly early, beside poses sampled finely; doors, blades, platforms.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/rooms.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;

/// A mover that can be made thicker or thinner.
class Shape {
public:
    enum Kind { kParticle, kSphere, kCapsule, kBox, kNeedle, kTetrahedron, kKinds };

    Shape(Kind kind, Rng& rng) : kind_(kind), axis_(test::random_vector(rng, 0.05, 0.6)) {
        if (kind == kSphere || kind == kCapsule) radius_ = rng.uniform(0.01, 0.5);
    }

    PartHit cast_in(const Scene& scene, const Vec3& at, const Vec3& path) const {
        if (is_hull()) return cast(scene, hull(0), at, path);
        if (kind_ == kCapsule) return cast(scene, Capsule{at - axis_, at + axis_, radius_}, path);
        return cast(scene, Sphere{at, radius_}, path);
    }
    /// Whether it meets the part at a fraction when it is thicker by `more` metres.
    bool meets(const Scene& scene, const Vec3& at, double fraction, double more) const {
        const auto found = [](const PartOverlap&) { return false; };
        const double radius = radius_ + more;
        if (is_hull()) return overlap_each(scene, hull(more), at, found, fraction) != Status::kMiss;
        if (radius < 0) return false;
        if (kind_ == kCapsule)
            return overlap_each(scene, Capsule{at - axis_, at + axis_, radius}, found, fraction) != Status::kMiss;
        return overlap_each(scene, Sphere{at, radius}, found, fraction) != Status::kMiss;
    }

private:
    bool is_hull() const { return kind_ > kCapsule; }
    Hull hull(double more) const {
        if (kind_ == kBox) return make_box({0.3 + more, 0.2 + more, 0.4 + more}).value();
        if (kind_ == kNeedle) return make_box({0.5 + more, 0.001 + more, 0.002 + more}).value();
        // Planes at equal distances from the middle: farther out by `more` it is larger by that share of it.
        const double size = 0.4 * (1 + more / (0.4 / std::sqrt(3.0)));
        const Vec3 corners[] = {{size, size, size}, {size, -size, -size}, {-size, size, -size}, {-size, -size, size}};
        return make_hull(corners).value();
    }

    Kind kind_;
    Vec3 axis_;
    double radius_ = 0;
};

struct Judged {
    std::size_t hits = 0, misses = 0, late = 0, early = 0;
};

/// Casts that start clear of the part, against samples of where both are.
void judge_turning(Shape::Kind kind, double turn, int count, Judged& judged) {
    const World empty, solid = test::cross_world();
    Rng rng(100 + std::uint64_t(kind));
    for (int made = 0; made < count;) {
        const Shape shape(kind, rng);
        RigidMotion motion = test::random_motion(rng, 2, 0);
        motion.turn = rng.direction() * turn;
        const MovingPart part(solid, motion);
        const Scene scene{empty, {&part, 1}};
        const Vec3 at = test::random_vector(rng, 0, 2.5);
        const Vec3 path = made % 4 ? test::random_vector(rng, 0, 3) : Vec3{};
        const Pose pose = pose_at(motion, 0);
        const Vec3 there = matrix_of(pose.rotation).back(at - pose.position);
        if (shape.meets(scene, at, 0, 2 * kPartTouch) || locate(solid, there).where != Where::kAir) continue;
        ++made;
        const PartHit hit = shape.cast_in(scene, at, path);
        ASSERT_NE(hit.status, Status::kInvalid);
        const double end = hit.touched() ? hit.fraction : 1;
        constexpr int kSamples = 150;
        bool late = false;
        for (int k = 0; k <= kSamples && !late; ++k) {
            const double t = end * k / kSamples;
            late = shape.meets(scene, at + path * t, t, -1e-7);
        }
        judged.late += late;
        judged.hits += hit.touched();
        judged.misses += !hit.touched();
        if (!hit.touched()) continue;
        judged.early += !shape.meets(scene, at + path * end, end, kPartTouch + 1e-8);
        EXPECT_EQ(hit.status, Status::kHit);
        EXPECT_EQ(hit.part, 0u);
        EXPECT_LT(length(hit.centre - (at + path * end)), 1e-12);
        EXPECT_NEAR(length(hit.normal), 1, 1e-9);
        EXPECT_EQ(hit.surface_velocity, velocity_at(motion, end, hit.point));
        EXPECT_LE(hit.safe_fraction, hit.fraction);
        const PartNear on = closest(scene, hit.point, 1, end);
        EXPECT_LT(on.distance, 1e-9);
        EXPECT_TRUE(solid.face_info(hit.face));
    }
}

class TurningParts : public testing::TestWithParam<int> {};

TEST_P(TurningParts, AreMetNeverLateAndHardlyEarly) {
    constexpr int kCasts = 150;
    std::size_t hits = 0, misses = 0;
    for (const double turn : {0.02, 0.5, 3.0, 8.0}) {
        Judged judged;
        judge_turning(Shape::Kind(GetParam()), turn, test::sample(kCasts), judged);
        EXPECT_EQ(judged.late, 0u) << "turn " << turn;
        EXPECT_EQ(judged.early, 0u) << "turn " << turn;
        hits += judged.hits;
        misses += judged.misses;
        if (test::sample(kCasts) < kCasts) continue;  // of a fifth one turn may have few
        EXPECT_GT(judged.hits, 10u) << "turn " << turn;
        EXPECT_GT(judged.misses, 15u) << "turn " << turn;
    }
    EXPECT_GT(hits, std::size_t(test::sample(60)));
    EXPECT_GT(misses, std::size_t(test::sample(400)));
}

INSTANTIATE_TEST_SUITE_P(Shapes, TurningParts, testing::Range(0, int(Shape::kKinds)));

/// A leaf that swings into a ball: the angle at which its plane reaches it is known.
TEST(TurningPart, DoorSwingsIntoAStandingBall) {
    const World empty;
    RigidMotion swing;
    swing.turn = {0, 0, 2};
    const MovingPart door(test::leaf_world(), swing);
    const Scene scene{empty, {&door, 1}};
    const double far = 0.7, radius = 0.2, bearing = 1.2;
    const Vec3 centre{far * std::cos(bearing), far * std::sin(bearing), 1};
    const double angle = bearing - std::asin((radius + 0.0625) / far);
    const PartHit hit = cast(scene, Sphere{centre, radius}, {});
    ASSERT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.feature, Feature::kFace);
    const double along = far * std::cos(bearing - angle);  // the touch is so far from the hinge
    EXPECT_LE(hit.fraction, angle / 2);
    EXPECT_GE(hit.fraction, angle / 2 - kPartTouch / (2 * along) * 1.01);
    const double turned = 2 * hit.fraction;
    EXPECT_LT(length(hit.normal - Vec3{-std::sin(turned), std::cos(turned), 0}), 1e-12);
    EXPECT_LT(length(hit.surface_velocity - cross(Vec3{0, 0, 2}, hit.point)), 1e-12);
    EXPECT_NEAR(length(hit.point - centre), radius, kPartTouch + 1e-12);
    EXPECT_NEAR(hit.fraction - hit.safe_fraction, 0.001 / (2 * along), 1e-6);
    // Opening the other way it never comes.
    MovingPart away = door;
    away.motion.turn = {0, 0, -2};
    EXPECT_FALSE(cast(Scene{empty, {&away, 1}}, Sphere{centre, radius}, {}));
    // What flees ahead of the leaf is not met.
    EXPECT_FALSE(cast(scene, Sphere{centre, radius}, {-4, 0, 0}));
}

/// Feet, exactly on a turntable or a little above, stay as they are while it turns beneath them.
TEST(TurningPart, TurntableLeavesWhatStandsOnIt) {
    const World empty;
    RigidMotion motion;
    motion.position = {0.5, 0, 0};
    const World slab = test::box_world({-4, -4, -1}, {4, 4, 0});
    for (const double turn : {0.05, -0.3, 2.0}) {
        motion.turn = {0, 0, turn};
        for (const Quaternion& rotation :
             {Quaternion{0, 0, 0, 1}, turn_by({0, 0, 0.7}), turn_by({3.141592653589793, 0, 0})}) {
            motion.rotation = rotation;
            const bool upside_down = rotation[0] > 0.5;
            const MovingPart table(slab, motion);
            const Scene scene{empty, {&table, 1}};
            for (const double above : {0.0, 0.00003, 0.001}) {
                const double floor = above + (upside_down ? 1 : 0);
                const Capsule person{{1.5, 0, floor + 0.3}, {1.5, 0, floor + 1.5}, 0.3};
                const Hull box = make_box({0.4, 0.4, 0.9}).value();
                const Vec3 at{1, 1, floor + 0.9};
                for (const Vec3& path : {Vec3{}, Vec3{0.1, 0.05, 0}, Vec3{0, 0.2, 0.1}}) {
                    EXPECT_FALSE(cast(scene, person, path)) << above;
                    EXPECT_FALSE(cast(scene, box, at, path)) << above;
                    EXPECT_FALSE(cast(scene, Sphere{{1, 1, floor + 0.5}, 0.5}, path)) << above;
                }
                const PartHit down = cast(scene, person, {0, 0, -0.5});
                EXPECT_TRUE(down.touched());
                EXPECT_NEAR(down.fraction, above / 0.5, kPartTouch / 0.5);
                EXPECT_NEAR(down.normal.z, 1, 1e-9);
                EXPECT_LT(length(down.surface_velocity - cross(motion.turn, down.point - motion.position)), 1e-12);
                EXPECT_TRUE(cast(scene, box, at, {0, 0, -0.5}).touched());
            }
        }
    }
}

/// A platform that tilts under feet pushes those on the side that rises, from the first moment, and none on the other.
TEST(TurningPart, TiltPushesTheRisingSide) {
    const World empty;
    RigidMotion motion;
    motion.turn = {0, 0.1, 0};  // x > 0 sinks
    const MovingPart table(test::box_world({-4, -4, -1}, {4, 4, 0}), motion);
    const Scene scene{empty, {&table, 1}};
    const Hull box = make_box({0.4, 0.4, 0.9}).value();
    EXPECT_EQ(cast(scene, box, {-2, 0, 0.9}, {}).status, Status::kInitialOverlap);
    EXPECT_FALSE(cast(scene, box, {2, 0, 0.9}, {}));
    EXPECT_EQ(cast(scene, Sphere{{-2, 0, 0.5}, 0.5}, {}).status, Status::kInitialOverlap);
    EXPECT_FALSE(cast(scene, Sphere{{2, 0, 0.5}, 0.5}, {}));
    const PartHit later = cast(scene, Sphere{{-2, 0, 0.51}, 0.5}, {});
    ASSERT_EQ(later.status, Status::kHit);
    EXPECT_NEAR(later.fraction, 0.05, 0.002);  // 0.01 m at some 0.2 m in the whole time
    // One that rises as fast as it is pushed stays in touch.
    EXPECT_FALSE(cast(scene, Sphere{{-2, 0, 0.5}, 0.5}, {0, 0, 0.21}));
}

/// Behind a blade that goes away, the next one comes round in the same motion.
TEST(TurningPart, TheNextBladeComesRound) {
    const World empty;
    RigidMotion motion;
    motion.turn = {0, 0, 5};
    const MovingPart blades(test::cross_world(), motion);
    const Scene scene{empty, {&blades, 1}};
    const Sphere behind{{0.8, -0.125 - 0.1, 0}, 0.1};  // in touch with the blade along x, on the side it leaves
    const PartHit hit = cast(scene, behind, {});
    ASSERT_EQ(hit.status, Status::kHit);
    // The blade along -y has to turn by 90 degrees less what it and the ball are wide.
    const double distance = std::sqrt(0.8 * 0.8 + 0.225 * 0.225);
    const double bearing = 3.141592653589793 / 2 - std::asin(0.225 / 0.8 / std::sqrt(1 + 0.225 * 0.225 / 0.64));
    EXPECT_NEAR(hit.fraction, (bearing - std::asin(0.225 / distance)) / 5, 1e-4);
}

}  // namespace
}  // namespace firma
