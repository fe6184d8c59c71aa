// SPDX-License-Identifier: MIT
// Where a glTF buffer's bytes come from.
#include "gltf/buffer_bytes.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "level/message.h"
#include "level/read_file.h"

namespace firma::gltf {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 32;  // of all buffers that are held apart from the file

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// Whether a file, links followed, lies in a folder or below it. What is not there is not known to lie elsewhere.
bool leads_out(const std::string& folder, const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code none;
    const fs::path file = fs::canonical(path, none);
    if (none) return false;  // reading it says why
    const fs::path home = fs::canonical(folder, none);
    return none || std::mismatch(home.begin(), home.end(), file.begin(), file.end()).first != home.end();
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
    for (int pads = 0; pads < 2 && text.ends_with('='); ++pads) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0) return std::nullopt;
        bits = bits << 6 | std::uint32_t(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += char(bits >> count & 0xFF);
    }
    return bytes;
}

std::optional<std::string> path_below(std::string_view uri) {
    std::string path;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        if (uri[k] != '%') {
            path += uri[k];
            continue;
        }
        const int high = k + 1 < uri.size() ? hex_digit(uri[k + 1]) : -1,
                  low = k + 2 < uri.size() ? hex_digit(uri[k + 2]) : -1;
        if (high < 0 || low < 0) return std::nullopt;
        path += char(high << 4 | low);
        k += 2;
    }
    for (const char c : path)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F || c == ':' || c == '\\') return std::nullopt;
    for (std::size_t first = 0; first <= path.size();) {
        const std::size_t end = std::min(path.find('/', first), path.size());
        const std::string_view part = std::string_view(path).substr(first, end - first);
        if (part.empty() || part == "..") return std::nullopt;
        first = end + 1;
    }
    return path;
}

Error Buffers::fail(ErrorCode code, std::string reason) const {
    return {code, name_ + ": buffer " + std::to_string(list_.size()), std::move(reason)};
}

Result<std::span<const std::byte>> Buffers::bytes_of(std::string_view uri) {
    std::string bytes;
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
            return fail(ErrorCode::kMalformed, "its data: URI is not base64");
        std::optional<std::string> decoded = decode_base64(uri.substr(comma + 1));
        if (!decoded) return fail(ErrorCode::kMalformed, "its data: URI is not base64");
        bytes = *std::move(decoded);
    } else {
        const std::optional<std::string> path = path_below(uri);
        if (!path) return fail(ErrorCode::kUnsupported, "names " + quote(uri) + ", which is no file beside this one");
        if (folder_.empty()) return fail(ErrorCode::kUnsupported, "lies in another file, " + quote(uri));
        if (leads_out(folder_, folder_ + *path))
            return fail(ErrorCode::kUnsupported,
                        "names " + quote(uri) + ", a link that leads out of the file's folder");
        Result<std::string> read = read_file(folder_ + *path);
        if (!read) return fail(read.error().code, quote(uri) + " " + read.error().reason);
        bytes = std::move(read).value();
    }
    held_bytes_ += bytes.size();
    if (held_bytes_ > kMostBytes) return fail(ErrorCode::kTooLarge, "makes more than 4 GiB of all buffers");
    const std::string& held = held_.emplace_back(std::move(bytes));
    return std::as_bytes(std::span(held));
}

std::optional<Error> Buffers::add(const std::optional<std::string_view>& uri, std::uint64_t length) {
    std::span<const std::byte> bytes;
    if (uri) {
        const Result<std::span<const std::byte>> found = bytes_of(*uri);
        if (!found) return found.error();
        bytes = found.value();
    } else {
        if (!list_.empty() || !chunks_.has_bin) return fail(ErrorCode::kMalformed, "says nowhere where its bytes are");
        bytes = chunks_.bin;
    }
    if (bytes.size() < length)
        return fail(ErrorCode::kMalformed,
                    "has " + std::to_string(bytes.size()) + " of its " + std::to_string(length) + " bytes");
    list_.push_back(bytes.first(std::size_t(length)));
    return std::nullopt;
}

}  // namespace firma::gltf
