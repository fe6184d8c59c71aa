// SPDX-License-Identifier: MIT
// Groups of faces that grow across edges.
#include "carve/face_groups.h"

#include <algorithm>

#include "base/assert.h"
#include "carve/gather.h"
#include "carve/held_behind.h"
#include "carve/polygon_reaches.h"
#include "index/box_tree.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

std::uint64_t face_key(const FacetPlace& facet) {
    if (const FaceOwner* owner = facet.block->owner_of(facet.record())) return reinterpret_cast<std::uintptr_t>(owner);
    return reinterpret_cast<std::uintptr_t>(facet.block) ^ std::uint64_t(facet.slot + 1) << 56;  // of 64: as SolidPatch
}

LiveFace live(const FacetPlace& facet) {
    return {static_cast<const SolidFace*>(facet.block->owner_of(facet.record())), facet};
}

/// By the rules of EdgeKey.
KeyedUse keyed_use(const SolidPatch& patch, const PatchUse& use) {
    const PatchEdge& edge = patch.edges[use.edge];
    if (edge.stored) {
        // A stored edge of the grid may run the other way than the patch met it; any other has its vertices.
        const KeyedUse by_object = firma::keyed_use(*edge.stored, use.reversed);
        if (by_object.key.stored) return by_object;
    }
    return firma::keyed_use(patch.vertices[patch.from(use)].point.rounded(),
                            patch.vertices[patch.to(use)].point.rounded());
}

/// Whether some shell of a cutter does not surely look outward.
bool has_hollow(const CutterSolid& cutter) {
    const std::vector<CutterTriangle>& triangles = cutter.placed.triangles;
    DisjointSets shells(triangles.size());
    FlatMap first_of_side;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            std::uint32_t& known = first_of_side.at(std::min(a, b) << 32 | std::max(a, b));
            if (known == FlatMap::kNone)
                known = t;
            else
                shells.join(known, t);
        }
    std::vector<double> volumes(triangles.size(), 0);  // six times, cubic input steps
    const Vec3 middle = (to_metres(cutter.box.low) + to_metres(cutter.box.high)) * (0.5 * kInputSteps);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto arm = [&](std::size_t k) { return cutter.points[triangles[t][k]].approximate() - middle; };
        volumes[shells.find(t)] += dot(arm(0), cross(arm(1), arm(2)));
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        if (shells.find(t) == t && !(volumes[t] > 1)) return true;
    return false;
}

}  // namespace

GridBox LiveFace::box() const {
    return stored ? stored->box : facet.block->box_of(facet.record());
}

void append_made(const FaceSet& made, std::span<const std::uint32_t> numbers, FaceSet& set) {
    FlatMap wanted;
    for (const std::uint32_t k : numbers) {
        wanted.at(reinterpret_cast<std::uintptr_t>(made.owners[k].get())) = k;
        set.owners.push_back(made.owners[k]);
    }
    for (const FaceSet::Entry& face : made.faces)
        if (wanted.find(reinterpret_cast<std::uintptr_t>(face.owner)) != FlatMap::kNone) append_face(made, face, set);
}

FaceGroups::FaceGroups(const CutFaces& cut)
    : cut_(cut), patch_(cut.view.patch()), sets_(cut.made_count() + patch_.faces.size()) {
    stays_.assign(patch_.faces.size(), 1);
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
        if (patch_.faces[face].replaced || patch_.faces[face].parent != ~0u) stays_[face] = 0;  // kept pieces are made
    for (const std::uint32_t face : cut_.loops.gone) stays_[face] = 0;
    user_.assign(2 * std::size_t(cut_.view.edge_count()), kNone);
    const auto use_edges = [&](std::span<const PatchUse> uses, std::uint32_t node) {
        for (const PatchUse& use : uses) {
            user_[2 * use.edge + use.reversed] = node;
            if (const std::uint32_t other = user_[2 * use.edge + !use.reversed]; other != kNone)
                sets_.join(node, other);
        }
    };
    const auto cut_faces = std::uint32_t(cut_.loops.faces.size());
    for (std::uint32_t k = 0; k < cut_faces; ++k) use_edges(cut_.loops.uses(cut_.loops.faces[k]), k);
    for (std::uint32_t k = cut_faces; k < cut_.made_count(); ++k)
        use_edges(patch_.uses(patch_.faces[cut_.parent(k)]), k);
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
        if (stays_[face]) use_edges(patch_.uses(patch_.faces[face]), patch_node(face));
    for (std::uint32_t k = 0; k < cut_faces; ++k)
        if (sets_.find(k) == k) changed_.push_back(k);
}

