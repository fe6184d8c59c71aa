// SPDX-License-Identifier: MIT
// What the brushes of a level are made of: bodies by the planes that joining left them.
#include "brush/brush_matters.h"

#include <algorithm>
#include <optional>

#include "brush/brush_kinds.h"

namespace firma {
namespace {

class MatterFinder {
public:
    MatterFinder(const BrushLevel& level, const MatterTable& table) : level_(level), table_(table) {
        for (const std::string& material : level.materials) {
            const SideKind::What what = side_kind(material).what;
            const bool filler = what == SideKind::What::kFiller || what == SideKind::What::kNothing;
            of_material_.push_back(filler ? 0 : matter_of_texture(table, material));
        }
        if (of_material_.empty()) of_material_.push_back(0);  // a level without names has material 0
        if (!level.entities.empty()) of_world_ = named(level.entities[0].value("matter")).value_or(0);
    }

    std::uint32_t of_brush(const Brush& brush) {
        if (brush.entity != 0)
            if (const auto given = named(level_.entities[brush.entity].value("matter"))) return *given;
        return most(brush, [&](const BrushSide& side) { return of_material_[side.material]; }).value_or(of_world_);
    }

    /// The material that most sides have which are no fillers; of fillers alone, that of most sides.
    std::uint32_t look_of(const Brush& brush) {
        const auto unfilled = [&](const BrushSide& side) {
            if (level_.materials.empty()) return 0u;
            const SideKind::What what = side_kind(level_.materials[side.material]).what;
            return what == SideKind::What::kFiller || what == SideKind::What::kNothing ? 0u : side.material + 1;
        };
        if (const auto found = most(brush, unfilled)) return *found - 1;
        return most(brush, [](const BrushSide& side) { return side.material + 1; }).value_or(1) - 1;
    }

    std::uint32_t of_name(std::string_view material) const { return matter_of_texture(table_, material); }

private:
    std::optional<std::uint32_t> named(std::string_view name) const {
        if (name.empty()) return std::nullopt;
        if (const auto found = matter_named(table_, name)) return found;
        const std::uint32_t fits = matter_of_texture(table_, name);
        return fits != 0 ? std::optional(fits) : std::nullopt;
    }

    /// What most sides say that is not 0; of equally many, what is said first.
    template <class Say>
    std::optional<std::uint32_t> most(const Brush& brush, const Say& say) {
        votes_.clear();
        for (std::uint32_t k = 0; k < brush.side_count; ++k) {
            const std::uint32_t said = say(level_.sides[brush.first_side + k]);
            if (said == 0) continue;
            const auto known =
                std::find_if(votes_.begin(), votes_.end(), [&](const Vote& it) { return it.for_ == said; });
            if (known == votes_.end())
                votes_.push_back({said, 1});
            else
                ++known->count;
        }
        if (votes_.empty()) return std::nullopt;
        return std::max_element(votes_.begin(), votes_.end(),
                                [](const Vote& a, const Vote& b) { return a.count < b.count; })
            ->for_;
    }

    struct Vote {
        std::uint32_t for_ = 0, count = 0;
    };

    const BrushLevel& level_;
    const MatterTable& table_;
    std::vector<std::uint32_t> of_material_;
    std::vector<Vote> votes_;
    std::uint32_t of_world_ = 0;
};

void add_source(MatterPieces& made, std::uint32_t first, std::uint32_t matter) {
    if (matter != (made.sources.empty() ? 0 : made.sources.back().matter)) made.sources.push_back({first, matter});
}

}  // namespace

MatterPieces matters_of_brushes(const BrushLevel& level, const JoinedLevel& joined, const MatterTable& table) {
    MatterPieces made;
    made.table = table;
    MatterFinder finder(level, table);
    std::vector<std::uint32_t> of_brush;
    for (const Brush& brush : level.brushes) {
        of_brush.push_back(finder.of_brush(brush));
        add_source(made, brush.first_side, of_brush.back());
    }
    const auto sides = std::uint32_t(level.sides.size());
    std::vector<std::uint32_t> of_surface;
    for (const std::string& material : level.surfaces.materials) of_surface.push_back(finder.of_name(material));
    if (of_surface.empty()) of_surface.push_back(0);
    for (std::uint32_t k = 0; k < level.surfaces.faces.size(); ++k)
        add_source(made, sides + k, of_surface[level.surfaces.faces[k].material]);
    made.pieces.reserve(joined.bodies.size());
    for (const JoinBody& body : joined.bodies) {
        const Brush& brush = level.brushes[body.brush];
        MatterPiece& piece = made.pieces.emplace_back();
        piece.matter = of_brush[body.brush];
        piece.look = finder.look_of(brush);
        piece.box = body.box;
        piece.first_plane = std::uint32_t(made.planes.size());
        piece.plane_count = std::uint32_t(body.planes.size());
        for (const PlaneId plane : body.planes) made.planes.push_back(joined.tables.planes.stored(plane));
        std::vector<std::uint32_t> materials;
        for (std::uint32_t k = 0; k < brush.side_count; ++k) {
            const BrushSide& side = level.sides[brush.first_side + k];
            materials.push_back(side.material);
            if (!(side.mask & kIsSky) || piece.sky) continue;
            piece.sky = true;
            piece.look = side.material;
        }
        std::sort(materials.begin(), materials.end());
        materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
        piece.first_material = std::uint32_t(made.materials.size());
        piece.material_count = std::uint32_t(materials.size());
        made.materials.insert(made.materials.end(), materials.begin(), materials.end());
    }
    return made;
}

}  // namespace firma
