// SPDX-License-Identifier: MIT
// Many casts at once, as users ask for them: what each batch reads, and where its answers go.
#include <algorithm>
#include <memory>
#include <type_traits>

#include "world/cast_many.h"

namespace firma {
namespace {

/// Casts one after the other.
template <class Input>
struct InputRows {
    std::span<const Input> rows;
    std::size_t size() const { return rows.size(); }
    bool fits() const { return true; }
    const Input& operator[](std::size_t k) const { return rows[k]; }
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
};

/// @param answers  how many there is room for
/// @param asks     function(ManyCasts): makes them
template <class Inputs, class Asks>
ManyResult many(const Inputs& inputs, bool fits, std::size_t answers, const Asks& asks) {
    using Input = std::remove_cvref_t<decltype(inputs[0])>;
    const auto ask = [&](std::size_t k) { return Asked(inputs[k]); };
    return asks(ManyCasts{fits ? inputs.size() : answers, fits, std::is_same_v<Input, CastInput>, ask});
}

template <class Inputs>
ManyResult many_firsts(const World& world, const Inputs& inputs, std::span<Hit> hits, const ManyOptions& options) {
    // Assigned, a hit would be made elsewhere and copied.
    const auto answer = [&](std::size_t k, PutHit put) { put(*std::construct_at(&hits[k])); };
    const bool fits = inputs.fits() && hits.size() == inputs.size();
    return many(inputs, fits, hits.size(),
                [&](const ManyCasts& casts) { return run_many(world, casts, answer, options); });
}

template <class Inputs>
ManyResult many_anys(const World& world, const Inputs& inputs, std::span<Status> statuses, const ManyOptions& options) {
    const auto answer = [&](std::size_t k, Status status) { statuses[k] = status; };
    const bool fits = inputs.fits() && statuses.size() == inputs.size();
    return many(inputs, fits, statuses.size(),
                [&](const ManyCasts& casts) { return run_many_any(world, casts, answer, options); });
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
    const auto answer = [&](std::size_t k, PutHit put) {
        Hit hit;
        put(hit);
        each_column(hits, hit, [&](const auto& column, const auto& said) {
            if (k < column.size()) column[k] = said;
        });
    };
    return many(inputs, fits, most, [&](const ManyCasts& many) { return run_many(world, many, answer, options); });
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
