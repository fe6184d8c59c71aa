// SPDX-License-Identifier: MIT
// Projectiles, what is done to them and what happens to them, as a caller has them.
#pragma once

#include "firma/firma_c.h"
#include "firma/projectiles.h"

namespace firma::c {

ShotTerms terms_of(const firma_shot_terms& from);
firma_shot_terms terms_told(const ShotTerms& from);
firma_projectile projectile_told(const Projectile& from);
firma_shot_event event_told(const ShotEvent& from);

}  // namespace firma::c
