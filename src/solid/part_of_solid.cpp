// SPDX-License-Identifier: MIT
// Some of a solid's faces as a solid of their own.
#include "solid/part_of_solid.h"

#include <vector>

#include "base/assert.h"
#include "base/flat_map.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

/// Copies of objects, moved, each made once.
template <class T>
class MovedObjects {
public:
    /// @param make  Ref<const T>(const T&)
    template <class Make>
    const Ref<const T>& of(const T& before, const Make& make) {
        std::uint32_t& known = number_.at(reinterpret_cast<std::uintptr_t>(&before));
        if (known != FlatMap::kNone) return made_[known];
        known = std::uint32_t(made_.size());
        return made_.emplace_back(make(before));  // which makes no other of the kind
    }

private:
    FlatMap number_;
    std::vector<Ref<const T>> made_;
};

class Mover {
public:
    explicit Mover(const InputPoint& by) : by_(by) {}

    GridPoint moved(const GridPoint& p) const {
        GridPoint to;
        for (int axis = 0; axis < 3; ++axis) to[axis] = p[axis] + by_[axis] * kSurfacePerInput;
        return to;
    }

    /// Its hash is left to who has all of them.
    Ref<SolidFace> face(const SolidFace& before) {
        Ref<SolidFace> after(new SolidFace);
        after->plane = plane(*before.plane);
        after->uses.reserve(before.uses.size());
        for (const SolidUse& use : before.uses) after->uses.emplace_back(edge(use.edge()), use.reversed());
        after->set_loop_ends(before.loop_ends());
        after->normal = before.normal;
        after->box.add(moved(before.box.low));
        after->box.add(moved(before.box.high));
        after->facets = before.facets;
        return after;
    }

private:
    /// n . (p - by) + d = n . p + (d - n . by).
    const Ref<const SolidPlane>& plane(const SolidPlane& before) {
        return planes_.of(before, [&](const SolidPlane& it) {
            Int128 offset = it.plane.offset();
            for (int axis = 0; axis < 3; ++axis) offset -= Int128(it.plane.normal[axis]) * by_[axis];
            const Plane moved = plane_of_numbers(it.plane.normal, offset);
            FIRMA_ASSERT(moved.valid(), "a plane that holds a point of the world");
            return Ref<const SolidPlane>(new SolidPlane(moved));
        });
    }
    const Ref<const SolidVertex>& vertex(const SolidVertex& before) {
        return vertices_.of(before, [&](const SolidVertex& it) {
            if (it.point.on_grid()) return Ref<const SolidVertex>(new SolidVertex(to_input(moved(it.point.rounded()))));
            const Ref<const SolidPlane> planes[3] = {plane(*it.plane(0)), plane(*it.plane(1)), plane(*it.plane(2))};
            return Ref<const SolidVertex>(
                new SolidVertex(ExactPoint(planes[0]->plane, planes[1]->plane, planes[2]->plane), planes));
        });
    }
    const Ref<const SolidEdge>& edge(const SolidEdge& before) {
        return edges_.of(before, [&](const SolidEdge& it) {
            Ref<SolidEdge> after(new SolidEdge);
            for (int k = 0; k < 2; ++k) {
                after->vertex[k] = vertex(*it.vertex[k]);
                after->plane[k] = plane(*it.plane[k]);
            }
            after->doubled = it.doubled;
            return Ref<const SolidEdge>(after.get());
        });
    }

    const InputPoint by_;
    MovedObjects<SolidPlane> planes_;
    MovedObjects<SolidVertex> vertices_;
    MovedObjects<SolidEdge> edges_;
};

}  // namespace

void append_facets(std::span<const FacetPlace> facets, FaceSet& set) {
    FlatMap known;
    for (const FacetPlace& facet : facets) {
        const Block& block = *facet.block;
        FaceSet::Entry entry = entry_of(block, facet.record());
        if (entry.owner) {
            std::uint32_t& seen = known.at(reinterpret_cast<std::uintptr_t>(entry.owner));
            if (seen == FlatMap::kNone) set.owners.emplace_back(entry.owner);
            seen = 0;
        }
        entry.first_corner = std::uint32_t(set.corners.size());
        append_corners(block, facet.record(), set);
        set.faces.push_back(entry);
    }
}

void move_faces(const InputPoint& by, FaceSet& set) {
    Mover mover(by);
    for (GridPoint& vertex : set.vertices) vertex = mover.moved(vertex);
    PlaneHashes hashes;
    FlatMap number;
    std::vector<Ref<const FaceOwner>> owners;
    for (const Ref<const FaceOwner>& owner : set.owners) {
        number.at(reinterpret_cast<std::uintptr_t>(owner.get())) = std::uint32_t(owners.size());
        Ref<SolidFace> moved = mover.face(static_cast<const SolidFace&>(*owner));
        moved->set_hash(hashes);
        owners.emplace_back(moved.get());
    }
    for (FaceSet::Entry& face : set.faces)
        if (face.owner) face.owner = owners[number.find(reinterpret_cast<std::uintptr_t>(face.owner))].get();
    set.owners = std::move(owners);
}

Solid solid_of_faces(FaceSet set, std::uint32_t next_face, const SolidData& like) {
    for (FaceSet::Entry& face : set.faces) face.part = 0;
    return solid_of(build_store(set, like.tree_options).store, false, next_face, like.edits, like.tree_options);
}

}  // namespace firma
