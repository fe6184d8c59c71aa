// SPDX-License-Identifier: MIT
// Scenes as JSON beside their worlds.
#include "bodies/write_scenes.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "body/body_shape.h"
#include "body/mover.h"
#include "firma/save.h"

namespace firma::bench {
namespace {

using nlohmann::json;

json three(const Vec3& v) {
    return {v.x, v.y, v.z};
}

json body_as_json(const Body& body) {
    const BodyShapeData& shape = body.shape.data();
    json spheres = json::array();
    for (const Sphere& sphere : shape.spheres)
        for (const double number : {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius})
            spheres.push_back(number);
    return {{"spheres", spheres},
            {"mass", shape.mass},
            {"inertia", three(shape.moments)},
            {"friction", body.friction},
            {"restitution", body.restitution},
            {"position", three(body.position)},
            {"rotation", principal_rotation(body)},
            {"velocity", three(body.velocity)},
            {"spin", three(body.spin)}};
}

json scene_as_json(const BodyScene& scene) {
    json bodies = json::array();
    for (const Body& body : scene.bodies) {
        bodies.push_back(body_as_json(body));
        if (scene.half > 0) bodies.back()["half"] = {scene.half, scene.half, scene.half};
    }
    return {{"name", scene.name}, {"what", scene.what}, {"seconds", scene.seconds}, {"bodies", bodies}};
}

}  // namespace

std::string write_scenes(std::span<const BodyScene> scenes, const std::string& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) return folder + ": " + fault.message();
    for (std::size_t k = 0;; ++k) {
        const std::string path = folder + "/" + std::to_string(k);
        if (k >= scenes.size()) {
            const bool was_there = std::filesystem::remove(path + ".json", fault);
            std::filesystem::remove(path + ".firma", fault);
            if (!was_there) return "";
            continue;
        }
        if (const auto world = save_world(scenes[k].world, path + ".firma"); !world) return world.error().text();
        std::ofstream file(path + ".json");
        if (!(file << scene_as_json(scenes[k]) << '\n').flush()) return path + ".json: cannot be written";
    }
}

}  // namespace firma::bench
