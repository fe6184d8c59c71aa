// SPDX-License-Identifier: MIT
// Reads the brushes, entities and patches of a .bsp into a BrushLevel.
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "brush/brush_builder.h"
#include "brush/brush_kinds.h"
#include "brush/bsp_planes.h"
#include "brush/parse_map.h"
#include "firma/brush_level.h"
#include "level/bsp_file.h"
#include "level/judge_input.h"
#include "level/message.h"

namespace firma {
namespace {

constexpr std::size_t kMostControlPoints = std::size_t(1) << 22;  // faces can share their vertices

// Up to the first NUL.
std::string_view text_of(std::span<const std::byte> lump) {
    const auto end = std::find(lump.begin(), lump.end(), std::byte{0});
    return {reinterpret_cast<const char*>(lump.data()), std::size_t(end - lump.begin())};
}

// What a model's brushes belong to.
struct Owner {
    std::uint32_t entity = 0;
    bool named = false;  // an entity says that the model is its own
    EntityRule rule = EntityRule::kMoves;
};

class BspReader {
public:
    BspReader(const BspFile& file, BrushBuilder& builder) : file_(file), builder_(builder) {}

    std::optional<Error> read() {
        const double scale = builder_.level.metres_a_unit;
        if (auto error = read_entities()) return error;
        if (auto error = read_models()) return error;
        const Result<BspBrushes> brushes = gather_bsp_brushes(file_, scale);
        if (!brushes) return brushes.error();
        builder_.shift(brushes.value().growth * scale, "in lump 8 (brushes)");
        const Result<ExactPlanes> planes = make_exact_planes(file_, brushes.value(), scale);
        if (!planes) return planes.error();
        for (std::uint32_t k = 0; k < brushes.value().brushes.size(); ++k)
            add_brush(k, brushes.value(), planes.value());
        return read_patches();
    }

private:
    std::string place(BspLump which, std::size_t entry) const {
        return file_.fault(ErrorCode::kMalformed, which, entry, {}).place;
    }

    std::optional<Error> read_entities() {
        const std::string lump = file_.fault(ErrorCode::kMalformed, BspLump::kEntities, {}).place;
        Result<MapFile> map = parse_map(text_of(file_.lump(BspLump::kEntities)), lump + ", line ", builder_.notes);
        if (!map) return map.error();
        if (map.value().entities.empty()) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kEntities, "holds no entity");
        }
        builder_.level.entities = std::move(map.value().entities);
        builder_.level.placed_from_origins = true;
        return std::nullopt;
    }

