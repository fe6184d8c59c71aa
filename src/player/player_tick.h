// SPDX-License-Identifier: MIT
// One tick of one player: what it does, phase by phase.
#pragma once

#include "player/allowed_motion.h"
#include "player/player_ground.h"
#include "player/player_shape.h"

namespace firma {

class PlayerTick {
public:
    PlayerTick(const Scene& scene, const PlayerShapeData& shape, const Player& player, const PlayerWish& wish,
               double seconds, const PlayerRules& rules, double offset);

    PlayerMove run();

private:
    /// All that a tick changes as it goes, so that a way can be tried.
    struct State {
        PlayerMove move;
        bool climbing = false;  ///< up a side too steep to stand on, to ground within a step
        Vec3 ground;            ///< normal of what it walks on
        AllowedMotion walls;    ///< what blocks it: faces too steep to walk on block upright, too
        AllowedMotion touched;  ///< all that was touched, as it was
    };

    bool get_free();
    void ride();
    void carry(double before, double after);
    void give_way();
    void choose_posture();
    void accelerate();
    void walk();
    void walk_along(Vec3 left);
    void stop_at_ledge(const State& begun, const Vec3& way);
    void fly();
    void settle(double far);
    void keep_offset(const Hit& hit, double far);
    void finish();

    struct Landing {
        PartHit hit;
        Vec3 feet;
        Ground ground;
    };
    Landing land(const Vec3& feet, const Vec3& fall) const;
    bool is_step(const Landing& landing, const Vec3& from) const;

    /// A sweep as far as is safe, noted, and what it touched.
    PartHit go(const Vec3& path);
    void back_off(const Vec3& normal, double far);
    bool climb(Vec3& left);
    /// Too high: it met something above where its head was; too low: something else alone.
    enum class Climb { kDone, kNowhere, kTooLow, kTooHigh };
    Climb climb_by(double rise, Vec3& left);
    Vec3 foothold(const Vec3& feet) const;
    bool come_down(const PartHit& hit, const Vec3& left);
    bool climb_from_slide(const PartHit& hit, const Vec3& left);
    void add_wall(const Vec3& normal);
    void note(const PartHit& hit, const Ground& ground);
    void stand_on(const Vec3& normal, std::uint32_t part);
    void leave_ground();
    double held_fall() const;
    bool is_held() const;
    Vec3 speed_of(std::uint32_t part) const;  ///< of a part at the feet, metres a second; zero of the level
    bool ground_within(const Vec3& feet, double far) const;

    Vec3 sideways(const Vec3& v) const { return v - up_ * dot(v, up_); }
    /// As long as `flat`, above the same line, in the plane of the ground.
    Vec3 along_ground(const Vec3& flat) const;
    Vec3 allowed_on_ground(const Vec3& motion) const;

    static constexpr int kMaxSlides = 8;

    Scene scene_;  ///< its parts stand where they are by now
    const World& world_;
    const PlayerShapeData& shape_;
    const PlayerWish& wish_;
    const PlayerRules& rules_;
    const GroundRules ground_rules_;
    const Vec3 up_;
    const double seconds_, offset_;
    const bool other_world_;
    PostureIn posture_;
    State state_;
    PlayerMove& move_ = state_.move;
    Player& player_ = state_.move.player;
};

}  // namespace firma
