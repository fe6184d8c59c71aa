// SPDX-License-Identifier: MIT
// Tries views on a small canvas.
#include "cli/find_camera.h"
#include "firma/queries.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cli/demo_casts.h"

namespace firma::cli {

namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::size_t kEyes = 4000;
constexpr int kTrials = 250;
constexpr std::size_t kTargets = 40;
constexpr double kNearest = 3, kFarthest = 12;  // metres from eye to target
constexpr int kTrialWidth = 64;
constexpr double kBestShare = 0.3;  // of a picture, for new faces: what is around them must be seen as well
constexpr double kSteepest = 0.5;   // of a view, up or down: beyond, people lose their way

/// Middles of some new faces, evenly taken.
std::vector<Vec3> targets_of(const std::vector<Face>& faces) {
    std::vector<Vec3> middles;
    for (const Face& face : faces) {
        if (face.source_edit == 0) continue;
        Vec3 middle;
        for (const Vec3& corner : face.corners) middle = middle + corner * (1.0 / double(face.corners.size()));
        middles.push_back(middle);
    }
    if (middles.size() <= kTargets) return middles;
    std::vector<Vec3> some;
    for (std::size_t k = 0; k < kTargets; ++k) some.push_back(middles[k * middles.size() / kTargets]);
    return some;
}

/// Whether nothing stands between, but for the last fifth of the way.
bool sees(const World& world, const Vec3& eye, const Vec3& target) {
    return !cast(world, {eye, 0.0}, (target - eye) * 0.8).touched();
}

}  // namespace

std::optional<draw::Camera> find_camera(const World& before, const World& after, const draw::Camera& size) {
    const std::vector<Face> faces = after.faces();
    const std::vector<Vec3> targets = targets_of(faces);
    if (targets.empty()) return std::nullopt;
    std::optional<draw::Camera> best;
    double most = -INFINITY;
    int trials = 0;
    for (const Query& query : make_demo_casts(before, kEyes, kSeed)) {
        if (trials >= kTrials) break;
        for (const Vec3& target : targets) {
            const Vec3 path = target - query.sphere.centre;
            const double distance = length(path);
            if (distance < kNearest || distance > kFarthest) continue;
            if (std::fabs(path[size.up]) > kSteepest * distance || !sees(after, query.sphere.centre, target)) continue;
            ++trials;
            draw::Camera camera = size;
            camera.eye = query.sphere.centre;
            camera.target = target;
            camera.width = kTrialWidth;
            camera.height = std::max(1, kTrialWidth * size.height / size.width);
            const double share = draw::share_of_new_faces(faces, camera);
            const double worth = -std::fabs(share - kBestShare);
            if (worth <= most) continue;
            most = worth;
            camera.width = size.width;
            camera.height = size.height;
            best = camera;
        }
    }
    return best;
}

}  // namespace firma::cli
