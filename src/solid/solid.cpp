// SPDX-License-Identifier: MIT
// The Solid's handle, and what is asked of solids.

#include "base/random.h"
#include "solid/bounds_of.h"
#include "solid/check_boundary.h"
#include "solid/first_seen.h"
#include "solid/hash_face.h"
#include "solid/hash_points.h"
#include "solid/measure_boundary.h"
#include "solid/same_boundary.h"
#include "solid/solid_data.h"
#include "solid/solid_face.h"

namespace firma {
namespace {

std::shared_ptr<const SolidData> no_solid() {
    static const auto none = std::make_shared<const SolidData>();
    return none;
}

/// Whether an object is seen for the first time.
bool is_first(FlatMap& seen, const void* object) {
    std::uint32_t& known = seen.at(reinterpret_cast<std::uintptr_t>(object));
    if (known != FlatMap::kNone) return false;
    known = 0;
    return true;
}

}  // namespace

Solid::Solid() : data_(no_solid()) {}
Solid::Solid(std::shared_ptr<const SolidData> data) : data_(data ? std::move(data) : no_solid()) {}
Solid::Solid(Solid&& other) noexcept : data_(std::exchange(other.data_, no_solid())) {}
Solid& Solid::operator=(Solid&& other) noexcept {
    data_ = std::exchange(other.data_, no_solid());
    return *this;
}

std::size_t Solid::face_count() const {
    return data_->faces.count;
}
bool Solid::rock_outside() const {
    return data_->rock_outside;
}
std::uint32_t Solid::edits() const {
    return data_->edits;
}

Box Solid::bounds() const {
    return data_->faces.root ? bounds_of(*data_->faces.root) : Box{};
}

void hash_points_anew(SolidData& data) {
    PointHash hash;
    FlatMap seen;
    if (data.faces.root)
        for_each_block(*data.faces.root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) {
                const FaceOwner* owner = block.owner_of(face);
                if (!owner || owner->facets == 1 || is_first(seen, owner)) add_face(block, face, 1, hash);
            }
        });
    const SumsByKey& sums = hash.finish();
    data.points = {};
    sums.add_to(data.points);
    data.point_sum = sums.total();
}

Solid solid_of(FaceStore faces, bool rock_outside, std::uint32_t next_face, std::uint32_t edits,
               const TreeOptions& options) {
    auto data = std::make_shared<SolidData>();
    data->faces = std::move(faces);
    data->rock_outside = rock_outside;
    data->next_face = next_face;
    data->edits = edits;
    data->tree_options = options;
    hash_points_anew(*data);
    return Solid(std::move(data));
}

std::vector<RegionHash> region_hashes(std::initializer_list<const PersistentMap<std::uint64_t>*> faces,
                                      const PersistentMap<std::uint64_t>& points) {
    PersistentMap<RegionHash> all;
    const auto add = [&](std::uint32_t key, std::uint64_t of_faces, std::uint64_t of_points) {
        const RegionHash* known = all.find(key);
        RegionHash sum = known ? *known : RegionHash{place_of_region(key), 0, 0};
        sum.faces += of_faces;
        sum.points += of_points;
        all.set(key, sum);
    };
    for (const PersistentMap<std::uint64_t>* some : faces)
        some->for_each([&](std::uint32_t key, std::uint64_t sum) { add(key, sum, 0); });
    points.for_each([&](std::uint32_t key, std::uint64_t sum) { add(key, 0, sum); });
    std::vector<RegionHash> list;
    all.for_each([&](std::uint32_t, const RegionHash& region) {
        if (region.faces != 0 || region.points != 0) list.push_back(region);
    });
    return list;
}

std::optional<SolidFault> check_solid(const Solid& solid) {
    return check_boundary(take_boundary(solid.data().faces.root.get()));
}

SolidMeasures measure_solid(const Solid& solid) {
    constexpr double kSquareMetre = kInputSteps * kInputSteps;
    constexpr double kCubicSurface = kSurfaceSteps * kSurfaceSteps * kSurfaceSteps;
    const Boundary boundary = take_boundary(solid.data().faces.root.get());
    const BoundaryMeasures sums = measure_boundary(boundary);
    SolidMeasures measures;
    measures.volume = rounded(sums.volume) / (kSquareMetre * kInputSteps);
    measures.area = rounded(sums.area) / kSquareMetre;
    measures.facet_volume = double(sums.facet_sixths) / kCubicSurface / 6;
    measures.faces = boundary.patch.faces.size();
    measures.facets = boundary.facets.size();
    return measures;
}

std::uint64_t hash_solid(const Solid& solid) {
    return mix_bits(solid.data().point_sum + std::uint64_t(solid.rock_outside()));
}

bool same_solid(const Solid& a, const Solid& b) {
    const SolidData &one = a.data(), &two = b.data();
    if (&one == &two) return true;
    return one.rock_outside == two.rock_outside && one.point_sum == two.point_sum &&
           same_boundary(one.faces.root.get(), two.faces.root.get());
}

std::vector<RegionHash> hash_regions(const Solid& solid) {
    return region_hashes({&solid.data().faces.regions}, solid.data().points);
}

Where locate(const Solid& solid, const Vec3& point) {
    switch (see_first(solid.data().faces.root.get(), point).kind) {
        case Seen::Kind::kAir:
            return Where::kAir;
        case Seen::Kind::kSolid:
            return Where::kSolid;
        case Seen::Kind::kNothing:
            return solid.rock_outside() ? Where::kSolid : Where::kAir;
        case Seen::Kind::kSurface:
            return Where::kSurface;
        case Seen::Kind::kUnsure:
        case Seen::Kind::kPolygon:
            break;
    }
    return Where::kUnknown;
}

}  // namespace firma
