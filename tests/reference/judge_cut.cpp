// SPDX-License-Identifier: MIT
// Judges a cut.
#include "tests/reference/judge_cut.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "base/assert.h"
#include "carve/check_shells.h"
#include "carve/place_cutter.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "tests/reference/carve_oracle.h"
#include "tests/reference/directed_edges.h"
#include "tests/reference/facet_corners.h"
#include "tests/reference/judge_contact.h"
#include "tests/reference/judge_rooms.h"
#include "tests/reference/protected_part.h"
#include "tests/reference/world_facets.h"
#include "world/clip_columns.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

using scenes::CutOrder;
using scenes::Rng;

constexpr std::size_t kFailuresKept = 8;

/// Digits out, so that like reasons count together.
std::string kind_of(const std::string& reason) {
    std::string text;
    for (const char c : reason) {
        if (c >= '0' && c <= '9') {
            if (text.empty() || text.back() != '#') text += '#';
        } else if (c != '.' && c != '-') {
            text += c;
        }
    }
    return text;
}

std::string words(const Vec3& v) {
    char text[100];
    std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
    return text;
}

Box box_of_facet(const FacetPlace& place) {
    Box box;
    for (const GridPoint& corner : grid_corners_of(place)) box.add(to_metres(corner));
    return box;
}

Box box_of(const PlacedCutter& placed) {
    Box box;
    for (const InputPoint& p : placed.vertices) box.add(to_metres(to_surface(p)));
    return box;
}

Vec3 point_in(const Box& box, Rng& rng) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = rng.uniform(box.low[axis], box.high[axis]);
    return p;
}

/// One cut and everything that is known of it.
class CutJudge {
public:
    CutJudge(const World& before, const CutOrder& order, const CarveResult& result, Rng& rng, const std::string& where,
             CutTally& tally, const JudgeOptions& options)
        : before_(before),
          after_(result.world),
          order_(order),
          result_(result),
          rng_(rng),
          where_(where),
          tally_(tally),
          options_(options),
          fill_(order.kind == CarveKind::kFill),
          protected_(before, fill_) {}

    void judge() {
        place();
        if (result_.status == CarveStatus::kRefused) count_refusal();
        if (!result_.done()) {
            if (&before_.data() != &after_.data()) fail("not done, and yet another world");
            if (result_.status == CarveStatus::kRefused && !result_.reproduction.empty())
                fail("a contradiction: " + result_.error.text());
            if (result_.status == CarveStatus::kNothing && options_.volume) judge_volume();
            if (is_left_by_protection()) judge_points();
            return;
        }
        if (!placed_) return fail("done with a cutter that cannot be placed");
        change_ = compare_facets(before_, after_);
        has_rooms_ = after_.data().cells.known();
        judge_faces();
        if (const std::string edge = open_edge(after_, &tally_.shared_edges); !edge.empty()) fail(edge);
        if (const auto fault = check_world(after_))
            fail("check_world: " + fault->what + " at face " + std::to_string(fault->face.value));
        if (const auto fault = check_solid(after_)) fail("check_solid: " + fault->what);
        if (options_.volume) judge_volume();
        if (has_rooms_) judge_rooms();
        judge_casts();
        judge_points();
        judge_rays();
    }

    bool failed() const { return failed_; }

private:
    void fail(const std::string& what) {
        tally_.fail(where_, what);
        failed_ = true;
    }

    void place() { placed_ = placed_cutter(order_, result_.report); }

    void count_refusal() {
        const bool unplaceable = !placed_ || check_cutter(*placed_);
        const bool blamed = !result_.reproduction.empty() ||
                            result_.error.reason.find("degenerate position") != std::string::npos ||
                            result_.error.reason.find("contradict") != std::string::npos;
        if (unplaceable && blamed) fail("blamed on the cutter and on the library: " + result_.error.text());
        tally_.unplaceable += unplaceable;
        tally_.blamed += blamed;
    }

