// SPDX-License-Identifier: MIT
// Casts with known answers, and a judge of other answers to them.
#include "support/exact_cases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "geometry/closest_point.h"

namespace firma::bench {
namespace {

constexpr double kGross = 1e-3;  // metres

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line, char between) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, between);) cells.push_back(cell);
    return cells;
}

std::vector<Row> read_rows(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> columns = split(line, ',');
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = split(line, ',');
        Row row;
        for (std::size_t k = 0; k < columns.size(); ++k) row[columns[k]] = k < cells.size() ? cells[k] : "";
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Numbers of our own test material: no check, no locale to speak of.
double real(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}

scenes::CastQuery read_cast(const Row& row) {
    const auto value = [&](const char* column) { return real(row.at(column)); };
    return {{{value("px"), value("py"), value("pz")}, value("radius")}, {value("dx"), value("dy"), value("dz")}};
}

Expected read_expected(const Row& row) {
    Expected expected;
    const std::string& status = row.at("status");
    expected.status = status == "hit" ? Status::kHit : status == "touching" ? Status::kInitialOverlap : Status::kMiss;
    expected.fraction = real(row.at("fraction"));
    const std::string& faces = row.at("faces").empty() ? row.at("face") : row.at("faces");
    for (const std::string& face : split(faces, '|')) expected.faces.push_back(std::uint32_t(real(face)));
    expected.margin = real(row.at("margin"));
    expected.first_margin = row.at("first_margin").empty() ? expected.margin : real(row.at("first_margin"));
    expected.must_hit = row.at("notes").find('M') != std::string::npos;
    return expected;
}

bool read_case(const std::string& base, ExactCase& exact) {
    exact.name = std::filesystem::path(base).filename().string();
    Result<Level> level = read_obj(read_text(base + ".obj"), exact.name + ".obj");
    if (!level) {
        std::fprintf(stderr, "%s\n", level.error().text().c_str());
        return false;
    }
    exact.level = std::move(level).value();
    exact.faces.resize(exact.level.source_faces);
    for (const LevelFace& face : exact.level.faces)
        for (std::uint32_t c = 0; c < face.corner_count; ++c)
            exact.faces[face.source].push_back(
                to_metres(exact.level.vertices[exact.level.corners[face.first_corner + c]]));
    for (const Row& row : read_rows(base + ".queries.csv")) exact.casts.push_back(read_cast(row));
    for (const Row& row : read_rows(base + ".expected.csv")) exact.expected.push_back(read_expected(row));
    return exact.casts.size() == exact.expected.size();
}

double tolerance_of(const ExactCase& exact, const scenes::CastQuery& move, const std::vector<std::uint32_t>& faces) {
    double size = std::max(max_abs(move.sphere.centre), max_abs(move.sphere.centre + move.path));
    for (const std::uint32_t face : faces)
        for (const Vec3& corner : exact.faces[face]) size = std::max(size, max_abs(corner));
    return 1e-9 * std::max(1.0, size / 1000);
}

struct Nearness {
    double distance = 0;
    double approach = 0;  ///< how fast the centre comes closer, per metre of path
};

Nearness nearness(const scenes::CastQuery& move, const std::vector<Vec3>& face, double fraction) {
    // Relative to a corner: far from the origin the sum would round away what is asked for.
    const Vec3 centre = (move.sphere.centre - face[0]) + move.path * fraction;
    const Closest closest = closest_to(centre, make_shape(face));
    const double size = closest.distance * length(move.path);
    return {closest.distance, size > 0 ? -dot(closest.away, move.path) / size : 0};
}

/// How deep the sphere has been, by this fraction, in the faces that should have stopped it.
double depth_at(const ExactCase& exact, std::size_t cast, double fraction) {
    const scenes::CastQuery& move = exact.casts[cast];
    const Expected& expected = exact.expected[cast];
    const double radius = move.sphere.radius;
    double deepest = 0;
    for (const std::uint32_t index : expected.faces) {
        const Nearness start = nearness(move, exact.faces[index], 0),
                       now = nearness(move, exact.faces[index], fraction);
        double depth;
        if (radius == 0)
            depth = now.distance;
        else if (now.approach < 0)
            depth = expected.first_margin;
        else
            depth = std::max(0.0, std::min(start.distance - radius, 0.0) - (now.distance - radius));
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

Vec3 normal_of(const std::vector<Vec3>& corners) {
    Vec3 normal;
    for (std::size_t c = 2; c < corners.size(); ++c)
        normal = normal + cross(corners[c - 1] - corners[0], corners[c] - corners[0]);
    return normal * (1 / length(normal));
}

/// By how much a sphere should not have stopped at the face that was answered, metres; infinite for a face met from
/// behind.
double falseness(const ExactCase& exact, const scenes::CastQuery& move, const Answer& answer) {
    const std::vector<Vec3>& face = exact.faces[answer.face];
    if (!(answer.fraction >= 0 && answer.fraction <= 1)) return INFINITY;
    if (dot(normal_of(face), move.path) > 1e-9 * length(move.path)) return INFINITY;
    return nearness(move, face, answer.fraction).distance - move.sphere.radius;
}

/// Whether a hit is too clear to be missed. A short path out of a firm overlap is, however small its margin.
bool is_clear(const ExactCase& exact, std::size_t cast, double tolerance) {
    const scenes::CastQuery& move = exact.casts[cast];
    const Expected& expected = exact.expected[cast];
    if (expected.must_hit || expected.margin > tolerance) return true;
    if (expected.status != Status::kInitialOverlap) return false;
    for (const std::uint32_t face : expected.faces) {
        const Nearness start = nearness(move, exact.faces[face], 0);
        if (start.distance - move.sphere.radius < -tolerance && start.approach > 1e-9 + 4 * tolerance / start.distance)
            return true;
    }
    return false;
}

}  // namespace

std::vector<ExactCase> read_exact_cases(const std::string& folder) {
    std::vector<std::string> bases;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        const std::string path = entry.path().string(), ending = ".expected.csv";
        if (path.ends_with(ending)) bases.push_back(path.substr(0, path.size() - ending.size()));
    }
    std::sort(bases.begin(), bases.end());
    std::vector<ExactCase> cases;
    for (const std::string& base : bases) {
        ExactCase exact;
        if (read_case(base, exact)) cases.push_back(std::move(exact));
    }
    return cases;
}

void Verdict::judge(const ExactCase& exact, std::size_t cast, const Answer& answer) {
    const scenes::CastQuery& move = exact.casts[cast];
    const Expected& expected = exact.expected[cast];
    const bool expects_touch = expected.status != Status::kMiss;
    ++casts;
    hits += expects_touch;
    std::vector<std::uint32_t> faces = expected.faces;
    if (answer.touched) faces.push_back(answer.face);
    const double tolerance = tolerance_of(exact, move, faces);
    if (!answer.touched) {
        if (!expects_touch || !is_clear(exact, cast, tolerance)) return;
        ++missed;
        missed_hits += expected.status == Status::kHit;
        gross += expected.margin > kGross;
        deepest = std::max(deepest, expected.margin);
        return;
    }
    const double away = falseness(exact, move, answer);
    false_hits += away > tolerance;
    gross += away > kGross;
    if (!expects_touch || expected.first_margin <= tolerance) return;
    const double behind = (answer.fraction - expected.fraction) * length(move.path);
    if (!(behind > 0)) return;
    const double depth = std::min(behind, depth_at(exact, cast, answer.fraction));
    late += depth > tolerance;
    gross += depth > kGross && !(away > kGross);
    deepest = std::max(deepest, depth);
}

void Verdict::add(const Verdict& more) {
    casts += more.casts;
    hits += more.hits;
    missed += more.missed;
    missed_hits += more.missed_hits;
    false_hits += more.false_hits;
    late += more.late;
    gross += more.gross;
    deepest = std::max(deepest, more.deepest);
}

}  // namespace firma::bench
