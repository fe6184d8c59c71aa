// SPDX-License-Identifier: MIT
// The exact part of a saved world, from the bottom up.
#include "save/unpack_exact.h"

#include <cmath>
#include <utility>

#include "save/sections.h"

namespace firma {
namespace {

/// How far the square of a normal's length, and its cosine with its plane's, may be from 1. Edits and levels compute
/// normals in double from whole numbers, in some ten operations, which leaves less than 2^-49; this is far more than
/// that, and far less than a picture or a cast shows.
constexpr double kRounding = 0x1p-40;

/// A normal as edits make them: of length 1 but for rounding, along the plane's.
bool suits(const Vec3& normal, const Plane& plane) {
    const Vec3 n = plane.direction();
    if (!is_finite(normal) || max_abs(normal) > 2) return false;
    return std::fabs(dot(normal, normal) - 1) <= kRounding && dot(normal, n) >= (1 - kRounding) * length(n);
}

class ExactReader {
public:
    ExactReader(Damage& damage, ExactImports imports)
        : damage_(damage),
          against_(std::move(imports.against)),
          planes_(std::move(imports.planes)),
          vertices_(std::move(imports.vertices)),
          edges_(std::move(imports.edges)) {}

    std::vector<Ref<SolidFace>> read(Sections& sections) {
        const Entries planes = sections.entries(kPlanesSection, kPlaneBytes);
        const Entries grid = sections.entries(kGridPointsSection, kPointBytes);
        const Entries met = sections.entries(kMeetPointsSection, kPointBytes);
        const Entries edges = sections.entries(kEdgesSection, kEdgeBytes);
        const Entries faces = sections.entries(kExactFacesSection, kExactFaceBytes);
        uses_ = sections.entries(kUsesSection, 4);
        ends_ = sections.entries(kLoopsSection, 4);
        if (damage_.error()) return {};
        const bool sound = each(planes, planes_, [&](std::size_t k) { return read_plane(planes, k); }) &&
                           each(grid, vertices_, [&](std::size_t k) { return read_grid_point(grid, k); }) &&
                           each(met, vertices_, [&](std::size_t k) { return read_meet_point(met, k); }) &&
                           each(edges, edges_, [&](std::size_t k) { return read_edge(edges, k); }) &&
                           each(faces, faces_, [&](std::size_t k) { return read_face(faces, k); });
        if (!sound) return {};
        for (const Entries* part : {&uses_, &ends_})
            if (part->left() > 0) damage_.report(part->type(), part->taken(), "belongs to no face");
        return std::move(faces_);
    }

private:
    template <class Objects, class Read>
    static bool each(const Entries& entries, Objects& objects, const Read& read) {
        objects.reserve(objects.size() + entries.count());
        for (std::size_t k = 0; k < entries.count(); ++k)
            if (!read(k)) return false;
        return true;
    }

    bool read_plane(const Entries& section, std::size_t k) {
        const std::byte* at = section.at(k);
        std::int64_t normal[3];
        for (int axis = 0; axis < 3; ++axis) normal[axis] = std::int64_t(read_u64(at + 8 * axis));
        const Unsigned128 offset = Unsigned128(read_u64(at + 32)) << 64 | read_u64(at + 24);
        const Plane plane = plane_of_numbers(normal, Int128(offset));
        if (!plane.valid()) return damage_.report(section.type(), k, "is no plane through points of the grid");
        planes_.push_back(Ref<const SolidPlane>(new SolidPlane(plane)));
        return true;
    }

    bool read_grid_point(const Entries& section, std::size_t k) {
        InputPoint point;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = read_i32(section.at(k) + 4 * axis);
            if (point[axis] < -kRimSteps || point[axis] >= kRimSteps)
                return damage_.report(section.type(), k, "lies outside the world");
        }
        vertices_.push_back(Ref<const SolidVertex>(new SolidVertex(point)));
        return true;
    }

    bool read_meet_point(const Entries& section, std::size_t k) {
        Ref<const SolidPlane> planes[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t plane = read_u32(section.at(k) + 4 * i);
            if (plane >= planes_.size()) return damage_.report(section.type(), k, "names a plane that is not there");
            planes[i] = planes_[plane];
        }
        if (!meet_in_world(planes[0]->plane, planes[1]->plane, planes[2]->plane))
            return damage_.report(section.type(), k, "its planes do not meet in a point within the world");
        vertices_.emplace_back(
            new SolidVertex(ExactPoint(planes[0]->plane, planes[1]->plane, planes[2]->plane), planes));
        return true;
    }

