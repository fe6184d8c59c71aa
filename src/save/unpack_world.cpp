// SPDX-License-Identifier: MIT
// From the bytes of a .firma file to a world: the container, the parts, then the world as a whole. The index that files
// had before is passed over as any unknown section is: worlds build their own.
#include "firma/save.h"
#include "save/anchor_bytes.h"
#include "save/check_whole.h"
#include "save/entries.h"
#include "save/sections.h"
#include "save/unpack_data.h"
#include "save/unpack_exact.h"
#include "save/unpack_faces.h"
#include "save/unpack_matters.h"
#include "save/unpack_textures.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

/// What a version of the format has.
std::vector<SectionType> known_sections(std::uint32_t version) {
    std::vector<SectionType> known(std::begin(kSectionsOfBoth), std::end(kSectionsOfBoth));
    if (version == 1) {
        known.insert(known.end(), std::begin(kSectionsOfVersion1), std::end(kSectionsOfVersion1));
    } else {
        if (version > 2) known.insert(known.end(), std::begin(kSectionsOfVersion3), std::end(kSectionsOfVersion3));
        known.insert(known.end(), std::begin(kSectionsOfAnchors), std::end(kSectionsOfAnchors));
        known.insert(known.end(), std::begin(kSectionsOfTextures), std::end(kSectionsOfTextures));
    }
    if (version >= 3) known.insert(known.end(), std::begin(kSectionsOfMatters), std::end(kSectionsOfMatters));
    return known;
}

/// All faces of one kind.
FaceSet faces_of_kind(const FaceSet& all, bool solid) {
    FaceSet some;
    for (const FaceSet::Entry& face : all.faces)
        if (face.solid == solid) append_face(all, face, some);
    return some;
}

}  // namespace

Result<World> unpack_world(std::span<const std::byte> bytes, std::string name) {
    Result<std::vector<Section>> read = read_container(bytes, name);
    if (!read) return read.error();
    const std::uint32_t version = version_of_container(bytes);
    Damage damage(name);
    Sections sections(std::move(read).value(), damage);
    const std::vector<SectionType> known = known_sections(version);
    sections.refuse_unknown(known);
    if (damage.error()) return *damage.error();
    UnpackedData unpacked = unpack_data(sections, damage);
    if (damage.error()) return *damage.error();
    std::vector<Ref<SolidFace>> exact;
    if (unpacked.exact) exact = unpack_exact(sections, damage);
    if (damage.error()) return *damage.error();
    unpack_portals(sections, unpacked, version > 2 && unpacked.exact ? &exact : nullptr, damage);
    if (damage.error()) return *damage.error();
    const FaceSet faces = version == 1 ? unpack_faces_of_version_1(sections, unpacked, exact, damage)
                                       : unpack_faces(sections, unpacked, exact, damage);
    if (!damage.error() && version > 1) unpacked.world.anchors = unpack_anchors(sections, damage);
    if (!damage.error() && version > 1) unpacked.world.textures = unpack_textures(sections, damage);
    if (!damage.error() && version > 2)
        unpacked.world.matters = unpack_matters(sections, unpacked.material_count(), damage);
    sections.refuse_unused(known);
    if (damage.error()) return *damage.error();
    StoredWorld& world = unpacked.world;
    world.solid = build_store(faces_of_kind(faces, true), world.tree_options);
    world.castable = build_store(faces_of_kind(faces, false), world.tree_options);
    World made = world_of(std::move(world));
    check_whole(made, unpacked.exact, damage);
    if (damage.error()) return *damage.error();
    return made;
}

}  // namespace firma
