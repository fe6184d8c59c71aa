// SPDX-License-Identifier: MIT
// A .firma file from disk: mapped where that is possible, so that its bytes are read once, by the checksums, and never
// copied as a whole; else read.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <system_error>

#include "firma/save.h"

namespace firma {
namespace {

Error cannot_read(const std::string& path, int reason) {
    return {ErrorCode::kCannotRead, path, "cannot be read: " + std::generic_category().message(reason)};
}

/// An open file; closes it.
class File {
public:
    explicit File(const std::string& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~File() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

/// The bytes of a regular file in memory, as they are asked for.
class Mapping {
public:
    Mapping(int descriptor, std::size_t size) : size_(size) {
        memory_ = size == 0 ? MAP_FAILED : mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
        if (works()) posix_madvise(memory_, size, POSIX_MADV_WILLNEED);
    }
    ~Mapping() {
        if (works()) munmap(memory_, size_);
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;
    bool works() const { return memory_ != MAP_FAILED; }
    std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(memory_), size_}; }

private:
    void* memory_;
    std::size_t size_;
};

/// What cannot be mapped, a pipe or an empty file, in pieces; stops at bytes that begin no .firma file.
Result<World> read_whole(int descriptor, const std::string& path) {
    constexpr std::size_t kPiece = std::size_t(1) << 20;
    std::vector<std::byte> bytes;
    for (;;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + kPiece);
        const ssize_t count = read(descriptor, bytes.data() + before, kPiece);
        bytes.resize(before + std::size_t(count > 0 ? count : 0));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannot_read(path, errno);
        if (count == 0 || (before == 0 && bytes.size() >= 8 && !is_firma_file(bytes))) return unpack_world(bytes, path);
    }
}

}  // namespace

Result<World> load_world(const std::string& path) {
    const File file(path);
    if (file.descriptor() < 0) return cannot_read(path, errno);
    struct stat status{};
    if (fstat(file.descriptor(), &status) != 0) return cannot_read(path, errno);
    if (S_ISDIR(status.st_mode)) return cannot_read(path, EISDIR);
    if (S_ISREG(status.st_mode) && std::uint64_t(status.st_size) <= std::numeric_limits<std::size_t>::max()) {
        const Mapping mapping(file.descriptor(), std::size_t(status.st_size));
        if (mapping.works()) return unpack_world(mapping.bytes(), path);
    }
    return read_whole(file.descriptor(), path);
}

}  // namespace firma
