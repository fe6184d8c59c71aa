// SPDX-License-Identifier: MIT
// Exact faces on their way into sections: each face, edge, vertex and plane once, numbered in the order in which faces
// lead to them. Objects of faces that the reader has already are named by number only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/flat_map.h"
#include "save/sections.h"
#include "solid/solid_face.h"

namespace firma {

/// Numbers for objects, from 0, by address: in the order they are asked for, so that no address shows.
template <class Object>
class ObjectNumbers {
public:
    std::uint32_t operator()(const Object* object) {
        std::uint32_t& known = number_of_.at(reinterpret_cast<std::uintptr_t>(object));
        if (known == FlatMap::kNone) {
            known = std::uint32_t(objects_.size());
            objects_.push_back(object);
        }
        return known;
    }
    /// Takes the next number for an object, whether it has one already or not: the first stays its own.
    void take_next(const Object* object) {
        std::uint32_t& known = number_of_.at(reinterpret_cast<std::uintptr_t>(object));
        if (known == FlatMap::kNone) known = std::uint32_t(objects_.size());
        objects_.push_back(object);
    }
    bool has(const Object* object) const {
        return number_of_.find(reinterpret_cast<std::uintptr_t>(object)) != FlatMap::kNone;
    }
    const std::vector<const Object*>& objects() const { return objects_; }

private:
    FlatMap number_of_;
    std::vector<const Object*> objects_;
};

class ExactPacker {
public:
    /// A face that the reader has: its plane, and the edge and first vertex of each of its uses, get the next numbers,
    /// whichever of them are one object. Before all that is packed.
    void import(const SolidFace& face);
    /// The number of a face to be packed.
    std::uint32_t number(const SolidFace* face) { return faces_(face); }
    /// Once, when all faces have their numbers.
    void pack();
    void add_to(std::vector<NewSection>& sections);

private:
    void pack_face(const SolidFace& face);
    void pack_plane(const Plane& plane);

    ObjectNumbers<SolidFace> faces_;
    ObjectNumbers<SolidEdge> edges_;
    ObjectNumbers<SolidVertex> imported_;
    ObjectNumbers<SolidPlane> planes_;
    std::size_t imported_edges_ = 0, imported_planes_ = 0;
    std::vector<bool> against_;  ///< of each imported edge: whether its use runs from its second vertex to its first
    ByteWriter plane_data_, grid_points_, meet_points_, edge_data_, exact_data_, uses_, loops_;
};

}  // namespace firma
