// SPDX-License-Identifier: MIT
// The judge.
#include "tests/reference/judge.h"

#include <algorithm>
#include <cstdio>
#include <initializer_list>

namespace firma::reference {

namespace {

constexpr double kDistance = 1e-9;     // metres, growing beyond coordinates of 1 km
constexpr double kFraction = 2e-11;    // metres along the path, growing also beyond paths of 100 m
constexpr double kGrazing = 0.01;      // approach from which on the fraction is judged
constexpr double kNormal = 1e-9;       // radians, on top of what a shift turns it by
constexpr double kFaceNormal = 1e-12;  // radians
constexpr double kParallel = 1e-9;     // radians between path and plane

std::string print(const char* format, std::initializer_list<double> values) {
    double v[4] = {0, 0, 0, 0};
    std::copy(values.begin(), values.end(), v);
    char text[200];
    std::snprintf(text, sizeof text, format, v[0], v[1], v[2], v[3]);
    return text;
}

std::string numbered(const char* before, std::uint32_t number, const char* after) {
    std::string text = before;
    text += std::to_string(number);
    text += after;
    return text;
}

/// The unit vector and the length, safe from overflow.
struct Heading {
    Vec3 unit;
    double length = 0;

    explicit Heading(const Vec3& path) {
        const double size = max_abs(path);
        if (size == 0) return;
        int exponent = 0;
        std::frexp(size, &exponent);
        const Vec3 scaled{std::ldexp(path.x, -exponent), std::ldexp(path.y, -exponent), std::ldexp(path.z, -exponent)};
        const double short_length = firma::length(scaled);
        unit = scaled * (1 / short_length);
        length = std::ldexp(short_length, exponent);
    }
};

class Judge {
public:
    Judge(const ExactOracle& oracle, const Cast& cast, const Answer& answer, bool one_face)
        : oracle_(oracle),
          cast_(cast),
          answer_(answer),
          hit_(answer.hit),
          exact_(is_valid(cast) ? cast.sphere : Sphere{}, is_valid(cast) ? cast.path : Vec3{}),
          heading_(is_valid(cast) ? cast.path : Vec3{}),
          one_face_(one_face) {}

    Verdict run() {
        expected_ = expect(cast_);
        if ((expected_.status == Status::kInvalid) != (hit_.status == Status::kInvalid)) {
            fail(Fault::kFields, "invalid and not invalid");
        } else if (hit_.status == Status::kMiss) {
            judge_miss();
        } else if (hit_.touched()) {
            judge_hit();
        }
        return verdict_;
    }

private:
    void fail(Fault fault, const std::string& text) {
        if (!verdict_.ok()) return;
        verdict_.fault = fault;
        verdict_.excused = false;
        verdict_.text = text;
        verdict_.text += numbered("; answered face ", answer_.face, print(" at %.17g", {hit_.fraction}).c_str());
        verdict_.text += expected_.touched()
                             ? numbered("; exact: face ", expected_.faces[0], " at ") + expected_.fraction_text()
                             : std::string("; exact: miss");
    }
    void check(const char* what, double value, double allowed) {
        if (!(value <= allowed))  // catches NaN too
            fail(Fault::kFields, std::string(what) + print(" off by %.3g (allowed %.3g)", {value, allowed}));
    }

    double tolerance(const std::vector<std::uint32_t>& faces) const {
        double most = std::max(max_abs(cast_.sphere.centre), max_abs(cast_.sphere.centre + cast_.path));
        for (const std::uint32_t f : faces)
            for (const Vec3& v : oracle_.faces()[f].hull.corners) most = std::max(most, max_abs(v));
        return kDistance * std::max(1.0, most / 1000);
    }
    double normal_tolerance(const Nearest& at) const { return kNormal + 4 * tolerance_ / at.distance; }
    double slope(const Vec3& unit) const { return dot(heading_.unit, unit); }
    SeenPolygon see(std::uint32_t f) const { return {oracle_.faces()[f].exact, exact_}; }
    Vec3 unit_normal(std::uint32_t f) const {  // from exact numbers: a sliver's double normal would be noise
        const IntegerVec& n = oracle_.faces()[f].exact.normal;
        const Integer most = std::max({Integer(abs(n.x)), Integer(abs(n.y)), Integer(abs(n.z))});
        const Vec3 v{nearest({n.x, most}), nearest({n.y, most}), nearest({n.z, most})};
        return v * (1 / length(v));
    }
    Ratio fraction() const {
        const Dyadic d = dyadic(hit_.fraction);
        if (d.exponent >= 0) return {Integer(d.mantissa) << unsigned(d.exponent), 1};
        return {d.mantissa, Integer(1) << unsigned(-d.exponent)};
    }