    void judge_faces() {
        if (!change_.untouched_kept) fail("a face that kept its id is another one");
        if (result_.report.faces_removed != change_.gone.size()) fail("report.faces_removed");
        if (result_.report.faces_added != change_.come.size()) fail("report.faces_added");
        if (after_.face_count() != before_.face_count() - change_.gone.size() + change_.come.size())
            fail("face_count is not before - gone + new");
        if (after_.version() != before_.version() + 1) fail("version");
        for (const FacetPlace& place : change_.gone)
            if (!place.record().solid && !may_take(place)) return fail("a face that bounds no solid is gone");
        for (const FacetPlace& place : change_.come)
            if (place.record().id.value < before_.data().next_face()) return fail("a new face with an old id");
    }

    /// A face that bounds no solid: panes go whole, of others what lies in the cutter, of clips on walls what stands
    /// straight over a hole, however far out.
    bool may_take(const FacetPlace& place) const {
        if (fill_ || (before_.data().rules && !before_.data().rules->open_faces)) return false;
        const CarveReport& report = result_.report;
        if (report.panes > 0) return true;
        if (report.open_trimmed + report.open_removed == 0) return false;
        constexpr double kRounded = 1e-3;
        const Box box = box_of(*placed_), own = box_of_facet(place);
        bool meets = true;
        for (int axis = 0; axis < 3; ++axis)
            meets = meets && own.low[axis] <= box.high[axis] + kRounded && own.high[axis] >= box.low[axis] - kRounded;
        return meets || (report.clips > 0 && is_clip(place.record()) && stands_over_hole(place));
    }

    /// Whether it is in front of some wall that was cut, and straight over where the cutter may be in it.
    bool stands_over_hole(const FacetPlace& clip) const {
        const std::vector<Vec3> corners = facet_corners(clip);
        std::vector<Vec3> cutter;
        for (const InputPoint& p : placed_->vertices) cutter.push_back(to_metres(to_surface(p)));
        return std::any_of(change_.gone.begin(), change_.gone.end(), [&](const FacetPlace& wall) {
            return wall.record().solid && is_over(corners, facet_corners(wall), cutter);
        });
    }

    static bool is_over(const std::vector<Vec3>& clip, const std::vector<Vec3>& wall, const std::vector<Vec3>& cutter) {
        constexpr double kRounded = 1e-2;
        const Vec3 normal = area_vector(wall);
        const auto range = [](const std::vector<Vec3>& points, const Vec3& along) {
            std::pair<double, double> ends{INFINITY, -INFINITY};
            for (const Vec3& p : points)
                ends = {std::min(ends.first, dot(p, along)), std::max(ends.second, dot(p, along))};
            return ends;
        };
        if (range(clip, normal).second < dot(wall[0], normal) - kRounded * length(normal)) return false;
        const auto meets_along = [&](const Vec3& along) {
            const auto [low, high] = range(clip, along);
            const auto [from, to] = range(cutter, along);
            return low <= to + kRounded * length(along) && high >= from - kRounded * length(along);
        };
        for (std::size_t k = 0; k < wall.size(); ++k) {
            const Vec3 side = wall[(k + 1) % wall.size()] - wall[k];
            if (!meets_along(side) || !meets_along(cross(side, normal))) return false;
        }
        return true;
    }

    /// Whether what may not be carved left nothing to cut.
    bool is_left_by_protection() const {
        return placed_ && result_.status == CarveStatus::kRefused && protected_.is_by_pieces() &&
               result_.error.reason.ends_with(" may not be carved");
    }

    void judge_volume() {
        if (!placed_) return;
        const Real all = volume_of(*placed_), within = volume_within(before_, *placed_);
        Real expected = fill_ ? Real(within - all) : within;
        // What was protected is still there, and judge_points() asks whether that is all; outside the cutter nothing
        // may have changed.
        if (result_.report.cut_short > 0) expected = Real(within - volume_within(after_, *placed_));
        const Real lost = volume_lost(change_.gone, change_.come, *placed_);
        const auto digits = [](const Real& value) { return value.str(30); };
        if (abs(lost - expected) > all * Real("1e-20"))
            fail("volume " + digits(lost) + " instead of " + digits(expected) + " of " + digits(all));
        // The report has the digits of a double, and where wide faces changed little what 100 bits leave of their
        // cones.
        Box box = box_of(*placed_);
        for (const std::vector<FacetPlace>* facets : {&change_.gone, &change_.come})
            for (const FacetPlace& place : *facets)
                for (const GridPoint& corner : grid_corners_of(place)) box.add(to_metres(corner));
        const double size = length(box.high - box.low);
        const Real rounding = abs(lost) * Real(0x1p-51) + Real(size * size * size * 0x1p-90);
        if (abs(Real(result_.report.volume) - lost) > rounding)
            fail("report.volume " + digits(Real(result_.report.volume)) + " instead of " + digits(lost));
    }

