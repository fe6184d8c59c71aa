// SPDX-License-Identifier: MIT
// Notes of a reader.
#include "brush/note_list.h"

namespace firma {

void NoteList::add(std::string_view what, std::string_view place) {
    const auto known = index_.find(std::string(what));
    if (known != index_.end()) {
        ++notes_[known->second].count;
    } else if (notes_.size() < kMostKinds) {
        index_.emplace(what, notes_.size());
        notes_.push_back({std::string(what), std::string(place), 1});
    } else {
        ++further_;
    }
}

std::vector<std::string> NoteList::texts() const {
    std::vector<std::string> texts;
    for (const Note& note : notes_) {
        texts.push_back(note.count == 1
                            ? note.what + ": " + note.place
                            : note.what + ": first " + note.place + ", " + std::to_string(note.count) + " in all");
    }
    if (further_ != 0) texts.push_back(std::to_string(further_) + " further notes of other kinds");
    return texts;
}

}  // namespace firma
