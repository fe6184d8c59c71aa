// SPDX-License-Identifier: MIT
// What a log is: the world it begins from, commands in order, checkpoints.
#include "firma/edit_log.h"

#include <utility>

#include "log/command_bytes.h"
#include "log/hash_rules.h"
#include "world/world_data.h"

namespace firma {

EditLog::EditLog(const World& level)
    : level_hash_(hash_world(level)),
      rules_hash_(hash_rules(level.data().rules ? *level.data().rules : CarveRules(), level.data().anchors.get())),
      level_edits_(level.solid().edits()),
      last_number_(level_edits_) {}

std::optional<Error> EditLog::append(EditCommand command) {
    if (std::optional<Error> error = judge_command(command, last_number_)) return error;
    last_number_ = firma::last_number(command);
    commands_.push_back(std::move(command));
    return {};
}

void EditLog::add_checkpoint(const World& world) {
    if (!checkpoints_.empty() && checkpoints_.back().commands == commands_.size()) checkpoints_.pop_back();
    checkpoints_.push_back({commands_.size(), hash_world(world)});
}

}  // namespace firma
