// SPDX-License-Identifier: MIT
// Crater shapes from a seed: balls, a drill, a wedge, a box. No sine or cosine, so the same bits everywhere.
//
// Every shape is seen whole from the origin: each triangle has positive volume with it, and each direction meets one.
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/random.h"
#include "firma/cutter.h"

namespace firma {
namespace {

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
};

/// What a vertex of the ball divides: a corner, a side or a triangle of the icosahedron.
enum class BallVertex : std::uint8_t { kCorner, kSide, kMiddle };

struct Ball {
    Mesh mesh;
    std::vector<BallVertex> kinds;
};

Mesh icosahedron() {
    const double p = (1 + std::sqrt(5.0)) / 2;
    return {{{-1, p, 0},
             {1, p, 0},
             {-1, -p, 0},
             {1, -p, 0},
             {0, -1, p},
             {0, 1, p},
             {0, -1, -p},
             {0, 1, -p},
             {p, 0, -1},
             {p, 0, 1},
             {-p, 0, -1},
             {-p, 0, 1}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Divides each triangle of the icosahedron into nine and puts their 92 vertices on the unit sphere.
class BallMaker {
public:
    Ball make() {
        for (const CutterTriangle& triangle : solid_.triangles) {
            // Vertices are numbered first, one by one: the order of arguments is the compiler's.
            std::uint32_t at[4][4] = {};
            for (int i = 0; i <= 3; ++i)
                for (int j = 0; j <= 3 - i; ++j) at[i][j] = vertex(triangle, {3 - i - j, i, j});
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3 - i; ++j) {
                    add(at[i][j], at[i + 1][j], at[i][j + 1]);
                    if (i + j < 2) add(at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]);
                }
        }
        return std::move(ball_);
    }

private:
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { ball_.mesh.triangles.push_back({a, b, c}); }

    /// The vertex with these thirds of a triangle's corners. The key has the corners in order of number, so that
    /// triangles agree on their common side, whichever way they run along it.
    std::uint32_t vertex(const CutterTriangle& triangle, const std::array<int, 3>& thirds) {
        std::map<std::uint32_t, int> key;
        for (std::size_t k = 0; k < 3; ++k)
            if (thirds[k] > 0) key[triangle[k]] = thirds[k];
        const auto [found, is_new] = number_.try_emplace(key, std::uint32_t(ball_.mesh.vertices.size()));
        if (is_new) {
            Vec3 sum;
            for (const auto& [corner, third] : key) sum = sum + solid_.vertices[corner] * third;
            ball_.mesh.vertices.push_back(sum * (1 / length(sum)));
            ball_.kinds.push_back(BallVertex(key.size() - 1));
        }
        return found->second;
    }

    Mesh solid_ = icosahedron();
    Ball ball_;
    std::map<std::map<std::uint32_t, int>, std::uint32_t> number_;
};

const Ball& unit_ball() {
    static const Ball ball = BallMaker().make();
    return ball;
}

Mesh rocky(Random& random) {
    Mesh mesh = unit_ball().mesh;
    for (Vec3& v : mesh.vertices) v = v * random.uniform(0.78, 1.2);
    return mesh;
}

/// Each triangle of the ball has one corner that divides no side of the icosahedron: those are the spikes.
Mesh spiky(Random& random) {
    const Ball& ball = unit_ball();
    Mesh mesh = ball.mesh;
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
        const bool valley = ball.kinds[k] == BallVertex::kSide;
        const double radius = valley ? random.uniform(0.55, 0.75) : random.uniform(1.25, 2.0);
        mesh.vertices[k] = mesh.vertices[k] * radius;
    }
    return mesh;
}

/// Cosines and sines of multiples of a sixteenth of the full turn, from the formula of the half angle.
std::array<std::pair<double, double>, 16> sixteenths() {
    const double c2 = std::sqrt(0.5), c1 = std::sqrt((1 + c2) / 2), s1 = std::sqrt((1 - c2) / 2);
    const double cosines[5] = {1, c1, c2, s1, 0};
    std::array<std::pair<double, double>, 16> turn;
    for (std::size_t k = 0; k < 4; ++k) {
        const double c = cosines[k], s = cosines[4 - k];
        turn[k] = {c, s};
        turn[k + 4] = {-s, c};
        turn[k + 8] = {-c, -s};
        turn[k + 12] = {s, -c};
    }
    return turn;
}

Mesh drill(Random& random) {
    constexpr std::uint32_t kSides = 16;
    struct Ring {
        double z, radius;
    };
    Mesh mesh;
    mesh.vertices = {{0, 0, -3}, {0, 0, 3}};
    for (const Ring& ring : {Ring{-3, 1}, Ring{2, 0.8}})
        for (const auto& [c, s] : sixteenths()) {
            const double radius = ring.radius * random.uniform(0.92, 1.08);
            const double z = ring.z + random.uniform(-0.08, 0.08);
            mesh.vertices.push_back({radius * c, radius * s, z});
        }
    for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t next = (k + 1) % kSides;
        const std::uint32_t low = 2 + k, low_next = 2 + next, high = low + kSides, high_next = low_next + kSides;
        mesh.triangles.push_back({0, low_next, low});
        mesh.triangles.push_back({low, low_next, high_next});
        mesh.triangles.push_back({low, high_next, high});
        mesh.triangles.push_back({1, high, high_next});
    }
    return mesh;
}

