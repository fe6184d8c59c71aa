// SPDX-License-Identifier: MIT
// From the bytes of a .firma file to a world: the container, the parts, then the world as a whole.
#include "firma/save.h"
#include "save/anchor_bytes.h"
#include "save/check_whole.h"
#include "save/entries.h"
#include "save/sections.h"
#include "save/unpack_data.h"
#include "save/unpack_exact.h"
#include "save/unpack_faces.h"
#include "save/unpack_index.h"
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
        known.insert(known.end(), std::begin(kSectionsOfIndex), std::end(kSectionsOfIndex));
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

BuiltStore store_over(Ref<const Node> root) {
    std::vector<PartIndex> whole;
    if (root) whole.push_back({0, std::move(root)});
    return store_of_parts(std::move(whole));
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
    std::optional<UnpackedIndex> index;
    if (!damage.error() && version > 1) index = unpack_index(sections, unpacked, faces, damage);
    sections.refuse_unused(known);
    if (damage.error()) return *damage.error();
    StoredWorld& world = unpacked.world;
    if (index) {
        world.solid = store_over(index->solid);
        world.castable = store_over(index->castable);
        world.indices = std::move(index->rooms);
    } else {
        world.solid = build_store(faces_of_kind(faces, true), world.tree_options);
        world.castable = build_store(faces_of_kind(faces, false), world.tree_options);
    }
    World made = world_of(std::move(world));
    check_whole(made, unpacked.exact, damage);
    if (damage.error()) return *damage.error();
    return made;
}

}  // namespace firma