    void judge_rooms() {
        if (const std::string open = unclosed_room(after_); !open.empty()) fail(open);
        if (after_.room_count() < before_.room_count()) fail("a room is not there any more");
        if (portal_count(after_) < portal_count(before_)) fail("a portal is not there any more");
        if (!fill_) judge_portals();
        tally_.holed += portal_count(after_) > portal_count(before_);
        for (std::uint32_t room = 0; room < before_.room_count(); ++room) {
            const RoomInfo was = *room_info(before_, {room}), is = *room_info(after_, {room});
            if (was.merged_into == RoomId{room} && is.merged_into != RoomId{room} && !was.portals.empty())
                fail("a room became part of another");
        }
    }

    /// Carving changes no portal that was there, but for its rim and what edits made.
    void judge_portals() {
        const Cells &before = before_.data().cells, &after = after_.data().cells;
        for (std::uint32_t k = 0; k < before.portal_count(); ++k) {
            const Portal &was = before.portal(k), &is = after.portal(k);
            if (before.is_closed(k) != after.is_closed(k)) fail("a portal was opened or closed");
            if (&was == &is || was.gone() || was.made) continue;
            if (is.gone()) return fail("a portal is gone");
            const double change = std::fabs(area_of(is) - area_of(was)), size = length_of(was.box);
            if (change > 0x1p-16 * size) fail("a portal's area changed by " + std::to_string(change));
        }
    }
    static double area_of(const Portal& portal) {
        double sum = 0;
        for (const PortalPolygon& polygon : portal.polygons()) {
            Vec3 twice{0, 0, 0};
            for (std::size_t k = 2; k < polygon.corners.size(); ++k)
                twice = twice + cross(polygon.shape.corners[k - 1] - polygon.shape.corners[0],
                                      polygon.shape.corners[k] - polygon.shape.corners[0]);
            sum += length(twice) / 2;
        }
        return sum;
    }
    static double length_of(const GridBox& box) { return length(to_metres(box.high) - to_metres(box.low)); }

    void judge_casts() {
        const World scratch = rebuilt(after_);
        Box box = box_of(*placed_);
        const Vec3 size = box.high - box.low;
        for (const double sign : {-0.5, 0.5}) box.add((box.low + box.high) * 0.5 + size * (sign * 2));
        for (int k = 0; k < options_.casts; ++k) {
            const Vec3 start = point_in(box, rng_);
            const Vec3 direction = rng_.direction();
            const double distance = length(size) * std::ldexp(1.0, int(rng_.below(6)) - 3);
            const double radius = rng_.chance(0.5) ? 0 : distance * 0.2 * rng_.uniform();
            const Sides sides = rng_.chance(0.5) ? Sides::kFront : Sides::kBoth;
            const Hit a = cast(after_, {start, radius}, direction * distance, {.sides = sides});
            const Hit b = cast(scratch, {start, radius}, direction * distance, {.sides = sides});
            ++tally_.casts;
            if (!same_hit(a, b))
                return fail("a tree from scratch answers otherwise: from " + words(start) + " by " +
                            words(direction * distance) + " radius " + std::to_string(radius));
            if (!has_rooms_) continue;
            std::uint32_t passed = 0;
            const std::string wrong = judge_cast_by_room(after_, {start, radius}, direction * distance, passed);
            if (!wrong.empty()) return fail(wrong);
            tally_.room_casts += passed > 0;
            tally_.crossings += passed > 1;
        }
    }

    /// Whether a point is far from all surfaces of both worlds.
    bool is_clear(const Vec3& p, double distance) const {
        return !closest(before_, p, distance) && !closest(after_, p, distance);
    }

