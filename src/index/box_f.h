// SPDX-License-Identifier: MIT
// A box as an index shows it.
#pragma once

namespace firma {

/// A closed box, rounded outward, in metres.
struct BoxF {
    float low[3];
    float high[3];
};

}  // namespace firma
