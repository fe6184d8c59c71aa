// SPDX-License-Identifier: MIT
// Writes aside and renames; signals clean up by the names in `removed`.
#include "cli/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <span>
#include <system_error>

#include "cli/failure.h"

namespace firma::cli {

namespace {

constexpr std::size_t kBufferBytes = 1 << 20;

// The handler may run on any thread at any moment, so a name is set before its file is made and dropped after it is
// gone.
struct Removed {
    char name[PATH_MAX + 64];
    std::atomic<bool> used{false};
};
Removed removed[8];

/// A place for a name; -1 when all are taken.
int free_slot() {
    for (int slot = 0; slot < int(std::size(removed)); ++slot)
        if (!removed[slot].used.load()) return slot;
    return -1;
}

extern "C" void on_signal(int) {
    for (const Removed& aside : removed)
        if (aside.used.load()) unlink(aside.name);
    constexpr char kText[] = "\nfirma: stopped by a signal\n";
    [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, kText, sizeof kText - 1);
    _exit(2);
}

/// Number of the descriptor that a path like /dev/fd/5 stands for, or -1. Opening such a path anew would cut the file
/// short.
int descriptor_named(const std::string& path) {
    if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        const std::string digits = path.substr(folder.size());
        if (digits.empty() || digits.size() > 6 || digits.find_first_not_of("0123456789") != std::string::npos)
            return -1;
        return std::atoi(digits.c_str());
    }
    return -1;
}

}  // namespace

void end_cleanly_on_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now{};
        sigaction(number, nullptr, &now);
        if (now.sa_handler == SIG_IGN) continue;  // nohup and background jobs of a shell
        struct sigaction action{};
        action.sa_handler = on_signal;
        sigaction(number, &action, nullptr);
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool is_standard_output(const std::string& path) {
    return descriptor_named(path) == STDOUT_FILENO;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && !std::filesystem::is_directory(folder, error))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw Failure(folder, "cannot be made: " + error.message());
}

void refuse_overwriting(const std::string& out, const std::string& input) {
    std::error_code none;
    if (std::filesystem::is_regular_file(out, none) && std::filesystem::equivalent(out, input, none))
        throw Failure(out, "is an input as well; write to another file");
}

AtomicFile::AtomicFile(const std::string& path) : name_(path) {
    if (path.empty()) throw Failure("--out", "is an empty name");
    if (path.size() >= PATH_MAX) throw Failure("--out", std::strerror(ENAMETOOLONG));
    buffer_.reserve(kBufferBytes);
    if (const int descriptor = descriptor_named(path); descriptor >= 0) {
        file_ = dup(descriptor);
        if (file_ < 0) fail(errno);
        return;
    }
    struct stat status{};
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) throw Failure(path, "is a folder; name a file");
        if (access(path.c_str(), W_OK) != 0) fail(errno);
        if (S_ISREG(status.st_mode)) {
            std::string target = path;
            if (const int reason = resolve_links(target)) fail(reason);
            open_aside(target);
            aside_->set_mode(status.st_mode);
        } else {
            file_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
            if (file_ < 0) fail(errno);
        }
        return;
    }
    if (errno != ENOENT) fail(errno);
    if (lstat(path.c_str(), &status) == 0) throw Failure(path, "is a link that leads nowhere");
    if (path.back() == '/') throw Failure(path, "is a folder; name a file");
    open_aside(path);
}

void AtomicFile::open_aside(const std::string& target) {
    const std::size_t slash = target.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
    const int slot = free_slot();
    if (slot < 0) throw Failure(name_, "cannot be written: too many outputs at once");
    Removed& mine = removed[slot];
    for (int attempt = 0;; ++attempt) {
        const std::string aside =
            folder + ".firma-" + std::to_string(getpid()) + "-" + std::to_string(attempt) + ".part";
        if (aside.size() >= sizeof mine.name) fail(ENAMETOOLONG);
        std::memcpy(mine.name, aside.c_str(), aside.size() + 1);
        mine.used = true;
        const int reason = aside_.emplace(aside).open_new();
        if (reason == 0) break;
        mine.used = false;
        if (reason != EEXIST || attempt == 100) fail(reason);
    }
    target_ = target;
    slot_ = slot;
}

AtomicFile::~AtomicFile() {
    if (file_ >= 0) close(file_);
    aside_.reset();
    if (slot_ >= 0) removed[slot_].used = false;
}

void AtomicFile::write(std::string_view text) {
    if (buffer_.size() + text.size() > kBufferBytes) {
        put(buffer_.data(), buffer_.size());
        buffer_.clear();
    }
    if (text.size() >= kBufferBytes) {
        put(text.data(), text.size());
    } else {
        buffer_ += text;
    }
}

void AtomicFile::finish() {
    if (finished_) return;
    put(buffer_.data(), buffer_.size());
    buffer_.clear();
    finished_ = true;
    if (!aside_) return;
    if (const int reason = aside_->flush()) fail(reason);
}

void AtomicFile::commit() {
    finish();
    if (!aside_) return;
    if (const int reason = aside_->rename_to(target_)) fail(reason);
    aside_.reset();
    removed[slot_].used = false;
    slot_ = -1;
}

void AtomicFile::put(const char* from, std::size_t size) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(from, size));
    if (const int reason = aside_ ? aside_->write(bytes) : write_all(file_, bytes)) fail(reason);
}

void AtomicFile::fail(int code) const {
    throw Failure(name_, std::string("cannot be written: ") + std::strerror(code));
}

}  // namespace firma::cli
