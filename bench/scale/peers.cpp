// SPDX-License-Identifier: MIT
// Which libraries bench_scale was built with.
#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

constexpr std::size_t kAny = ~std::size_t(0);

constexpr const char* kNames[] = {"Firma", "Embree", "Bullet", "CGAL", "FCL"};

constexpr PeerEntry kPeers[] = {
    {kNames[0], make_firma_peer, kAny, kAny},
#ifdef FIRMA_WITH_EMBREE
    {kNames[1], make_embree_peer, kAny, kAny},
#endif
#ifdef FIRMA_WITH_BULLET
    {kNames[2], make_bullet_peer, kAny, kAny},
#endif
#ifdef FIRMA_WITH_CGAL
    {kNames[3], make_cgal_peer, 2'000'000, kAny},
#endif
#ifdef FIRMA_WITH_FCL
    {kNames[4], make_fcl_peer, 200'000, 2'000'000},
#endif
};

}  // namespace

std::span<const PeerEntry> scale_peers() {
    return kPeers;
}

std::span<const char* const> scale_peer_names() {
    return kNames;
}

}  // namespace firma::bench