/// What was side by side before is of one shell, what is side by side now too. What the cutter alone bounds is a new
/// hollow, and has to do with none of the others; unless the cutter has a hollow itself: then it may be what is left of
/// a room that the cutter swallowed, around a piece in its hollow, or such a piece. A shell of which all that is left
/// is one group may have been that of a hollow, and the group a piece that hung in it, cut off all around: then it lies
/// within the cutter's convex hull, as any way out of the hollow leads into the cutter. Whatever else the cutter
/// touched may have held such a piece.
std::vector<FaceGroups::Family> FaceGroups::families(std::span<const std::uint32_t> lost) {
    DisjointSets related = sets_;
    for (const PatchEdge& edge : patch_.edges)
        if (!edge.split() && edge.face[0] != kNone && edge.face[1] != kNone)
            related.join(patch_node(edge.face[0]), patch_node(edge.face[1]));
    for (std::uint32_t k = 0; k < cut_.made_count(); ++k)
        if (cut_.parent(k) != kNone) related.join(k, patch_node(cut_.parent(k)));
    std::vector<std::uint8_t> is_old(cut_.made_count() + patch_.faces.size(), 0);
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face) is_old[related.find(patch_node(face))] = 1;
    const bool cuts_out = changed_.size() > 1 && has_hollow(cut_.view.cutter());
    std::vector<Family> families;
    std::vector<std::uint32_t> number(cut_.made_count() + patch_.faces.size(), kNone);
    for (const std::uint32_t group : changed_) {
        std::uint32_t& known = number[related.find(group)];
        if (known == kNone) {
            known = std::uint32_t(families.size());
            families.emplace_back();
        }
        families[known].groups.push_back(group);
    }
    for (const std::uint32_t face : lost)
        if (const std::uint32_t family = number[related.find(patch_node(face))]; family != kNone)
            families[family].lost = true;
    const bool apart = families.size() > 1 && std::any_of(families.begin(), families.end(), [&](const Family& family) {
                           if (!is_old[related.find(family.groups[0])]) return cuts_out;
                           return family.groups.size() == 1 && lies_in_the_cutter(family.groups[0]);
                       });
    if (apart) return {{changed_, !lost.empty()}};
    return families;
}

/// By boxes, of the faces that are known so far.
bool FaceGroups::lies_in_the_cutter(std::uint32_t group) {
    GridBox box;
    for (std::uint32_t k = 0; k < cut_.made_count(); ++k)
        if (sets_.find(k) == group) box.add(cut_.owner(k).box);
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
        if (stays_[face] && sets_.find(patch_node(face)) == group) box.add(live(patch_.faces[face].facet).box());
    const GridBox cutter = grown(cut_.view.cutter().box, kSurfacePerInput);
    for (int axis = 0; axis < 3; ++axis)
        if (box.low[axis] < cutter.low[axis] || box.high[axis] > cutter.high[axis]) return false;
    return true;
}

void FaceGroups::start(const Node* root, const Anchors& anchors) {
    root_ = root;
    anchors_ = &anchors;
    state_of_.assign(cut_.made_count() + patch_.faces.size(), kNone);
    const auto add_node = [&](std::uint32_t node, const LiveFace& face, const FaceRecord* record) {
        std::uint32_t& known = state_of_[sets_.find(node)];
        if (known == kNone) {
            known = std::uint32_t(states_.size());
            states_.emplace_back();
        }
        State& state = states_[known];
        state.box.add(face.box());
        state.held = state.held || (record && anchors.holds(*record)) || reaches_into_a_volume(face);
    };
    for (std::uint32_t k = 0; k < cut_.made_count(); ++k) {
        const std::uint32_t parent = cut_.parent(k);
        add_node(k, {&cut_.owner(k), {}}, parent == kNone ? nullptr : &patch_.faces[parent].facet.record());
    }
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
        if (stays_[face])
            add_node(patch_node(face), live(patch_.faces[face].facet), &patch_.faces[face].facet.record());
    for (std::uint32_t edge = 0; edge < patch_.edges.size(); ++edge) {
        const std::uint32_t forward = user_[2 * edge], back = user_[2 * edge + 1];
        if ((forward == kNone) == (back == kNone)) continue;
        open(keyed_use(patch_, {edge, forward == kNone}), forward == kNone ? back : forward);
    }
}

/// The place for the number of the open edge with a key; kNone when there is none.
std::uint32_t& FaceGroups::edge_with(const EdgeKey& key) {
    for (std::uint64_t hash = key.hash();; hash = next_key(hash)) {
        std::uint32_t& known = edge_of_key_.at(hash);
        if (known == FlatMap::kNone || open_[known].use.key == key) return known;
    }
}