    void judge_points() {
        const std::vector<FacetPlace> facets = all_facets(before_);
        Box box = box_of(*placed_);
        const Vec3 size = box.high - box.low;
        for (const double sign : {-0.5, 0.5}) box.add((box.low + box.high) * 0.5 + size * (sign * 1.3));
        const int rock = before_.data().rock_outside();
        std::optional<RoomBounds> rooms;
        if (has_rooms_) rooms.emplace(after_);
        for (int k = 0; k < options_.points; ++k) {
            const Vec3 p = point_in(box, rng_);
            if (!is_clear(p, 1e-4)) continue;
            ++tally_.points;
            const Where before = locate(before_.solid(), p), after = locate(after_.solid(), p);
            const bool in_cutter = winding(*placed_, p) > 0.5, cut = in_cutter && !protected_.holds(p);
            tally_.protected_points += in_cutter && !cut;
            for (const Where where : {before, after})
                if (where != Where::kAir && where != Where::kSolid) return fail("locate() cannot tell of " + words(p));
            const bool was = before == Where::kSolid, is = after == Where::kSolid;
            if (is != (fill_ ? was || cut : was && !cut)) return fail("wrong side after the cut: " + words(p));
            const double now = winding(facets, p) - winding(change_.gone, p) + winding(change_.come, p) + rock;
            if (std::fabs(now - is) > 1e-3)
                return fail("the surface winds " + std::to_string(now) + " times around " + words(p));
            if (rooms)
                if (const std::string wrong = rooms->judge(p); !wrong.empty()) return fail(wrong);
            if (is) continue;
            if (has_rooms_ && !air_.empty()) {
                ++tally_.ways;
                if (const std::string wrong = judge_way(after_, air_.back(), p); !wrong.empty()) return fail(wrong);
            }
            air_.push_back(p);
        }
    }

    /// A corner, a point of an edge or of the inside, most often of a new facet.
    Vec3 target() {
        const std::vector<FacetPlace>& facets = change_.come.empty() ? change_.gone : change_.come;
        const FacetPlace& place = facets[rng_.below(std::uint32_t(facets.size()))];
        const auto corners = grid_corners_of(place);
        const std::uint32_t k = rng_.below(std::uint32_t(corners.size()));
        const auto at = [&](std::size_t c) { return to_metres(corners[c % corners.size()]); };
        const Vec3 a = at(k), b = at(k + 1), c = at(k + 2);
        const double which = rng_.uniform(), u = rng_.uniform(), v = rng_.uniform();
        if (which < 0.4) return a;
        const Vec3 on_edge = a + (b - a) * (rng_.chance(0.3) ? 0.5 : u);
        return which < 0.8 ? on_edge : on_edge + (c - on_edge) * v;
    }

    bool is_solid(const Hit& hit) const {
        const std::optional<FaceInfo> face = after_.face_info(hit.face);
        return face && face->solid;
    }

    void judge_rays() {
        if (air_.empty() || (change_.come.empty() && change_.gone.empty())) return;
        const std::vector<bool> closed = closed_rooms(after_);
        for (int k = 0; k < options_.rays; ++k) {
            const Vec3 start = air_[rng_.below(std::uint32_t(air_.size()))];
            const Vec3 path = (target() - start) * 65536;
            const Hit front = cast(after_, {start, 0}, path);
            if (front.touched() && !front.portal.valid() && !is_solid(front)) continue;
            ++tally_.rays;
            const Location from = has_rooms_ ? locate(after_, start) : Location{Where::kAir, {0}};
            if (from.where == Where::kAir && closed[from.room.value] && !front.touched())
                return fail("a ray escapes from " + words(start) + " by " + words(path));
            const Hit both = cast(after_, {start, 0}, path, {.sides = Sides::kBoth});
            if (!both.touched() || both.portal.valid() || !is_solid(both)) continue;
            // At an edge where the surface turns away both faces are met at once, up to rounding.
            const double gap = (front.touched() ? front.fraction - both.fraction : INFINITY) * length(path);
            if (dot(path, both.face_normal) > 1e-6 * length(path) && gap > 1e-5)
                return fail("a ray from the air meets the back of a face first, from " + words(start) + " by " +
                            words(path) + ", a front " + std::to_string(gap) + " m later");
        }
    }

