// SPDX-License-Identifier: MIT
// Checking meshes: closed or not by exact decimals, whom it blames, and what it says of the snap.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "firma/mesh.h"
#include "level/exact_number.h"
#include "scenes/rng.h"

namespace firma {
namespace {

/// An .obj in the making.
struct TextMesh {
    std::vector<std::string> vertices;
    std::vector<std::vector<int>> faces;  // from 0

    std::string text() const {
        std::string text;
        for (const std::string& vertex : vertices) text += "v " + vertex + "\n";
        for (const auto& face : faces) {
            text += "f";
            for (const int corner : face) text += " " + std::to_string(corner + 1);
            text += "\n";
        }
        return text;
    }
    /// Of a face, as text() has it.
    std::uint32_t line(std::size_t face) const { return std::uint32_t(vertices.size() + face + 1); }
};

TextMesh cube() {
    return {{"0 0 0", "1 0 0", "0 1 0", "1 1 0", "0 0 1", "1 0 1", "0 1 1", "1 1 1"},
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
}

/// The surface of a box of n^3 cells, corners shared by index.
TextMesh large_box(int n) {
    TextMesh mesh;
    std::map<std::array<int, 3>, int> index;
    const auto corner = [&](std::array<int, 3> p) {
        const auto [entry, is_new] = index.try_emplace(p, int(mesh.vertices.size()));
        if (is_new) {
            std::ostringstream text;
            text << p[0] * 0.1 << ' ' << p[1] * 0.1 << ' ' << p[2] * 0.1;
            mesh.vertices.push_back(text.str());
        }
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int u = 0; u < n; ++u)
                for (int v = 0; v < n; ++v) {
                    std::vector<int> face;
                    for (const auto& [du, dv] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
                        std::array<int, 3> p{};
                        p[std::size_t(axis)] = side * n;
                        p[std::size_t((axis + 1) % 3)] = u + du;
                        p[std::size_t((axis + 2) % 3)] = v + dv;
                        face.push_back(corner(p));
                    }
                    if (side == 0) std::reverse(face.begin(), face.end());
                    mesh.faces.push_back(face);
                }
    return mesh;
}

MeshCheck check(const std::string& text, const ReadOptions& options = {}) {
    const Result<MeshCheck> result = check_obj(text, "t.obj", options);
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? result.value() : MeshCheck{};
}

std::size_t count(const MeshCheck& check, MeshFault what) {
    return std::size_t(
        std::count_if(check.faults.begin(), check.faults.end(), [&](const auto& f) { return f.what == what; }));
}

double seconds_of(const std::string& text) {
    const auto begin = std::chrono::steady_clock::now();
    check(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(CheckMesh, PassesAClosedMeshWoundEitherWay) {
    TextMesh mesh = cube();
    MeshCheck result = check(mesh.text());
    EXPECT_TRUE(result.closed());
    EXPECT_TRUE(result.notes.empty());
    EXPECT_EQ(result.faces, 6u);
    EXPECT_EQ(result.vertices, 8u);
    for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
    EXPECT_TRUE(check(mesh.text()).closed());
}

TEST(CheckMesh, NamesTheRimOfAMissingFace) {
    for (std::size_t gone = 0; gone < 6; ++gone) {
        TextMesh mesh = cube();
        mesh.faces.erase(mesh.faces.begin() + std::ptrdiff_t(gone));
        const MeshCheck result = check(mesh.text());
        ASSERT_EQ(result.faults.size(), 4u);
        EXPECT_FALSE(result.closed());
        for (const MeshFaultPlace& fault : result.faults) {
            EXPECT_EQ(fault.what, MeshFault::kOpenEdge);
            EXPECT_FALSE(fault.t_joint);
            EXPECT_EQ(fault.line, mesh.line(fault.source));
            EXPECT_EQ(length(fault.to - fault.from), 1);
        }
        EXPECT_TRUE(std::is_sorted(result.faults.begin(), result.faults.end(),
                                   [](const auto& a, const auto& b) { return a.source < b.source; }));
    }
}

TEST(CheckMesh, GivesTheEdgeAsTheFaceRunsAlongIt) {
    const MeshCheck result = check("v 0 0 0\nv 1 0 0\nv 0 1 0.25\n\nf 1 2 3\n");
    ASSERT_EQ(result.faults.size(), 3u);
    EXPECT_EQ(result.faults[1].from, (Vec3{1, 0, 0}));
    EXPECT_EQ(result.faults[1].to, (Vec3{0, 1, 0.25}));
    EXPECT_EQ(result.faults[1].line, 5u);
}

TEST(CheckMesh, BlamesAReversedFaceOnce) {
    for (std::size_t turned = 0; turned < 6; ++turned) {
        TextMesh mesh = cube();
        std::reverse(mesh.faces[turned].begin(), mesh.faces[turned].end());
        const MeshCheck result = check(mesh.text());
        ASSERT_EQ(result.faults.size(), 1u);
        EXPECT_EQ(result.faults[0].what, MeshFault::kReversedFace);
        EXPECT_EQ(result.faults[0].source, turned);
        EXPECT_EQ(result.faults[0].line, mesh.line(turned));
        EXPECT_NE(result.faults[0].from, result.faults[0].to);
    }
    TextMesh two = cube();
    std::reverse(two.faces[1].begin(), two.faces[1].end());
    std::reverse(two.faces[3].begin(), two.faces[3].end());
    EXPECT_EQ(count(check(two.text()), MeshFault::kReversedFace), 2u);
    EXPECT_EQ(check(two.text()).faults.size(), 2u);
}

TEST(CheckMesh, OfTwoHalvesBlamesTheOneWithoutTheFirstFace) {
    TextMesh mesh = cube();
    for (const std::size_t face : {0, 2, 4}) std::reverse(mesh.faces[face].begin(), mesh.faces[face].end());
    const MeshCheck result = check(mesh.text());
    ASSERT_EQ(result.faults.size(), 3u);
    EXPECT_EQ(result.faults[0].source, 1u);
    EXPECT_EQ(result.faults[1].source, 3u);
    EXPECT_EQ(result.faults[2].source, 5u);
}

TEST(CheckMesh, TellsReversedFacesAndHolesApart) {
    TextMesh mesh = large_box(10);
    scenes::Rng rng(1);
    for (int round = 0; round < 20; ++round) {
        TextMesh damaged = mesh;
        std::vector<std::uint32_t> turned;
        for (std::uint32_t face = 0; face < damaged.faces.size(); ++face)
            if (rng.chance(0.05)) {
                std::reverse(damaged.faces[face].begin(), damaged.faces[face].end());
                turned.push_back(face);
            }
        const std::size_t gone = rng.below(600);  // a hole, and faces behind it count one less
        if (std::find(turned.begin(), turned.end(), std::uint32_t(gone)) != turned.end()) continue;
        damaged.faces.erase(damaged.faces.begin() + std::ptrdiff_t(gone));
        const MeshCheck result = check(damaged.text());
        EXPECT_EQ(count(result, MeshFault::kOpenEdge), 4u);
        std::vector<std::uint32_t> blamed;
        for (const MeshFaultPlace& fault : result.faults)
            if (fault.what == MeshFault::kReversedFace) blamed.push_back(fault.source + (fault.source >= gone));
        EXPECT_EQ(blamed, turned);
    }
}

TEST(CheckMesh, FindsTJoints) {
    TextMesh mesh = cube();
    mesh.vertices.push_back("0.5 0 0");  // on the edge between faces 0 and 2, used by face 2 only
    mesh.faces[2] = {0, 8, 1, 5, 4};
    const MeshCheck result = check(mesh.text());
    ASSERT_EQ(result.faults.size(), 3u);
    EXPECT_EQ(result.faults[0].source, 0u);
    EXPECT_TRUE(result.faults[0].t_joint);
    EXPECT_FALSE(result.faults[1].t_joint);
    EXPECT_FALSE(result.faults[2].t_joint);

    mesh.vertices[8] = "0.5 0 1e-30";  // by ever so little beside it
    for (const MeshFaultPlace& fault : check(mesh.text()).faults) EXPECT_FALSE(fault.t_joint);
    mesh.vertices[8] = "0." + std::string(300, '3') + " 0 0";  // on it, with more digits than doubles have
    EXPECT_TRUE(check(mesh.text()).faults[0].t_joint);
    mesh.vertices[8] = "1.0000000000000000000000001 0 0";  // on its line, behind its end
    EXPECT_FALSE(check(mesh.text()).faults[0].t_joint);
    mesh.vertices[8] = "0.5 0 0";
    mesh.faces[2] = {0, 1, 5, 4};  // a vertex that no face uses is in nobody's way
    EXPECT_TRUE(check(mesh.text()).closed());
}

/// Against every position tried on every open edge.
TEST(CheckMesh, FindsTheSameTJointsAsTryingThemAll) {
    scenes::Rng rng(2);
    for (int round = 0; round < 300; ++round) {
        TextMesh mesh;
        std::vector<std::array<int, 3>> points;
        const int size = 2 + int(rng.below(12)), scale = round % 3;
        for (int k = 0; k < 200; ++k) {
            points.push_back(
                {int(rng.below(unsigned(size))), int(rng.below(unsigned(size))), int(rng.below(unsigned(size)))});
            std::string text;
            for (const int x : points.back())
                text += std::to_string(x) + (scale == 0 ? " " : scale == 1 ? "e-30 " : "e-399 ");
            mesh.vertices.push_back(text);
        }
        for (int k = 0; k < 66; ++k) mesh.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        const auto lies_on = [&](const Vec3& from, const Vec3& to, const std::array<int, 3>& point) {
            const Vec3 p{double(point[0]), double(point[1]), double(point[2])};
            const Vec3 a = to - from, b = p - from;
            return cross(a, b) == Vec3{0, 0, 0} && dot(a, b) > 0 && dot(a, b) < dot(a, a);
        };
        const MeshCheck result = check(mesh.text());
        if (scale == 2) continue;  // nearest doubles are all zero: only that it ends
        for (const MeshFaultPlace& fault : result.faults) {
            if (fault.what != MeshFault::kOpenEdge) continue;
            const double unit = scale ? 1e30 : 1;
            const auto whole = [&](const Vec3& v) {
                return Vec3{std::round(v.x * unit), std::round(v.y * unit), std::round(v.z * unit)};
            };
            const Vec3 from = whole(fault.from), to = whole(fault.to);
            const bool expected =
                std::any_of(points.begin(), points.begin() + 198, [&](const auto& p) { return lies_on(from, to, p); });
            EXPECT_EQ(fault.t_joint, expected);
        }
    }
}

TEST(CheckMesh, TakesEqualDecimalsForTheSamePosition) {
    const std::vector<std::vector<std::string>> spellings{
        {"0", "-0", "0.0", "0e5", "-.0", "0e-999999999999", "+0", "00"},
        {"1", "1.", "1.00", "+1", "1e0", "10e-1", "0.1e1", "0.1E+1", "001.0e+00", "100000000000000000000e-20"},
        {"0.1", ".1", "1e-1", "0.10000000000000000000000000000000000000000000000000", "+.1",
         "100000000000000000000000e-24"},
        {"123456789.123456789123456789e-6", "123.456789123456789123456789", "0123456789123456789123456789e-24"}};
    scenes::Rng rng(3);
    for (int round = 0; round < 50; ++round) {
        TextMesh mesh = cube(), separate;  // every face brings corners of its own, each spelt its own way
        std::array<std::size_t, 3> low, high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = rng.below(2);
            high[axis] = 2 + rng.below(2);
        }
        for (const auto& face : mesh.faces) {
            separate.faces.emplace_back();
            for (const int corner : face) {
                std::string text;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const auto& words = spellings[corner >> axis & 1 ? high[axis] : low[axis]];
                    text += words[rng.below(std::uint32_t(words.size()))] + " ";
                }
                separate.faces.back().push_back(int(separate.vertices.size()));
                separate.vertices.push_back(text);
            }
        }
        const MeshCheck result = check(separate.text());
        EXPECT_TRUE(result.closed());
        EXPECT_EQ(result.vertices, 8u);
    }
}

TEST(CheckMesh, TellsPositionsApartThatDoublesDoNot) {
    TextMesh mesh = cube();
    for (const std::string& other :
         {"1." + std::string(300, '0') + "1 0 0", std::string("0.99999999999999999999999 0 0"),
          std::string("1 1e-400 0"), std::string("1 0 -1e-300")}) {
        mesh.vertices.push_back(other);
        mesh.faces[2] = {0, int(mesh.vertices.size()) - 1, 5, 4};
        const MeshCheck result = check(mesh.text());
        EXPECT_FALSE(result.closed()) << other;
        EXPECT_EQ(result.vertices, 9u) << other;
    }
    mesh.vertices[8] = "1." + std::string(300, '0') + " 0 0";
    mesh.faces[2] = {0, 8, 5, 4};
    EXPECT_TRUE(check(mesh.text()).closed());
}

TEST(CheckMesh, RefusesNumbersBeyondSense) {
    for (const std::string& word : {"0." + std::string(500, '1'), std::string("1e-401"), std::string("1e-99999999999"),
                                    "0." + std::string(450, '0') + "1"}) {
        const Result<MeshCheck> result = check_obj("v 0 0 0\nv 1 " + word + " 0\nv 0 1 0\nf 1 2 3\n", "t.obj");
        ASSERT_FALSE(result.ok()) << word;
        EXPECT_EQ(result.error().code, ErrorCode::kOutOfRange);
        EXPECT_EQ(result.error().place, "t.obj:2");
        EXPECT_LT(result.error().reason.size(), 160u);
    }
    EXPECT_TRUE(check_obj("v 0 0 0\nv 1 1" + std::string(500, '0') + "e-500 0\nv 0 1 0\nf 1 2 3\n", "t.obj").ok());
    EXPECT_EQ(check_obj("v 0 0 0\nf 1 1 2\n", "t.obj").error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(check_obj("v 9000 0 0\nf 1 1 1\n", "t.obj").error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(check_obj("", "t.obj").error().code, ErrorCode::kMalformed);
}

TEST(CheckMesh, AcceptsEdgesOfFourFaces) {
    TextMesh mesh = cube();  // a second cube that shares an edge with the first
    const TextMesh other = cube();
    for (const std::string& vertex : other.vertices) {
        std::string moved = vertex;
        moved[0] = moved[0] == '0' ? '1' : '2';
        moved[2] = moved[2] == '0' ? '1' : '2';
        mesh.vertices.push_back(moved);
    }
    for (auto face : other.faces) {
        for (int& corner : face) corner += 8;
        mesh.faces.push_back(face);
    }
    const MeshCheck result = check(mesh.text());
    EXPECT_TRUE(result.closed());
    EXPECT_EQ(result.vertices, 14u);
    TextMesh turned = mesh;  // a face at that edge
    std::reverse(turned.faces[5].begin(), turned.faces[5].end());
    ASSERT_EQ(check(turned.text()).faults.size(), 1u);
    EXPECT_EQ(check(turned.text()).faults[0].source, 5u);
}

TEST(CheckMesh, ReportsARepeatedFaceByItsEdges) {
    TextMesh mesh = cube();
    mesh.faces.push_back(mesh.faces[2]);
    const MeshCheck result = check(mesh.text());
    ASSERT_EQ(result.faults.size(), 4u);
    for (const MeshFaultPlace& fault : result.faults) {
        EXPECT_EQ(fault.what, MeshFault::kOpenEdge);
        EXPECT_EQ(fault.source, 6u);
    }
}

/// A band with one twist has no front: one edge stays open whatever is turned.
TEST(CheckMesh, SurvivesAMoebiusBand) {
    std::string text;
    for (int k = 0; k < 5; ++k)
        text += "v " + std::to_string(k * k) + " 0 " + std::to_string(k) + "\nv " + std::to_string(k * k) + " 1 " +
                std::to_string(-k) + "\n";
    for (int k = 0; k < 4; ++k)
        text += "f " + std::to_string(2 * k + 1) + " " + std::to_string(2 * k + 2) + " " + std::to_string(2 * k + 4) +
                " " + std::to_string(2 * k + 3) + "\n";
    text += "f 9 10 1 2\n";
    const MeshCheck result = check(text);
    EXPECT_FALSE(result.closed());
    EXPECT_EQ(count(result, MeshFault::kOpenEdge), 10u + 2u);
}

TEST(CheckMesh, LooksThroughSpikesAndRepeatedCorners) {
    TextMesh mesh = cube();
    mesh.vertices.push_back("0.5 0.5 -1");
    mesh.faces[0] = {0, 0, 2, 8, 2, 3, 1};
    EXPECT_TRUE(check(mesh.text()).closed());
}

TEST(CheckMesh, NotesWhatTheSnapDoes) {
    const std::string flat = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n";
    const auto only_note = [&](const std::string& rest) {
        const MeshCheck result = check(flat + rest);
        EXPECT_EQ(result.notes.size(), 1u) << rest;
        return result.notes.empty() ? MeshNotePlace{MeshNote::kNoArea, 99, 0, {}} : result.notes[0];
    };
    const MeshNotePlace none = only_note("v 2 0 0\n\nf 1 5 2\n");
    EXPECT_EQ(none.what, MeshNote::kNoArea);
    EXPECT_EQ(none.source, 0u);
    EXPECT_EQ(none.line, 7u);
    EXPECT_EQ(only_note("f 1 2 2\n").what, MeshNote::kNoArea);
    EXPECT_EQ(only_note("f 1 2 3 2\n").what, MeshNote::kNoArea);
    EXPECT_EQ(only_note("f 2 3 4 3 2 1\n").what, MeshNote::kNoArea);
    EXPECT_EQ(only_note("v 0 0.00001 0\nf 1 2 5\n").what, MeshNote::kDropped);
    EXPECT_EQ(only_note("v 0 1e-399 0\nf 1 2 5\n").what, MeshNote::kDropped);
    EXPECT_EQ(only_note("v 0 0 0.1\nv 4 0 0.2\nv 4 4 0.3\nv 0 4 0.2\nf 5 6 7 8\n").what, MeshNote::kBent);
    EXPECT_EQ(only_note("v 4 4 1\nf 1 2 5 4\n").what, MeshNote::kDivided);
    EXPECT_EQ(only_note("v 1 1 0\nf 1 2 5 4\n").what, MeshNote::kDivided);
    EXPECT_EQ(only_note("f 1 3 2 4\n").what, MeshNote::kDivided);
    EXPECT_TRUE(check(flat + "f 1 2 3 4\nf 3 2 1\n").notes.empty());
    EXPECT_TRUE(check(flat + "v 4 4 0.00001\nf 1 2 5 4\n").notes.empty()) << "flat on the grid: nothing is done to it";
    // A sliver whose tip the snap takes to the other side.
    const MeshCheck turned = check("v 0 0 0\nv 0.00061 0.00013 0\nv 0.00037 0.000079 0\nf 1 2 3\n");
    ASSERT_EQ(turned.notes.size(), 1u);
    EXPECT_EQ(turned.notes[0].what, MeshNote::kTurned);
}

TEST(CheckMesh, NotesLargeConvexFaces) {
    std::string text, face = "f";
    for (int k = -40; k <= 40; ++k) {
        text += "v " + std::to_string(k) + " " + std::to_string(k * k) + " 0\n";
        face += " " + std::to_string(k + 41);
    }
    const MeshCheck result = check(text + face + "\n");
    ASSERT_EQ(result.notes.size(), 1u);
    EXPECT_EQ(result.notes[0].what, MeshNote::kDivided);
}

/// The same mesh in units of any size: what is exact does not care.
TEST(CheckMesh, JudgesTheFileAndComparesWithTheScale) {
    ReadOptions options;
    options.scale = 1e-6;
    const std::string text =
        "v 0 0 0\nv 4000000 0 0\nv 4000000 4000000 0\nv 0 4000000 0\nv 1 1 0\nf 1 2 3 4\nf 1 2 5\n";
    const MeshCheck result = check(text, options);
    ASSERT_EQ(result.notes.size(), 1u);
    EXPECT_EQ(result.notes[0].what, MeshNote::kDropped);
    EXPECT_EQ(result.faults[0].from, (Vec3{4000000, 0, 0}));
    EXPECT_FALSE(check_obj(text, "t.obj").ok());
}

/// Planes that hold exactly in decimals of every length: the three widths of arithmetic agree.
TEST(CheckMesh, JudgesPlanesAtEveryWidth) {
    for (const int decimals : {3, 9, 12, 16, 20, 60, 300}) {
        const std::string tail(std::size_t(decimals) - 1, '0');
        const auto number = [&](const char* whole, char last) { return std::string(whole) + "." + tail + last; };
        // x + y + z = const, exactly: corners moved along the plane by one unit in the last place
        const std::string on = "v 1 0 0\nv 0 1 0\nv " + number("-1", '1') + " 1 " +
                               (decimals == 3 ? "1.001" : number("1", '1')) + "\nv 0 0 1\n";
        const MeshCheck flat = check(on + "f 1 2 3 4\n");
        ASSERT_LE(flat.notes.size(), 1u);
        for (const MeshNotePlace& note : flat.notes) EXPECT_EQ(note.what, MeshNote::kBent) << decimals;
        const std::string off = "v 1 0 0\nv 0 1 0\nv -0.75 1 " + number("0", '1') + "\nv 0 0 1\nv -0.5 0 1.5\n";
        const MeshCheck bent = check(off + "f 1 2 3 4\n");
        ASSERT_EQ(bent.notes.size(), 1u);
        EXPECT_EQ(bent.notes[0].what, MeshNote::kDivided) << decimals;
    }
}

/// The same faces in units that make every number longer: notes stay as they are.
TEST(CheckMesh, JudgesAlikeAtEveryWidth) {
    scenes::Rng rng(6);
    std::array<std::size_t, 5> seen{};
    for (int round = 0; round < 400; ++round) {
        std::array<std::string, 4> texts;
        std::array<double, 4> scales;
        const int size = 2 + int(rng.below(4)), count = 4 + int(rng.below(4));
        std::vector<std::array<int, 3>> points(24);
        for (auto& point : points) {
            for (int& x : point) x = int(rng.below(unsigned(size)));
            if (rng.chance(0.7)) point[2] = (point[0] + 2 * point[1]) * (round % 2);  // many in one plane
        }
        for (std::size_t width = 0; width < texts.size(); ++width) {
            boost::multiprecision::cpp_int unit = 1;
            for (std::size_t k = 0; k < 25 * width * width; ++k) unit *= 5;
            scales[width] = 1 / unit.convert_to<double>();
            for (const auto& point : points) {
                texts[width] += "v";
                for (const int x : point) texts[width] += " " + boost::multiprecision::cpp_int(unit * x).str() + "e-1";
                texts[width] += "\n";
            }
        }
        std::string faces;
        for (int face = 0; face < 12; ++face) {
            faces += "f";
            for (int k = 0; k < count; ++k) faces += " " + std::to_string(1 + rng.below(24));
            faces += "\n";
        }
        const auto notes_at = [&](std::size_t width) {
            ReadOptions options;
            options.scale = scales[width];
            std::vector<std::pair<std::uint32_t, MeshNote>> notes;
            for (const MeshNotePlace& note : check(texts[width] + faces, options).notes)
                notes.push_back({note.source, note.what});
            return notes;
        };
        const auto notes = notes_at(0);
        for (const auto& [source, what] : notes) ++seen[std::size_t(what)];
        for (std::size_t width = 1; width < texts.size(); ++width)
            EXPECT_EQ(notes_at(width), notes) << texts[0] << faces;
    }
    EXPECT_GT(seen[std::size_t(MeshNote::kNoArea)], 20u);
    EXPECT_GT(seen[std::size_t(MeshNote::kBent)], 5u);
    EXPECT_GT(seen[std::size_t(MeshNote::kDivided)], 1000u);
}

TEST(CheckMesh, IsQuickOnLargeFiles) {
    TextMesh box = large_box(60);  // 21,600 faces
    EXPECT_TRUE(check(box.text()).closed());
    // Every face by itself: every edge open, and T-joints to look for all over.
    scenes::Rng rng(4);
    std::string loose, comb, hub;
    for (int k = 0; k < 30'000; ++k) {
        for (int corner = 0; corner < 3; ++corner) {
            loose += "v";
            for (int axis = 0; axis < 3; ++axis) loose += " " + std::to_string(rng.uniform(-100, 100));
            loose += "\n";
        }
        loose += "f -1 -2 -3\n";
    }
    // Many edges on one line, one inside the other; and many long edges from one place.
    comb = hub = "v 0 0 0\n";
    for (int k = 1; k < 30'000; ++k) {
        comb += "v " + std::to_string(k * 0.01) + " 0 0\nv " + std::to_string(-k * 0.01) + " 0 0\nv 0 " +
                std::to_string(k * 0.01) + " 1\nf -1 -2 -3\n";
        hub += "v 100 " + std::to_string(k * 0.001) + " 0\nv 100 " + std::to_string(k * 0.001) + " 0.0001\nf 1 -1 -2\n";
    }
    for (const std::string& text : {box.text(), loose, comb, hub})
        EXPECT_LT(seconds_of(text), 30);  // each about a second or less here
}

TEST(CheckMesh, ChecksByEnding) {
    EXPECT_EQ(check_mesh("nothing.obj").error().code, ErrorCode::kCannotRead);
    EXPECT_EQ(check_mesh("nothing.bsp").error().code, ErrorCode::kCannotRead);
    EXPECT_EQ(check_mesh("nothing.stl").error().code, ErrorCode::kUnsupported);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view begin) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().extension() == ".obj" && entry.path().filename().string().starts_with(begin))
            files.push_back(entry.path());
    return files;
}

TEST(CheckMesh, FindsOurOwnLevelsSound) {
    const auto files = files_in(std::filesystem::path(FIRMA_ROOT) / "levels", "");
    EXPECT_FALSE(files.empty());
    for (const auto& file : files) {
        const Result<MeshCheck> result = check_mesh(file.string());
        ASSERT_TRUE(result.ok()) << result.error().text();
        EXPECT_TRUE(result.value().closed()) << file;
        EXPECT_TRUE(result.value().notes.empty()) << file;
    }
}

TEST(CheckMesh, FindsTheSharedRoomsSound) {
    const std::filesystem::path folder = std::filesystem::path(FIRMA_ROOT) / "../shared/casts/cases";
    auto files = files_in(folder, "leak_");
    if (files.empty()) GTEST_SKIP() << "../shared/casts/cases is not here";
    for (const auto& file : files_in(folder, "walk_")) files.push_back(file);
    for (const auto& file : files) {
        const Result<MeshCheck> result = check_mesh(file.string());
        ASSERT_TRUE(result.ok()) << result.error().text();
        EXPECT_TRUE(result.value().closed()) << file;
        EXPECT_TRUE(result.value().notes.empty()) << file;
    }
}

/// A level of ours with one face taken out, turned, or doubled.
TEST(CheckMesh, FindsEveryDamageToALevel) {
    std::ifstream file(std::filesystem::path(FIRMA_ROOT) / "levels/first.obj");
    std::vector<std::string> lines;
    std::vector<std::size_t> faces;
    for (std::string line; std::getline(file, line); lines.push_back(line))
        if (line.starts_with("f ")) faces.push_back(lines.size());
    ASSERT_FALSE(faces.empty());
    scenes::Rng rng(5);
    for (int round = 0; round < 60; ++round) {
        const std::size_t damaged = faces[rng.below(std::uint32_t(faces.size()))];
        std::istringstream words(lines[damaged].substr(2));
        std::vector<std::string> corners;
        for (std::string word; words >> word;) corners.push_back(word);
        std::string turned = "f";
        for (std::size_t k = corners.size(); k-- > 0;) turned += " " + corners[k];
        std::string text;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (k == damaged && round % 3 == 0) continue;
            text += (k == damaged && round % 3 == 1 ? turned : lines[k]) + "\n";
            if (k == damaged && round % 3 == 2) text += lines[k] + "\n";
        }
        const MeshCheck result = check(text);
        if (round % 3 == 1) {
            ASSERT_EQ(result.faults.size(), 1u);
            EXPECT_EQ(result.faults[0].what, MeshFault::kReversedFace);
            EXPECT_EQ(result.faults[0].line, damaged + 1);
        } else {
            EXPECT_EQ(result.faults.size(), corners.size());
            EXPECT_EQ(count(result, MeshFault::kOpenEdge), corners.size());
        }
    }
}

TEST(ExactNumber, HasOneFormForEachNumber) {
    ExactDecimals decimals;
    EXPECT_EQ(decimals.add("-0.0e7"), ExactNumber{});
    EXPECT_EQ(decimals.add("1200"), (ExactNumber{12, 2, ExactNumber::kShort}));
    EXPECT_EQ(decimals.add("-.0120"), (ExactNumber{-12, -3, ExactNumber::kShort}));
    EXPECT_EQ(decimals.add("999999999999999999"), (ExactNumber{999999999999999999, 0, ExactNumber::kShort}));
    EXPECT_EQ(decimals.add("1234567890123456789"), decimals.add("+123456789.01234567890e10"));
    EXPECT_NE(decimals.add("1234567890123456789"), decimals.add("-1234567890123456789"));
    EXPECT_NE(decimals.add("1234567890123456789"), decimals.add("1234567890123456788"));
    EXPECT_EQ(exact_binary(0), ExactNumber{});
    EXPECT_EQ(exact_binary(-6), (ExactNumber{-3, 1, ExactNumber::kShort}));
    EXPECT_EQ(exact_binary(5e-324), (ExactNumber{1, -1074, ExactNumber::kShort}));
    EXPECT_EQ(exact_binary(0x1.fffffffffffffp1023), (ExactNumber{0x1fffffffffffff, 971, ExactNumber::kShort}));
}

}  // namespace
}  // namespace firma
