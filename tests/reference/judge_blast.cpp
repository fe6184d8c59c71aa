// SPDX-License-Identifier: MIT
// Judges blasts in a world with rooms and doors.
#include "tests/reference/judge_blast.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "carve/check_shells.h"
#include "firma/chunk.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "tests/reference/carve_oracle.h"
#include "tests/reference/facet_corners.h"
#include "tests/reference/judge_chunks.h"
#include "tests/reference/judge_rooms.h"
#include "tests/reference/protected_part.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

using scenes::RoomBlast;

/// Metres by which a corner may lie off its exact place: half a step of the surface grid each way.
constexpr double kRoundedBy = 0x1p-19 * 1.7321;
/// Metres: points nearer than this to a face or a rim are not asked about, where rounding could decide.
constexpr double kClearOfFaces = 1e-4, kClearOfRims = 2e-5;
constexpr double kCubicStep = 0x1p-54;  ///< cubic metres

std::string blast_words(const Vec3& v) {
    char text[100];
    std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
    return text;
}
std::string portal_words(std::uint32_t portal) {
    return "portal " + std::to_string(portal);
}
std::string room_words(RoomId room) {
    return "room " + std::to_string(room.value);
}

double portal_area(const Portal& portal) {
    double sum = 0;
    for (const PortalPolygon& polygon : portal.polygons()) sum += length(area_vector(polygon.shape.corners)) / 2;
    return sum;
}

/// Metres from the rim of a convex polygon to a point of its plane, inside; negative outside.
double within_rim(std::span<const Vec3> polygon, const Vec3& normal, const Vec3& point) {
    double least = INFINITY;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[k], &b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        const Vec3 inward = cross(normal, b - a);
        const double size = length(inward);
        if (size > 0) least = std::min(least, dot(inward, point - a) / size);
    }
    return least;
}

/// 6 times the volume of the cones from the origin, cubic steps: a coordinate has 32 bits, a determinant 98, and there
/// are less than 2^29 of them.
class ConeSum {
public:
    template <class Corner>
    void add(std::size_t count, const Corner& corner) {
        for (std::size_t k = 2; k < count; ++k) sum_ += determinant(corner(0), corner(k - 1), corner(k));
    }
    Int128 sum() const { return sum_; }

private:
    static Int128 determinant(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
        const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
            return Int128(p) * q - Int128(r) * s;
        };
        return a.x * minor(b.y, c.z, b.z, c.y) + a.y * minor(b.z, c.x, b.x, c.z) + a.z * minor(b.x, c.y, b.y, c.x);
    }
    Int128 sum_ = 0;
};

/// Six times the volumes of the rooms by their faces and portals, and of the solid by its own list of faces: of what
/// reaches to infinity, what that is short of infinity.
struct SixVolumes {
    std::vector<Int128> rooms;
    Int128 solid = 0;

    explicit SixVolumes(const World& world) {
        const WorldData& data = world.data();
        for (std::uint32_t room = 0; room < world.room_count(); ++room) {
            ConeSum sum;
            for (const FacetPlace& place : facets_of_room(world, room)) add(place, sum);
            rooms.push_back(-sum.sum());
        }
        for (std::uint32_t k = 0; k < data.cells.portal_count(); ++k) {
            const Portal& portal = data.cells.portal(k);
            if (portal.gone()) continue;
            ConeSum sum;
            for (const PortalPolygon& polygon : portal.all_polygons())
                sum.add(polygon.corners.size(), [&](std::size_t c) { return polygon.corners[c]; });
            const std::array<RoomId, 2> between = data.cells.rooms_of(portal);
            rooms[between[0].value] -= sum.sum();
            rooms[between[1].value] += sum.sum();
        }
        ConeSum sum;
        if (const Node* root = data.solid.data().faces.root.get())
            for_each_block(*root, [&](const Block& block) {
                for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) add({&block, slot}, sum);
            });
        solid = sum.sum();
    }

    Int128 all() const {
        Int128 sum = solid;
        for (const Int128 room : rooms) sum += room;
        return sum;
    }

private:
    static void add(const FacetPlace& place, ConeSum& sum) {
        if (!place.record().solid) return;
        const auto corners = grid_corners_of(place);
        sum.add(corners.size(), [&](std::size_t k) { return corners[k]; });
    }
};

double cubic_metres_of(Int128 six) {
    return double(six) / 6 * kCubicStep;
}

/// A point of a portal, well within one of its polygons.
struct PortalPoint {
    Vec3 point, normal;
    double within = 0;  ///< metres from the polygon's rim
};

std::optional<PortalPoint> point_of_portal(const Portal& portal, scenes::Rng& rng) {
    if (portal.polygons().empty()) return {};
    for (int tries = 0; tries < 6; ++tries) {
        const auto polygons = portal.polygons();
        const PortalPolygon& polygon = polygons[rng.below(std::uint32_t(polygons.size()))];
        const std::span<const Vec3> corners = polygon.shape.corners;
        const std::uint32_t k = 2 + rng.below(std::uint32_t(corners.size()) - 2);
        double u = rng.uniform(), v = rng.uniform();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const Vec3 point = corners[0] + (corners[k - 1] - corners[0]) * u + (corners[k] - corners[0]) * v;
        const Vec3 twice = area_vector(corners);
        const Vec3 normal = twice * (1 / length(twice));
        const double within = within_rim(corners, normal, point);
        if (within > kClearOfRims) return PortalPoint{point, normal, within};
    }
    return {};
}

