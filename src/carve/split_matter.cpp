// SPDX-License-Identifier: MIT
// New faces split where pieces of different matter meet.
//
// A plane Q divides a face in plane P along their line, directed as P x Q. A vertex on Q counts as in front of it, as
// if Q were moved back by less than anything: then each loop changes sides at single places, which lie in order along
// the line, in turn into the face's front part and out of it. Between each pair of them the line lies in the face and
// becomes an edge; what the loops hold in front and behind, with these edges, are the parts' outlines. Where an edge of
// the face runs along the line already, its part behind keeps it in place of a new one, and its part in front, which
// would run there and back, goes without.
#include "carve/split_matter.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"
#include "carve/gather.h"
#include "carve/group_loops.h"
#include "geometry/flat_point.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone32 = ~0u;

/// A piece near a cut, and whether it wins over those that may be carved.
struct Contender {
    bool soft;
    std::uint32_t number;
    auto operator<=>(const Contender&) const = default;
};

}  // namespace

std::optional<std::uint32_t> one_matter_near(const MatterPieces& pieces, const GridBox& box) {
    if (pieces.same && !pieces.pieces.empty()) return pieces.pieces[0].matter;
    std::optional<std::uint32_t> found;
    bool mesh = false;
    const bool several = pieces.tree.for_each_meeting(box, [&](std::uint32_t number) {
        const MatterPiece& piece = pieces.pieces[number];
        mesh = mesh || piece.mesh;
        if (found && *found != piece.matter) return true;
        found = piece.matter;
        return false;
    });
    if (several) return std::nullopt;
    // Around a mesh is the rest; bodies are all that is solid near them.
    if (mesh && *found != pieces.rest) return std::nullopt;
    return found.value_or(pieces.rest);
}

MatterSplitter::MatterSplitter(const CutInput& in, const Crossings& crossings, const NewLoops& loops,
                               const CutMatters& matters, const CarveRules* rules)
    : in_(in),
      loops_(loops),
      pieces_(*matters.pieces),
      inside_(matters.inside),
      rules_(rules),
      crossings_(crossings),
      view_(in, crossings_, made_) {
    made_.edges = loops.edges;
    first_part_ = view_.edge_count();
    assigned_.resize(loops.faces.size());
}

bool MatterSplitter::step() {
    if (next_ == loops_.faces.size()) {
        finish();
        return false;
    }
    if (next_ == 0) list_candidates();
    if (loops_.faces[next_].face == kNone32) assign(loops_.faces[next_]);
    ++next_;
    return true;
}

void MatterSplitter::assign(const NewFace& face) {
    Part whole;
    whole.uses.assign(loops_.uses(face).begin(), loops_.uses(face).end());
    whole.ends.assign(loops_.ends(face).begin(), loops_.ends(face).end());
    face_ = &face;
    plane_ = face.plane.get();
    assigned_[next_] = resolve(std::move(whole), candidates_);
    for (const Assigned& it : assigned_[next_]) note_vertices(it.part);
}

/// Corners are rounded, and so are boxes of pieces: a little larger than what it holds.
GridBox MatterSplitter::reach_of(std::span<const PatchUse> uses) const {
    GridBox box;
    for (const PatchUse& use : uses) box.add(view_.point(view_.from(use)).rounded());
    return grown(box, 2);
}

/// All pieces near the new faces. What wins comes first: what may not be carved, then the lower number.
void MatterSplitter::list_candidates() {
    GridBox box;
    for (const NewFace& face : loops_.faces)
        if (face.face == kNone32) box.add(reach_of(loops_.uses(face)));
    if (box.low.x > box.high.x) return;
    const bool hard = any_hard(pieces_, rules_);
    std::vector<Contender> found;
    pieces_.tree.for_each_meeting(box, [&](std::uint32_t number) {
        found.push_back({!hard || hardness_of(pieces_, pieces_.pieces[number], rules_) < 1, number});
        return false;
    });
    sort_range(found);
    for (const Contender& it : found) candidates_.push_back(it.number);
}

