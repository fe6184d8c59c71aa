// SPDX-License-Identifier: MIT
// Reads and judges everything before the first cast is made.
#include "cli/read_queries.h"

#include <array>
#include <string_view>

#include "cli/csv_reader.h"
#include "firma/queries.h"

namespace firma::cli {

std::vector<Query> read_queries(const std::string& path) {
    constexpr std::array<std::string_view, 7> kColumns{"px", "py", "pz", "dx", "dy", "dz", "radius"};
    const std::string text = read_file(path);
    CsvReader csv(text, path, kColumns);
    std::vector<Query> queries;
    queries.reserve(csv.most_rows());
    const World nothing;  // asks the library itself what it takes for valid
    while (csv.next()) {
        Query query;
        for (int axis = 0; axis < 3; ++axis) {
            query.sphere.centre[axis] = csv.number(std::size_t(axis));
            query.path[axis] = csv.number(std::size_t(axis) + 3);
        }
        query.sphere.radius = csv.number(6);
        if (query.sphere.radius < 0) csv.fail("radius is negative");
        if (cast(nothing, query.sphere, query.path).status == Status::kInvalid)
            csv.fail("a number is too large to be computed with");
        queries.push_back(query);
    }
    return queries;
}

}  // namespace firma::cli
