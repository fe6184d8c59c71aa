/* SPDX-License-Identifier: MIT */
/* A test in C: what does not hold is printed with its place, and counted. */
#ifndef FIRMA_TESTS_C_CHECK_H
#define FIRMA_TESTS_C_CHECK_H

#include <stdio.h>
#include <string.h>

#include "firma/firma_c.h"

extern int failures;

#define CHECK(condition)                                                                   \
    do {                                                                                   \
        if (!(condition)) {                                                                \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
            ++failures;                                                                    \
        }                                                                                  \
    } while (0)

/* A call that must succeed, and one that must fail with a code and say a word. */
#define CHECK_OK(call)                                                                                            \
    do {                                                                                                          \
        const firma_code code_ = (call);                                                                          \
        if (code_ != FIRMA_OK) {                                                                                  \
            fprintf(stderr, "%s:%d: %s: code %d: %s\n", __FILE__, __LINE__, #call, code_, firma_error_message()); \
            ++failures;                                                                                           \
        }                                                                                                         \
    } while (0)

#define CHECK_FAILS(call, expected, word)                                                                          \
    do {                                                                                                           \
        const firma_code code_ = (call);                                                                           \
        if (code_ != (expected) || !strstr(firma_error_message(), word)) {                                         \
            fprintf(stderr, "%s:%d: %s: code %d, not %d, or no \"%s\" in: %s\n", __FILE__, __LINE__, #call, code_, \
                    (int)(expected), word, firma_error_message());                                                 \
            ++failures;                                                                                            \
        }                                                                                                          \
    } while (0)

/* A room of 8 x 8 x 4 m in rock, its corner at the origin: faces look inward. */
firma_world make_room(void);
/* A cutter: the box from one corner to the other. */
firma_cutter make_box(double x0, double y0, double z0, double x1, double y1, double z1);
uint64_t hash_of(firma_world world);

void test_library(void);
void test_worlds(void);
void test_casts(void);
void test_movers(void);
void test_players(void);
void test_bodies(void);
void test_body_casts(void);
void test_sphere_sets(void);
void test_projectiles(void);
void test_debris(void);
void test_level_parts(void);
void test_supports(void);
void test_games(const char* folder);
void test_recordings(const char* folder);
void test_visitors(void);
void test_structs(void);
void test_old_names(void);
void test_carving(void);
void test_chunks(void);
void test_convex_pieces(void);
void test_commands(void);
void test_matters(void);
void test_logs(const char* sources);
void test_patches(void);
void test_stores(void);
void test_files(const char* folder);
void test_rooms(const char* folder);
void test_handles(void);

#endif