/// Where a part lies. In a plane, what counts is what is behind the face.
MatterSplitter::Sides MatterSplitter::sides(const Part& part, const SolidPlane& plane) const {
    Sides found;
    for (const PatchUse& use : part.uses) {
        const int side = exact_side(plane.plane, view_.point(view_.from(use)));
        found.behind |= side < 0;
        found.front |= side > 0;
        if (found.behind && found.front) return found;
    }
    if (!found.behind && !found.front)
        (dot(plane.plane.direction(), plane_->plane.direction()) < 0 ? found.front : found.behind) = true;
    return found;
}

/// Whether nothing of a part lies behind a plane.
bool MatterSplitter::keeps_away(const SolidPlane& plane, const Part& part) const {
    bool front = false;
    for (const PatchUse& use : part.uses) {
        const int side = exact_side(plane.plane, view_.point(view_.from(use)));
        if (side < 0) return false;
        front |= side > 0;
    }
    return front || sides(part, plane).front;
}

/// Those that no plane of their own keeps away from a part. Behind a face that carving makes lies solid: where all near
/// it are of one matter no more is asked.
std::vector<std::uint32_t> MatterSplitter::near(const Part& part, std::span<const std::uint32_t> candidates) const {
    const GridBox reach = reach_of(part.uses);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t number : candidates)
        if (boxes_meet(pieces_.pieces[number].box, reach)) found.push_back(number);
    if (are_of_one(found)) return found;
    std::erase_if(found, [&](std::uint32_t number) {
        return std::ranges::any_of(pieces_.planes_of(pieces_.pieces[number]),
                                   [&](const auto& plane) { return keeps_away(*plane, part); });
    });
    return found;
}

/// Bodies of one matter, none of a mesh.
bool MatterSplitter::are_of_one(std::span<const std::uint32_t> pieces) const {
    return std::ranges::all_of(pieces, [&](std::uint32_t number) {
        const MatterPiece& piece = pieces_.pieces[number];
        return !piece.mesh && piece.matter == pieces_.pieces[pieces[0]].matter;
    });
}

bool MatterSplitter::all_of_one(const std::vector<Assigned>& parts) const {
    return std::all_of(parts.begin(), parts.end(), [&](const Assigned& it) { return it.matter == parts[0].matter; });
}

std::vector<MatterSplitter::Assigned> MatterSplitter::one(Part part, std::uint32_t matter) {
    std::vector<Assigned> made;
    made.push_back({std::move(part), matter});
    return made;
}

/// @param candidates  those before them do not hold any of the part
std::vector<MatterSplitter::Assigned> MatterSplitter::resolve(Part part, std::span<const std::uint32_t> candidates) {
    const std::vector<std::uint32_t> found = near(part, candidates);
    for (std::span<const std::uint32_t> left = found; !left.empty(); left = left.subspan(1)) {
        const MatterPiece& piece = pieces_.pieces[left[0]];
        if (are_of_one(left)) return one(std::move(part), piece.matter);
        if (!piece.mesh) return divide(std::move(part), left, 0);
        const std::optional<GridPoint> point = point_within(part);
        if (point && holds(pieces_, piece, *point)) return one(std::move(part), piece.matter);
    }
    return one(std::move(part), pieces_.rest);
}

/// @param candidates  none of them a mesh's, of the first
/// @param plane       of the first: the part lies behind those before
std::vector<MatterSplitter::Assigned> MatterSplitter::divide(Part part, std::span<const std::uint32_t> candidates,
                                                             std::size_t plane) {
    const MatterPiece& piece = pieces_.pieces[candidates[0]];
    for (; plane < piece.plane_count; ++plane) {
        const Ref<const SolidPlane>& by = pieces_.planes_of(piece)[plane];
        const Sides lies = sides(part, *by);
        if (!lies.front) continue;
        if (!lies.behind) return resolve(std::move(part), candidates.subspan(1));
        std::vector<Part> behind, front;
        if (!split(part, by, behind, front)) {
            const std::uint32_t matter = matter_at_point(part, candidates);
            return one(std::move(part), matter);
        }
        std::vector<Assigned> all;
        const auto add = [&](std::vector<Assigned> some) {
            for (Assigned& it : some) all.push_back(std::move(it));
        };
        for (Part& it : behind) add(divide(std::move(it), candidates, plane + 1));
        for (Part& it : front) add(resolve(std::move(it), candidates.subspan(1)));
        if (!all_of_one(all)) return all;
        return one(std::move(part), all[0].matter);
    }
    return one(std::move(part), piece.matter);
}