/// Goes from room to room by the polygons that a straight way crosses, told by planes in double.
class PortalWalk {
public:
    enum class End : std::uint8_t { kThere, kUnsure, kWrong };

    PortalWalk(const World& world, RoomId room, const Vec3& from, const Vec3& to) : rooms{room} {
        const Cells& cells = world.data().cells;
        std::vector<Crossing> crossings;
        if (!cross_portals(cells, from, to, crossings)) return;
        std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
        for (std::size_t k = 0; k < crossings.size(); ++k) {
            const Crossing& crossing = crossings[k];
            if (k > 0 && crossing.at - crossings[k - 1].at < 1e-9) return;
            const std::array<RoomId, 2> between = cells.rooms_of(cells.portal(crossing.portal));
            if (between[crossing.from_behind] != rooms.back()) {
                end = End::kWrong;
                wrong = "a way from " + blast_words(from) + " to " + blast_words(to) + " crosses " +
                        portal_words(crossing.portal) + " out of " + room_words(between[crossing.from_behind]) +
                        " where it is in " + room_words(rooms.back());
                return;
            }
            if (cells.is_closed(crossing.portal)) passes_closed = true;
            rooms.push_back(between[!crossing.from_behind]);
        }
        end = End::kThere;
    }

    /// Whether a way crosses one polygon, and no other nor its rim.
    static bool crosses_one(const World& world, const Vec3& from, const Vec3& to) {
        std::vector<Crossing> crossings;
        return cross_portals(world.data().cells, from, to, crossings) && crossings.size() == 1;
    }

    End end = End::kUnsure;
    std::vector<RoomId> rooms;  ///< passed, the first and the last included
    bool passes_closed = false;
    std::string wrong;

private:
    struct Crossing {
        double at;
        std::uint32_t portal;
        bool from_behind;
    };

    /// False where it passes too near a rim, or along a polygon.
    static bool cross_portals(const Cells& cells, const Vec3& from, const Vec3& to, std::vector<Crossing>& crossings) {
        Box way;
        way.add(from);
        way.add(to);
        for (std::uint32_t k = 0; k < cells.portal_count(); ++k) {
            const Portal& portal = cells.portal(k);
            if (portal.gone() || !meet(way, portal.box)) continue;
            for (const PortalPolygon& polygon : portal.polygons())
                if (!cross_polygon(polygon, k, from, to, crossings)) return false;
        }
        return true;
    }

    static bool meet(const Box& way, const GridBox& box) {
        const Vec3 low = to_metres(box.low), high = to_metres(box.high);
        for (int axis = 0; axis < 3; ++axis)
            if (way.high[axis] < low[axis] - kClearOfRims || way.low[axis] > high[axis] + kClearOfRims) return false;
        return true;
    }

    static bool cross_polygon(const PortalPolygon& polygon, std::uint32_t portal, const Vec3& from, const Vec3& to,
                              std::vector<Crossing>& crossings) {
        const std::span<const Vec3> corners = polygon.shape.corners;
        const Vec3 twice = area_vector(corners);
        const Vec3 normal = twice * (1 / length(twice));
        const double before = dot(normal, from - corners[0]), after = dot(normal, to - corners[0]);
        const bool near = std::fabs(before) < 1e-7 || std::fabs(after) < 1e-7;
        if (!near && (before > 0) == (after > 0)) return true;
        const double at = before == after ? 0.5 : std::clamp(before / (before - after), 0.0, 1.0);
        const double within = within_rim(corners, normal, from + (to - from) * at);
        if (within < -kClearOfRims) return !near || before != after;
        if (near || within < kClearOfRims) return false;
        crossings.push_back({at, portal, before < 0});
        return true;
    }
};

/// A world, and what is asked of it before and after a blast.
struct BlastState {
    World world;
    SixVolumes volumes;

    explicit BlastState(const World& of) : world(of), volumes(of) {}
};

/// One blast and everything that is known of it.
class BlastJudge {
public:
    BlastJudge(const BlastState& before, const RoomBlast& blast, const CarveResult& result, scenes::Rng& rng,
               const std::string& where, BlastTally& tally, const BlastJudgeOptions& options)
        : before_(before.world),
          volumes_before_(before.volumes),
          after_(result.world),
          blast_(blast),
          result_(result),
          rng_(rng),
          where_(where),
          tally_(tally),
          options_(options),
          fills_(blast.cut.kind == CarveKind::kFill) {}

    /// What is asked of some blasts alone.
    struct Extent {
        bool whole = true;   ///< the library checks all of the world
        bool volume = true;  ///< the volume of the cutter within the solid is taken
    };

