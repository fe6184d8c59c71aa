// SPDX-License-Identifier: MIT
// Many casts at once, as users ask for them: what each batch reads, and where its answers go.
#include <algorithm>

#include "base/fetch_ahead.h"
#include "world/cast_many.h"
#include "world/run_tasks.h"

namespace firma {
namespace {

const Hull& hull_of(const HullInput& input) {
    static const Hull none;
    return input.hull ? *input.hull : none;
}

CastWay way_of(const CastInput& input) {
    return {input.sphere.centre, input.path};
}
CastWay way_of(const CapsuleInput& input) {
    return {input.capsule.from, input.path};
}
CastWay way_of(const HullInput& input) {
    return {input.at, input.path};
}

Hit first_of(const World& world, const CastInput& input, const CastOptions& options) {
    return cast(world, input.sphere, input.path, options);
}
Hit first_of(const World& world, const CapsuleInput& input, const CastOptions& options) {
    return cast(world, input.capsule, input.path, options);
}
Hit first_of(const World& world, const HullInput& input, const CastOptions& options) {
    return cast(world, hull_of(input), input.at, input.path, options);
}

Status any_of(const World& world, const CastInput& input, const CastOptions& options) {
    return cast_any(world, input.sphere, input.path, options);
}
Status any_of(const World& world, const CapsuleInput& input, const CastOptions& options) {
    return cast_any(world, input.capsule, input.path, options);
}
Status any_of(const World& world, const HullInput& input, const CastOptions& options) {
    return cast_any(world, hull_of(input), input.at, input.path, options);
}

template <class T>
void fetch_lines_of(const T* object) {
    constexpr std::size_t kLine = 64;
    for (std::size_t at = 0; at < sizeof(T); at += kLine) fetch_ahead(reinterpret_cast<const char*>(object) + at);
    fetch_ahead(reinterpret_cast<const char*>(object + 1) - 1);
    keep_fetches();
}

/// Casts one after the other.
template <class Input>
struct InputRows {
    std::span<const Input> rows;
    std::size_t size() const { return rows.size(); }
    bool fits() const { return true; }
    const Input& operator[](std::size_t k) const { return rows[k]; }
    void fetch(std::size_t k) const { fetch_lines_of(&rows[k]); }
};

struct InputColumns {
    const CastColumns& columns;