/// Behind one point, where nothing better tells.
std::uint32_t MatterSplitter::matter_at_point(const Part& part, std::span<const std::uint32_t> candidates) const {
    const std::optional<GridPoint> point = point_within(part);
    if (point)
        for (const std::uint32_t number : candidates)
            if (holds(pieces_, pieces_.pieces[number], *point)) return pieces_.pieces[number].matter;
    return pieces_.pieces[candidates[0]].matter;
}

/// In the middle of the widest way through a part across, where it is cut halfway between two corners.
std::optional<GridPoint> MatterSplitter::point_within(const Part& part) const {
    const Plane& plane = plane_->plane;
    const FlatView view = plane.front_view();
    std::vector<double> heights;
    for (const PatchUse& use : part.uses) heights.push_back(view_.point(view_.from(use)).approximate()[view.v()]);
    sort_range(heights);
    double at = 0, gap = 0;
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
        if (heights[k + 1] - heights[k] > gap) {
            gap = heights[k + 1] - heights[k];
            at = (heights[k] + heights[k + 1]) / 2;
        }
    if (!(gap > 0)) return std::nullopt;
    std::vector<double> crossed;
    for (const PatchUse& use : part.uses) {
        const Vec3 &a = view_.point(view_.from(use)).approximate(), &b = view_.point(view_.to(use)).approximate();
        const double a_v = a[view.v()], b_v = b[view.v()];
        if ((a_v < at) == (b_v < at)) continue;
        crossed.push_back(a[view.u()] + (b[view.u()] - a[view.u()]) * ((at - a_v) / (b_v - a_v)));
    }
    sort_range(crossed);
    double middle = 0, width = -1;
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2)
        if (crossed[k + 1] - crossed[k] > width) {
            width = crossed[k + 1] - crossed[k];
            middle = (crossed[k] + crossed[k + 1]) / 2;
        }
    if (width < 0) return std::nullopt;
    Vec3 point;
    point[view.u()] = middle;
    point[view.v()] = at;
    const int w = plane.dominant_axis();
    point[w] = -(plane.d + double(plane.normal[view.u()]) * middle + double(plane.normal[view.v()]) * at) /
               double(plane.normal[w]);
    // Just behind it.
    const Vec3 behind = point - plane.unit_normal() * 2;
    GridPoint rounded;
    for (int axis = 0; axis < 3; ++axis) {
        const double steps = std::floor(behind[axis] * kSurfacePerInput + 0.5);
        if (!(steps >= INT32_MIN && steps <= INT32_MAX)) return std::nullopt;
        rounded[axis] = std::int32_t(steps);
    }
    return rounded;
}

// ---- splitting by one plane ----

bool MatterSplitter::split(const Part& part, const Ref<const SolidPlane>& plane, std::vector<Part>& behind,
                           std::vector<Part>& front) {
    if (exact_parallel(plane->plane, plane_->plane)) return false;
    if (!cut_items(part, plane) || !pair_changes(plane->plane)) return false;
    line_edge_.assign(changes_.size(), kNone32);
    return trace(true, plane.get(), front) && trace(false, plane.get(), behind) && !behind.empty();
}

