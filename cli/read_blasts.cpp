// SPDX-License-Identifier: MIT
// Reads and judges everything before the first blast is fired.
#include "cli/read_blasts.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "cli/csv_reader.h"

namespace firma::cli {

namespace {

constexpr std::array<std::string_view, 6> kBlastColumns{"x", "y", "z", "radius", "shape", "seed"};

constexpr std::array<std::string_view, 3> kFromColumns{"fx", "fy", "fz"};

CutterShape shape_at(const CsvReader& csv, std::size_t column) {
    const std::optional<CutterShape> shape = cutter_shape(csv.at(column));
    if (!shape) csv.fail(fmt::format("shape: '{}' is none of rocky, spiky, drill, wedge, box", shown(csv.at(column))));
    return *shape;
}

std::uint64_t seed_at(const CsvReader& csv, std::size_t column) {
    const std::string_view text = csv.at(column);
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    if (error != std::errc() || stop != end)
        csv.fail(fmt::format("seed: '{}' is not a whole number within 0 .. 2^64 - 1", shown(text)));
    return seed;
}

}  // namespace

std::vector<Blast> read_blasts(const std::string& path) {
    const std::string text = read_file(path);
    CsvReader csv(text, path, kBlastColumns, kFromColumns);
    std::vector<Blast> blasts;
    while (csv.next()) {
        Blast blast;
        for (int axis = 0; axis < 3; ++axis) blast.position[axis] = csv.number(std::size_t(axis));
        blast.radius = csv.number(3);
        blast.shape = shape_at(csv, 4);
        blast.seed = seed_at(csv, 5);
        if (csv.has_optional()) {
            Vec3& from = blast.from.emplace();
            for (int axis = 0; axis < 3; ++axis) from[axis] = csv.number(kBlastColumns.size() + std::size_t(axis));
        }
        blasts.push_back(blast);
    }
    return blasts;
}

Cutter cutter_of(const Blast& blast) {
    return make_crater(blast.shape, blast.seed);
}

Pose pose_of(const Blast& blast) {
    return {blast.position, random_turn(blast.seed), blast.radius};
}

}  // namespace firma::cli
