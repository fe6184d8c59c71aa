// SPDX-License-Identifier: MIT
// Casts through a world: the first, any or each of the touches on the way.
#include <algorithm>
#include <type_traits>

#include "firma/queries.h"
#include "world/cast_asked.h"
#include "world/put_hit.h"
#include "world/touch_takers.h"

namespace firma {
namespace {

/// Goes as the options say.
template <class Found, class Mover>
void sweep_rooms(const World& world, const Vec3& centre, const Sweep& sweep, const Mover& mover,
                 const CastOptions& options, Found& found) {
    WorldSweep<Found, Mover> on_its_way(world.data(), sweep, mover, options, found);
    const auto go = [&] {
        while (const Node* index = on_its_way.next()) on_its_way.look_into(*index);
    };
    const RoomId start = first_room(world, centre, options);
    if (start == kAnyRoom) return go();
    RoomTrail unasked;
    RoomsOnTheWay rooms;
    on_its_way.start_in(start.value, rooms, options.trail ? *options.trail : unasked);
    go();
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
        KeepFirst first(sweep.end);
        if (ready == Status::kHit) find_first(sweep, first);
        put_first(world, ready, around.centre, path, sweep, mover, options, first.best, hit);
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

}  // namespace

Hit cast_asked(const World& world, const Asked& asked, const CastOptions& options) {
    const OtherMover* other = asked.other();
    return other ? ask(world, asked.around, *other, asked.path, options).first()
                 : ask(world, asked.around, asked.path, options).first();
}

Status cast_any_asked(const World& world, const Asked& asked, const CastOptions& options) {
    const OtherMover* other = asked.other();
    return other ? ask(world, asked.around, *other, asked.path, options).any()
                 : ask(world, asked.around, asked.path, options).any();
}

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
