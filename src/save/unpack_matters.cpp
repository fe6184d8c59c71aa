// SPDX-License-Identifier: MIT
// What a saved world is made of: every number that anything later relies on is checked. Bodies must be closed and have
// a volume, meshes must bound solids.
#include "save/unpack_matters.h"

#include <utility>

#include "firma/level.h"
#include "geometry/exact_plane.h"
#include "join/body_solid.h"
#include "save/sections.h"

namespace firma {
namespace {

constexpr std::uint32_t kMostPiecePlanes = 1024;  // as make_brush_shape() has it
/// Of the squares of pieces' planes, which cutting out their faces takes the time of: eight times what the readers of
/// brushes let pass.
constexpr std::uint64_t kMostPlanePairs = std::uint64_t(1) << 29;

bool unpack_table(const Entries& section, MatterPieces& made, Damage& damage) {
    const SectionType type = section.type();
    std::uint64_t left = section.count();
    if (left < kMattersBytes) return damage.report(type, "ends before its counts");
    left -= kMattersBytes;
    const std::byte* at = section.at(0);
    const std::uint64_t matters = read_u32(at), patterns = read_u32(at + 4);
    made.rest = read_u32(at + 8);
    made.rest_look = read_u32(at + 12);
    at += kMattersBytes;
    if (matters > left / kMatterBytes) return damage.report(type, "ends before its matters");
    left -= matters * kMatterBytes;
    if (patterns > left / 8) return damage.report(type, "ends before its patterns");
    left -= patterns * 8;
    const std::byte* const of_patterns = at + matters * kMatterBytes;
    Texts texts({of_patterns + patterns * 8, std::size_t(left)});
    made.table.matters.clear();
    made.table.patterns.clear();
    for (std::uint64_t k = 0; k < matters; ++k, at += kMatterBytes) {
        Matter& matter = made.table.matters.emplace_back();
        matter.density = read_f64(at);
        matter.strength = read_f64(at + 8);
        matter.hardness = read_f64(at + 16);
        const std::uint32_t fracture = read_u32(at + 24);
        if (fracture > std::uint32_t(FractureStyle::kPane)) return damage.report(type, k, "has no such way to break");
        matter.fracture = FractureStyle(fracture);
        const std::uint32_t lengths = read_u32(at + 28);
        if (!texts.take(lengths & 0xFFFF, matter.name) || !texts.take(lengths >> 16, matter.inside))
            return damage.report(type, k, "ends before its texts");
    }
    for (std::uint64_t k = 0; k < patterns; ++k) {
        MatterPattern& it = made.table.patterns.emplace_back();
        it.matter = read_u32(of_patterns + 8 * k);
        if (!texts.take(read_u32(of_patterns + 8 * k + 4), it.pattern))
            return damage.report(type, k, "ends before its pattern");
    }
    if (!texts.all_taken()) return damage.report(type, "has bytes behind its last text");
    if (const auto error = check_matters(made.table))
        return damage.report(ErrorCode::kMalformed, ": section " + section_name(type) + ", " + error->place,
                             error->reason);
    return true;
}

class PieceReader {
public:
    PieceReader(Sections& sections, std::size_t materials, MatterPieces& made, Damage& damage)
        : pieces_(sections.entries(kPiecesSection, kPieceBytes)),
          planes_(sections.entries(kPiecePlanesSection, kPlaneBytes)),
          polygons_(sections.entries(kPiecePolygonsSection, 4)),
          corners_(sections.entries(kPieceCornersSection, kPointBytes)),
          of_piece_(sections.entries(kPieceMaterialsSection, 4)),
          material_count_(materials),
          made_(made),
          damage_(damage) {}

    bool read() {
        if (damage_.error()) return false;
        for (std::size_t k = 0; k < pieces_.count(); ++k)
            if (!read_piece(k)) return false;
        for (const Entries* part : {&planes_, &polygons_, &corners_, &of_piece_})
            if (part->left() > 0) return damage_.report(part->type(), part->taken(), "belongs to no piece");
        return true;
    }

private:
    bool fault(std::size_t k, const char* reason) { return damage_.report(pieces_.type(), k, reason); }

    bool read_piece(std::size_t k) {
        const std::byte* at = pieces_.at(k);
        MatterPiece& piece = made_.pieces.emplace_back();
        piece.matter = read_u32(at);
        piece.look = read_u32(at + 4);
        const std::uint32_t flags = read_u32(at + 8), planes = read_u32(at + 12), polygons = read_u32(at + 16),
                            materials = read_u32(at + 20);
        for (int axis = 0; axis < 3; ++axis) {
            piece.box.low[axis] = read_i32(at + 24 + 4 * axis);
            piece.box.high[axis] = read_i32(at + 36 + 4 * axis);
        }
        if (piece.matter >= made_.table.matters.size()) return fault(k, "names no matter");
        if (piece.look >= material_count_) return fault(k, "names no material");
        if (flags & ~kSkyPiece) return fault(k, "has flags that mean nothing");
        piece.sky = flags & kSkyPiece;
        if ((planes == 0) == (polygons == 0)) return fault(k, "has planes and polygons, or none of them");
        if (planes > kMostPiecePlanes || planes > planes_.left()) return fault(k, "has more planes than there are");
        plane_pairs_ += std::uint64_t(planes) * planes;
        if (plane_pairs_ > kMostPlanePairs) return fault(k, "the pieces have too many planes");
        if (polygons > polygons_.left()) return fault(k, "has more polygons than there are");
        if (materials > of_piece_.left()) return fault(k, "has more materials than there are");
        return read_materials(piece, materials, k) &&
               (planes ? read_body(piece, planes, k) : read_mesh(piece, polygons, k));
    }

