// SPDX-License-Identifier: MIT
// Arguments and words; file_server.h holds the server.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

#include "cli/file_server.h"
#include "cli/json.h"
#include "cli/numbers.h"

namespace firma::cli {

namespace {

struct ServeArguments {
    std::string folder, port = "8080";
    bool json = false;
};

constexpr const char* kServeFooter =
    R"(Only programs on this machine can ask (127.0.0.1), only with GET and HEAD, and only for regular files below the
folder: nothing through "..", through a link that leads out, or by a name that begins with a dot. No folder is
listed. Runs until Ctrl-C (SIGINT, SIGTERM, SIGHUP), which is code 0.

--json: url, folder, port, before anything is answered.
)";

int run(const ServeArguments& arguments) {
    const int port = int(count_option("--port", arguments.port, 0, 65535));
    hold_back_signals();
    FileServer server(arguments.folder, port);
    const std::string url = fmt::format("http://127.0.0.1:{}", server.port());
    if (arguments.json) {
        Json json;
        json["url"] = url;
        json["folder"] = arguments.folder;
        json["port"] = server.port();
        print(json_text(std::move(json)));
    } else {
        print(fmt::format("serving {} on {} (Ctrl-C ends)\n", arguments.folder, url));
    }
    server.run();
    return 0;
}

}  // namespace

Verb add_serve(CLI::App& app) {
    Command command(app, "serve", "Hands out the files of a folder over HTTP, to this machine only");
    const auto arguments = std::make_shared<ServeArguments>();
    command.add_argument("FOLDER", arguments->folder, "whose files to hand out", true);
    command.add_option("--port", arguments->port, "N", "to listen on, 0 .. 65535; 0: any free one (default: 8080)");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kServeFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
