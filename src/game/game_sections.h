// SPDX-License-Identifier: MIT
// The sections of games and recordings. docs/formats.md says what is in them.
#pragma once

#include "save/container.h"

namespace firma {

// Beside those of the world, none of them required.
inline constexpr SectionType kGameSection = section_type("GAME");
inline constexpr SectionType kGameLogSection = section_type("GLOG");
inline constexpr SectionType kGamePartsSection = section_type("GPRT");
inline constexpr SectionType kGamePlayersSection = section_type("GPLY");
inline constexpr SectionType kGameShotsSection = section_type("GSHT");
inline constexpr SectionType kGameBodiesSection = section_type("GBOD");
inline constexpr SectionType kGameDebrisSection = section_type("GDEB");

// All required.
inline constexpr SectionType kRecordingSection = section_type("RECO");
inline constexpr SectionType kRecordedStartSection = section_type("STRT");
inline constexpr SectionType kRecordedEventsSection = section_type("EVNT");
inline constexpr SectionType kRecordedHashesSection = section_type("TICK");
inline constexpr SectionType kRecordedEndSection = section_type("LAST");

/// Whether a head and a table of sections name a section; false for what is no such file.
bool names_section(std::span<const std::byte> bytes, SectionType type);

}  // namespace firma