    Expected expect(const Cast& cast) const {
        return one_face_ ? oracle_.expect(cast, answer_.face) : oracle_.expect(cast);
    }

    /// One-sided, so near to parallel that another sign of path . normal is forgiven.
    bool nearly_parallel(std::uint32_t f) const {
        const bool both = cast_.sides == Sides::kBoth || oracle_.faces()[f].two_sided;
        return !both && std::fabs(slope(unit_normal(f))) <= kParallel;
    }

    /// Whether something is met at or before `latest` however the cast is shifted by twice the tolerance or turned by
    /// as much as is forgiven: then no rounding excuses to pass. Through a corner that several faces share, each by
    /// itself has no margin at all.
    bool surely_met_by(double latest) const {
        const Vec3 h = heading_.unit;
        const Vec3 least{std::fabs(h.x) < 0.6 ? 1.0 : 0.0, std::fabs(h.x) < 0.6 ? 0.0 : 1.0, 0};
        const Vec3 u = cross(h, least) * (1 / length(cross(h, least))), v = cross(h, u);
        const double shift = 2 * tolerance_, turn = 4 * kParallel * heading_.length;
        for (const Vec3& to : {Vec3{}, u, u * -1, v, v * -1, u * .7 + v * .7, u * .7 - v * .7, v * .7 - u * .7,
                               u * -.7 - v * .7, h, h * -1}) {
            for (const Vec3& aside : {Vec3{}, u, u * -1, v, v * -1}) {
                const Cast moved{
                    {cast_.sphere.centre + to * shift, cast_.sphere.radius}, cast_.path + aside * turn, cast_.sides};
                const Expected expected = expect(moved);
                if (!expected.touched()) return false;
                const double at = nearest({expected.at.floor_times(Integer(1) << 256), 1}, -256);
                if ((at - latest) * heading_.length > shift) return false;
            }
        }
        return true;
    }

    void judge_miss() {
        if (!expected_.touched()) return;
        verdict_.excused = true;
        if (max_abs(cast_.path) < 0x1p-1000) return;  // what the contract takes for a zero path
        tolerance_ = tolerance(expected_.faces);
        if (answer_.must_hit) return fail(Fault::kMissed, "the way out of a closed room");
        const std::uint32_t count = std::uint32_t(oracle_.faces().size());
        for (std::uint32_t f = one_face_ ? answer_.face : 0; f < (one_face_ ? answer_.face + 1 : count); ++f) {
            if (is_clear(oracle_, cast_, f)) return fail(Fault::kMissed, numbered("face ", f, " is clear"));
        }
        if (surely_met_by(1)) fail(Fault::kMissed, "nearby casts all meet something");
    }

    void judge_hit() {
        if (!(hit_.fraction >= 0 && hit_.fraction <= 1) || answer_.face >= oracle_.faces().size())
            return fail(Fault::kFields, "fraction or face out of range");
        std::vector<std::uint32_t> faces = expected_.faces;
        faces.push_back(answer_.face);
        tolerance_ = tolerance(faces);
        const SeenPolygon seen = see(answer_.face);
        const Nearest contact = seen.nearest_at(fraction());
        const std::string problem = problem_with(seen, contact);
        if (!expected_.touched()) {
            if (!problem.empty()) return fail(Fault::kFalse, problem);
            verdict_.excused = true;
        } else {
            judge_time(contact, problem);
        }
        if (verdict_.ok()) judge_fields(seen, contact);
    }

    /// Why no sphere should have stopped at this face, or nothing.
    std::string problem_with(const SeenPolygon& seen, const Nearest& contact) const {
        const bool both = cast_.sides == Sides::kBoth || oracle_.faces()[answer_.face].two_sided;
        if (!both && slope(unit_normal(answer_.face)) > kParallel) return "hit from behind";
        if (contact.gap > tolerance_) return print("%.3g m short of it", {contact.gap});
        if (hit_.fraction == 0 && contact.distance > tolerance_ && slope(contact.direction) > normal_tolerance(contact))
            return "the sphere moves away from it";
        if (hit_.fraction > 0) {
            const Nearest start = seen.nearest_at(Ratio{0, 1});
            if (start.gap < -tolerance_ && start.closing >= 0) return "an overlap that does not get deeper";
        }
        return {};
    }

