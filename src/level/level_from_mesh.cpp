// SPDX-License-Identifier: MIT
// From arrays in memory to a level.
#include <cmath>
#include <utility>

#include "firma/mesh.h"
#include "level/divide_polygon.h"
#include "level/level_builder.h"

namespace firma {
namespace {

class MeshReader {
public:
    MeshReader(const Mesh& mesh, std::string name, double scale)
        : mesh_(mesh), name_(std::move(name)), scale_(scale), builder_(name_) {}

    Result<Level> read() {
        if (std::optional<Error> error = check_arrays()) return *std::move(error);
        for (std::size_t k = 0; k < mesh_.vertices.size(); ++k)
            if (!builder_.add_vertex(mesh_.vertices[k] * scale_))
                return fail(ErrorCode::kOutOfRange, "vertex", k,
                            is_finite(mesh_.vertices[k]) ? "lies outside the world, which spans 8192 m to each side"
                                                         : "is not finite");
        builder_.mend_what_is_dropped();
        for (std::size_t face = 0, first = 0; face < faces_; ++face) {
            const std::size_t count = corners_of(face);
            const auto uvs = mesh_.uvs.empty() ? mesh_.uvs : mesh_.uvs.subspan(first, count);
            if (std::optional<Error> error = add_face(face, mesh_.corners.subspan(first, count), uvs)) return *error;
            first += count;
        }
        Level level = builder_.finish(std::uint32_t(faces_), 0);
        // Numbered as the caller numbers them, not as the builder would.
        if (!mesh_.material_names.empty())
            level.materials.assign(mesh_.material_names.begin(), mesh_.material_names.end());
        return level;
    }

private:
    std::size_t corners_of(std::size_t face) const {
        return mesh_.corner_counts.empty() ? 3 : mesh_.corner_counts[face];
    }

    Error fail(ErrorCode code, const char* what, std::size_t index, std::string reason) const {
        return fail(code, std::string(what) + " " + std::to_string(index), std::move(reason));
    }
    Error fail(ErrorCode code, std::string place, std::string reason) const {
        if (!name_.empty()) place = place.empty() ? name_ : name_ + ": " + place;
        return {code, std::move(place), std::move(reason)};
    }

    /// Lengths, before anything is made of them.
    std::optional<Error> check_arrays() {
        if (!(scale_ > 0) || !is_finite(scale_))
            return fail(ErrorCode::kInvalid, "", "the scale must be a finite number above zero");
        if (mesh_.corners.size() >= LevelBuilder::kMaxCount || mesh_.vertices.size() >= LevelBuilder::kMaxCount)
            return fail(ErrorCode::kTooLarge, "", "a level holds fewer than 2^31 vertices and corners");
        if (mesh_.corner_counts.empty() && mesh_.corners.size() % 3 != 0)
            return fail(ErrorCode::kMalformed, "", "its corners are no multiple of three");
        faces_ = mesh_.corner_counts.empty() ? mesh_.corners.size() / 3 : mesh_.corner_counts.size();
        if (faces_ == 0) return fail(ErrorCode::kMalformed, "", "has no faces");
        std::size_t sum = 0;
        for (std::size_t face = 0; face < faces_; ++face) {
            const std::size_t count = corners_of(face);
            if (count < 3 || count > kMaxOutlineCorners)
                return fail(ErrorCode::kMalformed, "face", face,
                            "has " + std::to_string(count) + " corners; 3 to " + std::to_string(kMaxOutlineCorners) +
                                " are possible");
            sum += count;
        }
        if (sum != mesh_.corners.size())
            return fail(ErrorCode::kMalformed, "",
                        "its faces have " + std::to_string(sum) + " corners, but there are " +
                            std::to_string(mesh_.corners.size()));
        const auto fits = [&](std::size_t size) { return size == 0 || size == faces_; };
        if (!fits(mesh_.materials.size()) || !fits(mesh_.masks.size()) || !fits(mesh_.two_sided.size()))
            return fail(ErrorCode::kMalformed, "", "an array about faces has not one entry for each");
        if (!mesh_.uvs.empty() && mesh_.uvs.size() != mesh_.corners.size())
            return fail(ErrorCode::kMalformed, "",
                        "has " + std::to_string(mesh_.uvs.size()) + " texture coordinates for " +
                            std::to_string(mesh_.corners.size()) + " corners");
        return std::nullopt;
    }

    std::optional<Error> add_face(std::size_t face, std::span<const std::uint32_t> outline,
                                  std::span<const TexturePoint> uvs) {
        for (const std::uint32_t vertex : outline)
            if (vertex >= mesh_.vertices.size())
                return fail(ErrorCode::kMalformed, "face", face,
                            "names vertex " + std::to_string(vertex) + " of " + std::to_string(mesh_.vertices.size()));
        for (const TexturePoint& uv : uvs)
            if (!is_finite(uv[0]) || !is_finite(uv[1]))
                return fail(ErrorCode::kOutOfRange, "face", face, "has texture coordinates that are not finite");
        LevelBuilder::FaceInfo info;
        info.source = std::uint32_t(face);
        if (!mesh_.materials.empty()) {
            const std::uint32_t material = mesh_.materials[face];
            if (material >= mesh_.material_names.size())
                return fail(ErrorCode::kMalformed, "face", face,
                            "names material " + std::to_string(material) + " of " +
                                std::to_string(mesh_.material_names.size()));
            info.material = material;
        }
        if (!mesh_.masks.empty()) info.mask = mesh_.masks[face];
        info.two_sided = !mesh_.two_sided.empty() && mesh_.two_sided[face] != 0;
        builder_.add_face(outline, info, uvs);
        if (builder_.corner_count() >= LevelBuilder::kMaxCount)
            return fail(ErrorCode::kTooLarge, "", "has more than 2^31 corners once divided");
        return std::nullopt;
    }

    const Mesh& mesh_;
    const std::string name_;
    const double scale_;
    std::size_t faces_ = 0;
    LevelBuilder builder_;
};

}  // namespace

Result<Level> level_from_mesh(const Mesh& mesh, std::string name, const ReadOptions& options) {
    return MeshReader(mesh, std::move(name), options.scale == 0 ? 1 : options.scale).read();
}

}  // namespace firma
