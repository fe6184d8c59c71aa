// SPDX-License-Identifier: MIT
// Cases of iterated cuts from a folder, as the Open Boolean Benchmark's study of sweeps has them: a workpiece, and
// tools that are taken away from it one after another. docs/benchmarks.md says what the folder holds; sweep_cases.sh
// runs this.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "carve/place_cutter.h"
#include "scenes/sweeps.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/table.h"

namespace firma::bench {
namespace {

namespace files = std::filesystem;

struct CaseSettings {
    std::string folder, csv;
    double scale = 128;  ///< metres a unit of the files
    std::size_t cuts = ~std::size_t(0);
    bool make = false, temporary = false;
};

constexpr const char* kHelp = R"(Iterated cuts of the cases in a folder.

bench_sweep_cases FOLDER [--scale METRES] [--cuts N] [--csv FOLDER]
bench_sweep_cases --make FOLDER      writes such cases there, from scenes/sweeps.h
bench_sweep_cases --quick            makes some, runs a few of their cuts
  --scale   metres a unit of the files is (128)
  --cuts    of each case at most so many
)";

[[noreturn]] void end(const std::string& why) {
    std::fprintf(stderr, "bench_sweep_cases: %s\n", why.c_str());
    std::exit(2);
}

CaseSettings read_case_settings(int argc, char** argv) {
    CaseSettings settings;
    for (int k = 1; k < argc; ++k) {
        const bool has_next = k + 1 < argc;
        if (!std::strcmp(argv[k], "--help")) std::fputs(kHelp, stdout), std::exit(0);
        if (!std::strcmp(argv[k], "--scale") && has_next)
            settings.scale = std::atof(argv[++k]);
        else if (!std::strcmp(argv[k], "--cuts") && has_next)
            settings.cuts = std::strtoull(argv[++k], nullptr, 10);
        else if (!std::strcmp(argv[k], "--csv") && has_next)
            settings.csv = argv[++k];
        else if (!std::strcmp(argv[k], "--make") && has_next)
            settings.make = true, settings.folder = argv[++k];
        else if (!std::strcmp(argv[k], "--quick"))
            settings.temporary = true, settings.cuts = 12;
        else if (argv[k][0] != '-' && settings.folder.empty())
            settings.folder = argv[k];
        else
            end(std::string("what is ") + argv[k] + "? Try --help");
    }
    if (settings.folder.empty() != settings.temporary) end("one folder is wanted. Try --help");
    if (!(settings.scale > 0)) end("--scale wants a number above 0");
    return settings;
}

// ---- cases of our own

/// Decimals that give a multiple of 2^-19 back.
void write_obj_mesh(const files::path& path, const std::vector<InputPoint>& vertices,
                    const std::vector<CutterTriangle>& triangles, double scale) {
    std::ofstream file(path);
    file.precision(20);
    for (const InputPoint& v : vertices)
        file << "v " << v.x / kInputSteps / scale << ' ' << v.y / kInputSteps / scale << ' '
             << v.z / kInputSteps / scale << '\n';
    for (const CutterTriangle& t : triangles) file << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    file.close();
    if (!file) end(path.string() + ": cannot be written");
}

void make_cases(const files::path& folder) {
    constexpr int kExponent = 7;
    const double scale = std::ldexp(1.0, kExponent);
    for (const scenes::SweepTool tool : scenes::kSweepTools) {
        const scenes::Sweep sweep = scenes::make_sweep(tool, kExponent);
        const files::path place = folder / ("made-" + std::string(scenes::name_of(tool)));
        files::create_directories(place / "sweeps");
        const PlacedCutter block = place_cutter(cutter_from_level(sweep.block).value(), {}).value();
        write_obj_mesh(place / "workpiece.obj", block.vertices, block.triangles, scale);
        for (std::size_t k = 0; k < sweep.poses.size(); ++k) {
            const PlacedCutter placed = place_cutter(sweep.tool, sweep.poses[k]).value();
            char name[32];
            std::snprintf(name, sizeof name, "sweep_%04zu.obj", k);
            write_obj_mesh(place / "sweeps" / name, placed.vertices, placed.triangles, scale);
        }
    }
}

// ---- what a folder holds

struct SweepCase {
    std::string name;
    files::path workpiece;
    std::vector<files::path> tools;  ///< in order of name
};

std::vector<SweepCase> find_cases(const files::path& folder) {
    std::vector<SweepCase> cases;
    std::vector<files::path> places{folder};
    std::error_code error;
    for (const auto& entry : files::directory_iterator(folder, error))
        if (entry.is_directory()) places.push_back(entry.path());
    std::sort(places.begin() + 1, places.end());
    for (const files::path& place : places) {
        if (!files::exists(place / "workpiece.obj") || !files::is_directory(place / "sweeps")) continue;
        SweepCase& found = cases.emplace_back();
        found.name = files::canonical(place).filename().string();
        found.workpiece = place / "workpiece.obj";
        for (const auto& entry : files::directory_iterator(place / "sweeps"))
            if (entry.path().extension() == ".obj") found.tools.push_back(entry.path());
        std::sort(found.tools.begin(), found.tools.end());
    }
    if (cases.empty()) end(folder.string() + ": no folder with a workpiece.obj and sweeps/*.obj in it");
    return cases;
}

template <class Value>
Value wanted(Result<Value> result) {
    if (!result) end(result.error().text());
    return std::move(result).value();
}

// ---- their cuts

struct CaseRun {
    std::vector<double> ms;
    std::size_t refused = 0, nothing = 0;
    double volume = 0, taken = 0;  ///< cubic metres, of the workpiece and by the reports
    World world;
};

CaseRun run_case(const SweepCase& one, const CaseSettings& settings) {
    CaseRun run;
    const ReadOptions units{.scale = settings.scale};
    run.world = carvable_world(wanted(read_level(one.workpiece.string(), units)));
    if (run.world.solid().face_count() != run.world.face_count())
        end(one.workpiece.string() + ": is not closed: firma check tells where");
    run.volume = measure_solid(run.world).volume;
    for (std::size_t k = 0; k < std::min(settings.cuts, one.tools.size()); ++k) {
        const Cutter tool = wanted(cutter_from_level(wanted(read_level(one.tools[k].string(), units))));
        const CutCost cost = cut_crater(run.world, tool, {});
        run.ms.push_back(cost.cpu);
        run.taken += cost.report.volume;
        run.refused += cost.status == CarveStatus::kRefused;
        run.nothing += cost.status == CarveStatus::kNothing;
    }
    return run;
}

std::string soundness(const World& world) {
    if (const auto fault = check_world(world)) return fault->what;
    if (const auto fault = check_solid(world)) return fault->what;
    return "sound";
}

std::string digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

int measure(const CaseSettings& settings) {
    Table table("sweep_cases", {"case", "cuts", "median ms", "p99 ms", "sum ms", "refused", "met only air", "facets",
                                "volume left, cubic units", "reports differ from it by", "check"});
    const double unit = settings.scale * settings.scale * settings.scale;
    for (const SweepCase& one : find_cases(settings.folder)) {
        const CaseRun run = run_case(one, settings);
        const double left = measure_solid(run.world).volume;
        table.add({one.name, count(run.ms.size()), number(median(run.ms)), number(quantile(run.ms, 0.99)),
                   number(std::accumulate(run.ms.begin(), run.ms.end(), 0.0)), count(run.refused), count(run.nothing),
                   count(run.world.solid().face_count()), digits(left / unit),
                   number(std::fabs((run.volume - run.taken - left) / run.volume)), soundness(run.world)});
    }
    return table.finish(settings.csv) ? 0 : 1;
}

/// A folder in the system's place for such, removed at the end.
int measure_made(CaseSettings settings) {
    const std::string wish = (files::temp_directory_path() / "firma_sweep_cases_XXXXXX").string();
    std::vector<char> name(wish.c_str(), wish.c_str() + wish.size() + 1);
    if (!mkdtemp(name.data())) end("no temporary folder can be made");
    settings.folder = name.data();
    make_cases(settings.folder);
    const int code = measure(settings);
    files::remove_all(settings.folder);
    return code;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    const CaseSettings settings = read_case_settings(argc, argv);
    if (settings.temporary) return measure_made(settings);
    if (!settings.make) return measure(settings);
    make_cases(settings.folder);
    return 0;
}
