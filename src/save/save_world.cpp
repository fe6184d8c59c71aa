// SPDX-License-Identifier: MIT
// A .firma file to disk: written aside, flushed, renamed, the folder flushed.
//
// The file aside has one name a target, and whoever writes it holds a lock on it that ends with the process. So what a
// killed one left is taken over, never two write it at once, and nothing piles up.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>

#include "firma/save.h"
#include "save/sync_folder.h"

namespace firma {
namespace {

Error cannot_write(const std::string& path, int reason) {
    return {ErrorCode::kCannotWrite, path, "cannot be written: " + std::generic_category().message(reason)};
}

/// Calls what a signal may interrupt until it is done.
template <class Call>
auto persist(const Call& call) {
    auto result = call();
    while (result < 0 && errno == EINTR) result = call();
    return result;
}

/// Without waiting for somebody to read from what may be a pipe; for files that says nothing.
constexpr int kToWrite = O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;

/// The file aside: open, locked, empty.
class Aside {
public:
    explicit Aside(std::string path) : path_(std::move(path)) {}
    ~Aside() {
        if (descriptor_ < 0) return;
        if (!renamed_) unlink(path_.c_str());  // still under the lock
        close(descriptor_);
    }
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;

    /// @return 0, or the system's reason; so with the others
    int open_locked() {
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

    void set_mode(mode_t mode) { [[maybe_unused]] const int done = fchmod(descriptor_, mode & 07777); }

    int write(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t count = persist([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
            if (count < 0) return errno;
            bytes = bytes.subspan(std::size_t(count));
        }
        return fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
    }

    int rename_to(const std::string& target) {
        if (rename(path_.c_str(), target.c_str()) != 0) return errno;
        renamed_ = true;
        return 0;
    }

private:
    bool is_at_path(int descriptor) const {
        struct stat here{}, there{};
        return fstat(descriptor, &here) == 0 && stat(path_.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
               here.st_ino == there.st_ino;
    }

    const std::string path_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

/// Makes of a path the one behind all links; leaves it where there is nothing yet.
/// @return 0, or the system's reason, as of a link that leads nowhere: to be followed, not replaced
int resolve(std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr), &std::free);
    const int reason = errno;
    struct stat status{};
    if (!real) return lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode) ? reason : 0;
    path = real.get();
    return 0;
}

int write_file(const std::vector<std::byte>& bytes, std::string target) {
    if (const int reason = resolve(target)) return reason;
    struct stat status{};
    const bool was_there = stat(target.c_str(), &status) == 0;
    if (was_there && S_ISDIR(status.st_mode)) return EISDIR;
    if (was_there && !S_ISREG(status.st_mode)) return EINVAL;  // never put in the place of a device
    if (was_there && access(target.c_str(), W_OK) != 0) return errno;
    Aside aside(target + ".part");
    if (const int reason = aside.open_locked()) return reason;
    if (was_there) aside.set_mode(status.st_mode);
    if (const int reason = aside.write(bytes)) return reason;
    if (const int reason = aside.rename_to(target)) return reason;
    return sync_folder_of(target);
}

}  // namespace

int sync_folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    const int descriptor = persist([&] { return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
    if (descriptor < 0) return errno == EACCES ? 0 : errno;  // a folder to write in, not to read
    const int reason = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
    close(descriptor);
    return reason;
}

std::optional<Error> save_world(const World& world, const std::string& path, const SaveOptions& options) {
    if (path.empty()) return Error{ErrorCode::kInvalid, "", "a file needs a name"};
    if (const int reason = write_file(pack_world(world, options), path)) return cannot_write(path, reason);
    return {};
}

}  // namespace firma