Mesh wedge(Random& random) {
    Mesh mesh;
    for (const double z : {-0.7, 0.7})
        for (const Vec3& corner : {Vec3{1.1, 0, z}, Vec3{-0.6, 0.45, z}, Vec3{-0.6, -0.45, z}}) {
            Vec3 v;
            for (int axis = 0; axis < 3; ++axis) v[axis] = corner[axis] + random.uniform(-0.1, 0.1);
            mesh.vertices.push_back(v);
        }
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

Mesh box() {
    Mesh mesh;
    for (int k = 0; k < 8; ++k) mesh.vertices.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

Mesh shape_mesh(CutterShape shape, std::uint64_t seed) {
    Random random(seed);
    switch (shape) {
        case CutterShape::kRocky:
            return rocky(random);
        case CutterShape::kSpiky:
            return spiky(random);
        case CutterShape::kDrill:
            return drill(random);
        case CutterShape::kWedge:
            return wedge(random);
        case CutterShape::kBox:
            break;
    }
    return box();
}

constexpr std::pair<std::string_view, CutterShape> kShapes[] = {{"rocky", CutterShape::kRocky},
                                                                {"spiky", CutterShape::kSpiky},
                                                                {"drill", CutterShape::kDrill},
                                                                {"wedge", CutterShape::kWedge},
                                                                {"box", CutterShape::kBox}};

}  // namespace

std::optional<CutterShape> cutter_shape(std::string_view name) {
    for (const auto& [text, shape] : kShapes)
        if (text == name) return shape;
    return std::nullopt;
}

std::string_view cutter_shape_name(CutterShape shape) {
    for (const auto& [text, known] : kShapes)
        if (known == shape) return text;
    return "";
}

Cutter make_crater(CutterShape shape, std::uint64_t seed) {
    if (cutter_shape_name(shape).empty()) return {};
    const Mesh mesh = shape_mesh(shape, seed);
    Result<Cutter> cutter = make_cutter(mesh.vertices, mesh.triangles, std::string(cutter_shape_name(shape)));
    FIRMA_ASSERT(cutter.ok(), "a shape of ours is closed");
    return std::move(cutter).value();
}

Quaternion random_turn(std::uint64_t seed) {
    Random random(seed);
    for (;;) {
        Quaternion q{};
        double square = 0;
        for (double& part : q) {
            part = random.uniform(-1, 1);
            square += part * part;
        }
        // Short ones would lose digits; what remains of the ball is as even as the whole.
        if (square < 0.01 || square > 1) continue;
        for (double& part : q) part /= std::sqrt(square);
        return q;
    }
}

}  // namespace firma
