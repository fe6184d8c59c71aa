// SPDX-License-Identifier: MIT
// Looks at every brush, every side, every surface.
#include "brush/judge_brush_level.h"

#include <cmath>
#include <string>
#include <utility>

#include "geometry/grid_orient.h"
#include "level/judge_level.h"

namespace firma {
namespace {

constexpr std::size_t kMostSides = std::size_t(1) << 20;  // what joining numbers

std::string missing(const char* what, std::size_t index, std::size_t count) {
    return std::string("its ") + what + " " + std::to_string(index) + " is not there: there are " +
           std::to_string(count);
}

class Judge {
public:
    explicit Judge(const BrushLevel& level) : level_(level) {}

    std::optional<Error> judge() const {
        if (level_.sides.size() >= kMostSides)
            return Error{ErrorCode::kTooLarge, level_.name, "a level has fewer than 2^20 brush sides"};
        if (!(level_.metres_a_unit > 0) || !is_finite(level_.metres_a_unit))
            return Error{ErrorCode::kInvalid, level_.name, "metres_a_unit must be a finite number above zero"};
        if (auto error = judge_textures(level_.textures, level_.name)) return error;
        std::size_t end = 0;  // of the sides of the brushes before
        for (std::size_t k = 0; k < level_.brushes.size(); ++k) {
            const Brush& brush = level_.brushes[k];
            if (std::string reason = fault_of(brush, end); !reason.empty()) return fault(place(k), std::move(reason));
            end = std::size_t(brush.first_side) + brush.side_count;
            for (std::uint32_t s = 0; s < brush.side_count; ++s)
                if (std::string reason = fault_of(level_.sides[brush.first_side + s]); !reason.empty())
                    return fault(place(k) + ", side " + std::to_string(s), std::move(reason));
        }
        // Those of no brush are planes all the same to who joins.
        for (std::size_t k = 0; k < level_.sides.size(); ++k)
            if (std::string reason = fault_of(level_.sides[k]); !reason.empty())
                return fault("side " + std::to_string(k), std::move(reason));
        return judge_surfaces();
    }

private:
    std::string place(std::size_t brush) const {
        const std::uint32_t line = level_.brushes[brush].line;
        return "brush " + std::to_string(brush) + (line == 0 ? "" : " (line " + std::to_string(line) + ")");
    }

    Error fault(const std::string& place, std::string reason) const {
        return {ErrorCode::kInvalid, level_.name.empty() ? place : level_.name + ": " + place, std::move(reason)};
    }

    std::string fault_of(const Brush& brush, std::size_t end) const {
        if (std::size_t(brush.first_side) + brush.side_count > level_.sides.size())
            return "its sides " + std::to_string(brush.first_side) + " to " +
                   std::to_string(std::size_t(brush.first_side) + brush.side_count) + " are not there: there are " +
                   std::to_string(level_.sides.size());
        if (brush.first_side < end)
            return "its sides begin at " + std::to_string(brush.first_side) + ", before those of an earlier brush end";
        if (brush.entity > 0 && brush.entity >= level_.entities.size())
            return missing("entity", brush.entity, level_.entities.size());
        if (brush.kind > BrushKind::kData) return "its kind is none";
        return "";
    }

    std::string fault_of(const BrushSide& side) const {
        if (side.material >= name_count(level_.materials))
            return missing("material", side.material, name_count(level_.materials));
        if (side.texture != kNoTexture && side.texture >= level_.textures.size())
            return missing("texture", side.texture, level_.textures.size());
        for (const GridPoint& point : side.points)
            if (!on_input_grid(point)) return "a point of it is not on the input grid";
        if (on_one_line(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2])))
            return "its three points lie on a line";
        return "";
    }

    std::optional<Error> judge_surfaces() const {
        const Level& surfaces = level_.surfaces;
        if (auto error = judge_level(surfaces, level_.name, "surfaces, ")) return error;
        for (const LevelFace& face : surfaces.faces)
            for (std::uint32_t c = 0; c < face.corner_count; ++c)
                if (!on_input_grid(surfaces.vertices[surfaces.corners[face.first_corner + c]]))
                    return fault("surfaces, face " + std::to_string(face.source),
                                 "a corner of it is not on the input grid");
        return std::nullopt;
    }

    const BrushLevel& level_;
};

}  // namespace

std::optional<Error> judge_brush_level(const BrushLevel& level) {
    return Judge(level).judge();
}

}  // namespace firma
