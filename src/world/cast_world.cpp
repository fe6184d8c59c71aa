// SPDX-License-Identifier: MIT
// Casts through a world: the first, any or each of the touches on the way.
#include <algorithm>
#include <type_traits>

#include "cast/cast_capsule_polygon.h"
#include "cast/make_hull_hit.h"
#include "firma/hull.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "geometry/rounding.h"
#include "world/run_tasks.h"
#include "world/sweep_world.h"

namespace firma {
namespace {

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

/// Goes as the options say.
template <class Found, class Mover>
void sweep_rooms(const World& world, const Vec3& centre, const Sweep& sweep, const Mover& mover,
                 const CastOptions& options, Found& found) {
    const WorldData& data = world.data();
    WorldSweep<Found, Mover> on_its_way(data, sweep, mover, options, found);
    if (data.cells.room_count() == 1) {
        if (options.trail) add_room(*options.trail, 0);
        return on_its_way.ask_all();
    }
    RoomTrail unasked;
    RoomTrail& trail = options.trail ? *options.trail : unasked;
    RoomId start = options.room;
    if (start == kLocateRoom) start = locate(world, centre).room;
    if (start == kAnyRoom) return on_its_way.ask_all();
    on_its_way.ask_from(data.cells.current_room(start.value), trail);
}

/// Is told of touches, whoever asks: one traversal serves all of them. A touch costs a call through a pointer.
struct TellAny {
    static constexpr bool kEarliestOnly = false;
    double latest;
    bool (*take)(TellAny& self, const SweepContact& contact);

    bool operator()(const SweepContact& contact) { return take(*this, contact); }
};

/// `Found` as TellAny, which it then is.
template <class Found>
TellAny tell(double latest) {
    return {latest, [](TellAny& self, const SweepContact& contact) { return static_cast<Found&>(self)(contact); }};
}

/// Keeps the earliest touch; of several at one time the lowest id.
struct KeepFirst : TellAny {
    static constexpr bool kEarliestOnly = true;
    SweepContact best;

    explicit KeepFirst(double end) : TellAny(tell<KeepFirst>(end)) {}
    bool operator()(const SweepContact& other) {
        const bool sooner = !best.contact.touched() || other.contact.t < best.contact.t ||
                            (other.contact.t == best.contact.t && other.comes_before(best));
        if (sooner) {
            best = other;
            latest = other.contact.t;
        }
        return false;
    }
};

struct StopAtAny : TellAny {
    Status status = Status::kMiss;

    explicit StopAtAny(double end) : TellAny(tell<StopAtAny>(end)) {}
    bool operator()(const SweepContact& contact) {
        status = contact.contact.status;
        return true;
    }
};

/// A lane that has the facet whole tells its corner, too: that is one place in memory less to wait for.
FaceRef name_of(const SweepContact& found) {
    if (!found.whole) return ref_to(*found.block, found.slot);
    return {found.face().id, found.whole->grid_corner(found.lane, 0)};
}

void put_face(const SweepContact& found, Hit& hit) {
    const FaceRecord& face = found.face();
    hit.face = name_of(found);
    if (const FaceOwner* owner = found.block->owner_of(face)) hit.face_normal = owner->normal;
    hit.material = face.material;
}

/// @param hit  one that says nothing yet
template <class Mover>
void put_hit(const World& world, const Sweep& sweep, const Mover& mover, const CastOptions& options,
             const SweepContact& found, Hit& hit) {
    const auto make = [&](const PolygonShape& polygon) {
        static_cast<PolygonHit&>(hit) = mover.hit(sweep, polygon, found.contact);
    };
    if (found.block) {
#if !defined(__wasm__)  // which has to be small
        if (found.through_plane) {
            const Vec3 corner = to_metres(found.whole->grid_corner(found.lane, 0));
            make_particle_hit(sweep, corner, found.normal, found.away, found.contact, hit);
        } else
#endif
            if (found.whole) {
            make(LaneShape(*found.whole, found.lane).polygon);
        } else {
            make(FaceShape(*found.block, found.face()).polygon);
        }
        put_face(found, hit);
    } else {
        const Portal& portal = world.data().cells.portal(found.portal);
        make(portal.polygons()[found.slot].shape);
        hit.portal = {found.portal};
        hit.material = portal.material;
    }
    hit.safe_fraction = safe_fraction(
        sweep, hit, options.contact_offset >= 0 ? options.contact_offset : world.tolerance().contact_offset);
}

/// Hands each touch on.
template <class Mover>
struct VisitEach : TellAny {
    HitVisitor visit;
    const World& world;
    const Sweep& sweep;
    const Mover& mover;
    const CastOptions& options;
    bool any = false;

    VisitEach(double end, HitVisitor v, const World& w, const Sweep& s, const Mover& m, const CastOptions& o)
        : TellAny(tell<VisitEach>(end)), visit(v), world(w), sweep(s), mover(m), options(o) {}
    bool operator()(const SweepContact& contact) {
        if (contact.contact.t > latest) return false;  // polygons tell of such, too, where rounding might say otherwise
        any = true;
        Hit hit;
        put_hit(world, sweep, mover, options, contact, hit);
        const double wanted = visit(hit);
        if (!(wanted > 0)) return true;
        if (wanted < 1 && wanted * sweep.end < latest) latest = wanted * sweep.end;
        return false;
    }
};

/// A sweep, or why there is none: kHit when it is ready to go.
Status prepare(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options, Sweep& sweep) {
    if (options.trail) options.trail->count = 0;
    if (!(options.contact_offset <= kLargestNumber)) return Status::kInvalid;  // also not a number
    if (options.room != kAnyRoom && options.room != kLocateRoom && options.room.value >= world.room_count())
        return Status::kInvalid;
    return make_sweep(sphere, path, sweep);
}

void sort_hits(std::vector<Hit>& hits) {
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction
               : a.face.id != b.face.id ? a.face.id < b.face.id
                                        : a.portal < b.portal;
    });
}