    bool read_materials(MatterPiece& piece, std::uint32_t count, std::size_t k) {
        piece.first_material = std::uint32_t(made_.materials.size());
        piece.material_count = count;
        for (std::uint32_t m = 0; m < count; ++m) {
            made_.materials.push_back(read_u32(of_piece_.take(1)));
            if (made_.materials.back() >= material_count_) return fault(k, "names no material");
            if (m > 0 && made_.materials.end()[-2] >= made_.materials.back())
                return fault(k, "its materials are out of order");
        }
        return true;
    }

    bool read_body(MatterPiece& piece, std::uint32_t count, std::size_t k) {
        piece.first_plane = std::uint32_t(made_.planes.size());
        piece.plane_count = count;
        for (std::uint32_t p = 0; p < count; ++p) {
            const std::byte* at = planes_.take(1);
            std::int64_t normal[3];
            for (int axis = 0; axis < 3; ++axis) normal[axis] = std::int64_t(read_u64(at + 8 * axis));
            const Unsigned128 offset = Unsigned128(read_u64(at + 32)) << 64 | read_u64(at + 24);
            const Plane plane = plane_of_numbers(normal, Int128(offset));
            if (!plane.valid())
                return damage_.report(planes_.type(), planes_.taken() - 1, "is no plane through points of the grid");
            made_.planes.push_back(
                Ref<const SolidPlane>(new SolidPlane(plane)));  // held, where there is no room for it
        }
        const std::optional<GridBox> box = box_of_planes(made_.planes_of(piece));
        if (!box) return fault(k, "its planes do not enclose a volume in the world");
        if (*box != piece.box) return fault(k, "its box is not that around it");
        return true;
    }

    bool read_mesh(MatterPiece& piece, std::uint32_t count, std::size_t k) {
        Level level;
        level.materials = level.groups = {""};
        GridBox box;
        for (std::uint32_t p = 0; p < count; ++p) {
            LevelFace face;
            face.source = p;
            face.first_corner = std::uint32_t(level.corners.size());
            face.corner_count = read_u32(polygons_.take(1));
            if (face.corner_count > corners_.left())
                return damage_.report(polygons_.type(), polygons_.taken() - 1, "has more corners than there are");
            for (std::uint32_t c = 0; c < face.corner_count; ++c) {
                const std::byte* at = corners_.take(1);
                level.corners.push_back(std::uint32_t(level.vertices.size()));
                level.vertices.push_back({read_i32(at), read_i32(at + 4), read_i32(at + 8)});
                box.add(level.vertices.back());
            }
            level.faces.push_back(face);
        }
        level.source_faces = count;
        Result<Solid> made = make_solid(level);
        if (!made || made.value().face_count() != count || made.value().rock_outside())
            return fault(k, "its polygons bound no solid");
        if (box != piece.box) return fault(k, "its box is not that around it");
        piece.mesh = std::move(made).value();
        return true;
    }

    Entries pieces_, planes_, polygons_, corners_, of_piece_;
    const std::size_t material_count_;
    std::uint64_t plane_pairs_ = 0;
    MatterPieces& made_;
    Damage& damage_;
};

bool unpack_sources(const Entries& section, MatterPieces& made, Damage& damage) {
    for (std::size_t k = 0; k < section.count(); ++k) {
        const MatterOfSources it{read_u32(section.at(k)), read_u32(section.at(k) + 4)};
        if (it.matter >= made.table.matters.size()) return damage.report(section.type(), k, "names no matter");
        if (k > 0 && it.first < made.sources.back().first) return damage.report(section.type(), k, "is out of order");
        made.sources.push_back(it);
    }
    return true;
}

}  // namespace

std::shared_ptr<const MatterPieces> unpack_matters(Sections& sections, std::size_t materials, Damage& damage) {
    if (!sections.has(kMattersSection)) return nullptr;
    auto made = std::make_shared<MatterPieces>();
    const Entries table = sections.entries(kMattersSection, 1);
    const Entries sources = sections.entries(kMatterSourcesSection, 8);
    if (damage.error() || !unpack_table(table, *made, damage)) return nullptr;
    if (made->rest >= made->table.matters.size()) {
        damage.report(kMattersSection, "names no matter for the rest");
        return nullptr;
    }
    if (made->rest_look >= materials) {
        damage.report(kMattersSection, "names no material for the rest");
        return nullptr;
    }
    PieceReader reader(sections, materials, *made, damage);
    if (!reader.read() || !unpack_sources(sources, *made, damage)) return nullptr;
    made->finish();
    return made;
}

}  // namespace firma
