// SPDX-License-Identifier: MIT
// Notes of a reader, for people: each kind once, with its first place and how often it came.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "firma/level.h"

namespace firma {

/// A hostile file cannot make it long: kinds beyond kMostKinds are only counted.
class NoteList {
public:
    static constexpr std::size_t kMostKinds = 256;

    void add(std::string_view what, std::string_view place);

    /// The same of a thing that casts would meet in its game and are not to meet here.
    /// @param things  what it is, in the plural: "patches of 'func_door'"; the same whenever `what` is
    void leave_out(std::string_view what, std::string_view things, std::string_view place);

    /// "what: place" or "what: first place, 17 in all", in order of first coming.
    std::vector<std::string> texts() const;

    /// Those left out, in order of first coming.
    std::vector<Omission> omissions() const;

private:
    struct Note {
        std::string what, place;
        std::uint64_t count = 0;
        std::string things;  ///< of those left out
    };
    Note* note(std::string_view what, std::string_view place);

    std::vector<Note> notes_;
    std::unordered_map<std::string, std::size_t> index_;
    std::uint64_t further_ = 0, further_left_out_ = 0;
};

}  // namespace firma
