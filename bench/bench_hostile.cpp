// SPDX-License-Identifier: MIT
// What the worst edit that a stranger may ask for costs: by the rules as they are, and by those of a server. Each edit
// is made in a process of its own, whose memory is read before and after.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "firma/solid.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;

    std::uint32_t add(const Vec3& vertex) {
        vertices.push_back(vertex);
        return std::uint32_t(vertices.size() - 1);
    }
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    Cutter cutter(const std::string& name) const { return make_cutter(vertices, triangles, name).value(); }
};

/// A bar along x with teeth that point up, as wide as the gaps between them: 56 m long, 60 m wide, 4 m high.
Mesh comb(int teeth) {
    constexpr double kLength = 56, kHalfWidth = 30, kHeight[3] = {-2, -1, 2};
    Mesh mesh;
    const int count = 2 * teeth;
    const auto vertex = [&](int level, int k, int side) { return std::uint32_t((level * count + k) * 2 + side); };
    for (const double height : kHeight)
        for (int k = 0; k < count; ++k)
            for (const double y : {-kHalfWidth, kHalfWidth})
                mesh.add({kLength * (k / double(count - 1) - 0.5), y, height});
    const auto wall = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {  // seen from y < 0
        mesh.quad(a, b, c, d);
        mesh.quad(d + 1, c + 1, b + 1, a + 1);
    };
    const auto along = [&](std::uint32_t a, std::uint32_t b) { mesh.quad(a, a + 1, b + 1, b); };
    for (int k = 0; k + 1 < count; ++k) {
        const bool tooth = k % 2 == 0;
        wall(vertex(0, k, 0), vertex(0, k + 1, 0), vertex(1, k + 1, 0), vertex(1, k, 0));
        along(vertex(0, k, 0), vertex(0, k + 1, 0));
        if (tooth) wall(vertex(1, k, 0), vertex(1, k + 1, 0), vertex(2, k + 1, 0), vertex(2, k, 0));
        along(vertex(tooth ? 2 : 1, k + 1, 0), vertex(tooth ? 2 : 1, k, 0));
        along(vertex(tooth ? 2 : 1, k, 0), vertex(tooth ? 1 : 2, k, 0));
    }
    along(vertex(1, 0, 0), vertex(0, 0, 0));
    along(vertex(0, count - 1, 0), vertex(1, count - 1, 0));
    along(vertex(1, count - 1, 0), vertex(2, count - 1, 0));
    return mesh;
}

/// A ball whose vertices lie 32 m and 8 m from its middle by turns.
Mesh spikes(int rows) {
    constexpr double kPi = 3.14159265358979323846;
    Mesh mesh;
    const int columns = 2 * rows;
    const std::uint32_t top = mesh.add({0, 0, 32}), bottom = mesh.add({0, 0, -32});
    const auto vertex = [&](int row, int column) {
        return std::uint32_t(2 + (row - 1) * columns + (column + columns) % columns);
    };
    for (int row = 1; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double polar = kPi * row / rows, turn = 2 * kPi * column / columns;
            const double radius = (row + column) % 2 ? 32 : 8;
            mesh.add(Vec3{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)} *
                     radius);
        }
    for (int column = 0; column < columns; ++column) {
        mesh.triangles.push_back({top, vertex(1, column), vertex(1, column + 1)});
        mesh.triangles.push_back({bottom, vertex(rows - 1, column + 1), vertex(rows - 1, column)});
        for (int row = 1; row + 1 < rows; ++row)
            mesh.quad(vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1),
                      vertex(row, column + 1));
    }
    return mesh;
}

struct Edit {
    std::string name;
    std::size_t size;
    std::function<Cutter()> world, cutter;  ///< a world is the solid that its cutter bounds
    Pose pose;
};

