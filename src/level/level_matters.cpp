// SPDX-License-Identifier: MIT
// What the closed pieces of a level are made of.
#include "level/level_matters.h"

#include <algorithm>
#include <map>

#include "base/sort.h"
#include "geometry/exact_integer.h"
#include "geometry/exact_plane.h"
#include "solid/append_faces.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

/// A closed piece of the surface.
struct Shell {
    std::vector<std::uint32_t> faces;  ///< ascending
    std::uint32_t matter = 0, look = 0;
    GridBox box;
    bool looks_out = true;
    std::vector<std::uint32_t> materials;  ///< ascending, each once
};

std::vector<std::uint32_t> matter_by_material(const Level& level, const MatterTable& table) {
    std::vector<std::uint32_t> matters;
    for (std::size_t k = 0; k < std::max<std::size_t>(level.materials.size(), 1); ++k) {
        const std::string given = k < level.matters.size() ? level.matters[k] : "";
        std::uint32_t matter = 0;
        if (!given.empty()) {
            const auto named = matter_named(table, given);
            matter = named ? *named : matter_of_texture(table, given);
        }
        if (matter == 0 && k < level.materials.size()) matter = matter_of_texture(table, level.materials[k]);
        matters.push_back(matter);
    }
    return matters;
}

/// What most say; of equally many the lowest.
std::uint32_t most_said(const std::map<std::uint32_t, std::size_t>& said) {
    std::uint32_t best = 0;
    std::size_t count = 0;
    for (const auto& [what, times] : said)
        if (times > count) {
            best = what;
            count = times;
        }
    return best;
}

GridBox box_of(const Level& level, const LevelFace& face) {
    GridBox box;
    for (std::uint32_t k = 0; k < face.corner_count; ++k) box.add(level.vertices[level.corners[face.first_corner + k]]);
    return box;
}

/// By the volume that its faces enclose, exactly: six times that of cones from a corner of the first. Corners have 26
/// bits, the determinants 82, millions of them 105.
bool looks_out(const Level& level, std::span<const std::uint32_t> faces) {
    const auto corner = [&](const LevelFace& face, std::uint32_t k) {
        return to_input(level.vertices[level.corners[face.first_corner + k]]);
    };
    const InputPoint o = corner(level.faces[faces[0]], 0);
    Int128 volume = 0;
    for (const std::uint32_t f : faces) {
        const LevelFace& face = level.faces[f];
        for (std::uint32_t k = 2; k < face.corner_count; ++k) {
            const InputPoint p[3] = {corner(face, 0), corner(face, k - 1), corner(face, k)};
            std::int64_t d[3][3];
            for (int row = 0; row < 3; ++row)
                for (int axis = 0; axis < 3; ++axis) d[row][axis] = std::int64_t(p[row][axis]) - o[axis];
            volume += Int128(d[0][0]) * (Int128(d[1][1]) * d[2][2] - Int128(d[1][2]) * d[2][1]) +
                      Int128(d[0][1]) * (Int128(d[1][2]) * d[2][0] - Int128(d[1][0]) * d[2][2]) +
                      Int128(d[0][2]) * (Int128(d[1][0]) * d[2][1] - Int128(d[1][1]) * d[2][0]);
        }
    }
    return volume > 0;
}

std::vector<Shell> shells_of(const Level& level, const LevelSolids& solids,
                             const std::vector<std::uint32_t>& matter_of_material) {
    std::map<std::uint32_t, std::size_t> number;
    std::vector<Shell> shells;
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        if (!solids.solid[f]) continue;
        const auto [at, is_new] = number.try_emplace(solids.piece[f], shells.size());
        if (is_new) shells.emplace_back();
        shells[at->second].faces.push_back(f);
    }
    for (Shell& shell : shells) {
        std::map<std::uint32_t, std::size_t> matters, looks;
        for (const std::uint32_t f : shell.faces) {
            const std::uint32_t material = level.faces[f].material;
            ++looks[material];
            if (matter_of_material[material] != 0) ++matters[matter_of_material[material]];
            shell.box.add(box_of(level, level.faces[f]));
        }
        shell.matter = most_said(matters);
        shell.look = most_said(looks);
        for (const auto& [material, times] : looks) shell.materials.push_back(material);
    }
    return shells;
}

