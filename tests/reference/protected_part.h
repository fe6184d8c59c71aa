// SPDX-License-Identifier: MIT
// What of a world may not be carved, asked of every zone and every piece by itself.
#pragma once

#include "firma/vec.h"
#include "firma/world.h"

namespace firma::reference {

class ProtectedPart {
public:
    /// @param fills  of what is filled in: zones count, pieces do not
    ProtectedPart(const World& world, bool fills) : world_(world), fills_(fills) {}

    /// Whether a point lies in a zone or piece that may not be carved. Of one that is nearer to their surfaces than
    /// rounding reaches it may say either.
    bool holds(const Vec3& p) const;
    /// Whether cutters are cut short at pieces. Elsewhere, and where what is in no piece may not be carved, faces say
    /// which cut is refused.
    bool is_by_pieces() const;

private:
    const World& world_;
    const bool fills_;
};

}  // namespace firma::reference
