// SPDX-License-Identifier: MIT
// Principal axes by Jacobi's turns.
#include "body/principal_axes.h"

#include <cmath>
#include <span>

#include "base/sort.h"

namespace firma {

PrincipalAxes principal_axes(const std::array<Vec3, 3>& tensor) {
    constexpr int kSweeps = 32;
    std::array<Vec3, 3> a = tensor, axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  // axes: columns, kept as rows
    for (int turn = 0; turn < 3 * kSweeps; ++turn) {
        const int p = turn % 3, q = (turn + 1) % 3;
        const double off = a[std::size_t(p)][q];
        const double size = std::fabs(a[std::size_t(p)][p]) + std::fabs(a[std::size_t(q)][q]);
        if (!(std::fabs(off) > size * 0x1p-56)) continue;
        // tan of the angle that makes a[p][q] zero, the smaller one.
        const double theta = (a[std::size_t(q)][q] - a[std::size_t(p)][p]) / (2 * off);
        const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (Vec3& row : a) {
            const double ap = row[p], aq = row[q];
            row[p] = c * ap - s * aq;
            row[q] = s * ap + c * aq;
        }
        const Vec3 row_p = a[std::size_t(p)], row_q = a[std::size_t(q)];
        a[std::size_t(p)] = row_p * c - row_q * s;
        a[std::size_t(q)] = row_p * s + row_q * c;
        const Vec3 axis_p = axes[std::size_t(p)], axis_q = axes[std::size_t(q)];
        axes[std::size_t(p)] = axis_p * c - axis_q * s;
        axes[std::size_t(q)] = axis_p * s + axis_q * c;
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto moment = [&](std::size_t k) { return a[k][int(k)]; };
    sort_range(std::span<std::size_t>(order),
               [&](std::size_t k, std::size_t l) { return moment(k) != moment(l) ? moment(k) > moment(l) : k < l; });
    const Vec3 x = axes[order[0]], y = axes[order[1]], z = cross(x, y);
    return {{moment(order[0]), moment(order[1]), moment(order[2])}, turn_of_axes(x, y, z)};
}

}  // namespace firma
