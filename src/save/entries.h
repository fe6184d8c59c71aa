// SPDX-License-Identifier: MIT
// A section being read: entries of one size, and errors that name section and entry.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "save/container.h"

namespace firma {

/// Why reading ended; the first reason stays. Readers go on only while there is none.
class Damage {
public:
    explicit Damage(const std::string& name) : name_(name) {}

    /// @return false, for the caller to return
    bool report(SectionType section, std::uint64_t entry, const char* reason) {
        return report(ErrorCode::kMalformed, ": section " + section_name(section) + ", entry " + std::to_string(entry),
                      reason);
    }
    bool report(SectionType section, const char* reason) {
        return report(ErrorCode::kMalformed, ": section " + section_name(section), reason);
    }
    bool report(ErrorCode code, const std::string& place, std::string reason) {
        if (!error_) error_ = Error{code, name_ + place, std::move(reason)};
        return false;
    }
    const std::optional<Error>& error() const { return error_; }

private:
    const std::string& name_;
    std::optional<Error> error_;
};

/// Entries of one size in a section, taken in order.
class Entries {
public:
    Entries() = default;
    Entries(SectionType type, std::span<const std::byte> bytes, std::size_t size)
        : type_(type), bytes_(bytes), size_(size) {}

    SectionType type() const { return type_; }
    std::size_t count() const { return bytes_.size() / size_; }
    bool whole() const { return bytes_.size() % size_ == 0; }
    const std::byte* at(std::size_t entry) const { return bytes_.data() + entry * size_; }

    std::size_t taken() const { return taken_; }
    std::size_t left() const { return count() - taken_; }
    /// The next so many, of those left.
    const std::byte* take(std::size_t entries) {
        const std::byte* first = at(taken_);
        taken_ += entries;
        return first;
    }

private:
    SectionType type_ = 0;
    std::span<const std::byte> bytes_;
    std::size_t size_ = 1, taken_ = 0;
};

/// Texts one after the other, their lengths known.
class Texts {
public:
    explicit Texts(std::span<const std::byte> bytes) : left_(bytes) {}
    bool take(std::uint64_t length, std::string& text) {
        if (length > left_.size()) return false;
        text.reserve(std::size_t(length));
        for (const std::byte byte : left_.first(std::size_t(length))) text += char(byte);
        left_ = left_.subspan(std::size_t(length));
        return true;
    }
    bool all_taken() const { return left_.empty(); }

private:
    std::span<const std::byte> left_;
};

/// The sections of a file by type.
class Sections {
public:
    Sections(std::vector<Section> all, Damage& damage) : all_(std::move(all)), damage_(damage) {}

    /// Looks for a section, and remembers that it was asked for. Reports one that is missing, or that ends within an
    /// entry: then there are no entries.
    Entries entries(SectionType type, std::size_t size) {
        for (std::size_t k = 0; k < all_.size(); ++k) {
            if (all_[k].type != type) continue;
            asked_.push_back(type);
            const Entries entries(type, all_[k].bytes, size);
            if (entries.whole()) return entries;
            damage_.report(type, entries.count(), "the section ends within it");
            return {type, {}, size};
        }
        damage_.report(type, "is missing");
        return {type, {}, size};
    }

    bool has(SectionType type) const {
        return std::any_of(all_.begin(), all_.end(), [&](const Section& section) { return section.type == type; });
    }

    /// Reports a section that is none of `known` and marked as required: others are passed over.
    void refuse_unknown(std::span<const SectionType> known) {
        for (const Section& section : all_)
            if (section.required() && !has(known, section.type))
                damage_.report(ErrorCode::kUnsupported, ": section " + section_name(section.type),
                               "is needed to understand the file, and this Firma does not know it");
    }

    /// Reports one that is of `known`, and yet nobody asked for it.
    void refuse_unused(std::span<const SectionType> known) {
        for (const Section& section : all_)
            if (has(known, section.type) && !has(asked_, section.type))
                damage_.report(section.type, "is there without a reason");
    }

private:
    static bool has(std::span<const SectionType> types, SectionType type) {
        return std::find(types.begin(), types.end(), type) != types.end();
    }

    std::vector<Section> all_;
    std::vector<SectionType> asked_;
    Damage& damage_;
};

}  // namespace firma
