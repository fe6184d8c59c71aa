// SPDX-License-Identifier: MIT
// Worlds in files and as bytes.
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/brush_world.h"
#include "firma/save.h"

namespace firma::c {
namespace {

firma_code give_world(Result<World> world, firma_world* out, const char* function) {
    if (!world) return fail(world.error());
    return give(std::make_unique<WorldObject>(std::move(world).value()), out, function);
}

firma_code check_exact(std::uint32_t exact, const char* function) {
    return exact > 1 ? fail(FIRMA_ERROR_INVALID, function, "exact must be 0 or 1") : FIRMA_OK;
}

#if defined(__wasm__)

firma_code load(const char*, const firma_world_options*, firma_world*, const char* function) {
    return fail(FIRMA_ERROR_UNSUPPORTED, function, "there are no files here: use firma_world_unpack()");
}
firma_code save(const World&, const char*, const SaveOptions&, const char* function) {
    return fail(FIRMA_ERROR_UNSUPPORTED, function, "there are no files here: use firma_world_pack()");
}

#else

firma_code load(const char* path, const firma_world_options* options, firma_world* world, const char* function) {
    if (std::string_view(path).ends_with(".firma")) {
        if (options) return fail(FIRMA_ERROR_INVALID, function, "a .firma file has its own options");
        return give_world(load_world(path), world, function);
    }
    WorldOptions made;
    ReadOptions read;
    if (const firma_code code = read_options(options, made, read, function)) return code;
    return give_world(read_world(path, made, read), world, function);
}

firma_code save(const World& world, const char* path, const SaveOptions& options, const char*) {
    const Result<FirmaWritten> saved = save_world(world, path, options);
    return saved ? FIRMA_OK : fail(saved.error());
}

#endif

}  // namespace

firma_code give_bytes(Result<std::vector<std::byte>> made, firma_bytes* out, const char* function) {
    if (!made) return fail(made.error());
    auto object = std::make_unique<BytesObject>();
    object->bytes = std::move(made).value();
    return give(std::move(object), out, function);
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_world_load(const char* path, const firma_world_options* options, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!path || !world) return bad_call(function, kNull);
        return load(path, options, world, function);
    });
}

firma_code firma_world_save(firma_world world, const char* path, uint32_t exact) {
    return guarded(__func__, [&, function = __func__] {
        if (!path) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_exact(exact, function)) return code;
        return save(object->world, path, {exact == 1}, function);
    });
}

firma_code firma_world_pack(firma_world world, uint32_t exact, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_exact(exact, function)) return code;
        return give_bytes(pack_world(object->world, {exact == 1}), bytes, function);
    });
}

firma_code firma_world_unpack(const void* data, size_t length, const char* name, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if ((!data && length) || !world) return bad_call(function, kNull);
        return give_world(unpack_world({static_cast<const std::byte*>(data), length}, name_or(name, "firma")), world,
                          function);
    });
}

firma_code firma_bytes_get_view(firma_bytes bytes, const void** data, size_t* length) {
    return guarded(__func__, [&, function = __func__] {
        if (!data || !length) return bad_call(function, kNull);
        const BytesObject* object = find<BytesObject>(bytes.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *data = object->bytes.data();
        *length = object->bytes.size();
        return FIRMA_OK;
    });
}

firma_code firma_bytes_release(firma_bytes bytes) {
    return release<BytesObject>(bytes.id, __func__);
}