    std::size_t size() const { return columns.x.size(); }
    bool fits() const {
        const auto all = [&](std::span<const double> column) { return column.size() == size(); };
        return all(columns.y) && all(columns.z) && all(columns.path_x) && all(columns.path_y) && all(columns.path_z) &&
               (columns.radius.empty() || all(columns.radius));
    }
    CastInput operator[](std::size_t k) const {
        return {{{columns.x[k], columns.y[k], columns.z[k]}, columns.radius.empty() ? 0 : columns.radius[k]},
                {columns.path_x[k], columns.path_y[k], columns.path_z[k]}};
    }
    void fetch(std::size_t k) const {
        for (const std::span<const double>* column :
             {&columns.x, &columns.y, &columns.z, &columns.path_x, &columns.path_y, &columns.path_z})
            fetch_ahead(&(*column)[k]);
        if (!columns.radius.empty()) fetch_ahead(&columns.radius[k]);
        keep_fetches();
    }
};

/// Answers k as long as there is room for it.
template <class Inputs>
ManyResult many_firsts(const World& world, const Inputs& inputs, std::span<Hit> hits, const ManyOptions& options) {
    const auto way = [&](std::size_t k) { return way_of(inputs[k]); };
    const auto answer = [&](std::size_t k, const CastOptions* each) {
        hits[k] = each ? first_of(world, inputs[k], *each) : invalid_hit({});
    };
    const auto fetch = [&](std::size_t k) {
        inputs.fetch(k);
        fetch_lines_of(&hits[k]);
        keep_fetches();
    };
    const bool fits = inputs.fits() && hits.size() == inputs.size();
    return run_many(world, {fits ? inputs.size() : hits.size(), fits, way, answer, fetch}, options);
}

template <class Inputs>
ManyResult many_anys(const World& world, const Inputs& inputs, std::span<Status> statuses, const ManyOptions& options) {
    const auto way = [&](std::size_t k) { return way_of(inputs[k]); };
    const auto answer = [&](std::size_t k, const CastOptions* each) {
        statuses[k] = each ? any_of(world, inputs[k], *each) : Status::kInvalid;
    };
    const auto fetch = [&](std::size_t k) {
        inputs.fetch(k);
        keep_fetches();
    };
    const bool fits = inputs.fits() && statuses.size() == inputs.size();
    return run_many(world, {fits ? inputs.size() : statuses.size(), fits, way, answer, fetch}, options);
}

/// Calls function(column, what a hit says of it) for each column.
template <class Function>
void each_column(const HitColumns& columns, const Hit& hit, const Function& function) {
    function(columns.status, hit.status);
    function(columns.fraction, hit.fraction);
    function(columns.safe_fraction, hit.safe_fraction);
    function(columns.normal_x, hit.normal.x);
    function(columns.normal_y, hit.normal.y);
    function(columns.normal_z, hit.normal.z);
    function(columns.face, hit.face);
    function(columns.material, hit.material);
}

}  // namespace

ManyResult cast_many(const World& world, std::span<const CastInput> casts, std::span<Hit> hits,
                     const ManyOptions& options) {
    return many_firsts(world, InputRows<CastInput>{casts}, hits, options);
}

ManyResult cast_many(const World& world, std::span<const CapsuleInput> casts, std::span<Hit> hits,
                     const ManyOptions& options) {
    return many_firsts(world, InputRows<CapsuleInput>{casts}, hits, options);
}

ManyResult cast_many(const World& world, std::span<const HullInput> casts, std::span<Hit> hits,
                     const ManyOptions& options) {
    return many_firsts(world, InputRows<HullInput>{casts}, hits, options);
}

ManyResult cast_many(const World& world, const CastColumns& casts, const HitColumns& hits, const ManyOptions& options) {
    const InputColumns inputs{casts};
    bool fits = inputs.fits();
    std::size_t most = inputs.size();
    each_column(hits, {}, [&](const auto& column, const auto&) {
        fits = fits && (column.empty() || column.size() == inputs.size());
        most = std::max(most, column.size());
    });
    const auto way = [&](std::size_t k) { return way_of(inputs[k]); };
    const auto answer = [&](std::size_t k, const CastOptions* each) {
        const Hit hit = each ? first_of(world, inputs[k], *each) : invalid_hit({});
        each_column(hits, hit, [&](const auto& column, const auto& said) {
            if (k < column.size()) column[k] = said;
        });
    };
    const auto fetch = [&](std::size_t k) {
        inputs.fetch(k);
        keep_fetches();
    };
    return run_many(world, {fits ? inputs.size() : most, fits, way, answer, fetch}, options);
}

ManyResult cast_many_any(const World& world, std::span<const CastInput> casts, std::span<Status> statuses,
                         const ManyOptions& options) {
    return many_anys(world, InputRows<CastInput>{casts}, statuses, options);
}

ManyResult cast_many_any(const World& world, std::span<const CapsuleInput> casts, std::span<Status> statuses,
                         const ManyOptions& options) {
    return many_anys(world, InputRows<CapsuleInput>{casts}, statuses, options);
}

ManyResult cast_many_any(const World& world, std::span<const HullInput> casts, std::span<Status> statuses,
                         const ManyOptions& options) {
    return many_anys(world, InputRows<HullInput>{casts}, statuses, options);
}

ManyResult cast_many_any(const World& world, const CastColumns& casts, std::span<Status> statuses,
                         const ManyOptions& options) {
    return many_anys(world, InputColumns{casts}, statuses, options);
}

bool cast_batch(const World& world, std::span<const CastInput> inputs, std::span<Hit> hits, const CastOptions& options,
                const Tasks* tasks) {
    return cast_many(world, inputs, hits, {.cast = options, .tasks = tasks}) == ManyResult::kDone;
}

}  // namespace firma
