// SPDX-License-Identifier: MIT
#include <system_error>

#include "base/file_aside.h"
#include "firma/save.h"

namespace firma {

Result<FirmaWritten> save_world(const World& world, const std::string& path, const SaveOptions& options) {
    if (path.empty()) return Error{ErrorCode::kInvalid, "", "a file needs a name"};
    const std::vector<std::byte> bytes = pack_world(world, options);
    const int reason = write_whole_file(path, [&](FileAside& file) { return file.write(bytes); });
    if (reason == 0) return FirmaWritten{bytes.size()};
    return Error{ErrorCode::kCannotWrite, path, "cannot be written: " + std::generic_category().message(reason)};
}

}  // namespace firma
