// SPDX-License-Identifier: MIT
// The bodies that a solid is made of.
#include <algorithm>

#include "carve/side_of_solid.h"
#include "firma/chunk.h"
#include "solid/part_of_solid.h"
#include "solid/shells.h"

namespace firma {
namespace {

class BodyFinder {
public:
    explicit BodyFinder(const Solid& solid)
        : solid_(solid), boundary_(take_boundary(solid.data().faces.root.get())), shells_(find_shells(boundary_)) {}

    std::vector<Solid> find() {
        for (std::uint32_t shell = 0; shell < shells_.faces.size(); ++shell)
            if (shells_.volumes[shell].high > 0) bodies_.push_back({solid_of({shell}, false), {shell}});
        std::vector<std::uint32_t> of_rock;
        for (std::uint32_t shell = 0; shell < shells_.faces.size(); ++shell) {
            if (shells_.volumes[shell].high > 0) continue;
            Body* around = innermost_around(shell);
            (around ? around->shells : of_rock).push_back(shell);
        }
        std::vector<Solid> pieces;
        if (solid_.rock_outside()) pieces.push_back(solid_of(of_rock, true));
        for (Body& body : bodies_)
            pieces.push_back(body.shells.size() == 1 ? std::move(body.solid) : solid_of(body.shells, false));
        return pieces;
    }

    std::size_t shell_count() const { return shells_.faces.size(); }

private:
    struct Body {
        Solid solid;  ///< without its hollows
        std::vector<std::uint32_t> shells;
    };

    Solid solid_of(const std::vector<std::uint32_t>& shells, bool rock_outside) const {
        std::vector<FacetPlace> facets;
        for (const std::uint32_t shell : shells)
            for (const std::uint32_t face : shells_.faces[shell]) {
                const auto own = boundary_.facets_of(face);
                facets.insert(facets.end(), own.begin(), own.end());
            }
        std::sort(facets.begin(), facets.end(),
                  [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
        FaceSet set;
        append_facets(facets, set);
        auto data =
            std::make_shared<SolidData>(solid_of_faces(std::move(set), solid_.data().next_face, solid_.data()).data());
        data->rock_outside = rock_outside;
        return Solid(std::move(data));
    }

    /// Bodies around one point lie in each other: the smallest is the innermost.
    Body* innermost_around(std::uint32_t hollow) {
        Body* found = nullptr;
        for (Body& body : bodies_) {
            const std::uint32_t outer = body.shells[0];
            if (!lies_inside(shells_.boxes[hollow], shells_.boxes[outer])) continue;
            if (found && !(shells_.volumes[outer] < shells_.volumes[found->shells[0]])) continue;
            if (is_in(hollow, body.solid)) found = &body;
        }
        return found;
    }
    static bool lies_inside(const GridBox& inner, const GridBox& outer) {
        for (int axis = 0; axis < 3; ++axis)
            if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
        return true;
    }
    /// By the first corner that tells: the shell may touch the body in some.
    bool is_in(std::uint32_t shell, const Solid& body) const {
        const SolidPatch& patch = boundary_.patch;
        for (const std::uint32_t face : shells_.faces[shell])
            for (const PatchUse& use : patch.uses(patch.faces[face]))
                if (const int side = side_of_solid(body, patch.vertices[patch.from(use)].point); side != 0)
                    return side > 0;
        return false;
    }

    const Solid solid_;
    const Boundary boundary_;
    const BoundaryShells shells_;
    std::vector<Body> bodies_;
};

}  // namespace

std::vector<Solid> connected_pieces(const Solid& solid) {
    if (solid.face_count() == 0) return solid.rock_outside() ? std::vector{solid} : std::vector<Solid>();
    BodyFinder finder(solid);
    if (finder.shell_count() == 1) return {solid};
    return finder.find();
}

}  // namespace firma
