// SPDX-License-Identifier: MIT
// Sorts a world's faces by material, names and colours those, counts bytes.
#include "cli/glb_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/failure.h"
#include "cli/numbers.h"
#include "draw/utf8.h"

namespace firma::cli {

namespace {

// What JSON takes, with much to spare: all but parts; a part but its name; a byte of a name, escaped (\u001f).
constexpr std::uint64_t kJsonBytes = 4096, kPartBytes = 4096, kNameBytes = 6;

/// FNV-1a, after G. Fowler, L. C. Noll, K.-P. Vo.
std::uint32_t hash_of(std::string_view text) {
    std::uint32_t hash = 0x811C9DC5;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
    return hash;
}

std::string part_name(const std::string& material, bool cut) {
    const std::string name = glb_name(material);
    return !cut ? name : name.empty() ? "(cut)" : name + " (cut)";
}

}  // namespace

GlbParts::GlbParts(const World& world) {
    struct Count {
        std::uint64_t faces = 0, corners = 0;
    };
    std::map<Key, Count> counts;
    for_each_record(world, [&](const Block&, const FaceRecord& face) {
        Count& count = counts[key(face)];
        ++count.faces;
        count.corners += face.corner_count;
    });
    for (const bool cut : {false, true}) {
        for (const auto& [key, count] : counts) {
            if (std::get<1>(key) != cut) continue;
            index_[key] = list_.size();
            list_.push_back({part_name(world.material_name(std::get<0>(key)), cut), cut, std::get<2>(key), count.faces,
                             count.corners});
        }
    }
}

std::uint64_t GlbParts::buffer_bytes() const {
    std::uint64_t bytes = 0;
    for (const GlbPart& part : list_) bytes += 2 * part.vertex_bytes() + part.index_bytes();
    return bytes;
}

std::uint64_t GlbParts::file_bytes() const {
    std::uint64_t bytes = kJsonBytes + buffer_bytes();
    for (const GlbPart& part : list_) bytes += kPartBytes + kNameBytes * part.name.size();
    return bytes;
}

void judge_glb_size(std::uint64_t bytes, const std::string& path) {
    if (bytes <= kLargestGlb) return;
    throw Failure(path, fmt::format("would take {}, and a .glb holds less than 4 GiB; write an .obj or a .firma file",
                                    bytes_text(bytes)));
}

std::string glb_name(std::string_view name) {
    std::string good;
    while (!name.empty()) {
        const std::size_t length = name[0] == '\0' ? 0 : draw::utf8_length(name);
        if (length == 0) {
            good += "\xEF\xBF\xBD";
        } else {
            good += name.substr(0, length);
        }
        name.remove_prefix(length == 0 ? 1 : length);
    }
    return good;
}

std::array<double, 3> colour_of(std::string_view name) {
    if (name.empty()) return {0.5, 0.5, 0.5};
    const std::uint32_t hash = hash_of(name);
    const double hue = double(hash % 360) / 60;  // 0 .. 6, red to red
    const double value = 0.4 + 0.1 * double(hash / 360 % 4), saturation = 0.4 + 0.1 * double(hash / 1440 % 4);
    std::array<double, 3> colour;
    for (int k = 0; k < 3; ++k) {
        // Red is at 0, green at 2, blue at 4 of the circle: full for a third of it, none for another, straight between.
        const double apart = std::fabs(hue - 2 * k), away = std::min(apart, 6 - apart);
        colour[std::size_t(k)] = value * (1 - saturation * (1 - std::clamp(2 - away, 0.0, 1.0)));
    }
    return colour;
}

}  // namespace firma::cli
