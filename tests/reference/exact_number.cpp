// SPDX-License-Identifier: MIT
// Whole numbers, ratios and roots.
#include "tests/reference/exact_number.h"

#include <cmath>
#include <cstdint>

namespace firma::reference {

int compare(const Ratio& a, const Ratio& b) {
    return sign(a.top * b.bottom - b.top * a.bottom);
}

// Newton from above: each step stays above the root until it is there.
Integer floor_root(const Integer& x) {
    if (sign(x) <= 0) return 0;
    const int bits = int(msb(x)) + 1;
    const int shift = bits > 60 ? (bits - 60 + 1) / 2 * 2 : 0;
    const auto head = Integer(x >> unsigned(shift)).convert_to<std::uint64_t>();
    Integer y = Integer(std::uint64_t(std::sqrt(double(head))) + 2) << unsigned(shift / 2);
    for (;;) {
        const Integer better = (y + x / y) >> 1;
        if (better >= y) return y;
        y = better;
    }
}

Integer Root::floor_times(const Integer& scale) const {
    const Integer under_root = s * square(scale);
    Integer root = floor_root(under_root);
    if (square(root) != under_root) ++root;  // floor(P - sqrt(S)) = P - ceil(sqrt(S))
    const Integer top = p * scale - root;
    Integer quotient = top / q;
    if (sign(top) < 0 && quotient * q != top) --quotient;  // division rounds toward zero
    return quotient;
}

bool Root::is_zero() const {
    return sign(p) >= 0 && square(p) == s;
}

namespace {

// of a + sqrt(c) - sqrt(b)
int sign_of_sum(const Integer& a, const Integer& b, const Integer& c) {
    if (sign(a) >= 0) {                          // (a + sqrt c)^2 against b
        const Integer rest = b - square(a) - c;  // 2 a sqrt c against this
        if (sign(rest) < 0) return 1;
        return sign(4 * square(a) * c - square(rest));
    }
    const Integer rest = c - b - square(a);  // sqrt c against sqrt b - a: this against 2 |a| sqrt b
    if (sign(rest) < 0) return -1;
    return sign(square(rest) - 4 * square(a) * b);
}

}  // namespace

int compare(const Root& a, const Root& b) {
    return sign_of_sum(a.p * b.q - b.p * a.q, square(b.q) * a.s, square(a.q) * b.s);
}

Dyadic dyadic(double x) {
    if (x == 0) return {};
    int exponent = 0;
    auto mantissa = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
    exponent -= 53;
    while (mantissa % 2 == 0) {
        mantissa /= 2;
        ++exponent;
    }
    return {mantissa, exponent};
}

Integer in_units(double x, int unit) {
    const Dyadic d = dyadic(x);
    return d.mantissa == 0 ? Integer(0) : Integer(d.mantissa) << unsigned(d.exponent + unit);
}

double nearest(const Ratio& a, int exponent) {
    if (sign(a.top) == 0) return 0;
    const int shift = 70 - int(msb(abs(a.top))) + int(msb(a.bottom));
    const Integer quotient =
        shift >= 0 ? Integer((a.top << unsigned(shift)) / a.bottom) : Integer(a.top / (a.bottom << unsigned(-shift)));
    return std::ldexp(quotient.convert_to<double>(), exponent - shift);
}

double root_minus(const Ratio& square_of, const Integer& minus, int exponent) {
    constexpr int kBits = 120;
    const Integer root = floor_root((square_of.top << (2 * kBits)) / square_of.bottom);
    return nearest({root - (minus << kBits), Integer(1) << kBits}, exponent);
}

std::string decimals(const Root& x, int digits) {
    Integer scale = 1;
    for (int k = 0; k < digits; ++k) scale *= 10;
    std::string text;  // backwards
    Integer rest = x.floor_times(scale);
    for (int k = 0; k <= digits || sign(rest) > 0; ++k, rest /= 10) {
        if (k == digits) text.push_back('.');
        text.push_back(char('0' + Integer(rest % 10).convert_to<int>()));
    }
    return {text.rbegin(), text.rend()};
}

}  // namespace firma::reference
