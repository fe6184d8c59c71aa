// SPDX-License-Identifier: MIT
// The oracle against the exact expectations that came with the project (../shared/casts), where they are at hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/reference/exact_oracle.h"

namespace {

using namespace firma;
using namespace firma::reference;
namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(cell);
    if (!line.empty() && line.back() == separator) cells.emplace_back();
    return cells;
}

std::vector<std::map<std::string, std::string>> read_rows(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = split(line, ',');
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = split(line, ',');
        std::map<std::string, std::string> row;
        for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = cells.at(k);
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::vector<Vec3>> read_polygons(const fs::path& path) {
    std::ifstream file(path);
    std::vector<Vec3> vertices;
    std::vector<std::vector<Vec3>> polygons;
    for (std::string line; std::getline(file, line);) {
        std::stringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 v;
            words >> v.x >> v.y >> v.z;
            vertices.push_back(v);
        } else if (kind == "f") {
            polygons.emplace_back();
            for (std::size_t index = 0; words >> index;) polygons.back().push_back(vertices.at(index - 1));
        }
    }
    return polygons;
}

Cast read_cast(std::map<std::string, std::string>& row, Sides sides) {
    const auto number = [&](const char* column) { return std::strtod(row[column].c_str(), nullptr); };
    return {{{number("px"), number("py"), number("pz")}, number("radius")},
            {number("dx"), number("dy"), number("dz")},
            sides};
}

const char* status_name(Status status) {
    return status == Status::kMiss             ? "miss"
           : status == Status::kHit            ? "hit"
           : status == Status::kInitialOverlap ? "touching"
                                               : "invalid";
}
int rank(const std::string& feature) {
    return feature == "face" ? 0 : feature == "edge" ? 1 : 2;
}

void compare_row(const ExactOracle& oracle, const Cast& cast, std::map<std::string, std::string>& row) {
    const Expected expected = oracle.expect(cast);
    ASSERT_EQ(status_name(expected.status), row["status"]);
    if (!expected.touched()) return;
    const std::string fraction = expected.fraction_text(20);
    std::string theirs = row["fraction"];
    if (theirs.find('.') == std::string::npos) theirs += ".";
    theirs.resize(fraction.size(), '0');
    EXPECT_EQ(fraction, theirs);
    std::string faces;
    for (const std::uint32_t f : expected.faces) {
        if (!faces.empty()) faces += '|';
        faces += std::to_string(f);
    }
    if (expected.faces.size() == 1) faces.clear();
    EXPECT_EQ(faces, row["faces"]);
    EXPECT_EQ(std::to_string(expected.faces.front()), row["face"]);
    EXPECT_GE(int(expected.feature),
              rank(row["feature"]));  // at a corner the files may name an edge or the face as well

    if (cast.sphere.radius == 0) return;  // the files' margins of passages count differently
    const ExactCast exact(cast.sphere, cast.path);
    double margin = -INFINITY;
    for (const std::uint32_t f : expected.faces) {
        const SeenPolygon seen(oracle.faces()[f].exact, exact);
        if (seen.passes_through()) return;
        margin = std::max(margin, seen.margin());
    }
    const double theirs_of = std::strtod(row[row["first_margin"].empty() ? "margin" : "first_margin"].c_str(), nullptr);
    EXPECT_NEAR(margin, theirs_of, 1e-3 * std::fabs(theirs_of) + 1e-14);
}

TEST(SharedExpectations, TheOracleAgreesWithAllOfThem) {
    const fs::path folder = fs::path(FIRMA_ROOT) / "../shared/casts/cases";
    if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder;
    std::size_t casts = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        const std::size_t at = file.find(".expected");
        if (at == std::string::npos || file.substr(file.size() - 4) != ".csv") continue;
        const Sides sides = file.find(".expected2") != std::string::npos ? Sides::kBoth : Sides::kFront;
        const std::string base = file.substr(0, at);
        const ExactOracle oracle(read_polygons(folder / (base + ".obj")));
        auto queries = read_rows(folder / (base + ".queries.csv"));
        auto rows = read_rows(entry.path());
        ASSERT_EQ(queries.size(), rows.size()) << file;
        for (std::size_t k = 0; k < rows.size(); ++k, ++casts) {
            SCOPED_TRACE(file + " row " + std::to_string(k));
            compare_row(oracle, read_cast(queries[k], sides), rows[k]);
        }
    }
    RecordProperty("casts", int(casts));
    EXPECT_GT(casts, 10000u);
}

}  // namespace