/// The loops, their edges split where they cross the plane; and where they change sides.
bool MatterSplitter::cut_items(const Part& part, const Ref<const SolidPlane>& plane) {
    items_.clear();
    item_ends_.clear();
    item_sides_.clear();
    changes_.clear();
    touching_.clear();
    on_line_.clear();
    std::uint32_t first = 0;
    std::vector<std::int8_t> sides;
    for (const std::uint32_t end : part.ends) {
        sides.clear();
        for (std::uint32_t k = first; k < end; ++k)
            sides.push_back(std::int8_t(exact_side(plane->plane, view_.point(view_.from(part.uses[k])))));
        const auto first_item = std::uint32_t(items_.size()), first_change = std::uint32_t(changes_.size());
        const auto change = [&](std::uint32_t item, std::uint32_t vertex, bool to_front) {
            SideChange made;
            made.item = item;
            made.vertex = vertex;
            made.to_front = to_front;
            made.next = std::uint32_t(changes_.size()) + 1;
            changes_.push_back(made);
        };
        for (std::uint32_t k = first; k < end; ++k) {
            const PatchUse& use = part.uses[k];
            const int here = sides[k - first], there = sides[k + 1 < end ? k + 1 - first : 0];
            const auto item = std::uint32_t(items_.size());
            items_.push_back(use);
            item_sides_.push_back(std::int8_t(here));
            if (here == 0) touching_.push_back(view_.from(use));
            if ((here >= 0) == (there >= 0)) continue;
            if (here == 0) {
                change(item, view_.from(use), false);
            } else if (there == 0) {
                change(item + 1, view_.to(use), true);
            } else {
                const std::uint32_t middle = split_vertex(base_number(use.edge), plane);
                if (middle == kNone32) return false;
                items_.back() = use_between(use, view_.from(use), middle);
                items_.push_back(use_between(use, middle, view_.to(use)));
                item_sides_.push_back(0);
                change(item + 1, middle, there > 0);
            }
        }
        const auto last_item = std::uint32_t(items_.size());
        item_ends_.push_back(last_item);
        for (std::uint32_t k = first_change; k < changes_.size(); ++k)
            if (changes_[k].item == last_item) changes_[k].item = first_item;
        if (changes_.size() > first_change) changes_.back().next = first_change;
        for (std::uint32_t k = first_item; k < last_item; ++k)
            if (item_sides_[k] == 0 && item_sides_[k + 1 < last_item ? k + 1 : first_item] == 0)
                on_line_[{view_.from(items_[k]), view_.to(items_[k])}] = items_[k];
        first = end;
    }
    return changes_.size() >= 2;
}

const Plane* MatterSplitter::across(std::uint32_t vertex, const Plane& plane) const {
    const ExactPoint& point = view_.point(vertex);
    if (point.on_grid()) return nullptr;
    for (int k = 0; k < 3; ++k)
        if (exact_turn(plane_->plane, plane, *point.plane(k)) != 0) return point.plane(k);
    return nullptr;
}

/// Along the line, directed as face x plane: 1 where b comes after a.
int MatterSplitter::order(const Plane& plane, std::uint32_t a, std::uint32_t b) {
    if (a == b) return 0;
    if (const Plane* through = across(a, plane))
        return exact_order(plane_->plane, plane, view_.point(a), *through, view_.point(b));
    if (const Plane* through = across(b, plane))
        return -exact_order(plane_->plane, plane, view_.point(b), *through, view_.point(a));
    const InputPoint p = view_.point(a).grid();
    for (int axis = 0; axis < 3; ++axis) {
        const Plane through = axis_plane(axis, p[axis]);
        if (exact_turn(plane_->plane, plane, through) != 0)
            return exact_order(plane_->plane, plane, view_.point(a), through, view_.point(b));
    }
    return 0;
}

bool MatterSplitter::pair_changes(const Plane& plane) {
    order_.clear();
    for (std::uint32_t k = 0; k < changes_.size(); ++k) order_.push_back(k);
    sort_range(order_, [&](std::uint32_t a, std::uint32_t b) {
        const int along = order(plane, changes_[a].vertex, changes_[b].vertex);
        return along != 0 ? along > 0 : a < b;
    });
    sort_range(touching_, [&](std::uint32_t a, std::uint32_t b) {
        const int along = order(plane, a, b);
        return along != 0 ? along > 0 : a < b;
    });
    if (order_.size() % 2 != 0) return false;
    // Those at one place come in turn, into the front and out of it.
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const bool wanted = k % 2 == 0;
        std::size_t found = k;
        while (found < order_.size() && changes_[order_[found]].to_front != wanted) ++found;
        if (found == order_.size()) return false;
        if (found == k) continue;
        if (order(plane, changes_[order_[k]].vertex, changes_[order_[found]].vertex) != 0) return false;
        std::rotate(order_.begin() + std::ptrdiff_t(k), order_.begin() + std::ptrdiff_t(found),
                    order_.begin() + std::ptrdiff_t(found) + 1);
    }
    for (std::size_t k = 0; k < order_.size(); k += 2) {
        changes_[order_[k]].partner = order_[k + 1];
        changes_[order_[k + 1]].partner = order_[k];
    }
    return true;
}

