// SPDX-License-Identifier: MIT
// Every cast of a scene, every way, judged.
#include "tests/reference/judge_scene.h"

#include <algorithm>
#include <cstdio>

#include "firma/level.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/world.h"
#include "tests/source_of.h"

namespace firma::reference {

std::uint64_t Tally::errors() const {
    std::uint64_t sum = 0;
    for (int fault = 1; fault < kFaultCount; ++fault) sum += faults[std::size_t(fault)];
    return sum;
}

void Tally::add(const Tally& other) {
    casts += other.casts;
    touched += other.touched;
    excused += other.excused;
    for (std::size_t fault = 0; fault < faults.size(); ++fault) faults[fault] += other.faults[fault];
    for (const std::string& failure : other.failures)
        if (wants_more()) failures.push_back(failure);
}

void Tally::add(const Verdict& verdict, bool touch, const std::string& repeat) {
    ++casts;
    touched += touch;
    excused += verdict.excused;
    if (verdict.ok()) return;
    ++faults[std::size_t(verdict.fault)];
    if (wants_more()) failures.push_back(std::string(name_of(verdict.fault)) + ": " + verdict.text + "\n" + repeat);
}

std::string describe(const ExactOracle& oracle, const Cast& cast, const std::vector<std::uint32_t>& faces) {
    const auto vec = [](const Vec3& v) {
        char text[100];
        std::snprintf(text, sizeof text, "{%.17g, %.17g, %.17g}", v.x, v.y, v.z);
        return std::string(text);
    };
    char radius[40];
    std::snprintf(radius, sizeof radius, "%.17g", cast.sphere.radius);
    std::string text = "  cast_polygon({" + vec(cast.sphere.centre) + ", " + radius + "}, " + vec(cast.path) +
                       ", polygon, Sides::" + (cast.sides == Sides::kBoth ? "kBoth" : "kFront") + ")\n";
    for (const std::uint32_t f : faces) {
        text += "  face ";
        text += std::to_string(f);
        text += oracle.faces()[f].two_sided ? " (two-sided): {" : ": {";
        for (const Vec3& v : oracle.faces()[f].hull.corners) text += vec(v) + ", ";
        text += "}\n";
    }
    return text;
}

namespace {

class SceneJudge {
public:
    SceneJudge(const scenes::CastScene& scene, std::uint64_t seed)
        : scene_(scene), polygons_(in_metres(scene)), oracle_(polygons_, scene.two_sided), rng_(seed) {
        WorldOptions options;
        options.tree.split = rng_.chance(0.5) ? Split::kLongestAxis : Split::kSurfaceArea;
        options.tree.faces_per_leaf = 1 + int(rng_.below(6));
        Result<World> made = make_world(scenes::level_of(scene.polygons, scene.two_sided), options);
        if (made.ok()) {
            world_ = made.value();
        } else {
            tally_.add({Fault::kFields, false, "make_world: " + made.error().text()}, false, "");
        }
    }

    Tally run() {
        if (world_.face_count() != polygons_.size()) return tally_;
        for (const scenes::CastQuery& query : scene_.casts)
            for (const Sides sides : {Sides::kFront, Sides::kBoth}) judge_chain({query.sphere, query.path, sides});
        return tally_;
    }

private:
    static std::vector<std::vector<Vec3>> in_metres(const scenes::CastScene& scene) {
        std::vector<std::vector<Vec3>> all;
        for (const scenes::GridPolygon& polygon : scene.polygons) all.push_back(scenes::to_metres(polygon));
        return all;
    }

    /// A cast, and at times what follows from where it stopped.
    void judge_chain(Cast cast) {
        for (int step = 0; step < 4; ++step) {
            const Hit hit = judge_world(cast);
            if (!hit.touched() || !rng_.chance(0.4)) return;
            const double left = rng_.chance(0.5) ? 1 - hit.fraction : 1;
            const double inward = dot(cast.path, hit.normal);
            const std::uint32_t what = rng_.below(4);
            cast.sphere.centre = rng_.chance(0.5) ? hit.centre : cast.sphere.centre + cast.path * hit.safe_fraction;
            if (what == 0) cast.path = cast.path * left;                                // on
            if (what == 1) cast.path = (cast.path - hit.normal * inward) * left;        // slide
            if (what == 2) cast.path = (cast.path - hit.normal * (2 * inward)) * left;  // bounce
            if (what == 3) cast.path = hit.normal * -length(cast.path);                 // head-on
        }
    }