    void judge_time(const Nearest& contact, const std::string& problem) {
        const Integer scale = Integer(1) << 256;
        const Ratio t = fraction();
        const Integer late_steps = (t.top * scale) / t.bottom - expected_.at.floor_times(scale);
        const double late_by = nearest({late_steps, 1}, -256) * heading_.length;
        if (late_by > tolerance_) judge_late(late_by);
        if (!problem.empty()) return fail(Fault::kEarly, problem);
        const bool tied =
            std::find(expected_.faces.begin(), expected_.faces.end(), answer_.face) != expected_.faces.end();
        if (!tied) verdict_.excused = true;
        const double allowed = kFraction * std::max(tolerance_ / kDistance, heading_.length / 100);
        if (std::fabs(late_by) <= allowed || !(tied || late_by > 0)) return;
        double margin = -INFINITY, approach = 0;
        for (const std::uint32_t f : expected_.faces) {
            const SeenPolygon seen = see(f);
            margin = std::max(margin, seen.margin());
            const Vec3 way = cast_.sphere.radius == 0 ? unit_normal(f) : seen.nearest_at(expected_.at).direction;
            approach = std::max(approach, cast_.sphere.radius == 0 ? std::fabs(slope(way)) : -slope(way));
        }
        if (margin > tolerance_ && approach >= kGrazing)
            return fail(Fault::kFraction, print("%.3g m off along the path (allowed %.3g), contact %.3g m off",
                                                {late_by, allowed, contact.gap}));
        verdict_.excused = true;
    }

    /// How deep the sphere has been by now in any face that it should have met earlier.
    void judge_late(double late_by) {
        verdict_.excused = true;
        const std::uint32_t count = std::uint32_t(oracle_.faces().size());
        for (std::uint32_t f = one_face_ ? answer_.face : 0; f < (one_face_ ? answer_.face + 1 : count); ++f) {
            if (surely_apart(oracle_.faces()[f].hull, cast_.sphere.centre, cast_.path, hit_.fraction,
                             cast_.sphere.radius))
                continue;
            const Expected alone = oracle_.expect(cast_, f);
            if (!alone.touched()) continue;
            const SeenPolygon seen = see(f);
            if (nearly_parallel(f)) continue;
            const double margin = seen.margin();
            if (margin <= tolerance_) continue;
            const Nearest start = seen.nearest_at(Ratio{0, 1}), now = seen.nearest_at(fraction());
            double depth = 0;
            if (cast_.sphere.radius == 0)
                depth = now.distance;
            else if (now.closing > 0)
                depth = margin;
            else
                depth = std::max(0.0, std::min(start.gap, 0.0) - now.gap);
            const Integer scale = Integer(1) << 256;
            const Ratio t = fraction();
            const double late_here =
                nearest({(t.top * scale) / t.bottom - alone.at.floor_times(scale), 1}, -256) * heading_.length;
            depth = std::min({depth, late_here, late_by});
            if (depth > tolerance_)
                return fail(Fault::kLate,
                            print("%.3g m too deep in face %.0f, margin %.3g", {depth, double(f), margin}));
        }
        if (late_by > 8 * tolerance_ && surely_met_by(hit_.fraction - 8 * tolerance_ / heading_.length))
            fail(Fault::kLate, print("%.3g m late; nearby casts all meet something earlier", {late_by}));
    }

    void judge_fields(const SeenPolygon& seen, const Nearest& contact) {
        const Face& face = oracle_.faces()[answer_.face];
        const Vec3 normal = unit_normal(answer_.face);
        check("centre", length(hit_.centre - contact.centre), tolerance_);
        const bool has_direction = !contact.on_polygon();
        if (-slope(has_direction ? contact.direction : hit_.normal) > kGrazing) {
            check("contact point", length(hit_.point - contact.point), tolerance_);
        } else {  // a hair earlier or later another point is the nearest
            check("contact point, from the centre,", length(hit_.point - contact.centre) - contact.distance,
                  tolerance_);
            check("contact point, from the face,", distance_of(hit_.point), tolerance_);
        }
        check("face normal", length(hit_.face_normal - normal), kFaceNormal);
        judge_normal(seen, contact, normal);
        judge_feature(face, contact, normal);
        if ((hit_.status == Status::kInitialOverlap) != (hit_.fraction == 0))
            fail(Fault::kFields, "touching means a fraction of 0, hit one above");
        if (hit_.status == Status::kHit && seen.nearest_at(Ratio{0, 1}).gap < -tolerance_)
            fail(Fault::kFields, "should say touching");
        judge_safe_fraction();
    }

    double distance_of(const Vec3& point) const {
        if (!is_finite(point)) return INFINITY;
        const ExactCast there({point, 0}, {});
        return SeenPolygon(oracle_.faces()[answer_.face].exact, there).nearest_at(Ratio{0, 1}).distance;
    }