/// The edges along the line from where it enters the face to where it leaves it, divided where corners touch it. Where
/// an edge of the face runs there already it is that.
void MatterSplitter::add_line(std::uint32_t enters, const SolidPlane& plane, bool backward,
                              std::vector<PatchUse>& uses) {
    const std::uint32_t from = changes_[enters].vertex, to = changes_[changes_[enters].partner].vertex;
    if (from == to) return;
    std::uint32_t& base = line_edge_[enters];
    if (base == kNone32) {
        base = view_.edge_count();
        made_.edges.push_back({from, to, {plane_, &plane}, false});
        base_of_part_.push_back(base);
        bases_[base] = {from, to, {plane_, &plane}, false};
    }
    std::vector<std::uint32_t> chain{from};
    for (const std::uint32_t vertex : touching_)
        if (order(plane.plane, vertex, to) > 0 && order(plane.plane, chain.back(), vertex) > 0) chain.push_back(vertex);
    chain.push_back(to);
    const auto edge = [&](std::size_t k) -> PatchUse {
        if (const auto there = on_line_.find({chain[k], chain[k + 1]}); there != on_line_.end()) return there->second;
        return {edge_between(base, chain[k], chain[k + 1]), false};
    };
    if (backward)
        for (std::size_t k = chain.size() - 1; k > 0; --k) uses.push_back({edge(k - 1).edge, !edge(k - 1).reversed});
    else
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) uses.push_back(edge(k));
}

/// Takes out edges that are run along both ways: what one loop runs along twice joins two loops, what two loops run
/// along makes one of them.
void MatterSplitter::take_out_returns(std::vector<std::vector<PatchUse>>& loops) {
    struct Place {
        std::size_t loop, use;
    };
    const auto from = [&](const Place& at) {
        std::vector<PatchUse> rest(loops[at.loop].begin() + std::ptrdiff_t(at.use) + 1, loops[at.loop].end());
        rest.insert(rest.end(), loops[at.loop].begin(), loops[at.loop].begin() + std::ptrdiff_t(at.use));
        return rest;
    };
    for (bool any = true; any;) {
        any = false;
        std::map<std::uint32_t, Place> seen;
        for (std::size_t loop = 0; loop < loops.size() && !any; ++loop)
            for (std::size_t use = 0; use < loops[loop].size() && !any; ++use) {
                const auto [at, is_new] = seen.try_emplace(loops[loop][use].edge, Place{loop, use});
                if (is_new) continue;
                any = true;
                const Place first = at->second, second{loop, use};
                std::vector<PatchUse> one = from(first);
                if (first.loop == second.loop) {
                    // Behind the first one up to the second, and the rest.
                    const auto middle = one.begin() + std::ptrdiff_t(second.use - first.use) - 1;
                    loops.emplace_back(middle + 1, one.end());
                    one.erase(middle, one.end());
                    loops[first.loop] = std::move(one);
                } else {
                    const std::vector<PatchUse> other = from(second);
                    one.insert(one.end(), other.begin(), other.end());
                    loops[first.loop] = std::move(one);
                    loops.erase(loops.begin() + std::ptrdiff_t(second.loop));
                }
            }
    }
    std::erase_if(loops, [](const std::vector<PatchUse>& loop) { return loop.empty(); });
}

