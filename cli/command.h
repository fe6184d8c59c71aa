// SPDX-License-Identifier: MIT
// How a verb says what it takes. Values stay text: numbers.h reads them, with better words than a parser has.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace firma::cli {

/// A verb of the command line. Only command.cpp and main.cpp see CLI11, which is slow to compile.
class Command {
public:
    /// Adds `firma NAME`.
    Command(CLI::App& app, const char* name, const char* help);

    /// A word without dashes. What is bound to it must stay where it is until the verb has run; so with the others.
    void add_argument(const char* name, std::string& value, const char* help, bool required);
    /// @param names  "--skin" or "-o,--out"
    /// @param type   what to write for the value in the help
    void add_option(const char* names, std::string& value, const char* type, const char* help, bool required = false);
    void add_flag(const char* names, bool& value, const char* help);
    /// An option with one value that is understood: what else is given is refused before anything is found missing.
    void add_choice(const char* names, std::string& value, const char* choice, const char* help);
    /// A flag that may be given a value, as `--flag=value`: "true" without one.
    void add_flag(const char* names, std::string& value, const char* help);
    /// What stands below the options: columns, units, exit codes.
    void set_footer(const std::string& text);

    const std::string& name() const { return name_; }
    /// Whether it is the verb of this call.
    bool called() const;

private:
    std::string name_;
    CLI::App* app_;
};

}  // namespace firma::cli
