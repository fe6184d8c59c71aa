// SPDX-License-Identifier: MIT
// Notes of a reader.
#include "brush/note_list.h"

namespace firma {

/// The note of this kind, counted up; null when there are too many kinds.
NoteList::Note* NoteList::note(std::string_view what, std::string_view place) {
    const auto known = index_.find(std::string(what));
    if (known != index_.end()) {
        ++notes_[known->second].count;
        return &notes_[known->second];
    }
    if (notes_.size() == kMostKinds) {
        ++further_;
        return nullptr;
    }
    index_.emplace(what, notes_.size());
    notes_.push_back({std::string(what), std::string(place), 1, {}});
    return &notes_.back();
}

void NoteList::add(std::string_view what, std::string_view place) {
    note(what, place);
}

void NoteList::leave_out(std::string_view what, std::string_view things, std::string_view place) {
    if (Note* const found = note(what, place))
        found->things = things;
    else
        ++further_left_out_;
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

std::vector<Omission> NoteList::omissions() const {
    std::vector<Omission> omissions;
    for (const Note& note : notes_)
        if (!note.things.empty()) omissions.push_back({note.things, note.count, note.place});
    if (further_left_out_ != 0) omissions.push_back({"things of other kinds", further_left_out_, ""});
    return omissions;
}

}  // namespace firma
