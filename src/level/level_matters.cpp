// SPDX-License-Identifier: MIT
// What the closed pieces of a level are made of.
#include "level/level_matters.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/sort.h"
#include "geometry/grid_orient.h"
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

/// How many say what. Many say in a row the same.
class Votes {
public:
    void add(std::uint32_t what) {
        if (count_ > 0 && what != what_) flush();
        what_ = what;
        ++count_;
    }
    const std::map<std::uint32_t, std::size_t>& finish() {
        if (count_ > 0) flush();
        return said_;
    }

private:
    void flush() {
        said_[what_] += count_;
        count_ = 0;
    }

    std::map<std::uint32_t, std::size_t> said_;
    std::uint32_t what_ = 0;
    std::size_t count_ = 0;
};

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
    const InputPoint apex = corner(level.faces[faces[0]], 0);
    Int128 volume = 0;
    for (const std::uint32_t f : faces) {
        const LevelFace& face = level.faces[f];
        const InputPoint first = corner(face, 0);
        for (std::uint32_t k = 2; k < face.corner_count; ++k)
            volume += height(apex, area_vector(first, corner(face, k - 1), corner(face, k)), first);
    }
    return volume > 0;
}

constexpr std::uint32_t kNoShell = ~0u;

std::vector<Shell> shells_of(const Level& level, const LevelSolids& solids,
                             const std::vector<std::uint32_t>& matter_of_material) {
    std::vector<std::uint32_t> number;  // of each piece's shell
    std::vector<Shell> shells;
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        if (!solids.solid[f]) continue;
        const std::uint32_t piece = solids.piece[f];
        if (piece >= number.size()) number.resize(piece + 1, kNoShell);
        if (number[piece] == kNoShell) {
            number[piece] = std::uint32_t(shells.size());
            shells.emplace_back();
        }
        shells[number[piece]].faces.push_back(f);
    }
    for (Shell& shell : shells) {
        Votes matters, looks;
        for (const std::uint32_t f : shell.faces) {
            const std::uint32_t material = level.faces[f].material;
            looks.add(material);
            if (matter_of_material[material] != 0) matters.add(matter_of_material[material]);
            shell.box.add(box_of(level, level.faces[f]));
        }
        shell.matter = most_said(matters.finish());
        shell.look = most_said(looks.finish());
        for (const auto& [material, times] : looks.finish()) shell.materials.push_back(material);
    }
    return shells;
}

void add_source(MatterPieces& made, std::uint32_t first, std::uint32_t matter) {
    if (matter != (made.sources.empty() ? 0 : made.sources.back().matter)) made.sources.push_back({first, matter});
}

void add_sources(const Level& level, const LevelSolids& solids, const std::vector<Shell>& shells,
                 const std::vector<std::uint32_t>& matter_of_material, MatterPieces& made) {
    std::vector<std::uint32_t> of_piece;
    for (const Shell& shell : shells) {
        const std::uint32_t piece = solids.piece[shell.faces[0]];
        if (piece >= of_piece.size()) of_piece.resize(piece + 1);
        of_piece[piece] = shell.matter;
    }
    std::vector<std::uint32_t> by_source(level.faces.size());
    std::iota(by_source.begin(), by_source.end(), 0u);
    const auto source = [&](std::uint32_t face) { return level.faces[face].source; };
    const auto goes_before = [&](std::uint32_t a, std::uint32_t b) {
        return source(a) != source(b) ? source(a) < source(b) : a < b;
    };
    // Most levels have them in order.
    if (!std::is_sorted(by_source.begin(), by_source.end(), goes_before)) sort_range(by_source, goes_before);
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
    bool is_one = true, looks_one = true;
    for (const Shell& shell : shells) {
        is_one = is_one && shell.matter == shells[0].matter;
        looks_one = looks_one && shell.look == shells[0].look;
    }
    if (is_one && looks_one) {  // whichever way they look
        made.rest = shells[0].matter;
        made.rest_look = shells[0].look;
        return made;
    }
    for (Shell& shell : shells) {
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
