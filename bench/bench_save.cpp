// SPDX-License-Identifier: MIT
// What saving a world and reading it back costs, against building it again from the .obj it came from.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "firma/save.h"
#include "firma/solid.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// Nanoseconds of processor time a face.
template <class Work>
double timed(const World& world, const Work& work) {
    const double start = thread_seconds();
    work();
    return (thread_seconds() - start) * 1e9 / double(world.face_count());
}

constexpr int kRounds = 3;  // each takes seconds where worlds are large

struct Numbers {
    std::vector<double> pack, unpack, check, save, load, obj, build;
};

void measure_world(const char* what, const World& world, Table& table) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const std::string saved = (folder / "firma_bench_save.firma").string(),
                      obj = (folder / "firma_bench_save.obj").string();
    Numbers of;
    std::vector<std::byte> bytes;
    if (!write_obj(world, obj)) return;
    for (int round = 0; round < kRounds; ++round) {
        of.pack.push_back(timed(world, [&] { bytes = pack_world(world); }));
        of.unpack.push_back(timed(world, [&] { keep(unpack_world(bytes, "bench").value().face_count()); }));
        of.check.push_back(timed(world, [&] { keep(!check_world(world) && !check_solid(world)); }));
        of.save.push_back(timed(world, [&] { keep(save_world(world, saved).ok()); }));
        of.load.push_back(timed(world, [&] { keep(load_world(saved).value().face_count()); }));
        Level level;
        of.obj.push_back(timed(world, [&] { level = read_level(obj).value(); }));
        of.build.push_back(timed(world, [&] { keep(make_world(level).value().face_count()); }));
    }
    const double faces = double(world.face_count());
    const double facets = double(pack_world(world, {.exact = false}).size());
    const double level = median(of.obj) + median(of.build);
    table.add({what, count(world.face_count()), number(double(bytes.size()) / faces), number(facets / faces),
               number(double(std::filesystem::file_size(obj)) / faces), number(median(of.pack)),
               number(median(of.unpack)), number(median(of.check)), number(median(of.save)), number(median(of.load)),
               number(median(of.obj)), number(median(of.build)), times(level / median(of.load))});
    std::filesystem::remove(saved);
    std::filesystem::remove(obj);
}

int measure(const Settings& settings) {
    Table table("save", {"world", "faces", "bytes a face", "without exact part", ".obj bytes a face",
                         "pack_world ns a face", "unpack_world ns", "of it check_world and check_solid ns",
                         "save_world ns", "load_world ns", "read_obj ns", "make_world ns", ".obj to .firma"});
    for (const int rooms : {2, 6, 20}) {
        if (settings.quick && rooms > 2) break;
        World world = carvable_world(crater_level(rooms));
        measure_world("uncut", world, table);
        const Cutter cutter = crater();
        const std::size_t cuts = settings.quick ? 50 : 1000;
        for (std::size_t k = 0; k < cuts; ++k) cut_crater(world, cutter, crater_pose(rooms, CraterPlaces::kSpread, k));
        measure_world("cut", world, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Worlds saved and read back, against building them again from an .obj."));
}
