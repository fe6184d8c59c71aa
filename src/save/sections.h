// SPDX-License-Identifier: MIT
// The sections of all versions, and how large their entries are. docs/formats.md says what is in them.
#pragma once

#include "save/container.h"

namespace firma {

inline constexpr SectionType kWorldSection = section_type("WRLD");
inline constexpr SectionType kMaterialsSection = section_type("MATS");
inline constexpr SectionType kRulesSection = section_type("RULE");
inline constexpr SectionType kFacesSection = section_type("FACE");
inline constexpr SectionType kVerticesSection = section_type("VERT");
inline constexpr SectionType kCornersSection = section_type("CORN");
// Cells.
inline constexpr SectionType kRoomRecordsSection = section_type("RECS");
inline constexpr SectionType kPortalsSection = section_type("PORT");
inline constexpr SectionType kPortalPolygonsSection = section_type("PPOL");
inline constexpr SectionType kPortalCornersSection = section_type("PCOR");
// From version 3 on.
inline constexpr SectionType kPortalFacesSection = section_type("PEXA");
inline constexpr SectionType kMergeSection = section_type("MERG");
inline constexpr SectionType kOpenFacesSection = section_type("OPEN");
// The exact part.
inline constexpr SectionType kPlanesSection = section_type("PLAN");
inline constexpr SectionType kGridPointsSection = section_type("GRID");
inline constexpr SectionType kMeetPointsSection = section_type("MEET");
inline constexpr SectionType kEdgesSection = section_type("EDGE");
inline constexpr SectionType kExactFacesSection = section_type("EXAC");
inline constexpr SectionType kUsesSection = section_type("USES");
inline constexpr SectionType kLoopsSection = section_type("LOOP");
// What holds pieces: may be missing, or passed over.
inline constexpr SectionType kAnchorsSection = section_type("HOLD");
// How textures lie: may be missing, or passed over.
inline constexpr SectionType kTextureMapsSection = section_type("TMAP");
inline constexpr SectionType kTexturedFacesSection = section_type("TFAC");
inline constexpr SectionType kTextureOutlinesSection = section_type("TCOR");
// What it is made of, from version 3 on: all of them, or none where there is nothing to say.
inline constexpr SectionType kMattersSection = section_type("MTTR");
inline constexpr SectionType kPiecesSection = section_type("PIEC");
inline constexpr SectionType kPiecePlanesSection = section_type("PPLA");
inline constexpr SectionType kPiecePolygonsSection = section_type("PPLY");
inline constexpr SectionType kPieceCornersSection = section_type("PCRN");
inline constexpr SectionType kPieceMaterialsSection = section_type("PMAT");
inline constexpr SectionType kMatterSourcesSection = section_type("MSRC");
// Of version 1 alone.
inline constexpr SectionType kRoomsSection = section_type("ROOM");
inline constexpr SectionType kBlocksSection = section_type("BLCK");
inline constexpr SectionType kBinsSection = section_type("BINS");
inline constexpr SectionType kOwnersSection = section_type("OWNR");

inline constexpr SectionType kSectionsOfBoth[] = {
    kWorldSection,   kMaterialsSection,   kRulesSection,      kFacesSection,          kVerticesSection,
    kCornersSection, kRoomRecordsSection, kPortalsSection,    kPortalPolygonsSection, kPortalCornersSection,
    kPlanesSection,  kGridPointsSection,  kMeetPointsSection, kEdgesSection,          kExactFacesSection,
    kUsesSection,    kLoopsSection};
inline constexpr SectionType kSectionsOfVersion3[] = {kPortalFacesSection, kMergeSection, kOpenFacesSection};
inline constexpr SectionType kSectionsOfTextures[] = {kTextureMapsSection, kTexturedFacesSection,
                                                      kTextureOutlinesSection};
inline constexpr SectionType kSectionsOfAnchors[] = {kAnchorsSection};
inline constexpr SectionType kSectionsOfMatters[] = {
    kMattersSection,      kPiecesSection,         kPiecePlanesSection,  kPiecePolygonsSection,
    kPieceCornersSection, kPieceMaterialsSection, kMatterSourcesSection};
inline constexpr SectionType kSectionsOfVersion1[] = {kRoomsSection, kBlocksSection, kBinsSection, kOwnersSection};

inline constexpr std::size_t kWorldBytes = 64;
inline constexpr std::size_t kRulesBytes = 64;       ///< without zones and hardness
inline constexpr std::size_t kZoneBytes = 64;        ///< without its name
inline constexpr std::size_t kRoomRecordBytes = 12;  ///< without its name
inline constexpr std::size_t kPortalBytes = 32;      ///< without its name
inline constexpr std::size_t kFaceBytes = 32;
inline constexpr std::size_t kBinBytes = 32;
inline constexpr std::size_t kBlockBytesOfVersion1 = 12;
inline constexpr std::size_t kFaceBytesOfVersion1 = 28;
inline constexpr std::size_t kPointBytes = 12;
inline constexpr std::size_t kPlaneBytes = 40;
inline constexpr std::size_t kEdgeBytes = 20;
inline constexpr std::size_t kExactFaceBytes = 36;
inline constexpr std::size_t kAnchorBytes = 12;
inline constexpr std::size_t kTextureMapBytes = 72;
inline constexpr std::size_t kTexturedFaceBytes = 12;
inline constexpr std::size_t kMattersBytes = 16;  ///< without matters and patterns
inline constexpr std::size_t kMatterBytes = 32;   ///< without its texts
inline constexpr std::size_t kPieceBytes = 48;

// Flags of the world.
inline constexpr std::uint32_t kRockOutside = 1;
inline constexpr std::uint32_t kExactPart = 2;
inline constexpr std::uint32_t kHasRules = 4;
inline constexpr std::uint32_t kHasRoomRecords = 8;
inline constexpr std::uint32_t kHasPortals = 16;
/// A face that is its own exact face, or has none.
inline constexpr std::uint32_t kOwnFace = ~0u;
/// A node above others, which lies over no block; a room without an index.
inline constexpr std::uint32_t kNoEntry = ~0u;
// Of a room.
inline constexpr std::uint32_t kExteriorRoom = 1;
// Of a portal.
inline constexpr std::uint32_t kClosedPortal = 1;
inline constexpr std::uint32_t kMadePortal = 2;  ///< by an edit
// Of a face.
inline constexpr std::uint8_t kTwoSidedFace = 1;
inline constexpr std::uint8_t kSolidFace = 2;
// What an anchor names.
inline constexpr std::uint32_t kMaterialHolds = 0, kSourceHolds = 1, kEditHolds = 2, kHangingHolds = 3,
                               kVolumeHolds = 4;
// Of a piece.
inline constexpr std::uint32_t kSkyPiece = 1;
// Of an edge.
inline constexpr std::uint32_t kDoubledEdge = 1;

}  // namespace firma
