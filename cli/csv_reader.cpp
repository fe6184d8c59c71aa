// SPDX-License-Identifier: MIT
// One pass over the text; nothing is copied.
#include "cli/csv_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "cli/failure.h"
#include "cli/numbers.h"

namespace firma::cli {

namespace {

struct Descriptor {
    int file;
    ~Descriptor() {
        if (file >= 0) close(file);
    }
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

}  // namespace

std::string shown(std::string_view text) {
    std::string out(text.substr(0, 40));
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    }
    return text.size() > 40 ? out + "..." : out;
}

std::string read_file(const std::string& path) {
    const Descriptor in{path == "-" ? dup(STDIN_FILENO) : open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (in.file < 0) throw Failure(path, std::strerror(errno));
    struct stat status{};
    if (fstat(in.file, &status) == 0 && S_ISDIR(status.st_mode)) throw Failure(path, "is a folder");
    std::string text;
    if (S_ISREG(status.st_mode)) text.reserve(std::size_t(status.st_size) + 1);
    for (std::size_t held = 0;;) {
        const std::size_t room = std::max<std::size_t>(text.capacity() - held, 1 << 16);
        text.resize(held + room);
        const ssize_t got = ::read(in.file, text.data() + held, room);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw Failure(path, std::string("cannot be read: ") + std::strerror(errno));
        held += std::size_t(got);
        text.resize(held);
        if (got == 0) return text;
    }
}

CsvReader::CsvReader(std::string_view text, std::string name, std::span<const std::string_view> columns,
                     std::span<const std::string_view> optional)
    : rest_(text), name_(std::move(name)), columns_(columns.begin(), columns.end()), required_(columns.size()) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // spreadsheets write one
    if (!next_line()) throw Failure(name_ + ":1", "the file is empty; a header is required");
    split();
    for (const std::string_view field : fields_) {
        const bool is_optional = std::find(optional.begin(), optional.end(), field) != optional.end();
        if (is_optional && !has_optional()) columns_.insert(columns_.end(), optional.begin(), optional.end());
        if (is_optional || std::find(columns.begin(), columns.end(), field) != columns.end()) continue;
        const std::string also = optional.empty() ? "" : fmt::format(", and may have {}", fmt::join(optional, ","));
        fail(fmt::format("'{}' is no column; the header must be {}{}", shown(field), fmt::join(columns, ","), also));
    }
    for (const std::string_view column : columns_) {
        const auto found = std::find(fields_.begin(), fields_.end(), column);
        if (found == fields_.end()) fail(fmt::format("the header lacks '{}'", column));
        if (std::find(found + 1, fields_.end(), column) != fields_.end())
            fail(fmt::format("the header has '{}' twice", column));
        place_.push_back(std::size_t(found - fields_.begin()));
    }
}

bool CsvReader::next() {
    if (!next_line()) return false;
    if (trimmed(row_).empty()) fail("an empty line");
    split();
    if (fields_.size() != columns_.size())
        fail(fmt::format("{} field{} where the header has {}", fields_.size(), fields_.size() == 1 ? "" : "s",
                         columns_.size()));
    return true;
}

double CsvReader::number(std::size_t column) const {
    const std::string_view text = at(column);
    const std::optional<double> value = read_number(text);
    if (value) return *value;
    if (text.empty()) fail(fmt::format("{} is empty", columns_[column]));
    fail(fmt::format("{}: '{}' is not a finite decimal number", columns_[column], shown(text)));
}

std::size_t CsvReader::most_rows() const {
    return std::size_t(std::count(rest_.begin(), rest_.end(), '\n')) + 1;
}

void CsvReader::fail(const std::string& reason) const {
    throw Failure(fmt::format("{}:{}", name_, line_), reason);
}

bool CsvReader::next_line() {
    if (rest_.empty()) return false;
    ++line_;
    const std::size_t end = rest_.find('\n');
    row_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (row_.ends_with('\r')) row_.remove_suffix(1);
    return true;
}

void CsvReader::split() {
    fields_.clear();
    for (std::string_view left = row_;;) {
        const std::size_t comma = left.find(',');
        fields_.push_back(trimmed(left.substr(0, comma)));
        if (comma == std::string_view::npos) return;
        left.remove_prefix(comma + 1);
    }
}

}  // namespace firma::cli