/// The parts on one side: outlines along loops and the line, and loops that lie there wholly.
bool MatterSplitter::trace(bool front, const SolidPlane* plane, std::vector<Part>& parts) {
    const auto loop_of = [&](std::uint32_t item) {
        std::size_t loop = 0;
        while (item >= item_ends_[loop]) ++loop;
        return loop;
    };
    std::vector<std::vector<PatchUse>> loops;
    std::vector<bool> seen(changes_.size(), false);
    const auto along_loop = [&](const SideChange& from, const SideChange& to, std::vector<PatchUse>& into) {
        const std::size_t loop = loop_of(from.item);
        const std::uint32_t first = loop == 0 ? 0 : item_ends_[loop - 1], end = item_ends_[loop];
        // A loop that touches the plane in one corner has nothing of it in front, and all of it behind.
        if (from.item == to.item && front) return;
        std::uint32_t k = from.item;
        do {
            into.push_back(items_[k]);
            k = k + 1 < end ? k + 1 : first;
        } while (k != to.item);
    };
    for (std::uint32_t start = 0; start < changes_.size(); ++start) {
        if (seen[start] || changes_[start].to_front != front) continue;
        std::vector<PatchUse>& loop = loops.emplace_back();
        for (std::uint32_t at = start; !seen[at];) {
            seen[at] = true;
            const SideChange& begins = changes_[at];
            const SideChange& ends_at = changes_[begins.next];
            along_loop(begins, ends_at, loop);
            add_line(front ? ends_at.partner : begins.next, *plane, front, loop);
            at = ends_at.partner;
        }
    }
    std::uint32_t first = 0;
    for (const std::uint32_t end : item_ends_) {
        const bool changes = std::any_of(changes_.begin(), changes_.end(),
                                         [&](const SideChange& it) { return it.item >= first && it.item < end; });
        if (!changes && (item_sides_[first] >= 0) == front)
            loops.emplace_back(items_.begin() + first, items_.begin() + end);
        first = end;
    }
    take_out_returns(loops);
    std::vector<PatchUse> uses;
    std::vector<std::uint32_t> ends;
    for (const std::vector<PatchUse>& loop : loops) {
        if (loop.size() < 3) return false;
        uses.insert(uses.end(), loop.begin(), loop.end());
        ends.push_back(std::uint32_t(uses.size()));
    }
    if (uses.empty()) return true;
    NewLoops grouped;
    NewFace like;
    like.plane = face_->plane;
    if (group_loops(view_, like, uses, ends, grouped) != Verdict::kFine) return false;
    for (const NewFace& made : grouped.faces) {
        Part& part = parts.emplace_back();
        part.uses.assign(grouped.uses(made).begin(), grouped.uses(made).end());
        part.ends.assign(grouped.ends(made).begin(), grouped.ends(made).end());
    }
    return true;
}

// ---- edges and their parts ----

std::uint32_t MatterSplitter::base_number(std::uint32_t edge) const {
    return edge < first_part_ ? edge : base_of_part_[edge - first_part_];
}

const MatterSplitter::Base& MatterSplitter::base_of(std::uint32_t edge) {
    const auto [at, is_new] = bases_.try_emplace(edge);
    if (!is_new) return at->second;
    if (edge < view_.first_new_edge()) {
        const PatchEdge& it = in_.patch.edges[edge];
        return at->second = {it.vertex[0], it.vertex[1], {it.plane[0], it.plane[1]}, it.doubled};
    }
    const NewEdge& it = view_.new_edge(edge);
    return at->second = {it.from, it.to, {it.plane[0], it.plane[1]}, it.doubled};
}

/// A part of a base edge, directed as that is: its ends in order along it.
std::uint32_t MatterSplitter::edge_between(std::uint32_t base, std::uint32_t a, std::uint32_t b) {
    const Base it = base_of(base);
    if (it.from == a && it.to == b) return base;
    const auto [at, is_new] = part_of_.try_emplace({base, a, b}, view_.edge_count());
    if (is_new) {
        made_.edges.push_back({a, b, {it.plane[0], it.plane[1]}, it.doubled});
        base_of_part_.push_back(base);
    }
    return at->second;
}

/// Of a use the part from a to b, in its own direction.
PatchUse MatterSplitter::use_between(const PatchUse& use, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t base = base_number(use.edge);
    return {use.reversed ? edge_between(base, b, a) : edge_between(base, a, b), use.reversed};
}

