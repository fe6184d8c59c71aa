// SPDX-License-Identifier: MIT
// Whether two boundaries are the same set of points.
//
// What both share goes first: blocks, then faces that are one object or equal corner by corner. In each plane, as faces
// look, the edges of what is left must cancel, those of the second boundary turned: see PlaneChain.
#include "solid/same_boundary.h"

#include <algorithm>
#include <functional>
#include <span>
#include <tuple>
#include <vector>

#include "base/sort.h"
#include "base/table_key.h"
#include "index/unshared_nodes.h"
#include "solid/plane_chain.h"
#include "solid/solid_face.h"

namespace firma {
namespace {

struct SideFace {
    std::uint64_t hash = 0;  ///< equal for faces that may be equal
    FacetPlace facet;        ///< one of its facets
    const SolidFace* stored = nullptr;
    bool of_second = false;

    std::size_t corner_count() const { return facet.record().corner_count; }
    InputPoint corner(std::size_t k) const { return to_input(facet.block->corner(facet.record(), k)); }
};

std::uint64_t hash_of(const SideFace& face) {
    if (face.stored) return mix_bits(face.stored->hash);
    std::uint64_t sum = 0;  // wherever it starts
    for (std::size_t k = 0; k < face.corner_count(); ++k) sum += point_key(face.corner(k));
    return sum;
}

void add_faces(std::span<const Node* const> nodes, bool of_second, std::vector<SideFace>& faces) {
    for (const Node* node : nodes) {
        if (!node->is_leaf()) continue;
        const Block& block = block_of(*node);
        for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
            SideFace face;
            face.facet = {&block, slot};
            face.stored = static_cast<const SolidFace*>(block.owner_of(block.faces[slot]));
            face.of_second = of_second;
            face.hash = hash_of(face);
            faces.push_back(face);
        }
    }
}

/// Says no of points that are the same, where one of them is on the grid by its planes alone.
bool surely_same(const ExactPoint& a, const ExactPoint& b) {
    if (&a == &b) return true;
    if (a.on_grid() != b.on_grid() || a.rounded() != b.rounded()) return false;
    for (int k = 0; k < 3 && !a.on_grid(); ++k)
        if (exact_side(*b.plane(k), a) != 0) return false;
    return true;
}

/// Corner by corner. Faces may be the same set of points all the same.
bool surely_same(const SideFace& a, const SideFace& b) {
    if (!a.stored != !b.stored) return false;
    if (!a.stored) {
        const std::size_t count = a.corner_count();
        if (count != b.corner_count()) return false;
        std::size_t start = 0;
        while (start < count && a.corner(start) != b.corner(0)) ++start;
        for (std::size_t k = 0; k < count; ++k)
            if (a.corner((start + k) % count) != b.corner(k)) return false;
        return true;
    }
    const SolidFace &one = *a.stored, &two = *b.stored;
    return one.plane->plane == two.plane->plane &&
           std::equal(one.loop_ends().begin(), one.loop_ends().end(), two.loop_ends().begin(), two.loop_ends().end()) &&
           std::equal(one.uses.begin(), one.uses.end(), two.uses.begin(), two.uses.end(),
                      [](const SolidUse& p, const SolidUse& q) { return surely_same(p.from().point, q.from().point); });
}

/// Takes the faces that both have out of those of one hash, and leaves each other one once. A face has facets in
/// several blocks.
/// @return the end of what is left
SideFace* without_shared(SideFace* first, SideFace* end, std::vector<SideFace>& of_second) {
    of_second.clear();
    SideFace* left = first;
    for (SideFace* face = first; face != end;) {
        SideFace* next = face + 1;
        while (face->stored && next != end && next->stored == face->stored) ++next;
        if (face->of_second == next[-1].of_second) {  // else an object of both
            if (face->of_second)
                of_second.push_back(*face);
            else
                *left++ = *face;
        }
        face = next;
    }
    // Those of one hash are nearly always equal; what is not is left to the planes.
    SideFace* kept = first;
    std::size_t paired = 0;
    for (SideFace* face = first; face != left; ++face) {
        if (paired < of_second.size() && surely_same(*face, of_second[paired]))
            ++paired;
        else
            *kept++ = *face;
    }
    return std::copy(of_second.begin() + std::ptrdiff_t(paired), of_second.end(), kept);
}

void remove_shared(std::vector<SideFace>& faces) {
    sort_range(faces, [](const SideFace& a, const SideFace& b) {
        if (a.hash != b.hash) return a.hash < b.hash;
        if (a.stored != b.stored) return std::less<const SolidFace*>()(a.stored, b.stored);
        return a.of_second < b.of_second;
    });
    std::vector<SideFace> scratch;
    SideFace *left = faces.data(), *const all_end = left + faces.size();
    for (SideFace *first = left, *end; first != all_end; first = end) {
        end = first + 1;
        while (end != all_end && end->hash == first->hash) ++end;
        left = std::copy(first, without_shared(first, end, scratch), left);
    }
    faces.resize(std::size_t(left - faces.data()));
}

/// Not valid() for a face without area: its edges run to and fro, and bound nothing.
Plane plane_of(const SideFace& face) {
    Plane plane;
    for (std::size_t k = 2; k < face.corner_count() && !plane.valid(); ++k)  // the first ones may lie on a line
        plane = plane_through(face.corner(0), face.corner(k - 1), face.corner(k));
    return plane;
}

bool comes_before(const Plane& a, const Plane& b) {
    const auto key = [](const Plane& p) {
        return std::tie(p.normal[0], p.normal[1], p.normal[2], p.offset_high, p.offset_low);
    };
    return key(a) < key(b);
}

void add_edges(const SideFace& face, PlaneChain& chain) {
    if (!face.stored) {
        for (std::size_t k = 0, count = face.corner_count(); k < count; ++k) {
            const InputPoint from = face.corner(k), to = face.corner(k + 1 < count ? k + 1 : 0);
            face.of_second ? chain.add(to, from) : chain.add(from, to);
        }
        return;
    }
    for (const SolidUse& use : face.stored->uses) {
        const SolidEdge& edge = use.edge();
        const bool back = use.reversed() != face.of_second;
        chain.add(edge.vertex[back]->point, edge.vertex[!back]->point, edge.plane[0]->plane, edge.plane[1]->plane);
    }
}

/// Whether in each plane the faces of both boundaries cover the same.
bool planes_cancel(const std::vector<SideFace>& faces) {
    struct InPlane {
        const Plane* plane;
        const SideFace* face;
    };
    std::vector<Plane> planes;  // of faces that are their own
    planes.reserve(faces.size());
    std::vector<InPlane> all;
    all.reserve(faces.size());
    for (const SideFace& face : faces) {
        const Plane& plane = face.stored ? face.stored->plane->plane : planes.emplace_back(plane_of(face));
        if (plane.valid()) all.push_back({&plane, &face});
    }
    sort_range(all, [](const InPlane& a, const InPlane& b) { return comes_before(*a.plane, *b.plane); });
    PlaneChain chain;
    for (std::size_t first = 0, end; first < all.size(); first = end) {
        chain.start(*all[first].plane);
        for (end = first; end < all.size() && *all[end].plane == *all[first].plane; ++end)
            add_edges(*all[end].face, chain);
        if (!chain.cancels()) return false;
    }
    return true;
}

}  // namespace

bool same_boundary(const Node* a, const Node* b) {
    if (a == b) return true;
    const UnsharedNodes nodes = unshared_nodes(std::span(&a, a != nullptr), std::span(&b, b != nullptr));
    std::vector<SideFace> faces;
    add_faces(nodes.before, false, faces);
    add_faces(nodes.after, true, faces);
    remove_shared(faces);
    return planes_cancel(faces);
}

}  // namespace firma
