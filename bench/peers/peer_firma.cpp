// SPDX-License-Identifier: MIT
// Firma as a peer: the adapter that ../shared/peers/driver.cpp runs beside Bullet's and Embree's.
//
// Meshes come snapped to Firma's grid (snap_scene.h), so that everybody is asked about the same geometry. Both sides of
// every face count, as for the other peers.
#include <firma/firma.h>
#include <peer.h>

#include <cmath>
#include <optional>

namespace {

std::int32_t steps(float metres) {
    return std::int32_t(std::lround(double(metres) * firma::kInputSteps)) * firma::kSurfacePerInput;
}

firma::Level level_of(const Mesh& mesh) {
    firma::Level level;
    level.name = "peer scene";
    level.materials = {""};
    level.groups = {""};
    for (std::size_t k = 0; k < mesh.nv(); ++k)
        level.vertices.push_back({steps(mesh.v[3 * k]), steps(mesh.v[3 * k + 1]), steps(mesh.v[3 * k + 2])});
    level.corners = mesh.i;
    level.faces.resize(mesh.nt());
    for (std::uint32_t k = 0; k < level.faces.size(); ++k) {
        level.faces[k].first_corner = 3 * k;
        level.faces[k].corner_count = 3;
        level.faces[k].source = k;
    }
    level.source_faces = std::uint32_t(level.faces.size());
    return level;
}

class FirmaPeer final : public Peer {
public:
    explicit FirmaPeer(firma::Split split) { options_.tree.split = split; }

    std::string describe() const override {
        return "firma::cast, double, Sides::kBoth, whole hits (point, normals, ids); tree split " +
               std::string(options_.tree.split == firma::Split::kSurfaceArea ? "by surface area"
                                                                             : "across the longest axis");
    }
    bool has_spheres() const override { return true; }

    bool build(const Mesh& mesh) override {
        firma::Result<firma::World> made = firma::make_world(level_of(mesh), options_);
        if (!made) {
            fprintf(stderr, "firma: %s\n", made.error().text().c_str());
            return false;
        }
        world_ = made.value();
        return true;
    }
    void clear() override { world_.reset(); }
    std::size_t bytes() const override { return world_ ? world_->statistics().bytes : 0; }

    void rays(const Cast* casts, std::size_t count, float* fractions) override {
        cast_all_of(casts, count, 0, fractions);
    }
    void spheres(const Cast* casts, std::size_t count, float* fractions) override {
        cast_all_of(casts, count, 1, fractions);
    }

private:
    /// @param thick  1 to use the casts' radii, 0 for rays (whose `r` says something else)
    void cast_all_of(const Cast* casts, std::size_t count, float thick, float* fractions) const {
        firma::CastOptions options;
        options.sides = firma::Sides::kBoth;
        for (std::size_t k = 0; k < count; ++k) {
            const Cast& c = casts[k];
            const firma::Sphere sphere{{c.o[0], c.o[1], c.o[2]}, double(thick) * double(c.r)};
            const firma::Hit hit = firma::cast(*world_, sphere, {c.d[0], c.d[1], c.d[2]}, options);
            fractions[k] = hit.touched() ? float(hit.fraction) : 2;
        }
    }

    firma::WorldOptions options_;
    std::optional<firma::World> world_;
};

}  // namespace

/// Variants: firma, firma_area (bins split by surface area).
Peer* make_peer(const std::string& variant) {
    return new FirmaPeer(variant.find("area") == std::string::npos ? firma::Split::kLongestAxis
                                                                   : firma::Split::kSurfaceArea);
}