void add_source(MatterPieces& made, std::uint32_t first, std::uint32_t matter) {
    if (matter != (made.sources.empty() ? 0 : made.sources.back().matter)) made.sources.push_back({first, matter});
}

void add_sources(const Level& level, const LevelSolids& solids, const std::vector<Shell>& shells,
                 const std::vector<std::uint32_t>& matter_of_material, MatterPieces& made) {
    std::map<std::uint32_t, std::uint32_t> of_piece;
    for (const Shell& shell : shells) of_piece[solids.piece[shell.faces[0]]] = shell.matter;
    std::vector<std::uint32_t> by_source;
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) by_source.push_back(f);
    const auto source = [&](std::uint32_t face) { return level.faces[face].source; };
    sort_range(by_source, [&](std::uint32_t a, std::uint32_t b) {
        return source(a) != source(b) ? source(a) < source(b) : a < b;
    });
    for (std::size_t k = 0; k < by_source.size(); ++k) {
        const std::uint32_t face = by_source[k];
        if (k > 0 && source(face) == source(by_source[k - 1])) continue;
        add_source(made, source(face),
                   solids.solid[face] ? of_piece[solids.piece[face]] : matter_of_material[level.faces[face].material]);
    }
}

}  // namespace

Solid solid_of_faces(const Level& level, const LevelSolids& solids, std::span<const std::uint32_t> faces) {
    FaceSet set;
    for (const std::uint32_t f : faces) {
        const LevelFace& face = level.faces[f];
        FaceSet::Entry entry;
        entry.id = {std::uint32_t(set.faces.size())};
        entry.source = face.source;
        entry.first_corner = std::uint32_t(set.corners.size());
        entry.corner_count = face.corner_count;
        entry.solid = true;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(level.vertices[level.corners[face.first_corner + k]]);
        }
        const auto exact = std::lower_bound(solids.stored.begin(), solids.stored.end(), f,
                                            [](const auto& it, std::uint32_t number) { return it.first < number; });
        if (exact != solids.stored.end() && exact->first == f) {
            entry.owner = exact->second.get();
            set.owners.emplace_back(exact->second.get());
        }
        set.faces.push_back(entry);
    }
    return solid_of(build_store(set, {}).store, false, std::uint32_t(set.faces.size()), 0, {});
}

MatterPieces matters_of_level(const Level& level, const LevelSolids& solids, const MatterTable& table) {
    MatterPieces made;
    made.table = table;
    const std::vector<std::uint32_t> matter_of_material = matter_by_material(level, table);
    std::vector<Shell> shells = shells_of(level, solids, matter_of_material);
    add_sources(level, solids, shells, matter_of_material, made);
    if (shells.empty()) return made;
    // Of the rest: what most of the faces around it are of.
    std::map<std::uint32_t, std::size_t> rests, looks;
    bool is_one = true;
    for (Shell& shell : shells) {
        is_one = is_one && shell.matter == shells[0].matter;
        shell.looks_out = looks_out(level, shell.faces);
        if (shell.looks_out) continue;
        rests[shell.matter] += shell.faces.size();
        looks[shell.look] += shell.faces.size();
    }
    if (is_one || solids.rock_outside) {
        made.rest = is_one ? shells[0].matter : most_said(rests);
        made.rest_look = looks.empty() ? shells[0].look : most_said(looks);
    }
    if (is_one) return made;
    sort_range(shells, [](const Shell& a, const Shell& b) {
        const auto one = a.box.volume(), other = b.box.volume();
        return one != other ? one < other : a.faces[0] < b.faces[0];
    });
    for (const Shell& shell : shells) {
        if (!shell.looks_out) continue;
        MatterPiece& piece = made.pieces.emplace_back();
        piece.matter = shell.matter;
        piece.look = shell.look;
        piece.box = shell.box;
        piece.mesh = solid_of_faces(level, solids, shell.faces);
        piece.first_material = std::uint32_t(made.materials.size());
        piece.material_count = std::uint32_t(shell.materials.size());
        made.materials.insert(made.materials.end(), shell.materials.begin(), shell.materials.end());
    }
    return made;
}

}  // namespace firma