    /// @return the state after; nothing unless the blast was done
    std::optional<BlastState> judge(const Extent& extent) {
        placed_ = placed_cutter(blast_.cut, result_.report);
        if (result_.status == CarveStatus::kRefused) count_refusal();
        if (!result_.done()) {
            if (&before_.data() != &after_.data()) fail("not done, and yet another world");
            if (result_.status == CarveStatus::kNothing && extent.volume) judge_nothing();
            return {};
        }
        if (!placed_) {
            fail("done with a cutter that cannot be placed");
            return {};
        }
        change_ = compare_facets(before_, after_);
        for (const InputPoint& p : placed_->vertices) box_.add(to_metres(to_surface(p)));
        if (const std::string open = unclosed_room(after_); !open.empty()) fail(open);
        if (extent.whole) judge_whole();
        std::optional<BlastState> state(after_);
        judge_volumes(state->volumes, extent.volume);
        judge_rooms();
        judge_portals();
        if (failed_) return state;  // what follows relies on it
        judge_points();
        judge_portal_sides();
        judge_doors();
        judge_casts();
        return state;
    }

    bool failed() const { return failed_; }

private:
    void fail(const std::string& what) {
        tally_.fail(where_, what);
        failed_ = true;
    }

    const Cells& cells_before() const { return before_.data().cells; }
    const Cells& cells_after() const { return after_.data().cells; }

    void count_refusal() {
        const bool unplaceable = !placed_ || check_cutter(*placed_);
        const bool blamed = result_.error.reason.find("degenerate position") != std::string::npos ||
                            result_.error.reason.find("contradict") != std::string::npos;
        if (blamed || !result_.reproduction.empty()) fail("a contradiction: " + result_.error.text());
        tally_.unplaceable += unplaceable;
        tally_.blamed += blamed;
    }

    /// Whether zones or pieces that may not be carved took part of the cutter.
    bool is_cut_short() const { return result_.report.cut_short > 0; }

    void judge_nothing() {
        if (!placed_ || is_cut_short()) return;
        const Real all = volume_of(*placed_), common = volume_within(before_, *placed_);
        const Real expected = fills_ ? Real(all - common) : common;
        if (abs(expected) > all * Real("1e-20")) fail("nothing, where there is something to cut");
    }

    void judge_whole() {
        if (const auto fault = check_world(after_))
            fail("check_world: " + fault->what + " at face " + std::to_string(fault->face.value));
        if (const auto fault = check_solid(after_)) fail("check_solid: " + fault->what);
    }

    /// Cubic metres by which rounded corners may change the volume of a room: all that changed, by its area, before and
    /// after.
    double rounding() const {
        double area = 0;
        for (const std::vector<FacetPlace>* facets : {&change_.gone, &change_.come})
            for (const FacetPlace& place : *facets) area += length(area_vector(facet_corners(place))) / 2;
        for (std::uint32_t k = 0; k < cells_after().portal_count(); ++k) {
            const Portal& is = cells_after().portal(k);
            if (k >= cells_before().portal_count()) {
                area += portal_area(is);
            } else if (&cells_before().portal(k) != &is) {
                area += portal_area(is) + portal_area(cells_before().portal(k));
            }
        }
        return area * kRoundedBy + 1e-12;
    }

    void judge_volumes(const SixVolumes& after, bool with_volume) {
        if (after.all() != volumes_before_.all()) fail("volumes of rooms and solid do not add up to what they did");
        const double allowed = rounding();
        const double lost = cubic_metres_of(volumes_before_.solid - after.solid);
        if (std::fabs(lost - result_.report.volume) > allowed)
            fail("by its facets the solid lost " + std::to_string(lost) + ", by the report " +
                 std::to_string(result_.report.volume));
        const Real exactly = volume_lost(change_.gone, change_.come, *placed_);
        const double far = length(box_.low) + length(box_.high) + 8;
        const Real digits = abs(exactly) * Real(0x1p-51) + Real(far * far * far * 0x1p-88);
        if (abs(Real(result_.report.volume) - exactly) > digits)
            fail("report.volume is not what the solid's exact faces lost");
        if (with_volume) {
            const Real all = volume_of(*placed_), common = volume_within(before_, *placed_);
            Real expected = fills_ ? Real(common - all) : common;
            // What was protected is still there, and judge_points() asks whether that is all.
            if (is_cut_short()) expected = Real(common - volume_within(after_, *placed_));
            if (abs(exactly - expected) > all * Real("1e-20"))
                fail("what was lost is not what the cutter has in common with the solid");
        }
        std::vector<std::uint32_t> gainers;
        for (std::uint32_t room = 0; room < after.rooms.size(); ++room) {
            const bool is_new = room >= volumes_before_.rooms.size();
            const RoomInfo info = *room_info(after_, {room});
            const double is = cubic_metres_of(after.rooms[room]);
            const double gained = is - (is_new ? 0 : cubic_metres_of(volumes_before_.rooms[room]));
            if (info.merged_into != RoomId{room}) continue;
            if (!info.exterior && is < -allowed) fail(room_words({room}) + " has less than no volume");
            if (fills_ ? gained > allowed : gained < -allowed)
                fail(room_words({room}) + (fills_ ? " gained " : " lost ") + std::to_string(gained) + " m3");
            if (!fills_ && !is_new && gained > allowed && lost_no_wall(room))
                fail(room_words({room}) + " gained air that it does not touch");
            if (gained > allowed) gainers.push_back(room);
        }
        if (!fills_ && !blast_.from && gainers.size() == 1 && gainers[0] < before_.room_count())
            judge_choice(gainers[0]);
    }