void FaceGroups::open(const KeyedUse& use, std::uint32_t node) {
    const auto number = std::uint32_t(open_.size());
    edge_with(use.key) = number;
    open_.push_back({use, node});
    state(node).edges.push_back(number);
}

std::uint32_t FaceGroups::join(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return a;
    if (b < a) std::swap(a, b);
    State &to = states_[state_of_[a]], &from = states_[state_of_[b]];
    to.edges.insert(to.edges.end(), from.edges.begin() + std::ptrdiff_t(from.next), from.edges.end());
    to.found.insert(to.found.end(), from.found.begin(), from.found.end());
    to.box.add(from.box);
    to.held = to.held || from.held;
    from = {};
    sets_.join(a, b);
    return a;
}

void FaceGroups::add_face(std::uint32_t node, const FacetPlace& facet) {
    node_of_face_.at(face_key(facet)) = node;
    State& own = state(node);
    own.found.push_back(facet);
    own.box.add(live(facet).box());
    own.held = own.held || anchors_->holds(facet.record()) || reaches_into_a_volume(live(facet));
    for_each_use(facet, [&](const KeyedUse& use) {
        const std::uint32_t known = edge_with(use.key);
        if (known == kNone) return open(use, node);
        open_[known].open = false;
        join(node, open_[known].node);
    });
}

/// By its outer loop: what lies in a hole of it may count as well.
bool FaceGroups::reaches_into_a_volume(const LiveFace& face) {
    if (anchors_->volumes.empty()) return false;
    const GridBox box = face.box();
    return std::any_of(anchors_->volumes.begin(), anchors_->volumes.end(), [&](const GridBox& volume) {
        if (!boxes_meet(box, volume)) return false;
        loop_.clear();
        if (face.stored)
            for (std::uint32_t k = 0; k < face.stored->loop_ends()[0]; ++k)
                loop_.push_back(face.stored->uses[k].from().point.approximate());
        else
            face.facet.block->for_each_corner(face.facet.record(), [&](const GridPoint& corner) {
                loop_.push_back(to_metres(corner) * kInputSteps);
            });
        return polygon_reaches_into(loop_, volume);
    });
}

bool FaceGroups::has_open_edge(State& state) const {
    while (state.next < state.edges.size() && !open_[state.edges[state.next]].open) ++state.next;
    return state.next < state.edges.size();
}

bool FaceGroups::is_closed(std::uint32_t node) {
    return !has_open_edge(state(node));
}

bool FaceGroups::grow(std::uint32_t node) {
    State& own = state(node);
    if (!has_open_edge(own)) return false;
    OpenEdge& edge = open_[own.edges[own.next]];
    const FacetPlace facet = find_across(*root_, edge.use);
    ++searched_;
    FIRMA_ASSERT(facet.block && patch_.find(facet) == SolidPatch::kNone,
                 "an edge that a cut left alone has a face on its other side, which the cut did not see");
    edge.open = false;
    if (facet.block && patch_.find(facet) == SolidPatch::kNone) add_face(node, facet);
    return true;
}

void FaceGroups::look_behind(std::uint32_t node) {
    State& own = state(node);
    if (own.held || own.found.empty()) return;
    own.held = is_held_behind(*root_, own.found.back(), cut_.view.cutter().box, *anchors_);
}

std::uint32_t FaceGroups::add(const FacetPlace& facet) {
    const std::uint32_t node = sets_.add();
    state_of_.push_back(std::uint32_t(states_.size()));
    states_.emplace_back();
    add_face(node, facet);
    return node;
}

std::uint32_t FaceGroups::find(const FacetPlace& facet) const {
    const std::uint32_t face = patch_.find(facet);
    return face != SolidPatch::kNone ? patch_node(face) : node_of_face_.find(face_key(facet));
}

std::vector<LiveFace> FaceGroups::faces(std::uint32_t node) {
    const std::uint32_t group = sets_.find(node);
    std::vector<LiveFace> all;
    for (const std::uint32_t k : made(node)) all.push_back({&cut_.owner(k), {}});
    for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
        if (stays_[face] && sets_.find(patch_node(face)) == group) all.push_back(live(patch_.faces[face].facet));
    for (const FacetPlace& facet : state(node).found) all.push_back(live(facet));
    return all;
}

std::vector<std::uint32_t> FaceGroups::made(std::uint32_t node) {
    const std::uint32_t group = sets_.find(node);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < cut_.made_count(); ++k)
        if (sets_.find(k) == group) numbers.push_back(k);
    return numbers;
}

}  // namespace firma
