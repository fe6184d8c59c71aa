// SPDX-License-Identifier: MIT
// What a straight path goes through.
#include "firma/pierce.h"

#include <memory>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"

namespace firma::c {
namespace {

struct PiercingObject final : Object {
    static constexpr Kind kKind = Kind::kPiercing;
    static constexpr const char* kNoun = "piercing";
    Piercing work;
    std::vector<firma_pierce_span> spans;
    std::vector<firma_shot_length> lengths;
    double thickness = 0;
};

firma_pierce_end end_told(const PierceEnd& from) {
    firma_pierce_end out{};
    out.fraction = from.fraction;
    put(from.point, out.point);
    put(from.normal, out.normal);
    out.face = from.face.id.value;
    put_corner(from.face, out.corner);
    out.material = from.material;
    return out;
}

firma_pierce_span span_told(const PierceSpan& from) {
    firma_pierce_span out{};
    out.in = end_told(from.in);
    out.out = end_told(from.out);
    out.thickness = from.thickness;
    out.first_length = from.first_matter;
    out.length_count = from.matter_count;
    out.portal = from.portal.value;
    out.pane = from.pane;
    out.starts_inside = from.starts_inside;
    out.ends_inside = from.ends_inside;
    return out;
}

firma_code read_pierce(const firma_pierce_options* given, PierceOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_pierce_options whole;
    firma_pierce_options_defaults(&whole);
    take_sized(given, whole);
    if (whole.both_sides > 1 || whole.no_panes > 1 || whole.no_matters > 1 || whole.reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "a flag is not 0 or 1, or reserved not 0");
    options.mask = whole.mask;
    options.sides = whole.both_sides ? Sides::kBoth : Sides::kFront;
    options.panes = whole.no_panes == 0;
    options.matters = whole.no_matters == 0;
    return FIRMA_OK;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_pierce_options_defaults(firma_pierce_options* options) {
    if (options) *options = {sizeof(firma_pierce_options), ~0u, 0, 0, 0, 0};
}

firma_code firma_piercing_create(firma_piercing* piercing) {
    return guarded(__func__, [&, function = __func__] {
        if (!piercing) return bad_call(function, kNull);
        return give(std::make_unique<PiercingObject>(), piercing, function);
    });
}

firma_code firma_piercing_get_view(firma_piercing piercing, firma_piercing_view* view) {
    return guarded(__func__, [&, function = __func__] {
        if (!view) return bad_call(function, kNull);
        if (!sized(view)) return bad_call(function, kWrongSize);
        const PiercingObject* const object = find<PiercingObject>(piercing.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        put_sized({0, 0, object->spans.data(), object->spans.size(), object->lengths.data(), object->lengths.size(),
                   object->thickness},
                  view);
        return FIRMA_OK;
    });
}

firma_code firma_piercing_release(firma_piercing piercing) {
    return release<PiercingObject>(piercing.id, __func__);
}

firma_code firma_pierce(firma_world world, const double start[3], const double path[3],
                        const firma_pierce_options* options, firma_piercing piercing, uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!start || !path || !status) return bad_call(function, kNull);
        PierceOptions chosen;
        if (const firma_code code = read_pierce(options, chosen, function)) return code;
        const WorldObject* const level = find<WorldObject>(world.id, function);
        if (!level) return FIRMA_ERROR_BAD_HANDLE;
        PiercingObject* const object = find<PiercingObject>(piercing.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Ray ray{{start[0], start[1], start[2]}, {path[0], path[1], path[2]}};
        const Status answer = pierce(level->world, ray, object->work, chosen);
        if (answer == Status::kInvalid)
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a number is not finite or too large");
        const Piercing& found = object->work;
        if (object->spans.capacity() < found.spans.size()) object->spans.reserve(found.spans.size());
        if (object->lengths.capacity() < found.matters.size()) object->lengths.reserve(found.matters.size());
        object->spans.clear();
        object->lengths.clear();
        for (const PierceSpan& span : found.spans) object->spans.push_back(span_told(span));
        for (const MatterLength& it : found.matters) object->lengths.push_back({it.from, it.to, it.matter, 0});
        object->thickness = found.thickness;
        *status = std::uint32_t(answer);
        return FIRMA_OK;
    });
}
