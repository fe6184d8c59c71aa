// SPDX-License-Identifier: MIT
// A scene of bench_scale for who runs elsewhere.
#include "scale/dump.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace firma::bench {
namespace {

template <class Value>
std::string_view bytes_of(std::span<const Value> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void write_file(const std::string& path, std::initializer_list<std::string_view> parts) {
    std::ofstream file(path, std::ios::binary);
    for (const std::string_view part : parts) file.write(part.data(), std::streamsize(part.size()));
    file.close();
    if (file) return;
    std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
    std::exit(1);
}

}  // namespace

SceneDump::SceneDump(const ScaleScene& scene, std::size_t casts) : scene_(scene), casts_(casts) {}

void SceneDump::add(const KindOfCast& kind, std::span<const FloatCast> casts, std::span<const double> fractions) {
    kinds_.append(kinds_.empty() ? "" : ",")
        .append("{\"name\":\"")
        .append(kind.name)
        .append(kind.shape == CastShape::kRay ? "\",\"shape\":\"ray\"" : "\",\"shape\":\"sphere\"")
        .append(",\"radius\":" + std::to_string(kind.range.radius_low))
        .append(kind.at_edges ? ",\"mustHit\":true}" : ",\"mustHit\":false}");
    for (const FloatCast& c : casts) {
        const float numbers[7] = {c.start[0], c.start[1], c.start[2], c.radius, c.path[0], c.path[1], c.path[2]};
        bytes_.append(bytes_of(std::span<const float>(numbers)));
    }
    bytes_.append(bytes_of(fractions));
}

void SceneDump::write(const std::string& folder) const {
    const TriangleMesh& mesh = scene_.mesh;
    const std::string triangles = std::to_string(mesh.triangles());
    const std::string base = folder + "/" + scene_.name + "_" + triangles;
    const std::string about =
        "{\"scene\":\"" + scene_.name + "\",\"vertices\":" + std::to_string(mesh.positions.size() / 3) +
        ",\"triangles\":" + triangles + ",\"casts\":" + std::to_string(casts_) + ",\"kinds\":[" + kinds_ + "]}\n";
    write_file(base + ".json", {about});
    write_file(base + ".bin", {bytes_of(std::span<const float>(mesh.positions)),
                               bytes_of(std::span<const std::uint32_t>(mesh.corners)), bytes_});
}

}  // namespace firma::bench