    /// All pockets went to one room: of the walls that were taken no other one had more.
    void judge_choice(std::uint32_t room) {
        for (const FacetPlace& place : change_.come)  // a pocket may be smaller than what rounding makes
            if (place.record().solid && place.record().edit == after_.data().edits() &&
                cells_after().current_room(place.block->part) != room)
                return;
        constexpr double kSure = 1e-3;  // square metres: more than rounding of corners makes
        const double own = taken_of_walls(room);
        bool several = false;
        for (std::uint32_t other = 0; other < before_.room_count(); ++other) {
            if (room_info(before_, {other})->merged_into != RoomId{other} || other == room) continue;
            if (room_info(after_, {other})->merged_into != RoomId{other}) return;  // swallowed: the last choice
            const double taken = taken_of_walls(other);
            several |= taken > kSure;
            if (taken > own + kSure)
                fail("what was opened went to " + room_words({room}) + ", and more of the walls of " +
                     room_words({other}) + " was taken");
        }
        tally_.choices += several;
    }

    struct WallArea {
        double was = 0, is = 0;  ///< square metres, of the facets that changed
    };
    /// Square metres of a room's walls that were taken: by faces, as one that the cutter's face beside it became part
    /// of makes up for no other. Faces that bound no solid are no walls.
    double taken_of_walls(std::uint32_t room) const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, WallArea> faces;  // by edit and source
        const auto of_face = [&](const FacetPlace& place) -> WallArea& {
            return faces[{place.record().edit, place.record().source}];
        };
        const auto area_of = [](const FacetPlace& place) { return length(area_vector(facet_corners(place))) / 2; };
        for (const FacetPlace& place : change_.gone)
            if (was_wall(place, room)) of_face(place).was += area_of(place);
        for (const FacetPlace& place : change_.come)
            if (is_old_wall(place, room)) of_face(place).is += area_of(place);
        double taken = 0;
        for (const auto& [key, walls] : faces) taken += std::fmax(0, walls.was - walls.is);
        return taken;
    }
    bool was_wall(const FacetPlace& place, std::uint32_t room) const {
        return place.record().solid && cells_before().current_room(place.block->part) == room;
    }
    /// Of the world after, but not of this edit's cutter.
    bool is_old_wall(const FacetPlace& place, std::uint32_t room) const {
        return place.record().solid && place.record().edit != after_.data().edits() &&
               cells_after().current_room(place.block->part) == room;
    }

    /// Whether none of a room's walls was taken, exactly so on a lattice; where corners were rounded it is not told. By
    /// planes: a wall that grows, as the cutter's face beside it becomes part of it, may make up for what another lost.
    bool lost_no_wall(std::uint32_t room) const {
        using Key = std::array<long long, 4>;  // of a plane: its normal and how far off the origin it lies
        std::map<Key, WallArea> planes;
        const auto add = [&](const FacetPlace& place, double WallArea::* sum) {
            const std::vector<Vec3> corners = facet_corners(place);
            const Vec3 twice = area_vector(corners);
            const double size = length(twice);
            if (size == 0) return;
            const Vec3 normal = twice * (1 / size);
            Key key;
            for (int axis = 0; axis < 3; ++axis) key[std::size_t(axis)] = std::llround(normal[axis] * 1e6);
            key[3] = std::llround(dot(normal, corners[0]) * 1e6);
            planes[key].*sum += size / 2;
        };
        for (const FacetPlace& place : change_.gone)
            if (was_wall(place, room)) add(place, &WallArea::was);
        for (const FacetPlace& place : change_.come)
            if (is_old_wall(place, room)) add(place, &WallArea::is);
        return std::all_of(planes.begin(), planes.end(), [](const auto& plane) {
            const WallArea& walls = plane.second;
            return std::fabs(walls.was - walls.is) <= 1e-12 * (1 + walls.was);
        });
    }

    void judge_rooms() {
        if (after_.room_count() < before_.room_count()) return fail("a room is not there any more");
        std::set<FaceId> gone;
        for (const FacetPlace& place : change_.gone) gone.insert(place.record().id);
        for (std::uint32_t k = 0; k < before_.room_count(); ++k) {
            const RoomInfo was = *room_info(before_, {k}), is = *room_info(after_, {k});
            if (was.name != is.name) fail(room_words({k}) + " has another name");
            if (was.merged_into != RoomId{k}) continue;
            if (is.merged_into == RoomId{k}) {
                if (was.exterior != is.exterior) fail(room_words({k}) + " is the exterior no more, or only now");
                tally_.rooms_filled += fills_ && was.faces > 0 && is.faces == 0;
                continue;
            }
            bool swallowed = !fills_ && was.portals.empty() && !was.exterior;
            for (const FacetPlace& place : facets_of_room(before_, k))
                swallowed = swallowed && (!place.record().solid || gone.contains(place.record().id));
            tally_.rooms_swallowed += swallowed;
            if (!swallowed) fail(room_words({k}) + " became part of " + room_words(is.merged_into));
        }
        tally_.rooms_made += after_.room_count() - before_.room_count();
    }

    using RoomPair = std::pair<std::uint32_t, std::uint32_t>;
    static RoomPair pair_of(const Cells& cells, const Portal& portal) {
        const std::array<RoomId, 2> rooms = cells.rooms_of(portal);
        return std::minmax(rooms[0].value, rooms[1].value);
    }
    static std::map<RoomPair, double> made_areas(const Cells& cells, const Cells& names) {
        std::map<RoomPair, double> areas;
        for (std::uint32_t k = 0; k < cells.portal_count(); ++k)
            if (cells.portal(k).made && !cells.portal(k).gone())
                areas[pair_of(names, cells.portal(k))] += portal_area(cells.portal(k));
        return areas;
    }

    void judge_portals() {
        const Cells &before = cells_before(), &after = cells_after();
        if (after.portal_count() < before.portal_count()) return fail("a portal is not there any more");
        for (std::uint32_t k = 0; k < before.portal_count(); ++k) {
            const Portal &was = before.portal(k), &is = after.portal(k);
            if (was.name != is.name || was.made != is.made || was.mask != is.mask)
                fail(portal_words(k) + " is another one");
            if (was.gone() != is.gone() && was.gone()) fail(portal_words(k) + " came back");
            if (before.is_closed(k) != after.is_closed(k) && !(fills_ && is.gone()))
                fail(portal_words(k) + " was opened or closed");
            if (&was == &is || was.gone()) continue;
            if (!is.gone() && pair_of(after, was) != pair_of(after, is)) fail(portal_words(k) + " leads elsewhere");
            const double change = portal_area(is) - portal_area(was);
            const double size = length(to_metres(was.box.high) - to_metres(was.box.low));
            const double allowed = kRoundedBy * 4 * (size + 1);
            if (fills_) {
                tally_.portals_filled += is.gone();
                tally_.portals_clipped += !is.gone();
                if (change > allowed) fail(portal_words(k) + " grew by a fill");
            } else if (!was.made) {
                tally_.portals_divided += 1;
                if (is.gone()) fail(portal_words(k) + " is gone");
                if (std::fabs(change) > allowed)
                    fail(portal_words(k) + " changed its area by " + std::to_string(change));
            } else {
                tally_.portals_grown += change > allowed;
            }
        }
        if (!fills_) judge_made_areas();
        for (std::uint32_t k = before.portal_count(); k < after.portal_count(); ++k) {
            const Portal& made = after.portal(k);
            const std::array<RoomId, 2> rooms = after.rooms_of(made);
            if (fills_) fail("a fill made a portal");
            if (!made.made || after.is_closed(k) || !made.name.empty()) fail("a new portal is none of an edit");
            if (rooms[0] == rooms[1] || made.gone()) fail("a new portal leads nowhere");
            ++tally_.portals_made;
        }
        tally_.holed += after.portal_count() > before.portal_count();
    }

    /// Carving takes nothing of what earlier carvings opened between two rooms, though pieces may have gone to another
    /// portal.
    void judge_made_areas() {
        const std::map<RoomPair, double> is = made_areas(cells_after(), cells_after());
        for (const auto& [rooms, area] : made_areas(cells_before(), cells_after())) {
            if (rooms.first == rooms.second) continue;  // of a room that was swallowed
            const auto found = is.find(rooms);
            if (found == is.end() || found->second < area - kRoundedBy * 16 * (area + 8))
                fail("portals of edits between " + room_words({rooms.first}) + " and " + room_words({rooms.second}) +
                     " became smaller");
        }
    }

    Vec3 point_around(double times) {
        const Vec3 middle = (box_.low + box_.high) * 0.5, half = (box_.high - box_.low) * (0.5 * times);
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = rng_.uniform(middle[axis] - half[axis], middle[axis] + half[axis]);
        return p;
    }

    bool is_clear(const Vec3& p) const {
        return !closest(before_, p, kClearOfFaces) && !closest(after_, p, kClearOfFaces);
    }

    void judge_points() {
        const RoomBounds rooms(after_);
        const ProtectedPart protected_part(before_, fills_);
        for (int k = 0; k < options_.points; ++k) {
            const Vec3 p = point_around(k % 3 == 0 ? 1.6 : 1);
            if (!is_clear(p)) continue;
            ++tally_.points;
            Location is;
            if (const std::string wrong = rooms.judge(p, &is); !wrong.empty()) return fail(wrong);
            const Location was = locate(before_, p);
            const bool in_cutter = winding(*placed_, p) > 0.5, cut = in_cutter && !protected_part.holds(p);
            tally_.protected_points += in_cutter && !cut;
            if (was.where != Where::kAir && was.where != Where::kSolid)
                return fail("before, locate() cannot tell of " + blast_words(p));
            const bool solid = fills_ ? was.where == Where::kSolid || cut : was.where == Where::kSolid && !cut;
            if (solid != (is.where == Where::kSolid)) return fail("on the wrong side of the solid: " + blast_words(p));
            if (solid) continue;
            if (was.where == Where::kAir && room_info(after_, was.room)->merged_into != is.room)
                return fail("what was air of " + room_words(was.room) + " is of " + room_words(is.room) + ": " +
                            blast_words(p));
            if (!judge_ways(p, is.room)) return;
            air_.emplace_back(p, is.room);
        }
    }

    /// From a few of the points found so far: as far as the way is free.
    bool judge_ways(const Vec3& to, RoomId room) {
        for (int k = 0; k < 3 && !air_.empty(); ++k) {
            const auto& [from, start] = air_[rng_.below(std::uint32_t(air_.size()))];
            std::array<RoomId, 256> passed;
            RoomTrail trail{passed};
            const Hit hit = cast(after_, {from, 0}, to - from, {.room = start, .trail = &trail});
            Vec3 end = to;
            RoomId located = room;
            if (hit.touched()) {
                end = from + (to - from) * (hit.fraction * 0.999);
                if (closest(after_, end, kClearOfFaces)) continue;
                const Location found = locate(after_, end);
                if (found.where != Where::kAir) {
                    fail("a way through the air ends outside it, at " + blast_words(end));
                    return false;
                }
                located = found.room;
            }
            const PortalWalk walk(after_, start, from, end);
            if (walk.end == PortalWalk::End::kUnsure) continue;
            ++tally_.ways;
            if (walk.end == PortalWalk::End::kWrong) {
                fail(walk.wrong);
                return false;
            }
            if (walk.rooms.back() != located) {
                fail("by portals, the way from " + blast_words(from) + " to " + blast_words(end) + " leads to " +
                     room_words(walk.rooms.back()) + ", and locate() says " + room_words(located));
                return false;
            }
            if (walk.passes_closed) {
                fail("a cast passes a closed portal: from " + blast_words(from) + " to " + blast_words(end));
                return false;
            }
            tally_.crossings += walk.rooms.size() > 1;
            const std::span<const RoomId> seen(passed.data(), std::min<std::size_t>(trail.count, passed.size()));
            for (const RoomId of_walk : walk.rooms)
                if (std::find(seen.begin(), seen.end(), of_walk) == seen.end()) {
                    fail("a cast by room does not tell of " + room_words(of_walk) + " on its way from " +
                         blast_words(from) + " to " + blast_words(to));
                    return false;
                }
        }
        return true;
    }

    std::vector<std::uint32_t> portals_near(const Cells& cells, bool closed, double reach) const {
        std::vector<std::uint32_t> near;
        for (std::uint32_t k = 0; k < cells.portal_count(); ++k) {
            const Portal& portal = cells.portal(k);
            if (portal.polygons().empty() || cells.is_closed(k) != closed) continue;
            const Vec3 low = to_metres(portal.box.low), high = to_metres(portal.box.high);
            bool meet = true;
            for (int axis = 0; axis < 3; ++axis)
                meet = meet && low[axis] <= box_.high[axis] + reach && high[axis] >= box_.low[axis] - reach;
            if (meet) near.push_back(k);
        }
        return near;
    }

    bool is_changed(std::uint32_t portal) const {
        return portal >= cells_before().portal_count() ||
               &cells_before().portal(portal) != &cells_after().portal(portal);
    }

    /// Both sides of points of open portals, new ones and changed ones first: the rooms that it names, a way through,
    /// and of a new one that it was a wall.
    void judge_portal_sides() {
        std::vector<std::uint32_t> portals, others;
        for (const std::uint32_t k : portals_near(cells_after(), false, 1))
            (is_changed(k) ? portals : others).push_back(k);
        portals.insert(portals.end(), others.begin(), others.end());
        for (std::size_t k = 0; k < portals.size() && k < std::size_t(options_.open) * 2; ++k) {
            if (k >= std::size_t(options_.open) && !is_changed(portals[k])) break;
            if (!judge_sides_of(portals[k])) return;
        }
    }

    bool judge_sides_of(std::uint32_t number) {
        const Portal& portal = cells_after().portal(number);
        const std::optional<PortalPoint> at = point_of_portal(portal, rng_);
        if (!at) return true;
        const double step = std::min(1e-3, at->within * 0.4);
        if (closest(after_, at->point, step * 1.5)) return true;
        const std::array<RoomId, 2> rooms = cells_after().rooms_of(portal);
        const std::array<Vec3, 2> sides{at->point + at->normal * step, at->point - at->normal * step};
        if (!PortalWalk::crosses_one(after_, sides[0], sides[1])) return true;  // another portal is as near
        std::array<Location, 2> is;
        for (std::size_t side = 0; side < 2; ++side) is[side] = locate(after_, sides[side]);
        ++tally_.open_casts;
        for (const std::size_t side : {0u, 1u}) {
            if (is[side] != Location{Where::kAir, rooms[side]}) {
                fail(portal_words(number) + " leads to " + room_words(rooms[side]) + ", and beside it at " +
                     blast_words(sides[side]) + " locate() says " + room_words(is[side].room));
                return false;
            }
            std::array<RoomId, 16> passed;
            RoomTrail trail{passed};
            const Hit hit =
                cast(after_, {sides[side], 0}, sides[!side] - sides[side], {.room = rooms[side], .trail = &trail});
            const auto end = passed.begin() + std::min<std::ptrdiff_t>(trail.count, std::ssize(passed));
            if (hit.touched() || std::find(passed.begin(), end, rooms[!side]) == end) {
                fail("no way through " + portal_words(number) + " at " + blast_words(at->point));
                return false;
            }
        }
        if (fills_ || !portal.made || !is_changed(number) || closest(before_, sides[0], step / 4) ||
            closest(before_, sides[1], step / 4) || crosses_several(before_, sides[0], sides[1]))
            return true;
        ++tally_.portal_sides;
        return judge_was_wall(number, sides, rooms);
    }

    /// Whether faces stand between two points one behind the other, as around air that is thinner than the way.
    static bool crosses_several(const World& world, const Vec3& from, const Vec3& to) {
        std::vector<Hit> hits;
        cast_all(world, {from, 0}, to - from, hits, {.sides = Sides::kBoth, .room = kAnyRoom});
        return !hits.empty() && hits.back().fraction > hits.front().fraction + 0.01;
    }

    /// A point of a portal that edits made, on one side of which there was solid: on the other there was the air of a
    /// room, and that is not the room that the shot came from, as then the pocket would be that room's.
    bool judge_was_wall(std::uint32_t number, const std::array<Vec3, 2>& sides, const std::array<RoomId, 2>& rooms) {
        const std::array<Location, 2> was{locate(before_, sides[0]), locate(before_, sides[1])};
        const bool solid[2] = {was[0].where == Where::kSolid, was[1].where == Where::kSolid};
        if (solid[0] && solid[1]) {
            fail(portal_words(number) + " stands where there was nothing but solid, at " + blast_words(sides[0]));
            return false;
        }
        if (!solid[0] && !solid[1]) return true;  // of an earlier blast
        const RoomId wall = rooms[solid[0]], pocket = rooms[solid[1]];
        const Location from = blast_.from ? locate(before_, *blast_.from) : Location{Where::kSolid, {}};
        if (from.where != Where::kAir || room_info(after_, from.room)->merged_into != wall) return true;
        fail("a pocket beside a wall of " + room_words(wall) + ", from which the shot came, is of " +
             room_words(pocket) + ": " + portal_words(number) + " at " + blast_words(sides[0]));
        return false;
    }

    /// Whether a fill left a point, and what is right beside it, alone.
    bool is_left(const Vec3& p) const {
        if (!fills_) return true;
        if (winding(*placed_, p) > 0.5) return false;
        for (int k = 0; k < 6; ++k) {
            Vec3 beside = p;
            beside[k / 2] += k % 2 == 0 ? kClearOfFaces : -kClearOfFaces;
            if (winding(*placed_, beside) > 0.5) return false;
        }
        return true;
    }

    /// Rays and spheres through points of portals that are closed, as those were before: none comes through.
    void judge_doors() {
        const std::vector<std::uint32_t> doors = portals_near(cells_before(), true, 2);
        for (int k = 0; k < options_.doors && !doors.empty(); ++k) {
            const std::uint32_t door = doors[rng_.below(std::uint32_t(doors.size()))];
            const std::optional<PortalPoint> at = point_of_portal(cells_before().portal(door), rng_);
            if (!at || !is_left(at->point)) continue;
            Vec3 way = rng_.direction();
            const double slant = dot(way, at->normal);
            if (std::fabs(slant) < 0.05) way = at->normal;
            const double far = rng_.chance(0.5) ? 0.01 : rng_.uniform(0.02, 3);
            const double radius = rng_.chance(0.5) ? 0 : rng_.uniform(0, 0.4);
            const Vec3 start = at->point - way * far;
            const Sides sides = rng_.chance(0.5) ? Sides::kFront : Sides::kBoth;
            CastOptions how{.sides = sides};
            for (const bool by_room : {false, true}) {
                if (by_room) {
                    const Location found = locate(after_, start);
                    if (found.where != Where::kAir || closest(after_, start, radius + 1e-5)) break;
                    how.room = found.room;
                }
                const Hit hit = cast(after_, {start, radius}, way * (2 * far), how);
                ++tally_.door_casts;
                // Of polygons that were cut, corners are rounded: off their plane.
                const double beyond = (hit.fraction - 0.5) * 2 * far * std::fabs(dot(way, at->normal));
                if (hit.touched() && beyond <= 4 * kRoundedBy) continue;
                fail("a cast comes through closed " + portal_words(door) + " at " + blast_words(at->point) + ": from " +
                     blast_words(start) + " by " + blast_words(way * (2 * far)) + " radius " + std::to_string(radius) +
                     (by_room ? " by room" : ""));
                return;
            }
        }
    }

    void judge_casts() {
        const double size = length(box_.high - box_.low);
        for (int k = 0; k < options_.casts; ++k) {
            const Vec3 start = point_around(2);
            const Vec3 direction = rng_.direction();
            const double distance = size * std::ldexp(1.0, int(rng_.below(5)) - 2);
            const double radius = rng_.chance(0.5) ? 0 : distance * 0.2 * rng_.uniform();
            const Hit hit = cast(after_, {start, radius}, direction * distance, {.sides = Sides::kBoth});
            ++tally_.casts;
            if (hit.portal.valid() && portal_info(after_, hit.portal)->open)
                return fail("a cast meets open " + portal_words(hit.portal.value));
            std::uint32_t passed = 0;
            const std::string wrong = judge_cast_by_room(after_, {start, radius}, direction * distance, passed);
            if (!wrong.empty()) return fail(wrong);
            tally_.room_casts += passed > 0;
        }
    }

    const World& before_;
    const SixVolumes& volumes_before_;
    const World& after_;
    const RoomBlast& blast_;
    const CarveResult& result_;
    scenes::Rng& rng_;
    const std::string& where_;
    BlastTally& tally_;
    const BlastJudgeOptions& options_;
    const bool fills_;
    std::optional<PlacedCutter> placed_;
    FacetChange change_;
    Box box_;  ///< of the cutter
    std::vector<std::pair<Vec3, RoomId>> air_;
    bool failed_ = false;
};

