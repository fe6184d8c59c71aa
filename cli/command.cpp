// SPDX-License-Identifier: MIT
// A thin wall before CLI11.
#include "cli/command.h"

#include <CLI/App.hpp>

namespace firma::cli {

Command::Command(CLI::App& app, const char* name, const char* help)
    : name_(name), app_(app.add_subcommand(name, help)->group("Verbs")) {}

void Command::add_argument(const char* name, std::string& value, const char* help, bool required) {
    app_->add_option(name, value, help)->required(required)->type_name("FILE");
}

void Command::add_option(const char* names, std::string& value, const char* type, const char* help, bool required) {
    app_->add_option(names, value, help)->required(required)->type_name(type);
}

void Command::add_choice(const char* names, std::string& value, const char* choice, const char* help) {
    const auto check = [choice](const std::string& given) {
        return given == choice ? "" : std::string("is ") + choice + " or not given, and not " + given;
    };
    app_->add_option(names, value, help)->type_name(choice)->check(check);
}

void Command::add_flag(const char* names, bool& value, const char* help) {
    app_->add_flag(names, value, help);
}

void Command::add_flag(const char* names, std::string& value, const char* help) {
    app_->add_flag(names, value, help);
}

void Command::set_footer(const std::string& text) {
    app_->footer(text);
}

bool Command::called() const {
    return app_->parsed();
}

}  // namespace firma::cli
