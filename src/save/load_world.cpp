// SPDX-License-Identifier: MIT
// A .firma file from disk, read into memory first: a mapping would end the program when someone else cuts the file.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>

#include "base/open_file.h"
#include "firma/save.h"
#include "save/container.h"
#include "save/little_endian.h"

namespace firma {
namespace {

/// Read before anything is believed about the size of a file.
constexpr std::size_t kFirstPiece = std::size_t(1) << 20;
/// A single read() takes no more.
constexpr std::size_t kPiece = std::size_t(1) << 30;

Error cannot_read(const std::string& path, int reason) {
    return {ErrorCode::kCannotRead, path, "cannot be read: " + std::generic_category().message(reason)};
}

/// An open file; closes it.
class File {
public:
    explicit File(const std::string& path) : descriptor_(open_descriptor(path)) {}
    ~File() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

/// The bytes read so far. By malloc, as a vector would write zeros first, and realloc moves pages instead of bytes.
class Bytes {
public:
    std::span<const std::byte> all() const { return {memory_.get(), size_}; }

    /// Reads until there are `size` bytes, or the file ends.
    /// @return errno on failure
    std::optional<int> read_up_to(int descriptor, std::size_t size) {
        auto* grown = static_cast<std::byte*>(std::realloc(memory_.get(), std::max<std::size_t>(size, 1)));
        if (!grown) return ENOMEM;
        static_cast<void>(memory_.release());
        memory_.reset(grown);
        while (size_ < size) {
            const ssize_t count = read(descriptor, memory_.get() + size_, std::min(size - size_, kPiece));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return errno;
            if (count == 0) break;
            size_ += std::size_t(count);
        }
        return std::nullopt;
    }

private:
    struct Free {
        void operator()(std::byte* memory) const { std::free(memory); }
    };
    std::unique_ptr<std::byte, Free> memory_;
    std::size_t size_ = 0;
};

/// Whether the head of a file says that it has so many bytes; where it does not, its beginning is enough for the error.
bool is_said_to_have(std::span<const std::byte> head, std::uint64_t size) {
    return is_firma_file(head) && head.size() >= kHeadBytes && read_u64(head.data() + 16) == size;
}

Result<World> load_regular(int descriptor, std::uint64_t size, const std::string& path) {
    Bytes bytes;
    std::uint64_t wanted = std::min<std::uint64_t>(size, kFirstPiece);
    if (const auto failed = bytes.read_up_to(descriptor, std::size_t(wanted))) return cannot_read(path, *failed);
    if (wanted < size && is_said_to_have(bytes.all(), size)) {
        wanted = size;
        if (wanted > std::numeric_limits<std::size_t>::max()) return cannot_read(path, ENOMEM);
        if (const auto failed = bytes.read_up_to(descriptor, std::size_t(wanted))) return cannot_read(path, *failed);
    }
    if (bytes.all().size() < wanted)
        return Error{ErrorCode::kCannotRead, path,
                     "cannot be read: cut short meanwhile, to " + std::to_string(bytes.all().size()) + " of " +
                         std::to_string(size) + " bytes"};
    return unpack_world(bytes.all(), path);
}

/// A pipe or the like, of which nobody knows the size; stops at bytes that begin no .firma file.
Result<World> load_stream(int descriptor, const std::string& path) {
    Bytes bytes;
    for (std::size_t wanted = 8;; wanted = std::max(2 * wanted, kFirstPiece)) {
        if (const auto failed = bytes.read_up_to(descriptor, wanted)) return cannot_read(path, *failed);
        if (bytes.all().size() < wanted || !is_firma_file(bytes.all())) return unpack_world(bytes.all(), path);
    }
}

}  // namespace

Result<World> load_world(const std::string& path) {
    const File file(path);
    if (file.descriptor() < 0) return cannot_read(path, errno);
    struct stat status{};
    if (fstat(file.descriptor(), &status) != 0) return cannot_read(path, errno);
    if (S_ISDIR(status.st_mode)) return cannot_read(path, EISDIR);
    if (S_ISREG(status.st_mode) && status.st_size > 0)
        return load_regular(file.descriptor(), std::uint64_t(status.st_size), path);
    return load_stream(file.descriptor(), path);
}

}  // namespace firma