    // Which entity each model is of ("model" "*3"), and which model each brush is of.
    std::optional<Error> read_models() {
        const auto models = file_.records<BspModel>();
        if (models.size() == 0) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kModels, "is empty; the first model is the level");
        }
        owners_.resize(models.size());
        owners_[0] = {0, true, EntityRule::kStatic};
        for (std::uint32_t k = 0; k < builder_.level.entities.size(); ++k) claim_model(k);
        const std::size_t brushes = file_.lump(BspLump::kBrushes).size() / BspBrush::kBytes;
        model_.assign(brushes, kNoModel);
        for (std::size_t k = 0; k < models.size(); ++k) {
            const BspModel model = models[k];
            if (const auto bad = bad_range("brushes", model.first_brush, model.brush_count, brushes)) {
                return file_.fault(ErrorCode::kMalformed, BspLump::kModels, k, *bad);
            }
            for (std::int32_t b = 0; b < model.brush_count; ++b) {
                std::uint32_t& of = model_[std::size_t(model.first_brush) + std::size_t(b)];
                if (of != kNoModel) {
                    return file_.fault(ErrorCode::kMalformed, BspLump::kModels, k,
                                       "brush " + std::to_string(model.first_brush + b) + " is that of model " +
                                           std::to_string(of) + " already");
                }
                of = std::uint32_t(k);
            }
        }
        return std::nullopt;
    }

    // An origin moves the model: what stands still but not where its planes say is kept as data.
    void claim_model(std::uint32_t number) {
        const Entity& entity = builder_.level.entities[number];
        const std::string_view model = entity.value("model");
        std::uint32_t index = 0;
        if (!model.starts_with('*')) return;
        const auto [end, fault] = std::from_chars(model.data() + 1, model.data() + model.size(), index);
        if (fault != std::errc() || end != model.data() + model.size()) return;
        if (index == 0 || index >= owners_.size() || owners_[index].named) return;
        owners_[index] = {number, true, entity_rule(entity.value("classname"))};
        EntityRule& rule = owners_[index].rule;
        if (!entity.value("origin").empty() && rule != EntityRule::kPasses) rule = EntityRule::kMoves;
    }

    void add_brush(std::uint32_t entry, const BspBrushes& brushes, const ExactPlanes& planes) {
        const BspSolid& from = brushes.brushes[entry];
        const std::string at = place(BspLump::kBrushes, entry);
        const auto shaders = file_.records<BspShader>();
        const auto contents = std::uint32_t(shaders[from.shader].content_flags);
        std::uint32_t flags = 0;
        std::vector<BrushBuilder::Side> sides;
        for (std::uint32_t k = from.first_side; k < from.first_side + from.side_count; ++k) {
            const BspSide& side = brushes.sides[k];
            if (!side.bounds) continue;
            const BspShader shader = shaders[side.shader];
            const auto surface = std::uint32_t(shader.surface_flags);
            const FittedPlane& plane = *planes.of_plane[side.plane];
            BrushBuilder::Side made;
            std::copy(std::begin(plane.points), std::end(plane.points), std::begin(made.side.points));
            made.side.material = builder_.material(shader.name);
            made.sky = (surface & bsp_flags::kSurfaceSky) != 0;
            made.portal = (surface & bsp_flags::kSurfaceHint) != 0 ||
                          (std::uint32_t(shader.content_flags) & bsp_flags::kAreaPortal) != 0;
            made.area = side.area;
            flags |= surface;
            builder_.shift(plane.shift, place(BspLump::kPlanes, side.plane));
            sides.push_back(made);
        }
        Brush brush;
        brush.kind = kind_by_flags(contents, flags).value_or(BrushKind::kData);
        brush.detail = (contents & bsp_flags::kDetail) != 0;
        find_owner(entry, brush, at);
        if (sides.size() < 4 && brush.kind != BrushKind::kData) {
            builder_.notes.leave_out("brush that encloses nothing is kept as data", "brushes that enclose nothing", at);
            brush.kind = BrushKind::kData;
        }
        if (sides.size() < 4) brush.part_kind = BrushKind::kData;
        builder_.add(brush, sides);
    }

    void find_owner(std::uint32_t entry, Brush& brush, const std::string& at) {
        if (model_[entry] == kNoModel) {
            builder_.notes.leave_out("brush of no model is kept as data", "brushes of no model", at);
            brush.kind = BrushKind::kData;
            return;
        }
        const Owner& owner = owners_[model_[entry]];
        brush.entity = owner.entity;
        if (owner.rule == EntityRule::kStatic) return;
        if (owner.rule == EntityRule::kDetail) {
            brush.detail = true;
            return;
        }
        if (owner.rule == EntityRule::kMarks) {
            brush.kind = BrushKind::kData;
            return;
        }
        const std::string what = owner.named ? quote(builder_.level.entities[owner.entity].value("classname"))
                                             : std::string("models that no entity names");
        const std::string brushes = "brushes of " + what, note = brushes + " are kept as data";
        if (owner.rule == EntityRule::kPasses || brush.kind == BrushKind::kData)
            builder_.notes.add(note, at);
        else
            builder_.notes.leave_out(note, brushes, at);
        if (owner.named && owner.rule == EntityRule::kMoves) brush.part_kind = brush.kind;
        brush.kind = BrushKind::kData;
    }

    // Those of the first model. Other surfaces are drawn, not met.
    std::optional<Error> read_patches() {
        const auto faces = file_.records<BspFace>();
        const BspModel world = file_.records<BspModel>()[0];
        if (const auto bad = bad_range("faces", world.first_face, world.face_count, faces.size())) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kModels, 0, *bad);
        }
        for (std::int32_t k = 0; k < world.face_count; ++k) {
            const auto entry = std::size_t(world.first_face) + std::size_t(k);
            const BspFace face = faces[entry];
            if (face.type != BspFace::kPatch) continue;
            if (auto error = add_patch(entry, face)) return error;
        }
        note_other_patches(std::size_t(world.first_face), std::size_t(world.face_count));
        return std::nullopt;
    }

    // Those of models that move.
    void note_other_patches(std::size_t first, std::size_t count) {
        const auto faces = file_.records<BspFace>();
        for (std::size_t k = 0; k < faces.size(); ++k)
            if ((k < first || k >= first + count) && faces[k].type == BspFace::kPatch)
                builder_.notes.leave_out("patch of another model than the first is left out",
                                         "patches of models other than the first", place(BspLump::kFaces, k));
    }

    std::optional<Error> add_patch(std::size_t entry, const BspFace& face) {
        const auto malformed = [&](std::string reason) {
            return file_.fault(ErrorCode::kMalformed, BspLump::kFaces, entry, std::move(reason));
        };
        const auto shaders = file_.records<BspShader>();
        const auto vertices = file_.records<BspVertex>();
        const std::int64_t width = face.patch_width, height = face.patch_height;
        const std::string size =
            "patch of " + std::to_string(width) + " x " + std::to_string(height) + " control points";
        if (face.shader < 0 || std::size_t(face.shader) >= shaders.size()) {
            return malformed("shader " + std::to_string(face.shader) + " of " + std::to_string(shaders.size()));
        }
        if (const auto bad = bad_range("vertices", face.first_vertex, face.vertex_count, vertices.size())) {
            return malformed(*bad);
        }
        if (width < 3 || height < 3 || width % 2 == 0 || height % 2 == 0) {
            return malformed(size + "; both must be odd and 3 or more");
        }
        if (width * height != face.vertex_count) {
            return malformed(size + ", but " + std::to_string(face.vertex_count) + " vertices");
        }
        control_points_ += std::size_t(face.vertex_count);
        if (control_points_ > kMostControlPoints) {
            return file_.fault(ErrorCode::kTooLarge, BspLump::kFaces, entry,
                               "patches have more than " + std::to_string(kMostControlPoints) + " control points");
        }
        const BspShader shader = shaders[std::size_t(face.shader)];
        const auto kind = kind_by_flags(std::uint32_t(shader.content_flags), std::uint32_t(shader.surface_flags));
        PatchSurface surface;
        surface.place = place(BspLump::kFaces, entry);
        surface.texture = shader.name;
        surface.mask = kind ? side_mask(*kind, *kind == BrushKind::kSky) : 0;
        surface.patch = surface.uvs = {std::uint32_t(width), std::uint32_t(height), {}};
        bool has_uvs = true;
        for (std::size_t k = 0; k < std::size_t(face.vertex_count); ++k) {
            const BspVertex vertex = vertices[std::size_t(face.first_vertex) + k];
            const auto [x, y, z] = vertex.position;
            surface.patch.control.push_back({x, y, z});
            surface.uvs.control.push_back({double(vertex.uv[0]), double(vertex.uv[1]), 0});
            has_uvs = has_uvs && is_finite(surface.uvs.control.back());
        }
        if (!has_uvs) surface.uvs = {};
        builder_.add_patch(std::move(surface));
        return std::nullopt;
    }

    static constexpr std::uint32_t kNoModel = ~0u;

    const BspFile& file_;
    BrushBuilder& builder_;
    std::vector<Owner> owners_;         // by model
    std::vector<std::uint32_t> model_;  // by brush
    std::size_t control_points_ = 0;
};

}  // namespace

Result<BrushLevel> read_bsp_brushes(std::span<const std::byte> bytes, std::string name, const ReadOptions& options) {
    if (auto error = judge_options(options, name)) return *std::move(error);
    const Result<BspFile> file = BspFile::open(bytes, name);
    if (!file) return file.error();
    BrushBuilder builder(std::move(name), options.scale == 0 ? kQuakeUnit : options.scale);
    if (auto error = BspReader(file.value(), builder).read()) return *std::move(error);
    return builder.finish(options.patch_tolerance);
}

}  // namespace firma