/// Where a base edge crosses a plane: the vertex that is there already, or a new one.
std::uint32_t MatterSplitter::split_vertex(std::uint32_t base, const Ref<const SolidPlane>& plane) {
    const auto [known, is_new] = vertex_on_.try_emplace({base, plane.get()}, kNone32);
    if (!is_new) return known->second;
    const Base& edge = base_of(base);
    if (exact_turn(edge.plane[0]->plane, edge.plane[1]->plane, plane->plane) == 0) return kNone32;
    const ExactPoint point(edge.plane[0]->plane, edge.plane[1]->plane, plane->plane);
    std::vector<std::uint32_t>& here = made_vertices_[point.rounded()];
    for (const std::uint32_t vertex : here) {
        const ExactPoint& other = view_.point(vertex);
        if (exact_side(edge.plane[0]->plane, other) == 0 && exact_side(edge.plane[1]->plane, other) == 0 &&
            exact_side(plane->plane, other) == 0)
            return known->second = vertex;
    }
    CutPoint made;
    made.point = point;
    made.planes[0] = edge.plane[0];
    made.planes[1] = edge.plane[1];
    made.planes[2] = plane.get();
    made.vertex = view_.vertex_count();
    crossings_.real.push_back(std::uint32_t(crossings_.points.size()));
    crossings_.points.push_back(made);
    here.push_back(made.vertex);
    return known->second = made.vertex;
}

// ---- the whole ----

/// Of a final part: whoever else uses its edges is divided at the same places.
void MatterSplitter::note_vertices(const Part& part) {
    for (const PatchUse& use : part.uses) {
        if (use.edge < first_part_) continue;
        const std::uint32_t base = base_number(use.edge);
        const Base& it = base_of(base);
        for (const std::uint32_t vertex : {view_.from(use), view_.to(use)})
            if (vertex != it.from && vertex != it.to) on_base_[base].push_back(vertex);
    }
}

void MatterSplitter::expand(const PatchUse& use, std::vector<PatchUse>& uses) {
    const std::uint32_t base = base_number(use.edge);
    const auto divided = on_base_.find(base);
    if (divided == on_base_.end()) return uses.push_back(use);
    const Base it = base_of(base);
    std::uint32_t from = view_.from(use), to = view_.to(use);
    if (use.reversed) std::swap(from, to);
    // The vertices between, along the base.
    const std::vector<std::uint32_t>& all = divided->second;
    const auto place = [&](std::uint32_t vertex) {
        if (vertex == it.from) return std::ptrdiff_t(-1);
        return vertex == it.to ? std::ptrdiff_t(all.size()) : std::find(all.begin(), all.end(), vertex) - all.begin();
    };
    std::vector<std::uint32_t> chain{from};
    for (std::ptrdiff_t k = place(from) + 1; k < place(to); ++k) chain.push_back(all[std::size_t(k)]);
    chain.push_back(to);
    if (use.reversed)
        for (std::size_t k = chain.size() - 1; k > 0; --k)
            uses.push_back({edge_between(base, chain[k - 1], chain[k]), true});
    else
        for (std::size_t k = 0; k + 1 < chain.size(); ++k)
            uses.push_back({edge_between(base, chain[k], chain[k + 1]), false});
}

void MatterSplitter::add_face(const NewFace& like, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends,
                              std::uint32_t material) {
    NewFace face = like;
    face.material = material;
    face.first_use = std::uint32_t(made_.all_uses.size());
    face.first_loop = std::uint32_t(made_.loop_ends.size());
    std::vector<PatchUse> expanded;
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends) {
        for (std::uint32_t k = first; k < end; ++k) expand(uses[k], expanded);
        made_.loop_ends.push_back(std::uint32_t(expanded.size()));
        first = end;
    }
    made_.all_uses.insert(made_.all_uses.end(), expanded.begin(), expanded.end());
    face.use_count = std::uint32_t(expanded.size());
    face.loop_count = std::uint32_t(ends.size());
    made_.faces.push_back(std::move(face));
}