    void judge_normal(const SeenPolygon& seen, const Nearest& contact, const Vec3& normal) {
        check("length of the normal", std::fabs(length(hit_.normal) - 1), 1e-9);
        const bool by_face = cast_.sphere.radius == 0 || (contact.on_polygon() && hit_.fraction == 0);
        if (!by_face && contact.distance < 1000 * tolerance_) return;  // no direction to speak of
        double error = INFINITY, allowed = kNormal;
        if (by_face) {
            // Parts of a path below 2^-250 of its largest are taken for zero, and then either side is where it came
            // from.
            const int facing = std::fabs(slope(normal)) < 0x1p-240 ? 0 : seen.facing();
            if (facing <= 0) error = length(hit_.normal - normal);
            if (facing >= 0) error = std::min(error, length(hit_.normal + normal));
        } else {
            allowed = normal_tolerance(contact);
            error = length(hit_.normal - contact.direction);
            if (!(error <= allowed) && expected_.touched())  // along a graze it turns: the exact moment's will do too
                error = std::min(error, length(hit_.normal - seen.nearest_at(expected_.at).direction));
        }
        check("normal", error, allowed);
    }

    void judge_feature(const Face& face, const Nearest& contact, const Vec3& normal) {
        const std::vector<Vec3>& v = face.hull.corners;
        const std::size_t k = hit_.feature_index;
        if (k >= v.size()) return fail(Fault::kFields, "feature index out of range");
        if (hit_.feature == Feature::kVertex) {
            check("contact at a vertex", length(hit_.point - v[k]), tolerance_);
        } else if (hit_.feature == Feature::kEdge) {
            const Vec3 edge = v[(k + 1) % v.size()] - v[k];
            const double along = std::clamp(dot(hit_.point - v[k], edge) / dot(edge, edge), 0.0, 1.0);
            check("contact at an edge", length(hit_.point - (v[k] + edge * along)), tolerance_);
        } else if (contact.distance > tolerance_ && expected_.touched() && expected_.feature != Feature::kFace) {
            check("contact with a face", length(cross(contact.direction, normal)), normal_tolerance(contact));
        }
    }

    void judge_safe_fraction() {
        const double safe = answer_.safe_fraction;
        if (std::isnan(safe) && one_face_) return;  // pair functions have none
        if (!(safe >= 0 && safe <= hit_.fraction))
            return fail(Fault::kFields, print("safe_fraction %.17g not within [0, fraction]", {safe}));
        const double steep = -slope(hit_.normal);
        if (steep <= kGrazing) return;
        const double ideal = std::max(0.0, hit_.fraction - answer_.contact_offset / (steep * heading_.length));
        check("safe_fraction, metres along the path,", std::fabs(safe - ideal) * heading_.length,
              tolerance_ + 1e-9 * answer_.contact_offset / (steep * steep));
    }

    const ExactOracle& oracle_;
    const Cast& cast_;
    const Answer& answer_;
    const PolygonHit& hit_;
    const ExactCast exact_;
    const Heading heading_;
    const bool one_face_;
    Expected expected_;
    double tolerance_ = kDistance;
    Verdict verdict_;
};

}  // namespace

const char* name_of(Fault fault) {
    constexpr const char* kNames[kFaultCount] = {"none", "missed", "false", "late", "early", "fraction", "fields"};
    return kNames[int(fault)];
}

bool is_clear(const ExactOracle& oracle, const Cast& cast, std::uint32_t face) {
    const Expected alone = oracle.expect(cast, face);
    if (!alone.touched()) return false;
    const Face& f = oracle.faces()[face];
    const ExactCast exact(cast.sphere, cast.path);
    const SeenPolygon seen(f.exact, exact);
    const Heading heading(cast.path);
    const bool both = cast.sides == Sides::kBoth || f.two_sided;
    if (!both && std::fabs(dot(heading.unit, f.hull.normal)) <= kParallel) return false;
    double most = std::max(max_abs(cast.sphere.centre), max_abs(cast.sphere.centre + cast.path));
    for (const Vec3& v : f.hull.corners) most = std::max(most, max_abs(v));
    const double tolerance = kDistance * std::max(1.0, most / 1000);
    if (seen.margin() > tolerance) return true;
    if (alone.status != Status::kInitialOverlap) return false;
    // A short path out of a firm overlap is clear all the same.
    const Nearest start = seen.nearest_at(Ratio{0, 1});
    if (start.gap >= -tolerance || start.on_polygon()) return false;
    return -dot(heading.unit, start.direction) > kNormal + 4 * tolerance / start.distance;
}

Verdict judge(const ExactOracle& oracle, const Cast& cast, const Answer& answer) {
    return Judge(oracle, cast, answer, false).run();
}

Verdict judge_face(const ExactOracle& oracle, const Cast& cast, const Answer& answer) {
    return Judge(oracle, cast, answer, true).run();
}

}  // namespace firma::reference
