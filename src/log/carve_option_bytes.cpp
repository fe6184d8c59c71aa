// SPDX-License-Identifier: MIT
// Options of edits as fields.
#include "log/carve_option_bytes.h"

#include <cmath>
#include <utility>

namespace firma {
namespace {

/// Numbers of fields: never used again for another meaning.
enum class OptionField : std::uint64_t {
    kMaterial = 1,
    kFrom = 2,
    kChunks = 3,
};

template <class Put>
void put_field(ByteWriter& out, OptionField field, const Put& put) {
    ByteWriter content;
    put(content);
    put_whole(out, std::uint64_t(field) << 1 | 1);
    put_whole(out, content.size());
    put_bytes(out, content.bytes());
}

std::string rest_of(ByteReader& in) {
    const std::span<const std::byte> bytes = in.bytes(in.left());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A point of the input grid in 12 bytes, any other in 24.
constexpr std::size_t kGridPointBytes = 12;

std::optional<GridPoint> on_grid(const Vec3& point) {
    const std::optional<GridPoint> grid = snap(point);
    return grid && to_metres(*grid) == point ? grid : std::nullopt;
}

void put_point(ByteWriter& out, const Vec3& point) {
    const std::optional<GridPoint> grid = on_grid(point);
    for (int axis = 0; axis < 3; ++axis) grid ? out.i32((*grid)[axis]) : out.f64(point[axis]);
}

Vec3 take_point(ByteReader& in) {
    if (in.left() == kGridPointBytes) {
        GridPoint grid;
        for (int axis = 0; axis < 3; ++axis) grid[axis] = std::int32_t(in.u32());
        if (in.ok() && on_grid(to_metres(grid)) != grid) in.fail("a point that is not on the grid");
        return to_metres(grid);
    }
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = in.f64();
    if (in.ok() && on_grid(point)) in.fail("a point of the grid in more bytes than it needs");
    return point;
}

constexpr std::size_t kChunkBytes = 16;

/// Nothing for ChunkOptions{}.
void put_chunks(ByteWriter& out, const ChunkOptions& chunks) {
    const ChunkOptions usual;
    if (chunks.min_volume == usual.min_volume && chunks.density == usual.density) return;
    out.f64(chunks.min_volume);
    out.f64(chunks.density);
}

ChunkOptions take_chunks(ByteReader& in) {
    ChunkOptions chunks;
    if (in.at_end()) return chunks;
    const std::size_t where = in.place();
    if (in.left() != kChunkBytes) in.fail("options of chunks that are not 16 bytes long");
    chunks.min_volume = in.f64();
    chunks.density = in.f64();
    if (!in.ok()) return chunks;
    const ChunkOptions usual;
    if (std::optional<Error> error = judge_chunk_options(chunks))
        in.fail_at(where, ErrorCode::kMalformed, error->reason);
    else if (chunks.min_volume == usual.min_volume && chunks.density == usual.density)
        in.fail_at(where, ErrorCode::kMalformed, "an option that is what it is by default");
    return chunks;
}

/// @return false for a field that is not known
bool take_field(ByteReader& in, std::uint64_t field, CarveOptions& options) {
    switch (OptionField(field)) {
        case OptionField::kMaterial:
            options.material = rest_of(in);
            if (options.material.empty()) in.fail("an option that is what it is by default");
            return true;
        case OptionField::kFrom:
            options.from = take_point(in);
            return true;
        case OptionField::kChunks:
            options.chunks = take_chunks(in);
            return true;
    }
    return false;
}

}  // namespace

std::optional<Error> judge_chunk_options(const ChunkOptions& options) {
    if (!is_finite(options.min_volume) || !is_finite(options.density))
        return Error{ErrorCode::kOutOfRange, "", "the options of chunks are not finite"};
    if (std::signbit(options.min_volume) || std::signbit(options.density))
        return Error{ErrorCode::kOutOfRange, "", "chunks of less than no volume or density"};
    return {};
}

void put_options(ByteWriter& out, const CarveOptions& options) {
    if (!options.material.empty())
        put_field(out, OptionField::kMaterial, [&](ByteWriter& content) {
            for (const char c : options.material) content.u8(static_cast<unsigned char>(c));
        });
    if (options.from && is_finite(*options.from))  // it has no effect otherwise
        put_field(out, OptionField::kFrom, [&](ByteWriter& content) { put_point(content, *options.from); });
    if (options.chunks)
        put_field(out, OptionField::kChunks, [&](ByteWriter& content) { put_chunks(content, *options.chunks); });
}

CarveOptions take_options(ByteReader& in) {
    CarveOptions options;
    std::uint64_t last = 0;
    while (in.ok() && !in.at_end()) {
        const std::size_t where = in.place();
        const std::uint64_t key = in.whole();
        ByteReader content = in.part(in.whole());
        if (!in.ok()) break;
        if (key >> 1 <= last) {
            in.fail_at(where, ErrorCode::kMalformed, "fields that do not ascend");
            break;
        }
        last = key >> 1;
        const bool known = take_field(content, last, options);
        if (known && content.ok() && !content.at_end()) content.fail("bytes behind an option");
        if (known && !(key & 1)) in.fail_at(where, ErrorCode::kMalformed, "an option that is needed does not say so");
        if (!content.ok()) in.fail(*content.error());
        if (!known && key & 1)
            in.fail_at(where, ErrorCode::kUnsupported, "an option that is needed, and this Firma does not know it");
    }
    return options;
}

}  // namespace firma