CarveResult fire(const World& world, const RoomBlast& blast, CarveOptions how) {
    how.from = blast.from;
    const scenes::CutOrder& cut = blast.cut;
    return cut.kind == CarveKind::kFill ? fill(world, cut.cutter, cut.pose, how)
                                        : carve(world, cut.cutter, cut.pose, how);
}

/// The same world hit by the same blasts, where what comes loose leaves.
class LooseJudge {
public:
    explicit LooseJudge(const World& world) : world_(with_anchors(world)), hanging_(hanging_faces(world)) {}

    /// The search beside the cut finds what a flood over all faces finds, and rooms are closed without it.
    /// @param judged  whether that is looked at
    /// @return what is wrong
    std::string add(const RoomBlast& blast, bool judged, BlastTally& tally) {
        CarveOptions how;
        how.chunks = ChunkOptions{.min_volume = 0};
        const bool fills = blast.cut.kind == CarveKind::kFill;
        CarveResult result = fire(world_, blast, how);
        std::string wrong;
        if (judged && !fills) {
            const ChunkVerdict verdict = judge_chunks(world_, hanging_, result, fire(world_, blast, {}));
            ++tally.chunk_searches;
            tally.chunks += verdict.loose;
            wrong = verdict.fault;
            if (wrong.empty()) wrong = unclosed_room(result.world);
            if (wrong.empty() && SixVolumes(result.world).all() != SixVolumes(world_).all())
                wrong = "volumes of rooms and solid do not add up to what they did";
        }
        if (!result.done()) return wrong;
        // What is put down free in the air stays there.
        if (fills)
            for (const auto& face : put_down_faces(result.world)) hanging_.insert(face);
        world_ = result.world;
        return wrong;
    }

private:
    World world_;
    HangingFaces hanging_;
};

