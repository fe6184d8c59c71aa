// SPDX-License-Identifier: MIT
// What levels are made of: tables made, read and shown, and what a world says of places and faces.
#include "firma/matter.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"

namespace firma::c {
namespace {

static_assert(FIRMA_FRACTURE_CHUNKS == int(FractureStyle::kChunks) &&
              FIRMA_FRACTURE_SPLINTERS == int(FractureStyle::kSplinters) &&
              FIRMA_FRACTURE_BENDS == int(FractureStyle::kBends) && FIRMA_FRACTURE_PANE == int(FractureStyle::kPane));

struct MattersObject final : Object {
    static constexpr Kind kKind = Kind::kMatters;
    static constexpr const char* kNoun = "table of matters";
    const MatterTable table;
    // What the view shows.
    std::vector<firma_matter> matters;
    std::vector<firma_matter_pattern> patterns;

    explicit MattersObject(MatterTable from) : table(std::move(from)) {
        for (const Matter& it : table.matters)
            matters.push_back({it.name.c_str(), it.inside.c_str(), it.density, it.strength, it.hardness,
                               std::uint32_t(it.fracture), 0});
        for (const MatterPattern& it : table.patterns) patterns.push_back({it.pattern.c_str(), it.matter, 0});
    }
};

firma_code give_matters(MatterTable table, firma_matters* out, const char* function) {
    return give(std::make_unique<MattersObject>(std::move(table)), out, function);
}

firma_code give_matters(Result<MatterTable> table, firma_matters* out, const char* function) {
    if (!table) return fail(table.error());
    return give_matters(std::move(table).value(), out, function);
}

}  // namespace

firma_code read_matters(const firma_matter_table& from, MatterTable& table, const char* function) {
    if (!sized(&from)) return bad_call(function, kWrongSize);
    firma_matter_table given{};
    take_sized(&from, given);
    if ((given.matter_count && !given.matters) || (given.pattern_count && !given.patterns))
        return bad_call(function, "a count without its array");
    bool plain = given.reserved == 0;
    table.matters.clear();
    // One too many is refused like all that are.
    for (std::size_t k = 0; k < std::min(given.matter_count, kMaxMatters + 1); ++k) {
        const firma_matter& it = given.matters[k];
        if (it.fracture > FIRMA_FRACTURE_PANE)
            return fail(FIRMA_ERROR_INVALID, function,
                        "the fracture style of matter " + std::to_string(k) + " is none");
        plain = plain && it.reserved == 0;
        table.matters.push_back(
            {text_of(it.name), text_of(it.inside), it.density, it.strength, it.hardness, FractureStyle(it.fracture)});
    }
    for (std::size_t k = 0; k < std::min(given.pattern_count, kMaxMatters + 1); ++k) {
        plain = plain && given.patterns[k].reserved == 0;
        table.patterns.push_back({text_of(given.patterns[k].pattern), given.patterns[k].matter});
    }
    return plain ? FIRMA_OK : fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_matters_default(firma_matters* matters) {
    return guarded(__func__, [&, function = __func__] {
        if (!matters) return bad_call(function, kNull);
        return give_matters(default_matters(), matters, function);
    });
}

firma_code firma_matters_from_text(const char* text, size_t length, const char* name, firma_matters* matters) {
    return guarded(__func__, [&, function = __func__] {
        if (!matters || (length && !text)) return bad_call(function, kNull);
        return give_matters(firma::read_matters({text, length}, name_or(name, "matters")), matters, function);
    });
}

#if !defined(__wasm__)

firma_code firma_matters_load(const char* path, firma_matters* matters) {
    return guarded(__func__, [&, function = __func__] {
        if (!path || !matters) return bad_call(function, kNull);
        return give_matters(read_matter_file(path), matters, function);
    });
}

#endif

firma_code firma_world_matters(firma_world world, firma_matters* matters) {
    return guarded(__func__, [&, function = __func__] {
        if (!matters) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        return object ? give_matters(matters_of(object->world), matters, function) : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_matters_get_view(firma_matters matters, firma_matter_table* table) {
    return guarded(__func__, [&, function = __func__] {
        if (!table) return bad_call(function, kNull);
        if (!sized(table)) return bad_call(function, kWrongSize);
        const MattersObject* object = find<MattersObject>(matters.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        put_sized(
            {0, 0, object->matters.data(), object->matters.size(), object->patterns.data(), object->patterns.size()},
            table);
        return FIRMA_OK;
    });
}

firma_code firma_matters_release(firma_matters matters) {
    return release<MattersObject>(matters.id, __func__);
}

firma_code firma_world_matter_at(firma_world world, const double point[3], uint32_t* matter) {
    return guarded(__func__, [&, function = __func__] {
        if (!point || !matter) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Vec3 at{point[0], point[1], point[2]};
        if (!is_finite(at)) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the point is not finite");
        *matter = matter_at(object->world, at);
        return FIRMA_OK;
    });
}

firma_code firma_world_matter_of(firma_world world, uint32_t face, const int32_t corner[3], uint32_t* matter) {
    return guarded(__func__, [&, function = __func__] {
        if (!corner || !matter) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::optional<std::uint32_t> found =
            matter_of(object->world, FaceRef{{face}, {corner[0], corner[1], corner[2]}});
        if (!found) return fail(FIRMA_ERROR_INVALID, function, "the world has no such face");
        *matter = *found;
        return FIRMA_OK;
    });
}

firma_code firma_world_count_matters(firma_world world, uint64_t* of_matter, size_t capacity,
                                     firma_matter_counts* counts) {
    return guarded(__func__, [&, function = __func__] {
        if (!counts || (capacity && !of_matter)) return bad_call(function, kNull);
        if (!sized(counts)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const MatterCounts all = count_matters(object->world);
        for (std::size_t k = 0; k < std::min(capacity, all.of_matter.size()); ++k) of_matter[k] = all.of_matter[k];
        put_sized({0, all.rest, all.pieces, all.protected_pieces, all.of_matter.size()}, counts);
        return FIRMA_OK;
    });
}
