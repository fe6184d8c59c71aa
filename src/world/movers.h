// SPDX-License-Identifier: MIT
// What moves in a cast: spheres by a traversal of their own, all else by one that they share.
#pragma once

#include <utility>
#include <variant>

#include "cast/capsule_shape.h"
#include "cast/cast_capsule_polygon.h"
#include "cast/make_hull_hit.h"
#include "firma/batch.h"
#include "firma/hull.h"
#include "world/sweep_world.h"

namespace firma {

/// What moves and is no sphere. One traversal serves all of them; each face that it comes near costs a call through a
/// pointer more.
class OtherMover {
public:
    virtual Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                            CastCounts* counts) const = 0;
    virtual PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const = 0;
    virtual LaneSweep lanes(const Sweep& sweep) const = 0;

protected:
    ~OtherMover() = default;
};

/// One of them, held elsewhere.
struct MoverRef {
    const OtherMover* mover;

    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                    CastCounts* counts) const {
        return mover->against(sweep, polygon, sides, latest, counts);
    }
    PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const {
        return mover->hit(sweep, polygon, contact);
    }
    LaneSweep lanes(const Sweep& sweep) const { return mover->lanes(sweep); }
};

#if defined(__wasm__)
/// A sphere as what moves. The module has to be small: there one traversal serves spheres, too.
class SphereAsOther final : public OtherMover {
public:
    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                    CastCounts* counts) const override {
        return SphereMover().against(sweep, polygon, sides, latest, counts);
    }
    PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const override {
        return SphereMover().hit(sweep, polygon, contact);
    }
    LaneSweep lanes(const Sweep& sweep) const override { return SphereMover().lanes(sweep); }
};
#endif

/// A hull as what moves. Its contacts' index is the name of the facet.
class HullMover final : public OtherMover {
public:
    explicit HullMover(const Hull& hull) : hull_(hull.shape()) {}

    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                    CastCounts* counts) const override {
        HullContact found = cast_hull_polygon(sweep, *hull_, polygon, sides, latest, counts);
        found.contact.index = found.facet.name.code();
        return found.contact;
    }
    PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const override {
        const SumFacet::Name name = SumFacet::Name::of(contact.index);
        return make_hull_hit(sweep, *hull_, polygon, {contact, HullAgainstPolygon(sweep, *hull_, polygon).facet(name)});
    }
    LaneSweep lanes(const Sweep& sweep) const override { return LaneSweep(sweep, hull_->extent); }

private:
    const HullShape* hull_;
};

/// A capsule as what moves; the sweep is that of the ball around it.
class CapsuleMover final : public OtherMover {
public:
    explicit CapsuleMover(const Capsule& capsule) : capsule_(shape_of_capsule(capsule)) {}

    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                    CastCounts* counts) const override {
        return cast_capsule_polygon(sweep, capsule_, polygon, sides, latest, counts);
    }
    PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const override {
        return make_capsule_hit(sweep, capsule_, polygon, contact);
    }
    LaneSweep lanes(const Sweep& sweep) const override { return LaneSweep(sweep, extent_of(capsule_)); }

private:
    const CapsuleShape capsule_;
};

/// A hull that is none has a negative radius: kInvalid.
inline Sphere ball_around(const Hull& hull, const Vec3& at) {
    return {at, hull.valid() ? hull.shape()->reach : -1};
}

/// What an input of a batch asks: what moves from where, along what.
struct Asked {
    Sphere around;  ///< holds all that moves
    Vec3 path;
    std::variant<std::monostate, CapsuleMover, HullMover> moves;  ///< of a sphere nothing

    explicit Asked(const CastInput& input) : around(input.sphere), path(input.path) {}
    explicit Asked(const CapsuleInput& input)
        : around(ball_around(input.capsule)),
          path(input.path),
          moves(std::in_place_type<CapsuleMover>, input.capsule) {}
    explicit Asked(const HullInput& input)
        : around(ball_around(hull_of(input), input.at)),
          path(input.path),
          moves(std::in_place_type<HullMover>, hull_of(input)) {}

    /// What moves where it is no sphere; lives as long as this.
    const OtherMover* other() const {
        if (const auto* capsule = std::get_if<CapsuleMover>(&moves)) return capsule;
        return std::get_if<HullMover>(&moves);
    }

private:
    static const Hull& hull_of(const HullInput& input) {
        static const Hull none;
        return input.hull ? *input.hull : none;
    }
};

}  // namespace firma
