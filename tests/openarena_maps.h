// SPDX-License-Identifier: MIT
// Where the maps of OpenArena are: FIRMA_OPENARENA names a folder of .bsp files (tools/unpack_openarena.sh makes one).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace firma {

/// Closed maps of every size, most of them with area portals. What is carved is carved in the first five.
inline constexpr const char* kRoomMaps[] = {"kaos2",   "czest2ctf", "islandctf",  "oa_koth1",    "ctf_compromise",
                                            "pul1ctf", "oa_dm5",    "ctf_inyard", "sleekgrinder"};
inline constexpr std::size_t kCarvedMaps = 5;

/// The .bsp files, by name; none where there is no such folder: tests skip then.
inline std::vector<std::filesystem::path> openarena_maps() {
    std::vector<std::filesystem::path> maps;
    const char* folder = std::getenv("FIRMA_OPENARENA");
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder == nullptr ? "" : folder, none))
        if (entry.path().extension() == ".bsp") maps.push_back(entry.path());
    std::sort(maps.begin(), maps.end());
    return maps;
}

inline constexpr const char* kNoOpenArena =
    "no .bsp files: FIRMA_OPENARENA names no folder of OpenArena's maps (tools/unpack_openarena.sh makes one from "
    "Debian's openarena-081-maps)";

}  // namespace firma
