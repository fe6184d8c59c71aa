// SPDX-License-Identifier: MIT
// Believes nothing: the file may come from anywhere.
#include "cli/read_hits.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "cli/csv_reader.h"
#include "cli/failure.h"

namespace firma::cli {

namespace {

// In the order of the file that `firma cast` writes; only these are used: 1 status, 4 c, 7 p, 10 n.
constexpr std::array<std::string_view, 19> kHitColumns{
    "query", "status", "fraction", "safe_fraction", "cx",  "cy",  "cz",   "px",      "py",  "pz",
    "nx",    "ny",     "nz",       "fnx",           "fny", "fnz", "face", "feature", "room"};

Status status_of(const CsvReader& csv) {
    const std::string_view word = csv.at(1);
    if (word == "hit") return Status::kHit;
    if (word == "touching") return Status::kInitialOverlap;
    if (word == "miss") return Status::kMiss;
    csv.fail("status is neither miss, hit nor touching");
}

Vec3 point_at(const CsvReader& csv, std::size_t column) {
    return {csv.number(column), csv.number(column + 1), csv.number(column + 2)};
}

}  // namespace

draw::DrawnCast drawn(const Query& query, const PolygonHit& hit) {
    return {query.sphere.centre, query.path, query.sphere.radius, hit.status, hit.centre, hit.point, hit.normal};
}

std::vector<draw::DrawnCast> read_hits(const std::string& path, std::span<const Query> queries) {
    const std::string text = read_file(path);
    CsvReader csv(text, path, kHitColumns);
    std::vector<draw::DrawnCast> casts;
    while (csv.next()) {
        const std::size_t row = casts.size();
        if (row >= queries.size()) csv.fail(fmt::format("there are only {} queries", queries.size()));
        if (csv.at(0) != std::to_string(row)) csv.fail(fmt::format("query {} was expected here", row));
        PolygonHit hit;
        hit.status = status_of(csv);
        if (hit.touched()) {
            hit.centre = point_at(csv, 4);
            hit.point = point_at(csv, 7);
            hit.normal = point_at(csv, 10);
        }
        casts.push_back(drawn(queries[row], hit));
    }
    if (casts.size() < queries.size())
        throw Failure(path, fmt::format("holds {} hits where there are {} queries", casts.size(), queries.size()));
    return casts;
}

}  // namespace firma::cli
