// SPDX-License-Identifier: MIT
// A program that has all inline functions of the public headers, and asks the pair functions about numbers that are not
// finite and about many casts. Built three times, with -ffast-math and without, it must print the same lines: the
// library's answers are not to depend on how the program is compiled. What it asks comes from whole numbers, as its own
// arithmetic does depend on that. Finding 4 (F4).
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "firma/firma.h"

namespace {

using firma::Vec3;

std::uint64_t bits_of(const double& number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

Vec3 with(const Vec3& v, int axis, std::uint64_t bits) {
    Vec3 changed = v;
    std::memcpy(&changed[axis], &bits, sizeof bits);
    return changed;
}

/// Whole numbers; the same with every compiler.
class Numbers {
public:
    /// low .. low + range - 1
    double next(std::int32_t low, std::int32_t range) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return double(low + std::int32_t((state_ >> 33) % std::uint64_t(range)));
    }

private:
    std::uint64_t state_ = 1;
};

void print(const char* what, const Vec3& v) {
    std::printf(" %s %016" PRIx64 " %016" PRIx64 " %016" PRIx64, what, bits_of(v.x), bits_of(v.y), bits_of(v.z));
}

void print(const firma::PolygonHit& hit) {
    std::printf("%d %d %u %016" PRIx64, int(hit.status), int(hit.feature), hit.feature_index, bits_of(hit.fraction));
    print("centre", hit.centre);
    print("point", hit.point);
    print("normal", hit.normal);
    std::printf("\n");
}

/// Has the compiler make its own copy of each, if it ever does. What they answer here is the program's own affair.
int use_inline_functions(const Vec3& a) {
    firma::Box box;
    box.add(a);
    box.add(firma::Box{a, a});
    const Vec3 sum = a + a - a * 2 + 2 * -a + cross(a, a);
    return firma::is_finite(a) + std::isfinite(a.x) + std::isnan(a.y) + std::signbit(a.z) + (sum == a) +
           (box == firma::Box{}) + box.empty() + (dot(a, a) < length(a)) + (max_abs(a) < 1);
}

}  // namespace

int main() {
    const std::uint64_t kNotANumber = 0x7ff8000000000000, kInfinity = 0x7ff0000000000000, kMinus = 0x8000000000000000;
    volatile int kept = 0;
    const std::vector<Vec3> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const Vec3 above{0, 0, 2}, down{0, 0, -4};
    print(firma::cast_polygon({above, 0.5}, down, square));
    for (const std::uint64_t bits : {kNotANumber, kNotANumber | kMinus, kInfinity, kInfinity | kMinus}) {
        for (int axis = 0; axis < 3; ++axis) {
            kept = kept + use_inline_functions(with(above, axis, bits));
            const firma::PolygonHit hits[] = {
                firma::cast_polygon({with(above, axis, bits), 0.5}, down, square),
                firma::cast_polygon({above, 0.5}, with(down, axis, bits), square),
                firma::cast_polygon({above, with({}, 0, bits).x}, down, square),
            };
            std::vector<Vec3> bad = square;
            bad[2] = with(bad[2], axis, bits);
            std::printf("%d %d %d overlap %d corners %d\n", int(hits[0].status), int(hits[1].status),
                        int(hits[2].status), int(firma::overlap({with(above, axis, bits), 5}, square)),
                        int(firma::check_polygon(bad)));
        }
    }
    Numbers numbers;
    for (int k = 0; k < 2000; ++k) {
        Vec3 start, path;
        for (int axis = 0; axis < 3; ++axis) {
            start[axis] = numbers.next(-3000, 6001) * 0x1p-10;
            path[axis] = numbers.next(-3000, 6001) * 0x1p-9;
        }
        if (k % 5 == 0) path[k % 3] = 0x1p-1060;  // which a program with -ffast-math has its processor take for zero
        const double radius = k % 3 ? numbers.next(0, 500) * 0x1p-9 : 0;
        print(firma::cast_polygon({start, radius}, path, square, firma::Sides::kBoth));
    }
}
