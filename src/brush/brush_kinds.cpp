// SPDX-License-Identifier: MIT
// The tables of names and flags.
#include "brush/brush_kinds.h"

#include <string>

#include "firma/masks.h"

namespace firma {
namespace {

using What = SideKind::What;

struct NameRule {
    enum class Where : std::uint8_t { kName, kPrefix, kFolder };  ///< of the last part; the folder it lies in
    Where where;
    std::string_view text;
    SideKind kind;
};

constexpr auto kName = NameRule::Where::kName, kPrefix = NameRule::Where::kPrefix, kFolder = NameRule::Where::kFolder;
constexpr SideKind kFiller = {What::kFiller, BrushKind::kSolid}, kNothing = {What::kNothing, BrushKind::kData};
constexpr SideKind known(BrushKind kind) {
    return {What::kKnown, kind};
}

// The first that fits. Names are those of Quake, Half-Life, Quake 2 and Quake 3 and their editors' common folders.
constexpr NameRule kNames[] = {
    {kName, "portal", known(BrushKind::kPortal)},
    {kName, "hint", known(BrushKind::kPortal)},
    {kName, "areaportal", known(BrushKind::kPortal)},

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

    {kName, "trigger", known(BrushKind::kData)},
    {kName, "aaatrigger", known(BrushKind::kData)},
    {kName, "origin", known(BrushKind::kData)},
    {kName, "nodrop", known(BrushKind::kData)},
    {kName, "fog", known(BrushKind::kData)},
    {kFolder, "fogs", known(BrushKind::kData)},
    {kName, "lightgrid", known(BrushKind::kData)},
    {kName, "botclip", known(BrushKind::kData)},
    {kName, "monsterclip", known(BrushKind::kData)},
    {kName, "donotenter", known(BrushKind::kData)},
    {kName, "clusterportal", known(BrushKind::kData)},
    {kName, "antiportal", known(BrushKind::kData)},
    {kName, "anchor", known(BrushKind::kData)},

    {kPrefix, "*", known(BrushKind::kLiquid)},
    {kPrefix, "!", known(BrushKind::kLiquid)},
    {kFolder, "liquids", known(BrushKind::kLiquid)},
    {kName, "watercaulk", known(BrushKind::kLiquid)},
    {kName, "lavacaulk", known(BrushKind::kLiquid)},
    {kName, "slimecaulk", known(BrushKind::kLiquid)},

    {kPrefix, "sky", known(BrushKind::kSky)},
    {kFolder, "skies", known(BrushKind::kSky)},

    {kPrefix, "{", known(BrushKind::kGlass)},  // fences and gratings with holes
    {kName, "glass", known(BrushKind::kGlass)},
    {kFolder, "glass", known(BrushKind::kGlass)},
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
    {"func_detail_illusionary", false, EntityRule::kMoves},
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

}  // namespace

SideKind side_kind(std::string_view texture) {
    const std::string form = normal_form(texture);
    const std::string_view whole = form;
    const std::size_t slash = whole.rfind('/');
    const bool plain = slash == std::string_view::npos;
    const std::string_view last = plain ? whole : whole.substr(slash + 1);
    const std::string_view above = plain ? std::string_view() : whole.substr(0, slash);
    const std::string_view folder = above.substr(above.rfind('/') + 1);  // npos + 1 is 0
    for (const NameRule& rule : kNames) {
        const bool fits = rule.where == kName     ? last == rule.text
                          : rule.where == kPrefix ? last.starts_with(rule.text)
                                                  : folder == rule.text;
        if (fits) return rule.kind;
    }
    return {};
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
