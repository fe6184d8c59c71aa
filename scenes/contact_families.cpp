// SPDX-License-Identifier: MIT
// Levels and cuts in forced contact.
#include "scenes/contact_families.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <tuple>

#include "scenes/lattice_solids.h"

namespace firma::scenes {
namespace {

constexpr std::size_t kContactCuts = 16;
constexpr std::int64_t kWidestCutter = 24 * kMetre;

enum class Contact : std::uint8_t {
    kBlock,
    kBent,
    kWedge,
    kGear,
    kLetter,
    kSponge,
    kSlope,    ///< a tetrahedron with corners on faces, edges and vertices
    kFace,     ///< a face moved outward or inward, and all between
    kAgain,    ///< an earlier cutter where it was
    kShifted,  ///< an earlier cutter moved along the lattice, or by the way from one of its vertices to another
    kPart,     ///< a part of the level, or the box around one or more of them
};
constexpr int kContacts = 11;

bool on_input_grid(const Steps& s) {
    return ((s.x | s.y | s.z) & (kInput - 1)) == 0;
}

std::int64_t extent(std::span<const Steps> points) {
    std::int64_t most = 0;
    for (const Steps& p : points) {
        const Steps way = p - points[0];
        most = std::max({most, std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    }
    return most;
}

void bounds_of(std::span<const Steps> points, Steps& low, Steps& high) {
    low = high = points[0];
    for (const Steps& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
}

/// Its thickness is drawn before it: arguments of one call would be drawn in the compiler's order.
LatticeSolid any_letter(Rng& rng) {
    const int thick = 1 + int(rng.below(2));
    return letter_solid(kLatticeLetters[rng.below(std::uint32_t(kLatticeLetters.size()))], thick);
}

/// Makes cuts that touch what is there: a level's faces, and the cutters before.
class ContactMaker {
public:
    /// @param unit  of the lattice, in surface steps
    ContactMaker(const Level& level, std::int64_t unit, Rng& rng) : unit_(unit), rng_(rng) {
        for (const LevelFace& face : level.faces) {
            std::vector<Steps> corners;
            for (std::uint32_t k = 0; k < face.corner_count; ++k)
                corners.push_back(steps(level.vertices[level.corners[face.first_corner + k]]));
            if (std::all_of(corners.begin(), corners.end(), on_input_grid)) faces_.push_back(std::move(corners));
        }
        of_level_ = faces_.size();
    }

    /// What kPart cuts with.
    void add_part(const LatticeSolid& part) { parts_.push_back(part); }

    /// Kinds at random from a list, until there are enough.
    std::vector<CutOrder> cuts(std::span<const Contact> kinds) {
        if (faces_.empty()) return {};
        for (int tries = 0; orders_.size() < kContactCuts && tries < 400; ++tries) {
            const Contact kind = kinds[rng_.below(std::uint32_t(kinds.size()))];
            if (kind == Contact::kAgain) {
                repeat();
                continue;
            }
            add(make(kind), kind);
        }
        return std::move(orders_);
    }

private:
    std::int64_t small(std::uint32_t most) { return 1 + std::int64_t(rng_.below(most)); }

    /// A few steps of the lattice along one axis or more; may be none.
    Steps lattice_way(std::uint32_t most) {
        Steps way;
        for (std::int64_t* part : {&way.x, &way.y, &way.z})
            *part = rng_.chance(0.5) ? 0 : (rng_.chance(0.5) ? small(most) : -small(most)) * unit_;
        return way;
    }

    const std::vector<Steps>& face() {
        // As often one of a cutter before as one of the level.
        const auto later = std::uint32_t(faces_.size() - of_level_);
        if (later > 0 && rng_.chance(0.5)) return faces_[of_level_ + rng_.below(later)];
        return faces_[rng_.below(std::uint32_t(of_level_))];
    }

    /// A corner of a face, a point of an edge or of its inside that lies on the grid.
    Steps point_of(const std::vector<Steps>& corners) {
        const auto count = std::uint32_t(corners.size());
        const std::uint32_t k = rng_.below(count);
        const Steps &a = corners[k], &b = corners[(k + 1) % count], &c = corners[(k + 2) % count];
        const std::int64_t i = rng_.below(9), j = rng_.chance(0.5) ? 0 : std::int64_t(rng_.below(std::uint32_t(9 - i)));
        const Steps along = (b - a) * i + (c - a) * j;
        const Steps p = a + Steps{along.x / 8, along.y / 8, along.z / 8};
        if ((along.x | along.y | along.z) % (8 * kInput) != 0 || rng_.chance(0.4)) return a;
        return p;
    }

    /// Turned, of the lattice's size, with one of its vertices on a point of a face or a few steps beside it.
    LatticeSolid placed(const LatticeSolid& made) {
        LatticeSolid solid = scaled(turned(made, rng_.below(24)), unit_);
        Steps to = point_of(face());
        if (rng_.chance(0.5)) to = to + lattice_way(2);
        const Steps from = solid.vertices[rng_.below(std::uint32_t(solid.vertices.size()))];
        return moved(std::move(solid), to - from);
    }

    /// Corners from what lies nearest among some faces; one corner may be any point of the lattice beside them.
    LatticeSolid slope() {
        const Steps first = point_of(face());
        std::vector<Steps> points;
        for (int k = 0; k < 24; ++k) {
            const Steps p = point_of(face());
            if (!(p == first)) points.push_back(p);
        }
        const auto distance = [&](const Steps& p) {
            const Steps way[2] = {first, p};
            return extent(way);
        };
        std::sort(points.begin(), points.end(), [&](const Steps& p, const Steps& q) {
            return std::tuple(distance(p), p.x, p.y, p.z) < std::tuple(distance(q), q.x, q.y, q.z);
        });
        if (points.size() < 3) return {};
        const std::size_t near = points.size() > 8 ? 8 : points.size();
        const auto one = [&] { return points[rng_.below(std::uint32_t(near))]; };
        const Steps a = one(), b = one(), c = rng_.chance(0.5) ? one() : first + lattice_way(4);
        return tetrahedron(first, a, b, c);
    }

    LatticeSolid moved_face() {
        const std::vector<Steps> corners = face();
        if (extent(corners) > kWidestCutter) return {};
        Steps way;
        std::int64_t* part[3] = {&way.x, &way.y, &way.z};
        *part[rng_.below(3)] = (rng_.chance(0.5) ? small(3) : -small(3)) * unit_;
        if (rng_.chance(0.3)) way = way + lattice_way(2);
        return moved_polygon(corners, way);
    }

    LatticeSolid shifted() {
        if (made_.empty()) return {};
        const LatticeSolid& solid = made_[rng_.below(std::uint32_t(made_.size()))];
        const auto vertex = [&] { return solid.vertices[rng_.below(std::uint32_t(solid.vertices.size()))]; };
        const Steps from = vertex(), to = vertex();
        return moved(solid, rng_.chance(0.5) ? to - from : lattice_way(2));
    }

    LatticeSolid part() {
        if (parts_.empty()) return {};
        const LatticeSolid& one = parts_[rng_.below(std::uint32_t(parts_.size()))];
        if (rng_.chance(0.4)) return one;
        if (rng_.chance(0.3)) return moved(one, lattice_way(1));
        std::vector<Steps> points = one.vertices;
        if (rng_.chance(0.3))
            for (const LatticeSolid& other : parts_)
                points.insert(points.end(), other.vertices.begin(), other.vertices.end());
        Steps low, high;
        bounds_of(points, low, high);
        // Each side where it is, or a step out or, seldom, in.
        const auto out = [&] { return rng_.chance(0.5) ? 0 : rng_.chance(0.7) ? unit_ : -unit_; };
        for (std::int64_t* at : {&low.x, &low.y, &low.z}) *at -= out();
        for (std::int64_t* at : {&high.x, &high.y, &high.z}) *at += out();
        if (low.x >= high.x || low.y >= high.y || low.z >= high.z) return {};
        return block_solid(low, high);
    }

    LatticeSolid make(Contact kind) {
        switch (kind) {
            case Contact::kBlock:
                return placed(block_solid({}, {small(3), small(3), small(3)}));
            case Contact::kBent:
                return placed(bent_solid(rng_, int(small(2))));
            case Contact::kWedge:
                return placed(wedge_solid(rng_, 4));
            case Contact::kGear:
                return placed(gear_solid(rng_, small(3)));
            case Contact::kLetter:
                return placed(any_letter(rng_));
            case Contact::kSponge:
                return placed(sponge_solid(rng_.chance(0.05) ? 2 : 1));
            case Contact::kSlope:
                return slope();
            case Contact::kFace:
                return moved_face();
            case Contact::kShifted:
                return shifted();
            case Contact::kPart:
                return part();
            case Contact::kAgain:
                break;
        }
        return {};
    }

    void add(const LatticeSolid& solid, Contact kind) {
        static constexpr std::string_view kNames[kContacts] = {"block", "bent", "wedge", "gear",    "letter", "sponge",
                                                               "slope", "face", "again", "shifted", "part"};
        if (solid.empty() || extent(solid.vertices) > 2 * kWidestCutter || !all_in_world(solid.vertices)) return;
        CutOrder order;
        order.cutter = cutter_of(solid, kNames[std::size_t(kind)], order.pose.position);
        if (!order.cutter.valid()) return;
        order.kind = rng_.chance(0.45) ? CarveKind::kFill : CarveKind::kCarve;
        orders_.push_back(std::move(order));
        made_.push_back(solid);
        for (const auto& [a, b, c] : solid.triangles)
            faces_.push_back({solid.vertices[a], solid.vertices[b], solid.vertices[c]});
    }

    void repeat() {
        if (orders_.empty()) return;
        CutOrder order = orders_[rng_.below(std::uint32_t(orders_.size()))];
        order.kind = rng_.chance(0.5) ? CarveKind::kFill : CarveKind::kCarve;
        orders_.push_back(std::move(order));
    }

    const std::int64_t unit_;
    Rng& rng_;
    std::vector<std::vector<Steps>> faces_;  ///< the level's, then those of cutters
    std::size_t of_level_ = 0;
    std::vector<LatticeSolid> parts_, made_;
    std::vector<CutOrder> orders_;
};

std::int64_t any_unit(Rng& rng) {
    static constexpr std::int64_t kUnits[] = {kMetre, kMetre / 2, kMetre / 4, kMetre / 16};
    return kUnits[rng.below(4)];
}

/// The origin, or whole metres far from it.
Steps any_place(Rng& rng) {
    if (rng.chance(0.7)) return {};
    const Steps far = random_steps(rng, 7000);
    return far * kMetre;
}

/// A level of separate solids, or of rooms in rock, on a lattice.
struct LatticeLevel {
    std::int64_t unit = kMetre;
    bool room = false;
    std::vector<LatticeSolid> parts;

    /// In steps of the lattice.
    void add(const LatticeSolid& solid, const Steps& place) { parts.push_back(moved(scaled(solid, unit), place)); }
};

void set_case(CutCase& it, const LatticeLevel& level, std::span<const Contact> kinds, Rng& rng) {
    std::vector<GridPolygon> faces;
    for (const LatticeSolid& part : level.parts) add_faces(faces, part, level.room);
    it.level = level_of(faces);
    ContactMaker maker(it.level, level.unit, rng);
    for (const LatticeSolid& part : level.parts) maker.add_part(part);
    it.cuts = maker.cuts(kinds);
}

/// One to four blocks that do not touch.
LatticeLevel separate_blocks(Rng& rng) {
    LatticeLevel level{any_unit(rng), rng.chance(0.3), {}};
    const Steps place = any_place(rng);
    for (int k = 0; k < 4; ++k) {
        if (k > 0 && rng.chance(0.4)) continue;
        const auto size = [&] { return 1 + std::int64_t(rng.below(3)); };
        const std::int64_t x = size(), y = size(), z = size();
        level.add(block_solid({}, {x, y, z}), place + Steps{k % 2 * 4, k / 2 * 4, 0} * level.unit);
    }
    return level;
}

template <class Make>
LatticeLevel one_solid(Rng& rng, const Make& make) {
    LatticeLevel level{any_unit(rng), rng.chance(0.3), {}};
    const Steps place = any_place(rng);
    level.add(turned(make(), rng.below(24)), place);
    return level;
}

void contact_blocks(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kBlock};
    set_case(it, separate_blocks(rng), kKinds, rng);
}
void contact_faces(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kFace};
    const bool blocks = rng.chance(0.5);
    set_case(it, blocks ? separate_blocks(rng) : one_solid(rng, [&] { return bent_solid(rng, 2); }), kKinds, rng);
}
void contact_wedges(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kWedge, Contact::kWedge, Contact::kShifted};
    const bool blocks = rng.chance(0.5);
    set_case(it, blocks ? separate_blocks(rng) : one_solid(rng, [&] { return wedge_solid(rng, 4); }), kKinds, rng);
}
void contact_bent(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kBent, Contact::kBent, Contact::kShifted};
    set_case(it, one_solid(rng, [&] { return bent_solid(rng, 1 + int(rng.below(2))); }), kKinds, rng);
}
void contact_gears(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kGear, Contact::kGear, Contact::kShifted, Contact::kBlock};
    set_case(it, one_solid(rng, [&] { return gear_solid(rng, 3); }), kKinds, rng);
}
void contact_letters(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kLetter, Contact::kLetter, Contact::kShifted};
    const bool wall = rng.chance(0.5);
    set_case(it, one_solid(rng, [&] { return wall ? block_solid({}, {8, 6, 2}) : any_letter(rng); }), kKinds, rng);
}
void contact_sponges(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kSponge, Contact::kSponge, Contact::kShifted, Contact::kPart};
    const bool large = rng.chance(0.1);
    set_case(it, one_solid(rng, [&] { return sponge_solid(large ? 2 : 1); }), kKinds, rng);
}
void contact_slopes(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kSlope, Contact::kSlope, Contact::kSlope, Contact::kShifted,
                                         Contact::kFace};
    const std::uint32_t which = rng.below(3);
    set_case(it,
             which == 0   ? separate_blocks(rng)
             : which == 1 ? one_solid(rng, [&] { return wedge_solid(rng, 4); })
                          : one_solid(rng, [] { return tetrahedron({0, 0, 0}, {4, 1, 0}, {1, 3, 1}, {0, 1, 5}); }),
             kKinds, rng);
}
void contact_parts(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kPart, Contact::kPart, Contact::kPart, Contact::kBlock};
    const std::uint32_t which = rng.below(4);
    set_case(it,
             which == 0   ? separate_blocks(rng)
             : which == 1 ? one_solid(rng, [&] { return bent_solid(rng, 2); })
             : which == 2 ? one_solid(rng, [&] { return any_letter(rng); })
                          : one_solid(rng, [&] { return gear_solid(rng, 2); }),
             kKinds, rng);
}
void contact_again(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kAgain, Contact::kAgain, Contact::kBlock, Contact::kBent,
                                         Contact::kWedge, Contact::kSlope, Contact::kGear};
    set_case(it, separate_blocks(rng), kKinds, rng);
}
void contact_terrain(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kBlock, Contact::kBlock, Contact::kBent,
                                         Contact::kFace,  Contact::kWedge, Contact::kShifted};
    LatticeLevel level{any_unit(rng), false, {}};
    const Steps place = any_place(rng);
    level.add(column_terrain(rng, 4 + int(rng.below(4)), 3), place);
    set_case(it, level, kKinds, rng);
}

