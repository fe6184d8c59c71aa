// SPDX-License-Identifier: MIT
// The article's formulas as printed, mended, and Firma's, on casts with known answers: what they miss, how deep it
// gets, what a face costs.
#include "article/questions.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "cast/cast_sphere_polygon.h"
#include "firma/queries.h"
#include "firma/world.h"
#include "geometry/polygon_shape.h"
#include "naive/mended.h"
#include "naive/printed.h"
#include "support/exact_cases.h"
#include "support/family_cases.h"
#include "support/race.h"
#include "support/table.h"
#include "tests/source_of.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

template <class Real>
struct PlainCase {
    std::vector<naive::PlainFace<Real>> faces;
    std::vector<std::uint32_t> source;

    explicit PlainCase(const ExactCase& exact) {
        for (std::uint32_t k = 0; k < exact.faces.size(); ++k) {
            if (exact.faces[k].empty()) continue;
            faces.emplace_back(exact.faces[k]);
            source.push_back(k);
        }
    }
};

/// A cast narrowed to the numbers a formula works with.
template <class Real>
struct PlainCast {
    naive::Vector<Real> pos, path;
    Real radius;
    naive::ViewAlong<Real> view;

    explicit PlainCast(const CastQuery& move)
        : pos(naive::narrowed<Real>(move.sphere.centre)),
          path(naive::narrowed<Real>(move.path)),
          radius(Real(move.sphere.radius)),
          view(path) {}
};

template <class Real>
naive::Meeting<Real> printed(const naive::PlainFace<Real>& face, const PlainCast<Real>& move) {
    return naive::printed_cast(face, move.pos, move.path, move.radius);
}
template <class Real>
naive::Meeting<Real> half_mended(const naive::PlainFace<Real>& face, const PlainCast<Real>& move) {
    return naive::mended_cast(face, move.pos, move.path, move.radius, move.view, true);
}
template <class Real>
naive::Meeting<Real> mended(const naive::PlainFace<Real>& face, const PlainCast<Real>& move) {
    return naive::mended_cast(face, move.pos, move.path, move.radius, move.view);
}

/// A way of answering, and of testing one cast against one face for the clock.
class Formula {
public:
    explicit Formula(std::string name) : name_(std::move(name)) {}
    virtual ~Formula() = default;
    const std::string& name() const { return name_; }

    virtual void enter(const ExactCase& exact) = 0;
    virtual Answer answer(const CastQuery& move) const = 0;

    /// Every cast against the faces it is paired with.
    using Pairs = std::vector<std::vector<std::uint32_t>>;
    virtual void test(const Pairs& pairs) const = 0;

private:
    std::string name_;
};

template <class Real>
class PlainFormula : public Formula {
public:
    using Function = naive::Meeting<Real> (*)(const naive::PlainFace<Real>&, const PlainCast<Real>&);
    PlainFormula(std::string name, Function function) : Formula(std::move(name)), function_(function) {}

    void enter(const ExactCase& exact) override {
        exact_ = &exact;
        plain_.emplace(exact);
        moves_.clear();
        for (const CastQuery& move : exact.casts) moves_.emplace_back(move);
    }

    Answer answer(const CastQuery& move) const override {
        const PlainCast<Real> plain(move);
        naive::Meeting<Real> best;
        Answer answer;
        for (std::size_t k = 0; k < plain_->faces.size(); ++k) {
            const naive::Meeting<Real> other = function_(plain_->faces[k], plain);
            if (!other || (best && *best <= *other)) continue;
            best = other;
            answer = {true, double(*other), plain_->source[k]};
        }
        return answer;
    }

    void test(const Pairs& pairs) const override {
        for (std::size_t cast = 0; cast < pairs.size(); ++cast)
            for (const std::uint32_t face : pairs[cast]) keep(function_(plain_->faces[face], moves_[cast]).has_value());
    }

private:
    Function function_;
    const ExactCase* exact_ = nullptr;
    std::optional<PlainCase<Real>> plain_;
    std::vector<PlainCast<Real>> moves_;
};

class FirmaFormula : public Formula {
public:
    using Formula::Formula;

    void enter(const ExactCase& exact) override {
        world_ = make_world(exact.level).value();
        shapes_.clear();
        for (const auto& corners : exact.faces)
            if (!corners.empty()) shapes_.push_back(make_shape(corners));
        sweeps_.assign(exact.casts.size(), {});
        for (std::size_t k = 0; k < sweeps_.size(); ++k)
            make_sweep(exact.casts[k].sphere, exact.casts[k].path, sweeps_[k]);
    }