/// Teeth from below, teeth from above across them: as many crossings as the square of the teeth.
Edit combs(int teeth) {
    const auto make = [teeth] { return comb(teeth).cutter("comb"); };
    Pose pose;  // a quarter turn about z, then half a turn about x
    pose.rotation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};
    pose.position = {0, 0, 1.5};
    return {"combs that cross", std::size_t(teeth), make, make, pose};
}

Edit balls(int rows) {
    const auto make = [rows] { return spikes(rows).cutter("ball"); };
    Pose pose;
    pose.rotation = {0.1, 0.2, 0.3, 0.9};
    return {"balls of spikes", std::size_t(rows), make, make, pose};
}

/// A ball of spikes within a box of eight kilometres.
Edit large_box(int rows) {
    Pose pose;
    pose.scale = 4000;
    return {"8 km box around a ball", std::size_t(rows), [rows] { return spikes(rows).cutter("ball"); },
            [] { return make_crater(CutterShape::kBox, 0); }, pose};
}

CarveRules of_a_server() {
    CarveRules rules;
    rules.max_candidate_faces = 100'000;
    rules.max_new_faces = 20'000;
    rules.max_cutter_triangles = 2'000;
    rules.max_pairs = 200'000;
    rules.max_cutter_size = 64;
    return rules;
}

/// What a process of its own tells about an edit.
struct Outcome {
    double seconds = 0;
    std::size_t faces = 0;
    CarveStatus status = CarveStatus::kRefused;
    char reason[200] = "it was ended";
    double megabytes = 0;  ///< most at any time, beyond the most before the edit
};

double megabytes_at_most() {
    struct rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return double(used.ru_maxrss) / 1024;
}

Outcome make_apart(const Edit& edit, const CarveRules& rules) {
    int ends[2];
    if (pipe(ends) != 0) std::exit((std::perror("pipe"), 1));
    const pid_t child = fork();
    if (child == 0) {
        Outcome told;
        const SolidResult before = unite(Solid(), edit.world(), Pose());
        const Cutter cutter = edit.cutter();
        SolidCutOptions options;
        options.rules = &rules;
        const double megabytes = megabytes_at_most(), start = thread_seconds();
        const SolidResult result = subtract(before.solid, cutter, edit.pose, options);
        told.seconds = thread_seconds() - start;
        told.megabytes = megabytes_at_most() - megabytes;
        told.faces = result.report.faces_added;
        told.status = result.status;
        std::snprintf(told.reason, sizeof told.reason, "%s", result.done() ? "done" : result.error.text().c_str());
        _exit(write(ends[1], &told, sizeof told) == ssize_t(sizeof told) ? 0 : 1);
    }
    close(ends[1]);
    Outcome outcome;
    if (read(ends[0], &outcome, sizeof outcome) != ssize_t(sizeof outcome)) outcome = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return outcome;
}

int measure(const Settings& settings) {
    std::vector<Edit> edits;
    for (const int teeth : settings.quick ? std::vector<int>{8} : std::vector<int>{64, 128, 256, 512})
        edits.push_back(combs(teeth));
    for (const int rows : settings.quick ? std::vector<int>{8} : std::vector<int>{64, 128, 256})
        edits.push_back(balls(rows));
    edits.push_back(large_box(settings.quick ? 8 : 256));
    Table table("hostile", {"edit", "size", "rules", "s", "MB", "facets made", "outcome"});
    bool fine = true;
    for (const Edit& edit : edits)
        for (const bool server : {false, true}) {
            const Outcome it = make_apart(edit, server ? of_a_server() : CarveRules());
            fine &= it.status != CarveStatus::kRefused || std::string(it.reason) != "it was ended";
            table.add({edit.name, count(edit.size), server ? "a server's" : "default", number(it.seconds),
                       number(it.megabytes), count(it.faces), it.reason});
        }
    return table.finish(settings.csv) && fine ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    return firma::bench::measure(firma::bench::read_settings(
        argc, argv, "What the worst edits cost: time and memory, by the rules as they are and by those of a server."));
}
