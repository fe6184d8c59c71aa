// SPDX-License-Identifier: MIT
// The command line `firma`: finds the verb, runs it, turns whatever goes wrong into one sentence and code 2.
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/failure.h"
#include "cli/verb.h"
#include "cli/verbs.h"

namespace firma::cli {

namespace {

constexpr const char* kFooter = R"(`firma VERB --help` tells what a verb takes and writes.

Metres, seconds; right-handed; lines of files count from 1, a header included, everything else from 0.
Exit codes: 0 done; 1 `check` found faults, `log verify`, `replay` or `demo` a disagreement; 2 a bad call or bad input.
)";

/// A missing descriptor would be given to the next file opened, and the level's bytes would land in it.
void hold_standard_descriptors() {
    for (int descriptor = 0; descriptor <= 2; ++descriptor) {
        if (fcntl(descriptor, F_GETFD) == -1) open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
    }
}

/// The first argument when it looks like a verb but is none.
void refuse_unknown_verb(int argc, char** argv, const std::vector<Verb>& verbs) {
    if (argc < 2) throw Failure("", "which verb? (firma --help lists them)");
    const std::string word = argv[1];
    if (word.starts_with('-') && word != "-") return;
    std::string names;
    for (const Verb& verb : verbs) {
        if (verb.command.name() == word) return;
        names += (names.empty() ? "" : ", ") + verb.command.name();
    }
    throw Failure(word, "is no verb; there are " + names);
}

/// `--rooms auto` becomes one word: for `draw` --rooms alone is a flag, and the next word may be its level.
std::vector<std::string> gather_words(int argc, char** argv) {
    std::vector<std::string> words;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        if (word == "auto" && !words.empty() && words.back() == "--rooms")
            words.back() += "=auto";
        else
            words.push_back(word);
    }
    std::reverse(words.begin(), words.end());  // as the parser wants them
    return words;
}

/// The place of a call that does not parse: the verb, if it got that far.
std::string place_of(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands()) return command->get_name();
    return "";
}

/// The parser says "--rooms: 1 required auto missing" of an option without its value.
std::string reason_of(const CLI::ParseError& error) {
    constexpr std::string_view kBefore = ": 1 required ", kBehind = " missing";
    const std::string text = error.what();
    const std::size_t at = text.find(kBefore);
    if (at == std::string::npos || !text.ends_with(kBehind)) return text;
    const std::size_t value = at + kBefore.size();
    return text.substr(0, at) + ": wants a value: " + text.substr(value, text.size() - kBehind.size() - value);
}

int run(int argc, char** argv) {
    CLI::App app("Firma: casts particles and spheres through levels and carves craters into them, exactly.", "firma");
    app.footer(kFooter);
    app.set_version_flag("--version", "firma " FIRMA_VERSION);
    app.require_subcommand(0, 1);
    app.get_formatter()->column_width(30);
    app.get_formatter()->label("SUBCOMMAND", "VERB");
    app.get_formatter()->label("Subcommands", "Verbs");
    const std::vector<Verb> verbs{add_info(app), add_check(app), add_cast(app),     add_carve(app),
                                  add_log(app),  add_walk(app),  add_simulate(app), add_replay(app),
                                  add_draw(app), add_serve(app), add_demo(app)};
    refuse_unknown_verb(argc, argv, verbs);
    try {
        app.parse(gather_words(argc, argv));
    } catch (const CLI::CallForHelp&) {
        print(app.help());
        return 0;
    } catch (const CLI::CallForVersion& version) {
        print(std::string(version.what()) + "\n");
        return 0;
    } catch (const CLI::ParseError& error) {
        const std::string place = place_of(app);
        throw Failure(
            place, fmt::format("{} (firma {}{}--help tells more)", reason_of(error), place, place.empty() ? "" : " "));
    }
    for (const Verb& verb : verbs) {
        if (verb.command.called()) return verb.run();
    }
    throw Failure("", "which verb? (firma --help lists them)");
}

int complain(const char* text) noexcept {
    std::fputs("firma: ", stderr);
    std::fputs(text, stderr);
    std::fputs("\n", stderr);
    return 2;
}

}  // namespace

}  // namespace firma::cli

int main(int argc, char** argv) {
    using firma::cli::complain;
    try {
        firma::cli::hold_standard_descriptors();
        firma::cli::end_cleanly_on_signals();
        return firma::cli::run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory");
    } catch (const std::exception& error) {
        return complain(error.what());
    } catch (...) {
        return complain("something went wrong that has no name");
    }
}
