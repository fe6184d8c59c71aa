// SPDX-License-Identifier: MIT
// The tables of names and flags.
#include "brush/brush_kinds.h"

#include <string>

#include "firma/level.h"

namespace firma {
namespace {

using What = SideKind::What;

struct NameRule {
    /// The whole of the last part, its beginning, its end; the folder that it lies in, the beginning of that.
    enum class Where : std::uint8_t { kName, kPrefix, kSuffix, kFolder, kFolderPrefix };
    Where where;
    std::string_view text;
    SideKind kind;
};

constexpr auto kName = NameRule::Where::kName, kPrefix = NameRule::Where::kPrefix, kSuffix = NameRule::Where::kSuffix,
               kFolder = NameRule::Where::kFolder, kFolderPrefix = NameRule::Where::kFolderPrefix;
constexpr SideKind kFiller = {What::kFiller, BrushKind::kSolid}, kNothing = {What::kNothing, BrushKind::kData};
constexpr SideKind known(BrushKind kind) {
    return {What::kKnown, kind};
}

// The first that fits. Names are those of Quake, Half-Life, Quake 2 and Quake 3 and their editors' common folders.
constexpr NameRule kNames[] = {
    {kName, "portal", known(BrushKind::kPortal)},
    {kName, "hint", known(BrushKind::kPortal)},
    {kName, "areaportal", known(BrushKind::kPortal)},
    {kName, "visportal", known(BrushKind::kPortal)},
    {kName, "subtlehint", known(BrushKind::kPortal)},
    {kName, "hintlocal", known(BrushKind::kPortal)},

    {kName, "caulk", kFiller},
    {kName, "nodraw", kFiller},
    {kName, "skip", kFiller},
    {kName, "hintskip", kFiller},
    {kName, "null", kFiller},
    {kName, "nodrawnonsolid", kNothing},
    {kName, "nonsolid", kNothing},

    {kName, "clip", known(BrushKind::kPlayerClip)},
    {kName, "playerclip", known(BrushKind::kPlayerClip)},
    {kName, "player_clip", known(BrushKind::kPlayerClip)},
    {kName, "fullclip", known(BrushKind::kPlayerClip)},
    {kName, "full_clip", known(BrushKind::kPlayerClip)},
    {kName, "metalclip", known(BrushKind::kPlayerClip)},
    {kName, "weapclip", known(BrushKind::kShotClip)},
    {kName, "shotclip", known(BrushKind::kShotClip)},
    {kName, "missileclip", known(BrushKind::kShotClip)},
    {kName, "weaponclip", known(BrushKind::kShotClip)},
    {kName, "weapon_clip", known(BrushKind::kShotClip)},

    {kName, "trigger", known(BrushKind::kData)},
    {kName, "aaatrigger", known(BrushKind::kData)},
    {kName, "origin", known(BrushKind::kData)},
    {kName, "nodrop", known(BrushKind::kData)},
    {kName, "fog", known(BrushKind::kData)},
    {kFolder, "fogs", known(BrushKind::kData)},
    {kName, "lightgrid", known(BrushKind::kData)},
    {kName, "botclip", known(BrushKind::kData)},
    {kName, "monsterclip", known(BrushKind::kData)},
    {kName, "monster_clip", known(BrushKind::kData)},
    {kName, "donotenter", known(BrushKind::kData)},
    {kName, "clusterportal", known(BrushKind::kData)},
    {kName, "antiportal", known(BrushKind::kData)},
    {kName, "anchor", known(BrushKind::kData)},

    {kPrefix, "*", known(BrushKind::kLiquid)},
    {kPrefix, "!", known(BrushKind::kLiquid)},
    {kFolderPrefix, "liquids", known(BrushKind::kLiquid)},  // liquids_lava
    {kName, "watercaulk", known(BrushKind::kLiquid)},
    {kName, "lavacaulk", known(BrushKind::kLiquid)},
    {kName, "slimecaulk", known(BrushKind::kLiquid)},

    {kPrefix, "sky", known(BrushKind::kSky)},
    {kFolder, "skies", known(BrushKind::kSky)},
    {kFolder, "sky", known(BrushKind::kSky)},
    {kFolder, "skybox", known(BrushKind::kSky)},

    {kPrefix, "{", known(BrushKind::kGlass)},  // fences and gratings with holes
    {kName, "glass", known(BrushKind::kGlass)},
    {kFolder, "glass", known(BrushKind::kGlass)},
};

// In the folder `common` (or `editor`) of games with shaders, before the names above. What these games agree on: of
// names that they use differently it is as in Quake 3. Solid that is not drawn and lets light through stops walkers and
// shots, and no sight: as glass.
constexpr NameRule kShaderNames[] = {
    {kName, "nodraw", kNothing},
    {kName, "skip", kNothing},
    {kName, "hintskip", kNothing},
    {kPrefix, "shadow", kNothing},

    {kName, "forcecaulk", kFiller},
    {kName, "collision", kFiller},
    {kName, "skipdetail", kFiller},
    {kPrefix, "terrain", kFiller},

    {kName, "fullclip", known(BrushKind::kGlass)},
    {kName, "weapclip", known(BrushKind::kGlass)},
    {kName, "weap_clip", known(BrushKind::kGlass)},
    {kName, "weaponclip", known(BrushKind::kGlass)},
    {kName, "weapon_clip", known(BrushKind::kGlass)},
    {kPrefix, "clipweap", known(BrushKind::kGlass)},
    {kName, "slick", known(BrushKind::kGlass)},
    {kName, "cushion", known(BrushKind::kGlass)},

    {kName, "clipshot", known(BrushKind::kShotClip)},
    {kName, "clipmonster", known(BrushKind::kData)},
    {kPrefix, "clip", known(BrushKind::kPlayerClip)},  // clipfull, clipmissile, clip_metal
    {kName, "missileclip", known(BrushKind::kPlayerClip)},
    {kName, "slickplayerclip", known(BrushKind::kPlayerClip)},
    {kName, "nowalljumpclip", known(BrushKind::kPlayerClip)},
    {kName, "no_walljump", known(BrushKind::kPlayerClip)},
    {kName, "ladder", known(BrushKind::kPlayerClip)},
    {kName, "outside", known(BrushKind::kPlayerClip)},

    {kPrefix, "trig", known(BrushKind::kData)},
    {kPrefix, "alpha_", known(BrushKind::kData)},
    {kSuffix, "build", known(BrushKind::kData)},  // nobuild, noalienbuild
    {kSuffix, "donotenter", known(BrushKind::kData)},
    {kName, "ai_nosight", known(BrushKind::kData)},
    {kName, "aas_solid", known(BrushKind::kData)},
    {kName, "ik_clip", known(BrushKind::kData)},
    {kPrefix, "moveable", known(BrushKind::kData)},

    {kName, "water", known(BrushKind::kLiquid)},
    {kName, "slime", known(BrushKind::kLiquid)},
    {kName, "lava", known(BrushKind::kLiquid)},
    {kSuffix, "water", known(BrushKind::kLiquid)},  // nodrawwater
};

// Of the same games, in the folder `sfx`.
constexpr NameRule kShaderEffects[] = {
    {kPrefix, "fog_", known(BrushKind::kData)},
    {kSuffix, "fog", known(BrushKind::kData)},
    {kSuffix, "fogdense", known(BrushKind::kData)},
};

struct ClassRule {
    std::string_view text;
    bool prefix;
    EntityRule rule;
};

// The first that fits; what is not named here moves or triggers something, as far as we can know. Layers and groups of
// TrenchBroom are func_group.
constexpr ClassRule kClasses[] = {
    {"worldspawn", false, EntityRule::kStatic},
    {"func_group", false, EntityRule::kStatic},
    {"func_detail_illusionary", false, EntityRule::kPasses},
    {"func_illusionary", false, EntityRule::kPasses},
    {"trigger_", true, EntityRule::kPasses},
    {"func_detail", true, EntityRule::kDetail},
    {"func_static", false, EntityRule::kStatic},
    {"func_wall", false, EntityRule::kStatic},
    {"func_areaportal", false, EntityRule::kPortal},
    {"firma_anchor", false, EntityRule::kMarks},
};

std::string normal_form(std::string_view name) {
    std::string form(name);
    for (char& c : form) {
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        if (c == '\\') c = '/';
    }
    return form;
}

// The last part of a name, and the folder that it lies in.
struct NameParts {
    std::string form;
    std::string_view last, folder;