    const World &before_, &after_;
    const CutOrder& order_;
    const CarveResult& result_;
    Rng& rng_;
    const std::string& where_;
    CutTally& tally_;
    const JudgeOptions& options_;
    const bool fill_;
    const ProtectedPart protected_;
    std::optional<PlacedCutter> placed_;
    FacetChange change_;
    std::vector<Vec3> air_;
    bool has_rooms_ = false;
    bool failed_ = false;
};

/// The same cut in slices; once dropped half way, once to the end.
std::string judge_slices(const World& world, const CutOrder& order, const CarveResult& whole, Rng& rng) {
    CarveJob job(world, order.cutter, order.pose, {}, order.kind);
    int steps = 0;
    while (!job.run(0)) ++steps;
    const CarveResult result = job.result();
    if (result.status != whole.status) return "in slices it ends otherwise";
    if (hash_world(result.world) != hash_world(whole.world)) return "in slices it ends in other bits";
    if (hash_solid(result.world) != hash_solid(whole.world)) return "in slices it ends in another solid";
    if (result.report.volume != whole.report.volume) return "in slices it reports otherwise";
    const std::uint64_t hash = hash_world(world);
    {
        CarveJob dropped(world, order.cutter, order.pose, {}, order.kind);
        const int end = steps > 0 ? int(rng.below(std::uint32_t(steps))) : 0;
        for (int k = 0; k < end; ++k) dropped.run(0);
    }
    return hash_world(world) == hash ? "" : "a dropped edit changed the world";
}

bool disjoint(const CutOrder& a, const CutOrder& b) {
    const Result<PlacedCutter> p = place_cutter(a.cutter, a.pose), q = place_cutter(b.cutter, b.pose);
    if (!p || !q) return false;
    const Box one = box_of(p.value()), other = box_of(q.value());
    for (int axis = 0; axis < 3; ++axis)
        if (one.high[axis] + 0.01 < other.low[axis] || other.high[axis] + 0.01 < one.low[axis]) return true;
    return false;
}

}  // namespace

void CutTally::fail(const std::string& where, const std::string& what) {
    if (failures.size() < kFailuresKept) failures.push_back(where + ": " + what);
    Refusals& like = kinds[kind_of(what)];
    if (++like.count == 1) like.first = where;
}

void CutTally::add(const CutTally& other) {
    cuts += other.cuts;
    done += other.done;
    nothing += other.nothing;
    refused += other.refused;
    unplaceable += other.unplaceable;
    blamed += other.blamed;
    sliced += other.sliced;
    commuted += other.commuted;
    reseamed += other.reseamed;
    replayed += other.replayed;
    points += other.points;
    protected_points += other.protected_points;
    rays += other.rays;
    casts += other.casts;
    room_casts += other.room_casts;
    crossings += other.crossings;
    ways += other.ways;
    holed += other.holed;
    shared_edges += other.shared_edges;
    carve_seconds += other.carve_seconds;
    failed += other.failed;
    again += other.again;
    reversed += other.reversed;
    grown += other.grown;
    history_points += other.history_points;
    const auto add_kinds = [](const std::map<std::string, Refusals>& from, std::map<std::string, Refusals>& to) {
        for (const auto& [reason, some] : from) {
            Refusals& mine = to[reason];
            mine.count += some.count;
            if (mine.first.empty()) mine.first = some.first;
        }
    };
    add_kinds(other.refusals, refusals);
    add_kinds(other.kinds, kinds);
    for (const std::string& text : other.failures)
        if (failures.size() < kFailuresKept) failures.push_back(text);
}

std::string open_edge(const World& world, std::uint64_t* shared_edges) {
    DirectedEdges edges;
    for (const FacetPlace& place : all_facets(world))
        if (place.record().solid) edges.add(place);
    return edges.first_open(shared_edges);
}

void report_contradictions() {
    set_assert_handler([](const char* condition, const char* advice, const char* file, int line) {
        if (std::strstr(advice, "contradict")) return;
        std::fprintf(stderr, "%s:%d: %s: %s\n", file, line, condition, advice);
        std::abort();
    });
}

ContradictionsReported::~ContradictionsReported() {
    set_assert_handler(nullptr);
}