    Answer answer(const CastQuery& move) const override {
        const Hit hit = cast(world_, move.sphere, move.path);
        return {hit.touched(), hit.fraction, source_of(world_, hit)};
    }

    void test(const Pairs& pairs) const override {
        for (std::size_t cast = 0; cast < pairs.size(); ++cast) {
            const Sweep& sweep = sweeps_[cast];
            if (sweep.end == 0) continue;
            for (const std::uint32_t face : pairs[cast])
                keep(cast_sweep_polygon(sweep, shapes_[face], Sides::kFront, sweep.end).touched());
        }
    }

private:
    World world_;
    std::vector<PolygonShape> shapes_;
    std::vector<Sweep> sweeps_;
};

/// The faces whose grown boxes a cast's path meets, from the front: those that reach the formulas when boxes cull.
Formula::Pairs near_pairs(const ExactCase& exact) {
    Formula::Pairs pairs(exact.casts.size());
    for (std::size_t cast = 0; cast < pairs.size(); ++cast) {
        const CastQuery& move = exact.casts[cast];
        std::uint32_t index = 0;
        for (const auto& corners : exact.faces) {
            if (corners.empty()) continue;
            Box box;
            for (const Vec3& corner : corners) box.add(corner);
            for (int axis = 0; axis < 3; ++axis) {
                box.low[axis] -= move.sphere.radius;
                box.high[axis] += move.sphere.radius;
            }
            const PolygonShape shape = make_shape(corners);
            if (dot(move.path, shape.normal) < 0 && clip_segment_box(move.sphere.centre, move.path, box))
                pairs[cast].push_back(index);
            ++index;
        }
    }
    return pairs;
}

Formula::Pairs all_pairs(const ExactCase& exact) {
    std::uint32_t count = 0;
    for (const auto& corners : exact.faces) count += !corners.empty();
    std::vector<std::uint32_t> every(count);
    for (std::uint32_t k = 0; k < count; ++k) every[k] = k;
    return Formula::Pairs(exact.casts.size(), every);
}

std::size_t size_of(const Formula::Pairs& pairs) {
    std::size_t size = 0;
    for (const auto& faces : pairs) size += faces.size();
    return size;
}

/// Answers as `firma cast` writes them, for ../shared/casts/score.py; normals and points as the formulas would have it.
void write_hits(const std::string& folder, const Formula& formula, const ExactCase& exact) {
    std::filesystem::create_directories(folder);
    std::ofstream file(folder + "/" + exact.name + ".hits.csv");
    file.precision(17);
    file << "query,status,fraction,safe_fraction,cx,cy,cz,px,py,pz,nx,ny,nz,fnx,fny,fnz,face,feature,room\n";
    for (std::size_t k = 0; k < exact.casts.size(); ++k) {
        const CastQuery& move = exact.casts[k];
        const Answer answer = formula.answer(move);
        file << k << (answer.touched ? answer.fraction > 0 ? ",hit," : ",touching," : ",miss,,,,,,,,,,,,,,,,,");
        if (answer.touched) {
            const Vec3 centre = move.sphere.centre + move.path * answer.fraction;
            const ClosestPoint closest = closest_point(centre, exact.faces[answer.face]);
            const Vec3 unit = make_shape(exact.faces[answer.face]).unit_normal();
            const bool plane = closest.distance == 0 || move.sphere.radius == 0;
            const Vec3 normal = plane ? unit : (centre - closest.point) * (1 / closest.distance);
            file << answer.fraction << ',' << answer.fraction;
            for (const Vec3& v : {centre, closest.point, normal, unit}) file << ',' << v.x << ',' << v.y << ',' << v.z;
            const char* features[] = {"face", "edge", "vertex"};
            file << ',' << answer.face << ',' << features[int(closest.feature)] << ",0";
        }
        file << '\n';
    }
}

using Formulas = std::vector<std::unique_ptr<Formula>>;

Formulas all_formulas() {
    Formulas all;
    all.push_back(std::make_unique<PlainFormula<float>>("as printed; float", &printed<float>));
    all.push_back(std::make_unique<PlainFormula<double>>("as printed; double", &printed<double>));
    all.push_back(
        std::make_unique<PlainFormula<double>>("mended but for the early-outs; double", &half_mended<double>));
    all.push_back(std::make_unique<PlainFormula<float>>("mended; float", &mended<float>));
    all.push_back(std::make_unique<PlainFormula<double>>("mended; double", &mended<double>));
    all.push_back(std::make_unique<FirmaFormula>("Firma"));
    return all;
}