    Hit judge_world(const Cast& cast) {
        CastOptions options;
        options.sides = cast.sides;
        if (rng_.chance(0.3)) options.contact_offset = rng_.chance(0.5) ? 0.02 : 0;
        const Hit hit = firma::cast(world_, cast.sphere, cast.path, options);
        Answer answer{hit, hit.touched() ? source_of(world_, hit) : 0, hit.safe_fraction,
                      options.contact_offset < 0 ? world_.tolerance().contact_offset : options.contact_offset, false};
        if (!hit.touched()) answer.safe_fraction = NAN;
        count("World", judge(oracle_, cast, answer), cast, hit, answer.face);
        judge_names(cast, hit);
        judge_any(cast, options, hit);
        if (rng_.chance(0.25)) judge_all(cast, options, hit);
        judge_pair(cast, hit.touched() ? answer.face : rng_.below(std::uint32_t(polygons_.size())));
        if (rng_.chance(0.3)) judge_pair(cast, rng_.below(std::uint32_t(polygons_.size())));
        return hit;
    }

    void count(const char* way, const Verdict& verdict, const Cast& cast, const PolygonHit& hit, std::uint32_t face) {
        std::string repeat;
        if (!verdict.ok() && tally_.wants_more()) {
            std::vector<std::uint32_t> faces{face};
            for (const std::uint32_t f : oracle_.expect(cast).faces)
                if (f != face) faces.push_back(f);
            repeat = std::string("  by ") + way + ", answered " +
                     (hit.status == Status::kMiss             ? "miss"
                      : hit.status == Status::kHit            ? "hit"
                      : hit.status == Status::kInitialOverlap ? "touching"
                                                              : "invalid") +
                     "\n" + describe(oracle_, cast, faces);
        }
        tally_.add(verdict, hit.touched(), repeat);
    }
    void broken(const char* what, const Cast& cast, const PolygonHit& hit) {
        count("World", {Fault::kFields, false, what}, cast, hit, 0);
    }

    void judge_names(const Cast& cast, const Hit& hit) {
        if (!hit.touched()) return;
        if (!hit.face.valid()) return broken("face unset", cast, hit);
        const std::optional<FaceInfo> face = world_.face_info(hit.face);
        if (!face) return broken("the world does not find the face met", cast, hit);
        if (face->ref() != hit.face || face->material != hit.material || room_of(world_, hit) != face->room)
            return broken("hit and face disagree", cast, hit);
    }

    void judge_any(const Cast& cast, const CastOptions& options, const Hit& hit) {
        const Status any = cast_any(world_, cast.sphere, cast.path, options);
        const bool touched = any == Status::kHit || any == Status::kInitialOverlap;
        if (touched != hit.touched() || (any == Status::kInvalid) != (hit.status == Status::kInvalid))
            broken("cast_any differs from cast", cast, hit);
    }

    void judge_all(const Cast& cast, const CastOptions& options, const Hit& hit) {
        std::vector<Hit> hits;
        const Status status = cast_all(world_, cast.sphere, cast.path, hits, options);
        if (status != hit.status || hits.empty() == hit.touched())
            return broken("cast_all and cast differ in status", cast, hit);
        if (hits.empty() && hit.status != Status::kMiss) return;
        if (!hits.empty() && (hits[0].face != hit.face || hits[0].fraction != hit.fraction))
            return broken("cast_all begins with another hit", cast, hit);
        std::vector<const Hit*> of_face(polygons_.size());
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const Hit*& first = of_face.at(source_of(world_, hits[k]));
            if (first) return broken("cast_all names a face twice", cast, hit);
            first = &hits[k];
            if (k > 0 && (hits[k].fraction < hits[k - 1].fraction ||
                          (hits[k].fraction == hits[k - 1].fraction && hits[k].face.id <= hits[k - 1].face.id)))
                return broken("cast_all is not in order", cast, hit);
        }
        for (std::uint32_t f = 0; f < of_face.size(); ++f) {
            Answer answer{{}, f, NAN, 0, false};
            if (of_face[f]) answer.hit = *of_face[f];
            count("cast_all", judge_face(oracle_, cast, answer), cast, answer.hit, f);
        }
    }

    void judge_pair(const Cast& cast, std::uint32_t face) {
        const Sides sides = oracle_.faces()[face].two_sided ? Sides::kBoth : cast.sides;
        const PolygonHit hit = cast_polygon(cast.sphere, cast.path, polygons_[face], sides);
        count("cast_polygon", judge_face(oracle_, cast, {hit, face, NAN, 0, false}), cast, hit, face);
    }

    using Face_ = firma::Face;
    const scenes::CastScene& scene_;
    const std::vector<std::vector<Vec3>> polygons_;
    const ExactOracle oracle_;
    scenes::Rng rng_;
    World world_;
    Tally tally_;
};

}  // namespace

Tally judge_scene(const scenes::CastScene& scene, std::uint64_t seed) {
    return SceneJudge(scene, seed).run();
}

Tally judge_family(const scenes::CastFamily& family, std::uint64_t seed, std::uint64_t index) {
    return judge_scene(scenes::make_cast_scene(family, seed, index), seed * 0x9E3779B97F4A7C15ull + index);
}

}  // namespace firma::reference
