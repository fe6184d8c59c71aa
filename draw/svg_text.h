// SPDX-License-Identifier: MIT
// SVG as text: numbers to a tenth of a pixel, words escaped.
#pragma once

#include <string>
#include <string_view>

namespace firma::draw {

/// A point of the page in pixels, y downwards.
struct PagePoint {
    double x = 0, y = 0;
};

class SvgText {
public:
    /// Text that is SVG already.
    SvgText& raw(std::string_view svg);
    /// Words of any origin: markup, control characters and bytes that are not UTF-8 do no harm.
    SvgText& words(std::string_view text);
    /// Rounded to 0.1; 0 for what is not finite.
    SvgText& number(double value);
    /// "x,y"
    SvgText& point(const PagePoint& p);

    /// A whole <text>; `style` holds attributes.
    void label(const PagePoint& at, std::string_view text, std::string_view style = {});
    /// A whole <line>.
    void line(const PagePoint& from, const PagePoint& to, std::string_view style);

    const std::string& text() const { return text_; }
    std::size_t size() const { return text_.size(); }

private:
    std::string text_;
};

/// "1234.5", in the fewest digits, for labels; never with an exponent below 1e15.
std::string short_number(double value, int decimals);
/// 1234567 -> "1,234,567"
std::string grouped_number(std::size_t value);

}  // namespace firma::draw
