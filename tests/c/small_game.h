/* SPDX-License-Identifier: MIT */
/* A small game for tests: a room with a column that hangs from its ceiling, a door, a player, a ball. */
#ifndef FIRMA_TESTS_C_SMALL_GAME_H
#define FIRMA_TESTS_C_SMALL_GAME_H

#include "tests/c/check.h"

/* The room of make_room(), with the column. */
firma_world make_hung_room(void);
/* A leaf of 1 x 0.25 x 2 m, its lower side's middle at the origin. */
firma_world make_leaf(void);
firma_body_shape make_ball(void);
/* It waits, goes up by 2 m in a second, and comes down after another. */
uint32_t add_door(firma_game game);
/* With all of these; the player walks along x. */
firma_game make_game(firma_world room);
/* What happens by ticks, and the ticks from one to another: the door, rockets, a blast, wishes, a cut. */
void fight(firma_game game, uint64_t from, uint64_t to);

#endif