CarveResult make_cut(const World& world, const CutOrder& order) {
    return order.kind == CarveKind::kFill ? fill(world, order.cutter, order.pose)
                                          : carve(world, order.cutter, order.pose);
}

std::optional<PlacedCutter> placed_cutter(const CutOrder& order, const CarveReport& report) {
    Pose pose = order.pose;
    pose.scale *= report.scale;
    Result<PlacedCutter> placed = place_cutter(order.cutter, pose);
    if (!placed) return std::nullopt;
    return std::move(placed).value();
}

CarveResult judge_cut(World& world, const CutOrder& order, Rng& rng, const std::string& where, CutTally& tally,
                      const JudgeOptions& options) {
    const std::uint64_t hash = hash_world(world);
    const auto start = std::chrono::steady_clock::now();
    CarveResult result = make_cut(world, order);
    tally.carve_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++tally.cuts;
    tally.done += result.done();
    tally.nothing += result.status == CarveStatus::kNothing;
    if (result.status == CarveStatus::kRefused) {
        ++tally.refused;
        CutTally::Refusals& like = tally.refusals[kind_of(result.error.reason)];
        if (++like.count == 1) like.first = where;
    }

    CutJudge judge(world, order, result, rng, where, tally, options);
    judge.judge();
    bool failed = judge.failed();
    const auto expect = [&](bool holds, const std::string& what) {
        if (holds) return;
        tally.fail(where, what);
        failed = true;
    };
    expect(hash_world(world) == hash, "the world before is not as it was");
    if (rng.chance(options.slices)) {
        ++tally.sliced;
        const std::string what = judge_slices(world, order, result, rng);
        expect(what.empty(), what);
    }
    tally.failed += failed;
    world = result.world;
    return result;
}

CutTally judge_cuts(World world, World again, std::span<const CutOrder> cuts, const std::string& name,
                    std::uint64_t seed, const JudgeOptions& options) {
    CutTally tally;
    World before_last = world;
    Rng rng(seed);
    std::optional<ContactJudge> contact;
    if (options.contact) contact.emplace(world, options);
    cuts = cuts.first(std::min(cuts.size(), options.most_cuts));
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        const World before = world;
        const std::string where = name + " cut=" + std::to_string(k);
        const std::uint64_t failed = tally.failed;
        const CarveResult result = judge_cut(world, cuts[k], rng, where, tally, options);
        bool holds = !contact || contact->judge(before, cuts[k], result, rng, where, tally);
        const bool commutes =
            k > 0 && (disjoint(cuts[k - 1], cuts[k]) || (contact && cuts[k - 1].kind == cuts[k].kind));
        if (commutes && rng.chance(0.5)) {
            const World other = make_cut(make_cut(before_last, cuts[k]).world, cuts[k - 1]).world;
            ++tally.commuted;
            const bool same_facets = hash_of_surface(other) == hash_of_surface(world);
            tally.reseamed += !same_facets;
            if (!same_facets && !reference::same_solid(other, world)) {
                tally.fail(where, "another solid when made before cut " + std::to_string(k - 1));
                holds = false;
            }
        }
        if (!holds && tally.failed == failed) ++tally.failed;
        if (contact && tally.failed > failed) contact->start_again(world);
        before_last = before;
    }
    // Equal logs, equal bytes.
    for (const CutOrder& cut : cuts) again = make_cut(again, cut).world;
    tally.replayed += cuts.size();
    if (hash_world(again) != hash_world(world)) {
        tally.fail(name, "made again from the level it ends in another world");
        ++tally.failed;
    }
    return tally;
}

CutTally judge_case(const scenes::CutFamily& family, std::uint64_t seed, std::uint64_t index, const Level& ours,
                    const JudgeOptions& options) {
    const scenes::CutCase it = scenes::make_cut_case(family, seed, index, ours);
    const std::string name =
        std::string(family.name) + " seed=" + std::to_string(seed) + " case=" + std::to_string(index);
    const Result<World> made = make_world(it.level);
    if (!made) {
        CutTally tally;
        tally.fail(name, made.error().text());
        ++tally.failed;
        return tally;
    }
    return judge_cuts(made.value(), make_world(it.level).value(), it.cuts, name, seed ^ index << 32, options);
}

}  // namespace firma::reference