std::string text_of_blast(const RoomBlast& blast) {
    return std::string(scenes::kBlastNames[std::size_t(blast.family)]) +
           (blast.cut.kind == CarveKind::kFill ? " fill" : " carve") + " at " + blast_words(blast.cut.pose.position);
}

}  // namespace

void BlastTally::add(const BlastTally& other) {
    CutTally::add(other);
    filled += other.filled;
    shot_from += other.shot_from;
    cut_short += other.cut_short;
    rooms_made += other.rooms_made;
    rooms_swallowed += other.rooms_swallowed;
    rooms_filled += other.rooms_filled;
    choices += other.choices;
    portals_made += other.portals_made;
    portals_grown += other.portals_grown;
    portals_divided += other.portals_divided;
    portals_clipped += other.portals_clipped;
    portals_filled += other.portals_filled;
    portal_sides += other.portal_sides;
    door_casts += other.door_casts;
    open_casts += other.open_casts;
    chunk_searches += other.chunk_searches;
    chunks += other.chunks;
    judge_seconds += other.judge_seconds;
}

BlastTally judge_blasts(World world, std::span<const RoomBlast> blasts, const std::string& name, std::uint64_t seed,
                        const BlastJudgeOptions& options) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    BlastTally tally;
    std::optional<BlastState> state(world);
    std::optional<LooseJudge> loose;
    if (options.chunks_every > 0) loose.emplace(world);
    for (std::size_t k = 0; k < blasts.size(); ++k) {
        const RoomBlast& blast = blasts[k];
        scenes::Rng rng(seed * 0x9E3779B97F4A7C15ull ^ (k + 1) * 0xD1B54A32D192ED03ull);
        const std::string where = name + " blast=" + std::to_string(k) + " " + text_of_blast(blast);
        const auto start = Clock::now();
        const bool fills = blast.cut.kind == CarveKind::kFill;
        const CarveResult result = fire(state->world, blast, {});
        tally.carve_seconds += seconds_since(start);
        const auto judged = Clock::now();
        ++tally.cuts;
        tally.done += result.done();
        tally.nothing += result.status == CarveStatus::kNothing;
        tally.refused += result.status == CarveStatus::kRefused;
        tally.filled += result.done() && fills;
        tally.cut_short += result.done() && result.report.cut_short > 0;
        tally.shot_from += result.done() && blast.from.has_value();
        if (result.status == CarveStatus::kRefused) {
            CutTally::Refusals& like = tally.refusals[result.error.reason];
            if (++like.count == 1) like.first = where;
        }
        const bool last = k + 1 == blasts.size();
        const auto is_due = [&](int every) { return every > 0 && k % std::size_t(every) == std::size_t(every) - 1; };
        BlastJudge::Extent extent;
        extent.whole = last || is_due(options.whole_every);
        extent.volume = is_due(options.volume_every);
        BlastJudge judge(*state, blast, result, rng, where, tally, options);
        std::optional<BlastState> after = judge.judge(extent);
        bool failed = judge.failed();
        if (options.chunks_every > 0) {
            const std::string wrong = loose->add(blast, is_due(options.chunks_every), tally);
            if (!wrong.empty()) tally.fail(where, "with loose pieces taken out: " + wrong);
            failed = failed || !wrong.empty();
        }
        tally.judge_seconds += seconds_since(judged);
        tally.failed += failed;
        if (failed) break;  // what comes after would fail likewise
        if (after) state = std::move(after);
    }
    return tally;
}

}  // namespace firma::reference