constexpr Contact kAllKinds[] = {Contact::kBlock,  Contact::kBlock,   Contact::kBent, Contact::kWedge, Contact::kGear,
                                 Contact::kFace,   Contact::kFace,    Contact::kFace, Contact::kSlope, Contact::kSlope,
                                 Contact::kLetter, Contact::kShifted, Contact::kAgain};

void contact_rooms(Rng& rng, const Level&, CutCase& it) {
    const bool pillars = rng.chance(0.5);
    const CutLevel level = pillars ? room_with_pillars(rng, {}, kMetre / 8) : block_with_cavities(rng, {}, kMetre / 8);
    it.level = level_of(level.faces);
    it.cuts = ContactMaker(it.level, any_unit(rng), rng).cuts(kAllKinds);
}
void contact_our_level(Rng& rng, const Level& ours, CutCase& it) {
    it.level = ours;
    it.cuts = ContactMaker(it.level, any_unit(rng), rng).cuts(kAllKinds);
}
void contact_meshes(Rng& rng, const Level&, CutCase& it) {
    static constexpr Contact kKinds[] = {Contact::kFace, Contact::kFace, Contact::kSlope, Contact::kSlope,
                                         Contact::kShifted};
    // Meshes whose pieces are castable only have nothing to be cut: another one.
    do it.level = level_of(any_closed_mesh(rng).faces);
    while (level_solidity(it.level).solid_faces < it.level.faces.size());
    it.cuts = ContactMaker(it.level, any_unit(rng), rng).cuts(kKinds);
}

}  // namespace

const std::vector<CutFamily>& contact_families() {
    static const std::vector<CutFamily> families = {
        {"contact_blocks", contact_blocks},       {"contact_faces", contact_faces},
        {"contact_wedges", contact_wedges},       {"contact_bent", contact_bent},
        {"contact_gears", contact_gears},         {"contact_letters", contact_letters},
        {"contact_sponges", contact_sponges},     {"contact_slopes", contact_slopes},
        {"contact_parts", contact_parts},         {"contact_again", contact_again},
        {"contact_terrain", contact_terrain},     {"contact_rooms", contact_rooms},
        {"contact_our_level", contact_our_level}, {"contact_meshes", contact_meshes},
    };
    return families;
}

std::vector<CutOrder> contact_cuts(const Level& walls, std::uint64_t seed, std::uint64_t index) {
    Rng rng(Rng(seed * 0x9E3779B97F4A7C15ull + index).next());
    const std::int64_t unit = any_unit(rng);
    return ContactMaker(walls, unit, rng).cuts(kAllKinds);
}

}  // namespace firma::scenes
