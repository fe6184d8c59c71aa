// SPDX-License-Identifier: MIT
// Fifty faces out and a hundred in, ready to cast: what that takes, by the size of the level. Faces near each other on
// open ground, each square of two triangles replaced by four; every edit is made to what the one before left.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <vector>

#include "carve/gather.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"
#include "solid/face_store.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

constexpr std::int32_t kMetre = std::int32_t(kSurfaceSteps);
constexpr std::uint32_t kPatch = 5;   ///< squares along a side of what is replaced
constexpr std::uint32_t kApart = 10;  ///< squares from one such place to the next

/// Squares of a metre, two triangles each: those of square (i, j) have the ids 2 (j side + i) and the next.
class Ground {
public:
    explicit Ground(std::uint32_t side) : side_(side), heights_((side + 1) * (side + 1)) {
        scenes::Rng rng(5);
        for (std::int32_t& height : heights_) height = std::int32_t(rng.below(64)) * (kMetre / 64);
    }

    std::uint32_t side() const { return side_; }
    GridPoint corner(std::uint32_t i, std::uint32_t j) const {
        return {metres(i), metres(j), heights_[j * (side_ + 1) + i]};
    }
    GridBox box(std::uint32_t i, std::uint32_t j, std::uint32_t squares) const {
        GridBox around;
        around.add(GridPoint{metres(i), metres(j), 0});
        around.add(GridPoint{metres(i + squares), metres(j + squares), kMetre});
        return around;
    }
    std::uint32_t id(std::uint32_t i, std::uint32_t j) const { return 2 * (j * side_ + i); }

    FaceSet faces() const {
        FaceSet set;
        for (std::uint32_t j = 0; j < side_; ++j)
            for (std::uint32_t i = 0; i < side_; ++i) {
                const GridPoint a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
                add(set, id(i, j), {a, b, c});
                add(set, id(i, j) + 1, {a, c, d});
            }
        return set;
    }

    static void add(FaceSet& set, std::uint32_t id, const std::vector<GridPoint>& corners) {
        FaceSet::Entry face;
        face.id = {id};
        face.source = id;
        add_facet(set, corners, face);
    }

private:
    /// The middle of the ground is at 0.
    std::int32_t metres(std::uint32_t k) const { return (std::int32_t(k) - std::int32_t(side_ / 2)) * kMetre; }

    std::uint32_t side_;
    std::vector<std::int32_t> heights_;
};

/// The faces of a patch, and what comes in their place.
struct Change {
    std::vector<FacetPlace> goes;
    FaceSet comes;

    Change(const Ground& ground, const FaceStore& store, std::uint32_t i, std::uint32_t j, std::uint32_t next_id) {
        std::vector<FacetPlace> found;
        gather_facets(store.root.get(), ground.box(i, j, kPatch), found, 0);
        const auto is_in = [&](std::uint32_t id) {
            const std::uint32_t square = id / 2, x = square % ground.side(), y = square / ground.side();
            return x >= i && x < i + kPatch && y >= j && y < j + kPatch;
        };
        for (const FacetPlace& facet : found)
            if (is_in(facet.record().id.value)) goes.push_back(facet);
        for (std::uint32_t y = j; y < j + kPatch; ++y)
            for (std::uint32_t x = i; x < i + kPatch; ++x) {
                const GridPoint around[] = {ground.corner(x, y), ground.corner(x + 1, y), ground.corner(x + 1, y + 1),
                                            ground.corner(x, y + 1)};
                const GridPoint middle{around[0].x + kMetre / 2, around[0].y + kMetre / 2, -kMetre};
                for (int k = 0; k < 4; ++k) Ground::add(comes, next_id++, {around[k], around[(k + 1) % 4], middle});
            }
    }
};

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

void measure_size(std::uint32_t side, std::size_t edits, Table& table) {
    const Ground ground(side);
    const TreeOptions options;
    const FaceSet faces = ground.faces();
    FaceStore store = build_store(faces, options).store;
    const std::size_t before = store.count;
    const std::uint32_t places = side / kApart;
    std::vector<std::uint32_t> order(places * places);
    std::iota(order.begin(), order.end(), 0u);
    scenes::Rng rng(9);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng.below(std::uint32_t(k))]);
    order.resize(std::min(order.size(), edits));
    auto next_id = std::uint32_t(faces.faces.size());
    std::vector<double> wall, processor;
    std::size_t out = 0, in = 0;
    for (const std::uint32_t place : order) {
        Change change(ground, store, place % places * kApart, place / places * kApart, next_id);
        next_id += std::uint32_t(change.comes.faces.size());
        out += change.goes.size();
        in += change.comes.faces.size();
        const auto start = std::chrono::steady_clock::now();
        const double start_processor = thread_seconds();
        StoreEdit edit(store, options);
        for (const FacetPlace& facet : change.goes) edit.remove(facet);
        edit.add(std::move(change.comes));
        while (edit.step()) {
        }
        store = edit.result();
        processor.push_back((thread_seconds() - start_processor) * 1e3);
        wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    table.add({count(before), count(order.size()), number(double(out) / double(order.size())),
               number(double(in) / double(order.size())), number(median(processor)),
               number(percentile(processor, 0.99)), number(median(wall)), number(percentile(wall, 0.99))});
}

int measure(const Settings& settings) {
    Table table("edit_index", {"triangles", "edits", "faces out", "faces in", "ms", "99th percentile",
                               "ms by the clock", "99th percentile of that"});
    for (const std::uint32_t side : {70u, 224u, 708u, 2236u}) {
        if (settings.quick && side > 224) break;
        measure_size(side, settings.quick ? 20 : 1000, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(
        read_settings(argc, argv, "Fifty faces out of an index and a hundred in, by the size of the level."));
}
