// SPDX-License-Identifier: MIT
#include "base/file_aside.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <memory>

namespace firma {
namespace {

/// Calls what a signal may interrupt until it is done.
template <class Call>
auto persist(const Call& call) {
    auto result = call();
    while (result < 0 && errno == EINTR) result = call();
    return result;
}

/// Without waiting for somebody to read from what may be a pipe; for files that says nothing.
constexpr int kToWrite = O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;

/// File systems that cannot flush count as having done so.
int flushed(int descriptor) {
    return fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

/// Flushes the folder that a file lies in, so that its name is there after a power cut as well.
int flush_folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    const int descriptor = persist([&] { return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
    if (descriptor < 0) return errno == EACCES ? 0 : errno;  // a folder to write in, not to read
    const int reason = flushed(descriptor);
    close(descriptor);
    return reason;
}

}  // namespace

FileAside::~FileAside() {
    if (descriptor_ < 0) return;
    if (!renamed_) unlink(path_.c_str());  // still under the lock
    close(descriptor_);
}

int FileAside::open_locked() {
    for (;;) {
        const int descriptor = persist([&] { return open(path_.c_str(), kToWrite, 0666); });
        if (descriptor < 0) return errno;
        struct stat status{};
        if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
            close(descriptor);
            return EINVAL;  // somebody's pipe or device
        }
        if (persist([&] { return flock(descriptor, LOCK_EX); }) != 0 && errno != ENOLCK && errno != ENOTSUP) {
            const int reason = errno;
            close(descriptor);
            return reason;
        }
        if (is_at_path(descriptor)) {
            descriptor_ = descriptor;
            break;
        }
        close(descriptor);  // whoever had the lock has renamed or removed it
    }
    return ftruncate(descriptor_, 0) == 0 ? 0 : errno;
}

int FileAside::open_new() {
    descriptor_ = persist([&] { return open(path_.c_str(), kToWrite | O_EXCL, 0666); });
    return descriptor_ < 0 ? errno : 0;
}

void FileAside::set_mode(mode_t mode) {
    [[maybe_unused]] const int done = fchmod(descriptor_, mode & 07777);
}

int FileAside::write(std::span<const std::byte> bytes) {
    return write_all(descriptor_, bytes);
}

int FileAside::flush() {
    return flushed(descriptor_);
}

int FileAside::rename_to(const std::string& target) {
    if (rename(path_.c_str(), target.c_str()) != 0) return errno;
    renamed_ = true;
    return flush_folder_of(target);
}

bool FileAside::is_at_path(int descriptor) const {
    struct stat here{}, there{};
    return fstat(descriptor, &here) == 0 && stat(path_.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
           here.st_ino == there.st_ino;
}

int write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = persist([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
        if (count < 0) return errno;
        bytes = bytes.subspan(std::size_t(count));
    }
    return 0;
}

int resolve_links(std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr), &std::free);
    const int reason = errno;
    struct stat status{};
    if (!real) return lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode) ? reason : 0;
    path = real.get();
    return 0;
}

int write_whole_file(const std::string& path, const std::function<int(FileAside&)>& write) {
    std::string target = path;
    if (const int reason = resolve_links(target)) return reason;
    struct stat status{};
    const bool was_there = stat(target.c_str(), &status) == 0;
    if (was_there && S_ISDIR(status.st_mode)) return EISDIR;
    if (was_there && !S_ISREG(status.st_mode)) return EINVAL;  // never put in the place of a device
    if (was_there && access(target.c_str(), W_OK) != 0) return errno;
    FileAside aside(target + ".part");
    if (const int reason = aside.open_locked()) return reason;
    if (was_there) aside.set_mode(status.st_mode);
    if (const int reason = write(aside)) return reason;
    if (const int reason = aside.flush()) return reason;
    return aside.rename_to(target);
}

}  // namespace firma
