// SPDX-License-Identifier: MIT
// Exact faces into sections.
#include "save/exact_packer.h"

#include "save/face_packer.h"

namespace firma {

void ExactPacker::import(const SolidFace& face) {
    planes_.take_next(face.plane.get());
    for (const SolidUse& use : face.uses) {
        edges_.take_next(use.address());
        imported_.take_next(&use.from());
        against_.push_back(use.reversed());
    }
    imported_edges_ = edges_.objects().size();
    imported_planes_ = planes_.objects().size();
}

void ExactPacker::pack() {
    for (const SolidFace* face : faces_.objects()) pack_face(*face);
    // Vertices are numbered through, those of the grid first; which are how many is known only now.
    ObjectNumbers<SolidVertex> on_grid, met;
    const auto each_edge = [&](const auto& function) {
        for (std::size_t k = imported_edges_; k < edges_.objects().size(); ++k) function(*edges_.objects()[k]);
    };
    each_edge([&](const SolidEdge& edge) {
        for (const Ref<const SolidVertex>& vertex : edge.vertex)
            if (!imported_.has(vertex.get())) (vertex->point.on_grid() ? on_grid : met)(vertex.get());
    });
    const auto first_own = std::uint32_t(imported_.objects().size());
    const auto first_met = first_own + std::uint32_t(on_grid.objects().size());
    each_edge([&](const SolidEdge& edge) {
        for (const Ref<const SolidVertex>& vertex : edge.vertex)
            edge_data_.u32(imported_.has(vertex.get()) ? imported_(vertex.get())
                           : vertex->point.on_grid()   ? first_own + on_grid(vertex.get())
                                                       : first_met + met(vertex.get()));
        for (const Ref<const SolidPlane>& plane : edge.plane) edge_data_.u32(planes_(plane.get()));
        edge_data_.u32(edge.doubled ? kDoubledEdge : 0);
    });
    for (const SolidVertex* vertex : on_grid.objects()) put_point(grid_points_, vertex->point.grid());
    for (const SolidVertex* vertex : met.objects())
        for (int k = 0; k < 3; ++k) meet_points_.u32(planes_(vertex->plane(k)));
    for (std::size_t k = imported_planes_; k < planes_.objects().size(); ++k) pack_plane(planes_.objects()[k]->plane);
}

void ExactPacker::pack_face(const SolidFace& face) {
    exact_data_.u32(planes_(face.plane.get()));
    exact_data_.u32(std::uint32_t(face.uses.size()));
    exact_data_.u32(std::uint32_t(face.loop_ends().size()));
    for (int axis = 0; axis < 3; ++axis) exact_data_.f64(face.normal[axis]);
    for (const SolidUse& use : face.uses) {
        const std::uint32_t edge = edges_(use.address());
        const bool against = edge < against_.size() && against_[edge];
        uses_.u32(edge << 1 | std::uint32_t(use.reversed() != against));
    }
    for (const std::uint32_t end : face.loop_ends()) loops_.u32(end);
}

void ExactPacker::pack_plane(const Plane& plane) {
    for (const std::int64_t n : plane.normal) plane_data_.u64(std::uint64_t(n));
    plane_data_.u64(std::uint64_t(plane.offset()));
    plane_data_.u64(std::uint64_t(plane.offset() >> 64));
}

void ExactPacker::add_to(std::vector<NewSection>& sections) {
    sections.push_back({kPlanesSection, kRequiredSection, std::move(plane_data_)});
    sections.push_back({kGridPointsSection, kRequiredSection, std::move(grid_points_)});
    sections.push_back({kMeetPointsSection, kRequiredSection, std::move(meet_points_)});
    sections.push_back({kEdgesSection, kRequiredSection, std::move(edge_data_)});
    sections.push_back({kExactFacesSection, kRequiredSection, std::move(exact_data_)});
    sections.push_back({kUsesSection, kRequiredSection, std::move(uses_)});
    sections.push_back({kLoopsSection, kRequiredSection, std::move(loops_)});
}

}  // namespace firma