    explicit NameParts(std::string_view name) : form(normal_form(name)) {
        const std::string_view whole = form;
        const std::size_t slash = whole.rfind('/');
        const bool plain = slash == std::string_view::npos;
        last = plain ? whole : whole.substr(slash + 1);
        const std::string_view above = plain ? std::string_view() : whole.substr(0, slash);
        folder = above.substr(above.rfind('/') + 1);  // npos + 1 is 0
    }
    NameParts(const NameParts&) = delete;
    NameParts& operator=(const NameParts&) = delete;
};

bool fits(const NameRule& rule, const NameParts& name) {
    switch (rule.where) {
        case kName:
            return name.last == rule.text;
        case kPrefix:
            return name.last.starts_with(rule.text);
        case kSuffix:
            return name.last.ends_with(rule.text);
        case kFolder:
            return name.folder == rule.text;
        case kFolderPrefix:
            return name.folder.starts_with(rule.text);
    }
    return false;
}

std::optional<SideKind> first_that_fits(std::span<const NameRule> rules, const NameParts& name) {
    for (const NameRule& rule : rules)
        if (fits(rule, name)) return rule.kind;
    return std::nullopt;
}

bool is_tool_folder(std::string_view folder) {
    return folder == "common" || folder == "editor";
}

}  // namespace

MapGame map_game(std::string_view format, bool has_primitives, std::span<const std::string_view> textures) {
    if (format.starts_with("Quake3")) return MapGame::kShaders;
    if (!format.empty() && format != "Unknown") return MapGame::kNumbers;
    if (has_primitives) return MapGame::kShaders;
    for (const std::string_view texture : textures) {
        const NameParts name(texture);
        if (name.folder == "common" || name.form.starts_with("textures/")) return MapGame::kShaders;
    }
    return MapGame::kNumbers;
}

SideKind side_kind(std::string_view texture, MapGame game) {
    const NameParts name(texture);
    std::optional<SideKind> kind;
    if (game == MapGame::kShaders && is_tool_folder(name.folder)) kind = first_that_fits(kShaderNames, name);
    if (game == MapGame::kShaders && name.folder == "sfx") kind = first_that_fits(kShaderEffects, name);
    if (!kind) kind = first_that_fits(kNames, name);
    return kind.value_or(SideKind{});
}

// Portals and hints are solid to nobody. What is solid and lets light through is glass, gratings, weapon clips.
std::optional<BrushKind> kind_by_flags(std::uint32_t contents, std::uint32_t flags) {
    using namespace bsp_flags;
    if (contents & kAreaPortal) return BrushKind::kPortal;
    if (contents & kSolid) {
        if (flags & kSurfaceSky) return BrushKind::kSky;
        return contents & kTranslucent ? BrushKind::kGlass : BrushKind::kSolid;
    }
    if (flags & kSurfaceHint) return BrushKind::kPortal;
    if (contents & (kLava | kSlime | kWater)) return BrushKind::kLiquid;
    if (contents & kWindow) return BrushKind::kGlass;
    if (contents & kPlayerClip) return BrushKind::kPlayerClip;
    if (contents & (kFog | kMonsterClip | kOrigin | kTrigger | kNoDrop)) return BrushKind::kData;
    if (flags & kSurfaceSky) return BrushKind::kSky;
    return std::nullopt;
}

BrushKind brush_kind(std::span<const SideKind> sides) {
    const SideKind* first = nullptr;
    bool filler = false, nothing = false;
    for (const SideKind& side : sides) {
        if (side.what == What::kKnown && side.kind == BrushKind::kPortal) return BrushKind::kPortal;
        filler = filler || side.what == What::kFiller;
        nothing = nothing || side.what == What::kNothing;
        if (first == nullptr && (side.what == What::kPlain || side.what == What::kKnown)) first = &side;
    }
    if (first != nullptr) return first->kind;
    return nothing && !filler ? BrushKind::kData : BrushKind::kSolid;
}

std::uint32_t side_mask(BrushKind brush, bool sky) {
    switch (brush) {
        case BrushKind::kSolid:
        case BrushKind::kSky:
            return sky ? kStopsSolid | kIsSky : kStopsSolid;
        case BrushKind::kGlass:
            return kStopsWalk | kStopsShots;
        case BrushKind::kPlayerClip:
            return kStopsWalk;
        case BrushKind::kShotClip:
            return kStopsShots;
        case BrushKind::kLiquid:
            return kStopsLiquid;
        case BrushKind::kPortal:
        case BrushKind::kData:
            break;
    }
    return 0;
}

EntityRule entity_rule(std::string_view classname) {
    for (const ClassRule& rule : kClasses) {
        if (rule.prefix ? classname.starts_with(rule.text) : classname == rule.text) return rule.rule;
    }
    return EntityRule::kMoves;
}

}  // namespace firma