/// One question: what moves from where, along what.
template <class Mover>
struct Question {
    const World& world;
    const Sphere& around;  ///< holds all that moves; of the caller, as all of these
    const Vec3& path;
    const Mover mover;
    const CastOptions& options;

    Hit first() const {
        Hit hit;  // the only one that is returned: so it is made where the caller has it
        Sweep sweep;
        const Status ready = prepare(world, around, path, options, sweep);
        if (ready == Status::kInvalid) {
            hit = invalid_hit(around.centre);
        } else if (ready == Status::kMiss) {
            hit.centre = around.centre + path;
        } else {
            KeepFirst first(sweep.end);
            find_first(sweep, first);
            if (first.best.contact.touched())
                put_hit(world, sweep, mover, options, first.best, hit);
            else
                hit.centre = around.centre + path;
        }
        return hit;
    }

    Status any() const {
        Sweep sweep;
        const Status ready = prepare(world, around, path, options, sweep);
        if (ready != Status::kHit) return ready;
        StopAtAny any(sweep.end);
        find(sweep, any);
        return any.status;
    }

    Status each(HitVisitor visit) const {
        Sweep sweep;
        const Status ready = prepare(world, around, path, options, sweep);
        if (ready != Status::kHit) return ready;
        VisitEach<Mover> each(sweep.end, visit, world, sweep, mover, options);
        find(sweep, each);
        return each.any ? Status::kHit : Status::kMiss;
    }

    Status all(std::vector<Hit>& hits) const {
        hits.clear();
        const auto add = [&](const Hit& hit) {
            hits.push_back(hit);
            return 1.0;
        };
        const Status status = each(add);
        sort_hits(hits);
        return hits.empty() ? status : hits[0].status;
    }

private:
    void find(const Sweep& sweep, TellAny& told) const {
        sweep_rooms(world, around.centre, sweep, mover, options, told);
    }
    /// Of a sphere by a traversal of its own, as nothing is asked more often.
    void find_first(const Sweep& sweep, KeepFirst& first) const {
        if constexpr (std::is_same_v<Mover, SphereMover>)
            sweep_rooms(world, around.centre, sweep, mover, options, first);
        else
            find(sweep, first);
    }
};

#if defined(__wasm__)
Question<MoverRef> ask(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    static const SphereAsOther mover;
    return {world, sphere, path, {&mover}, options};
}
#else
Question<SphereMover> ask(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    return {world, sphere, path, {}, options};
}
#endif

/// @param mover  lives as long as the question, as does `around`
Question<MoverRef> ask(const World& world, const Sphere& around, const OtherMover& mover, const Vec3& path,
                       const CastOptions& options) {
    return {world, around, path, {&mover}, options};
}

/// A hull that is none has a negative radius: kInvalid.
Sphere ball_around(const Hull& hull, const Vec3& at) {
    return {at, hull.valid() ? hull.shape()->reach : -1};
}

}  // namespace

Hit cast(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    return ask(world, sphere, path, options).first();
}

Status cast_any(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    return ask(world, sphere, path, options).any();
}

Status cast_each(const World& world, const Sphere& sphere, const Vec3& path, HitVisitor visit,
                 const CastOptions& options) {
    return ask(world, sphere, path, options).each(visit);
}

Status cast_all(const World& world, const Sphere& sphere, const Vec3& path, std::vector<Hit>& hits,
                const CastOptions& options) {
    return ask(world, sphere, path, options).all(hits);
}

Hit cast(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, const CastOptions& options) {
    return ask(world, ball_around(hull, at), HullMover(hull), path, options).first();
}

Status cast_any(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, const CastOptions& options) {
    return ask(world, ball_around(hull, at), HullMover(hull), path, options).any();
}

Status cast_each(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, HitVisitor visit,
                 const CastOptions& options) {
    return ask(world, ball_around(hull, at), HullMover(hull), path, options).each(visit);
}

Status cast_all(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, std::vector<Hit>& hits,
                const CastOptions& options) {
    return ask(world, ball_around(hull, at), HullMover(hull), path, options).all(hits);
}

Hit cast(const World& world, const Capsule& capsule, const Vec3& path, const CastOptions& options) {
    return ask(world, ball_around(capsule), CapsuleMover(capsule), path, options).first();
}

Status cast_any(const World& world, const Capsule& capsule, const Vec3& path, const CastOptions& options) {
    return ask(world, ball_around(capsule), CapsuleMover(capsule), path, options).any();
}

Status cast_each(const World& world, const Capsule& capsule, const Vec3& path, HitVisitor visit,
                 const CastOptions& options) {
    return ask(world, ball_around(capsule), CapsuleMover(capsule), path, options).each(visit);
}

Status cast_all(const World& world, const Capsule& capsule, const Vec3& path, std::vector<Hit>& hits,
                const CastOptions& options) {
    return ask(world, ball_around(capsule), CapsuleMover(capsule), path, options).all(hits);
}

}  // namespace firma
