// SPDX-License-Identifier: MIT
// Casts that are on their way at one time: a place for each, where it stands between the indices that it goes through.
#include <memory>
#include <new>
#include <optional>
#include <type_traits>

#include "base/assert.h"
#include "world/cast_asked.h"
#include "world/cast_together.h"
#include "world/put_hit.h"
#include "world/touch_takers.h"

namespace firma {
namespace {

#if !defined(__wasm__)  // which has to be small

/// Where caches hold a level there is little to wait for, and what is on its way pushes other things out of the nearest
/// cache; by measurement (docs/performance.md).
std::uint32_t places_that_pay(std::size_t faces) {
    constexpr std::size_t kMany = 150'000, kVeryMany = 1'000'000;
    return faces < kMany ? 2 : faces < kVeryMany ? 6 : LaneSource::kPlaces;
}

/// @tparam Found  what is kept of touches while a cast goes on
template <class Found, class Mover>
class Flights final : public LaneSource {
public:
    static_assert(std::is_trivially_destructible_v<Asked>);

    /// A cast from when it is asked until it is answered.
    struct Flight {
        Flight() {}

        std::size_t cast = 0;
        union {
            Asked asked;  ///< made where it stays, once it is asked
        };
        Sweep sweep;
        Status ready = Status::kMiss;  ///< kHit where there was something to look for
        std::optional<Found> found;

    private:
        friend class Flights;
        // Spheres' first touches by a traversal of their own, as nothing is asked more often.
        static constexpr bool kOwn = std::is_same_v<Mover, SphereMover> && std::is_same_v<Found, KeepFirst>;

        std::optional<WorldSweep<std::conditional_t<kOwn, Found, TellAny>, Mover>> way;
    };
    using Answer = FunctionRef<void(const Flight& flight)>;

    Flights(const World& world, const AskedCasts& casts, Answer answer, const CastOptions& options)
        : world_(world), casts_(casts), answer_(answer), options_(options), next_(casts.first) {
        places = casts.places ? casts.places : places_that_pay(world.face_count());
        FIRMA_ASSERT(places <= kPlaces, "more casts at one time than there is room for");
    }

    static Mover mover_of(const Asked& asked) {
        if constexpr (std::is_same_v<Mover, SphereMover>)
            return {};
        else
            return {asked.other()};
    }

    Next next(std::uint32_t place, bool ended) override {
        Flight& flight = flights_[place];
        if (flight.way) {
            if (ended) flight.way->end();
            if (const Node* index = flight.way->next()) return {index, &flight.way->query()};
            answer(flight);
        }
        while (next_ < casts_.first + casts_.count) {
            start(flight);
            if (flight.ready == Status::kHit) {
                const Node* index = flight.way->next();
                if (flight.way->by_lanes() && index) return {index, &flight.way->query()};
                for (; index; index = flight.way->next()) flight.way->look_into(*index);
            }
            answer(flight);
        }
        return {};
    }

private:
    void start(Flight& flight) {
        flight.cast = next_;
        const Asked& asked = *new (&flight.asked) Asked(casts_.ask(next_++));
        flight.ready = prepare(world_, asked.around, asked.path, options_, flight.sweep);
        flight.found.emplace(flight.sweep.end);
        if (flight.ready != Status::kHit) return;
        flight.way.emplace(world_.data(), flight.sweep, mover_of(asked), options_, *flight.found);
        const RoomId room = first_room(world_, asked.around.centre, options_);
        if (room == kAnyRoom) return;
        const auto place = std::size_t(&flight - flights_);
        flight.way->start_in(room.value, rooms_[place], unasked_[place]);
    }

    void answer(Flight& flight) {
        answer_(flight);
        flight.way.reset();
    }

    const World& world_;
    const AskedCasts& casts_;
    const Answer answer_;
    const CastOptions options_;
    std::size_t next_;
    Flight flights_[kPlaces];
    // By place, and apart, as they are large and mostly not asked for.
    RoomTrail unasked_[kPlaces];
    RoomsOnTheWay rooms_[kPlaces];
};

/// @return false, and nothing asked, where it cannot be done
template <class Found, class Mover, class Answer>
bool fly(const World& world, const AskedCasts& casts, const Answer& answer, const CastOptions& options) {
    const LanesTogether together = together_in_use();
    if (!together) return false;
    const std::unique_ptr<Flights<Found, Mover>> flights(new (std::nothrow)
                                                             Flights<Found, Mover>(world, casts, answer, options));
    if (!flights) return false;
    together(*flights);
    return true;
}

#endif

}  // namespace

void cast_together(const World& world, const AskedCasts& casts, FunctionRef<AnswerFirst> answer,
                   const CastOptions& options) {
#if !defined(__wasm__)
    const auto of = [&](const auto& flight, const auto& mover) {
        const auto put = [&](Hit& hit) {
            put_first(world, flight.ready, flight.asked.around.centre, flight.asked.path, flight.sweep, mover, options,
                      flight.found->best, hit);
        };
        answer(flight.cast, put);
    };
    if (casts.spheres
            ? fly<KeepFirst, SphereMover>(
                  world, casts, [&](const auto& flight) { of(flight, SphereMover()); }, options)
            : fly<KeepFirst, MoverRef>(
                  world, casts, [&](const auto& flight) { of(flight, MoverRef{flight.asked.other()}); }, options))
        return;
#endif
    for (std::size_t k = casts.first; k < casts.first + casts.count; ++k)
        answer(k, [&](Hit& hit) { hit = cast_asked(world, casts.ask(k), options); });
}

void cast_any_together(const World& world, const AskedCasts& casts, FunctionRef<AnswerAny> answer,
                       const CastOptions& options) {
#if !defined(__wasm__)
    const auto tell = [&](const auto& flight) {
        answer(flight.cast, flight.ready == Status::kHit ? flight.found->status : flight.ready);
    };
    if (casts.spheres ? fly<StopAtAny, SphereMover>(world, casts, tell, options)
                      : fly<StopAtAny, MoverRef>(world, casts, tell, options))
        return;
#endif
    for (std::size_t k = casts.first; k < casts.first + casts.count; ++k)
        answer(k, cast_any_asked(world, casts.ask(k), options));
}

}  // namespace firma
