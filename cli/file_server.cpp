// SPDX-License-Identifier: MIT
// cpp-httplib carries the requests; what may be read is decided here.
#include "cli/file_server.h"

#include <httplib.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "cli/connection_threads.h"
#include "cli/failure.h"

namespace firma::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kHost = "127.0.0.1";
// Each open connection keeps a thread: six of a browser, and those that say nothing until their time is over.
constexpr std::size_t kMostConnections = 512;

constexpr std::array<std::pair<std::string_view, const char*>, 14> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".wasm", "application/wasm"},  // else browsers do not compile it while it arrives
    {".json", "application/json"},
    {".map", "application/json"},
    {".obj", "model/obj"},
    {".txt", "text/plain; charset=utf-8"},
    {".csv", "text/csv; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".ico", "image/x-icon"},
}};

const char* type_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    for (const auto& [known, type] : kTypes) {
        if (ending == known) return type;
    }
    return "application/octet-stream";
}

sigset_t ending_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, number);
    return signals;
}

/// "localhost:8080" -> "localhost"
std::string_view host_name(std::string_view host) {
    return host.substr(0, host.rfind(':'));
}

bool is_this_machine(const std::string& host) {
    const std::string_view name = host_name(host);
    return name == kHost || name == "localhost";
}

/// Whether a path, decoded, is a list of plain names: no "..", nothing hidden, nothing that ends a C string early.
bool has_plain_names(std::string_view path) {
    if (path.empty() || path[0] != '/' || path.find('\0') != std::string_view::npos) return false;
    for (std::size_t slash = 0; slash != std::string_view::npos; slash = path.find('/', slash + 1)) {
        if (path.substr(slash + 1, 1) == ".") return false;
    }
    return true;
}

bool is_below(const fs::path& folder, const fs::path& path) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// The file a request means, links resolved; nothing when there is none that may be read.
std::optional<fs::path> file_of(const fs::path& folder, const std::string& path) {
    if (!has_plain_names(path)) return {};
    std::error_code error;
    const fs::path file = fs::canonical(folder / (path.substr(1) + (path.back() == '/' ? "index.html" : "")), error);
    if (error || !is_below(folder, file) || !fs::is_regular_file(file, error) || error) return {};
    return file;
}

std::optional<std::string> read_whole(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file.is_open() || file.bad()) return {};
    return bytes;
}

void refuse(httplib::Response& response, int status, const char* reason) {
    response.status = status;
    response.set_content(std::string(reason) + "\n", "text/plain; charset=utf-8");
}

void answer(const fs::path& folder, const httplib::Request& request, httplib::Response& response) {
    // Files are handed out whole, as HTTP allows: the library serves ranges without a look at where a file ends. The
    // request is the library's own variable, const only in here.
    const_cast<httplib::Request&>(request).ranges.clear();
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Cache-Control", "no-cache");
    // A page of its own, cut off from others: browsers then give it a clock of 5 us instead of 100.
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cross-Origin-Embedder-Policy", "require-corp");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    if (!is_this_machine(request.get_header_value("Host"))) return refuse(response, 403, "only for this machine");
    if (request.method != "GET" && request.method != "HEAD") {
        response.set_header("Allow", "GET, HEAD");
        return refuse(response, 405, "only GET and HEAD");
    }
    const std::optional<fs::path> file = file_of(folder, request.path);
    if (!file) return refuse(response, 404, "not found");
    std::optional<std::string> bytes = read_whole(*file);
    if (!bytes) return refuse(response, 404, "not found");
    if (bytes->empty()) return response.set_content("", type_of(*file));
    // By a provider, as the library would compress what is set at once: for seconds, and nobody gains by it here.
    const auto held = std::make_shared<const std::string>(std::move(*bytes));
    response.set_content_provider(
        held->size(), type_of(*file), [held](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            return offset < held->size() && sink.write(held->data() + offset, std::min(length, held->size() - offset));
        });
}

}  // namespace

struct FileServer::State {
    fs::path folder;
    httplib::Server server;
};

FileServer::FileServer(const std::string& folder, int port) : state_(std::make_unique<State>()) {
    std::error_code error;
    state_->folder = fs::canonical(folder, error);
    if (error) throw Failure(folder, error.message());
    if (!fs::is_directory(state_->folder)) throw Failure(folder, "is no folder");

    httplib::Server& server = state_->server;
    socket_t socket = -1;
    // Without SO_REUSEPORT, which the library sets by itself: a port that is taken is to be an error.
    server.set_socket_options([&socket](socket_t opened) {
        socket = opened;
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.new_task_queue = [] { return new ConnectionThreads(kMostConnections); };
    // A browser that uses a connection just as its time is over shows an error in place of the page: so each serves one
    // request, and one that was opened ahead of time has a while to make it.
    server.set_keep_alive_max_count(1);
    server.set_keep_alive_timeout(4);  // seconds: also how long the end may take
    server.set_read_timeout(5);
    server.set_payload_max_length(0);
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        answer(state_->folder, request, response);
        return httplib::Server::HandlerResponse::Handled;
    });
    port_ = port == 0 ? server.bind_to_any_port(kHost) : (server.bind_to_port(kHost, port) ? port : -1);
    if (port_ <= 0)
        throw Failure("--port", std::to_string(port) + " on " + kHost + " cannot be had: taken by another program, " +
                                    "or not allowed; try another, or 0 for any");
    // The library lets five wait to be accepted; of more at once some would try again after a second.
    listen(socket, int(kMostConnections));
    server.set_socket_options([](socket_t) {});
}

FileServer::~FileServer() = default;

void FileServer::run() {
    std::atomic<bool> ended = false;
    std::thread answering([this, &ended] {
        state_->server.listen_after_bind();
        ended = true;
        kill(getpid(), SIGTERM);  // where it ended by itself, run() is still waiting for a signal
    });
    // stop() is lost on a server that does not run yet.
    while (!state_->server.is_running() && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const sigset_t signals = ending_signals();
    int number = 0;
    sigwait(&signals, &number);
    state_->server.stop();
    answering.join();
}

void hold_back_signals() {
    const sigset_t signals = ending_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace firma::cli