void MatterSplitter::finish() {
    for (auto& [base, vertices] : on_base_) {
        // Along the base: by the planes that meet in it, whichever way their line is directed.
        const Base& it = base_of(base);
        plane_ = it.plane[0];
        const Plane& other = it.plane[1]->plane;
        sort_range(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        const bool forward = order(other, it.from, it.to) > 0;
        sort_range(vertices, [&](std::uint32_t a, std::uint32_t b) {
            const int along = order(other, a, b);
            return forward ? along > 0 : along < 0;
        });
    }
    made_.gone = loops_.gone;
    for (std::size_t k = 0; k < loops_.faces.size(); ++k) {
        const NewFace& face = loops_.faces[k];
        if (face.face != kNone32)
            add_face(face, loops_.uses(face), loops_.ends(face), kNone32);
        else
            for (const Assigned& it : assigned_[k]) add_face(face, it.part.uses, it.part.ends, inside_[it.matter]);
    }
    // Faces of the world beside, which the cut left whole.
    std::vector<bool> goes(in_.patch.faces.size(), false);
    for (const std::uint32_t face : loops_.gone) goes[face] = true;
    for (std::uint32_t index = 0; index < in_.patch.faces.size(); ++index) {
        const PatchFace& face = in_.patch.faces[index];
        if (face.replaced || goes[index]) continue;
        const bool divided = std::ranges::any_of(
            in_.patch.uses(face), [&](const PatchUse& use) { return on_base_.find(use.edge) != on_base_.end(); });
        if (!divided) continue;
        made_.gone.push_back(index);
        NewFace like;
        like.plane = Ref<const SolidPlane>(face.plane);
        like.face = index;
        add_face(like, in_.patch.uses(face), in_.patch.ends(face), kNone32);
    }
    sort_range(made_.gone);
    divide_taken();
    mark_doubled();
}

/// Edges that were made between two vertices of the grid where there may be another edge: of a crater that ends along
/// an edge of the world, say, whose new faces are divided there.
void MatterSplitter::mark_doubled() {
    const auto pair = [&](std::uint32_t edge) {
        const std::uint32_t a = view_.from({edge, false}), b = view_.to({edge, false});
        return std::pair(std::min(a, b), std::max(a, b));
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t edge = first_part_; edge < view_.edge_count(); ++edge) {
        const auto [a, b] = pair(edge);
        if (view_.point(a).on_grid() && view_.point(b).on_grid()) first.try_emplace({a, b}, edge);
    }
    if (first.empty()) return;
    for (std::uint32_t edge = 0; edge < first_part_; ++edge)
        if (const auto made = first.find(pair(edge)); made != first.end()) made->second = edge;
    for (std::uint32_t edge = first_part_; edge < view_.edge_count(); ++edge)
        if (const auto made = first.find(pair(edge)); made != first.end() && made->second != edge)
            made_.edges[edge - view_.first_new_edge()].doubled = true;
}

/// What was taken of faces, and edges that something else uses, are divided at the same places.
void MatterSplitter::divide_taken() {
    const std::size_t faces = made_.faces.size();
    for (const NewFace& face : loops_.taken) add_face(face, loops_.uses(face), loops_.ends(face), kNone32);
    made_.taken.assign(made_.faces.begin() + std::ptrdiff_t(faces), made_.faces.end());
    made_.faces.resize(faces);
    std::vector<bool> is_divided(in_.patch.edges.size(), false);
    std::vector<PatchUse> parts;
    for (const EdgeDivision& division : loops_.divisions) {
        is_divided[division.edge] = true;
        parts.clear();
        for (std::uint32_t k = 0; k < division.count; ++k) expand(loops_.parts[division.first_part + k], parts);
        add_division(division.edge, parts);
    }
    for (const auto& [base, vertices] : on_base_) {
        if (base >= view_.first_new_edge() || is_divided[base]) continue;
        parts.clear();
        expand({base, false}, parts);
        add_division(base, parts);
    }
}

void MatterSplitter::add_division(std::uint32_t edge, std::span<const PatchUse> parts) {
    made_.divisions.push_back({edge, std::uint32_t(made_.parts.size()), std::uint32_t(parts.size())});
    made_.parts.insert(made_.parts.end(), parts.begin(), parts.end());
}

}  // namespace firma