/// Processor time of all tests over all cases, by formula: cases and formulas take turns.
std::vector<Lap> race_over(const Formulas& formulas, const std::vector<ExactCase>& cases,
                           Formula::Pairs (*pairs_of)(const ExactCase&), int rounds, std::size_t& tests) {
    std::vector<Lap> total(formulas.size(), Lap{0, 0});
    tests = 0;
    for (const ExactCase& exact : cases) {
        const Formula::Pairs pairs = pairs_of(exact);
        tests += size_of(pairs);
        std::vector<Contender> contenders;
        for (const auto& formula : formulas) {
            formula->enter(exact);
            contenders.push_back({formula->name(), [&formula, &pairs] { formula->test(pairs); }});
        }
        const std::vector<Lap> laps = race(contenders, rounds);
        for (std::size_t k = 0; k < laps.size(); ++k) total[k].seconds += laps[k].seconds;
    }
    for (Lap& lap : total) lap.ratio = lap.seconds / total.back().seconds;
    return total;
}

/// @return false when Firma was wrong, or the table could not be written
bool judge(const Formulas& formulas, const std::vector<ExactCase>& cases, const Settings& settings) {
    Table table("article_formulas", {"formulas", "missed", "of all hits", "missed, not overlapping at the start",
                                     "false or early", "late", "wrong by over 1 mm", "deepest m"});
    bool right = false;
    for (std::size_t k = 0; k < formulas.size(); ++k) {
        Verdict verdict;
        for (const ExactCase& exact : cases) {
            formulas[k]->enter(exact);
            for (std::size_t cast = 0; cast < exact.casts.size(); ++cast)
                verdict.judge(exact, cast, formulas[k]->answer(exact.casts[cast]));
            if (!settings.rest.empty()) write_hits(settings.rest + "/" + std::to_string(k), *formulas[k], exact);
        }
        table.add({formulas[k]->name(), count(verdict.missed), percent(double(verdict.missed) / double(verdict.hits)),
                   count(verdict.missed_hits), count(verdict.false_hits), count(verdict.late), count(verdict.gross),
                   number(verdict.deepest)});
        right = verdict.missed + verdict.false_hits + verdict.late == 0;  // the last one is Firma
    }
    return table.finish(settings.csv) && right;
}

bool measure_cost(const Formulas& formulas, const std::vector<ExactCase>& cases, const Settings& settings) {
    struct Column {
        std::vector<Lap> laps;
        std::size_t tests = 0;
    };
    Column all, near, ordinary;
    all.laps = race_over(formulas, cases, all_pairs, settings.rounds, all.tests);
    near.laps = race_over(formulas, cases, near_pairs, settings.rounds, near.tests);
    const std::vector<ExactCase> everyday = ordinary_cases(settings.few(4000));
    ordinary.laps = race_over(formulas, everyday, near_pairs, settings.rounds, ordinary.tests);
    Table table("article_formulas_cost", {"formulas", "every pair, ns", "boxes met, ns", "boxes met, to Firma",
                                          "ordinary scenes, boxes met, ns", "ordinary, to Firma"});
    const auto each = [](const Column& column, std::size_t k) {
        return number(column.laps[k].seconds / double(column.tests) * 1e9);
    };
    for (std::size_t k = 0; k < formulas.size(); ++k)
        table.add({formulas[k]->name(), each(all, k), each(near, k), times(near.laps[k].ratio), each(ordinary, k),
                   times(ordinary.laps[k].ratio)});
    const bool written = table.finish(settings.csv);
    std::printf("\n%s tests of a cast against a face, %s with a box met from the front; %s in ordinary scenes\n",
                count(all.tests).c_str(), count(near.tests).c_str(), count(ordinary.tests).c_str());
    return written;
}

}  // namespace

int measure_formulas(const Settings& settings) {
    std::vector<ExactCase> cases = read_exact_cases(settings.shared + "/casts/cases");
    if (cases.empty()) {
        std::printf("%s/casts/cases is not there: judged on families of our own, by Firma's own answers\n",
                    settings.shared.c_str());
        cases = family_cases(settings.quick ? 1 : 3);
    }
    const Formulas formulas = all_formulas();
    const bool right = judge(formulas, cases, settings);
    return measure_cost(formulas, cases, settings) && right ? 0 : 1;
}

}  // namespace firma::bench