    bool read_edge(const Entries& section, std::size_t k) {
        const std::byte* at = section.at(k);
        Ref<SolidEdge> edge(new SolidEdge);
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t vertex = read_u32(at + 4 * i), plane = read_u32(at + 8 + 4 * i);
            if (vertex >= vertices_.size())
                return damage_.report(section.type(), k, "names a vertex that is not there");
            if (plane >= planes_.size()) return damage_.report(section.type(), k, "names a plane that is not there");
            edge->vertex[i] = vertices_[vertex];
            edge->plane[i] = planes_[plane];
        }
        const std::uint32_t flags = read_u32(at + 16);
        if (flags & ~kDoubledEdge) return damage_.report(section.type(), k, "has flags that mean nothing");
        edge->doubled = flags & kDoubledEdge;
        if (edge->vertex[0].get() == edge->vertex[1].get())
            return damage_.report(section.type(), k, "begins where it ends");
        if (exact_parallel(edge->plane[0]->plane, edge->plane[1]->plane))
            return damage_.report(section.type(), k, "its two planes are parallel");
        for (const Ref<const SolidVertex>& vertex : edge->vertex)
            for (const Ref<const SolidPlane>& plane : edge->plane)
                if (!lies_on(plane->plane, vertex->point))
                    return damage_.report(section.type(), k, "its vertices lie off its planes");
        edges_.emplace_back(edge.get());
        return true;
    }

    bool read_face(const Entries& section, std::size_t k) {
        const std::byte* at = section.at(k);
        const std::uint32_t plane = read_u32(at), uses = read_u32(at + 4), loops = read_u32(at + 8);
        if (plane >= planes_.size()) return damage_.report(section.type(), k, "names a plane that is not there");
        if (uses > uses_.left() || loops > ends_.left())
            return damage_.report(section.type(), k, "has more edges or loops than there are");
        Ref<SolidFace> face(new SolidFace);
        face->plane = planes_[plane];
        face->facets = 0;
        for (int axis = 0; axis < 3; ++axis) face->normal[axis] = read_f64(at + 12 + 8 * axis);
        if (!suits(face->normal, face->plane->plane))
            return damage_.report(section.type(), k, "its normal is not that of its plane");
        if (!read_uses(*face, uses) || !read_loops(*face, loops)) return false;
        face->set_hash();
        faces_.push_back(std::move(face));
        return true;
    }

    bool read_uses(SolidFace& face, std::uint32_t count) {
        face.uses.reserve(count);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t entry = uses_.taken();
            const std::uint32_t use = read_u32(uses_.take(1));
            if (use >> 1 >= edges_.size())
                return damage_.report(uses_.type(), entry, "names an edge that is not there");
            const bool against = use >> 1 < against_.size() && against_[use >> 1];
            face.uses.emplace_back(edges_[use >> 1], ((use & 1) != 0) != against);
            face.box.add(face.uses.back().from().point.rounded());
        }
        return true;
    }

    bool read_loops(SolidFace& face, std::uint32_t count) {
        std::uint32_t before = 0;
        std::vector<std::uint32_t> loop_ends;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t entry = ends_.taken();
            const std::uint32_t end = read_u32(ends_.take(1));
            if (end > face.uses.size() || end < before || end - before < 3)
                return damage_.report(ends_.type(), entry, "is no loop of three edges or more");
            loop_ends.push_back(end);
            before = end;
        }
        if (count == 0 || before != face.uses.size())
            return damage_.report(kExactFacesSection, faces_.size(), "has edges in no loop, or none");
        face.set_loop_ends(loop_ends);
        return true;
    }

    Damage& damage_;
    Entries uses_, ends_;
    std::vector<bool> against_;
    std::vector<Ref<const SolidPlane>> planes_;
    std::vector<Ref<const SolidVertex>> vertices_;
    std::vector<Ref<const SolidEdge>> edges_;
    std::vector<Ref<SolidFace>> faces_;
};

}  // namespace

void ExactImports::add(const SolidFace& face) {
    planes.push_back(face.plane);
    for (const SolidUse& use : face.uses) {
        edges.emplace_back(use.address());
        vertices.emplace_back(&use.from());
        against.push_back(use.reversed());
    }
}

std::vector<Ref<SolidFace>> unpack_exact(Sections& sections, Damage& damage, ExactImports imports) {
    return ExactReader(damage, std::move(imports)).read(sections);
}

}  // namespace firma
