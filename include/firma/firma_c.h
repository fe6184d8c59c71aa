/* SPDX-License-Identifier: MIT */
/* Firma from C: worlds, casts, players, parts that move, carving, bodies, games, differences, histories, edit logs,
 * recordings, files. C99 and later; from C++ use the other headers.
 *
 * Handles. A world, level, cutter, job, edit, store, diff, faces, triangles, region meshes, chunks, matters, command,
 * log, replay, hull, parts, player shape, body shape, bodies, body index, shot events, piercing, debris, supports,
 * convex pieces, game, recording or bytes is a handle: a struct with a number that is 0 for none. Whoever gets one
 * releases it, each with its own function. A handle that was released, never made, or of another kind gives
 * FIRMA_ERROR_BAD_HANDLE, always: numbers are never used twice. Releasing 0 does nothing.
 *
 * Errors. Every function that can fail returns a firma_code; then nothing was changed, and no output was written but
 * where a function says so. firma_error_message() tells the calling thread why its last call failed. Pointers that may
 * be null say so; any other null, a count without its array, or a struct whose `size` cannot be right gives
 * FIRMA_ERROR_BAD_CALL. No exception leaves a function.
 * One rule says where a failure shows: where the answer has a firma_status (firma_cast(), firma_cast_any(),
 * firma_cast_each(), firma_cast_batch(), the same of movers, scenes, sets of spheres and a body index,
 * firma_cast_many()), bad numbers of the input and a room that the world does not have give FIRMA_OK with status
 * FIRMA_INVALID; everywhere else they give a code,
 * FIRMA_ERROR_OUT_OF_RANGE for the numbers, FIRMA_ERROR_INVALID for the room. Options that make no sense, and faces,
 * portals and materials that the world does not have, give FIRMA_ERROR_INVALID everywhere. A search that finds nothing
 * has not failed: it says so in its output.
 *
 * Structs. Those that begin with `size` may grow in later versions: set it to the struct's sizeof, also in structs that
 * a call fills (`firma_room room = {.size = sizeof room};`). A caller that was compiled with an older, shorter struct
 * is served: what its struct lacks is taken as by default, or not given. All other structs stay as they are.
 *
 * Threads. Any thread may call anything; worlds and cutters never change and may be used by many at once. Jobs,
 * edits, logs, replays, parts, bodies, debris, games, piercings and shot events are for one thread at a time; parts and
 * bodies that nobody changes meanwhile for many. A handle must not be released while another thread is using it. (A
 * visitor may release the world that it is shown.)
 *
 * Costs. Finding what a handle names, releasing 0, setting defaults and getting a view cost the same, however much the
 * handle holds, and take no memory. A call that gives a handle takes memory for it, and a short lock that all threads
 * share, as releasing does. The release of the last handle to something frees it: of a world what no other world
 * shares. A call that writes a list into the caller's memory works out all of it each time, also where `capacity` is 0
 * to learn the count first: asked twice, it costs twice. Where nothing else is said, a call costs the same for every
 * world.
 *
 * Units: metres, seconds, radians; right-handed. Points and vectors are three doubles. The contract of a cast stands in
 * docs/casting.md, what carving keeps and refuses in docs/carving.md. */
#ifndef FIRMA_FIRMA_C_H
#define FIRMA_FIRMA_C_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(FIRMA_C_BUILD)
#define FIRMA_API __declspec(dllexport)
#elif defined(_WIN32) && defined(FIRMA_C_SHARED) /* the target firma::c says so where it is a DLL */
#define FIRMA_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define FIRMA_API __attribute__((visibility("default")))
#else
#define FIRMA_API
#endif

/* ---- the library ------------------------------------------------------------------------------------------------ */

#define FIRMA_VERSION_MAJOR 0
#define FIRMA_VERSION_MINOR 2
#define FIRMA_VERSION_PATCH 0

/* Major * 65536 + minor * 256 + patch, of the library at run time. */
FIRMA_API uint32_t firma_version(void);

typedef enum firma_code {
    FIRMA_OK = 0,
    FIRMA_ERROR_CANNOT_READ = 1,  /* the file is missing or cannot be read */
    FIRMA_ERROR_MALFORMED = 2,    /* data break their format */
    FIRMA_ERROR_OUT_OF_RANGE = 3, /* a number is not finite, or beyond what Firma can hold */
    FIRMA_ERROR_TOO_LARGE = 4,    /* a count or size exceeds a limit */
    FIRMA_ERROR_UNSUPPORTED = 5,  /* a format or version that Firma does not read, or not in this build */
    FIRMA_ERROR_INVALID = 6,      /* arguments that make no sense */
    FIRMA_ERROR_CANNOT_WRITE = 7, /* the file cannot be made or written */
    FIRMA_ERROR_BAD_HANDLE = 8,   /* released, never made, or of another kind */
    FIRMA_ERROR_BAD_CALL = 9,     /* a null that may not be, a `size` that cannot be, a call out of order */
    FIRMA_ERROR_NO_MEMORY = 10,
    FIRMA_ERROR_BROKEN = 11,  /* firma_world_check() found something that does not hold */
    FIRMA_ERROR_INTERNAL = 12 /* a mistake of Firma's own: please report it */
} firma_code;

/* "place: reason" of the calling thread's last call that returned another code than FIRMA_OK, or of its last refused
 * edit; "" before any. Good until the thread's next call that fails. */
FIRMA_API const char* firma_error_message(void);

/* Where the pool in which worlds keep their blocks gets its memory from, in slabs of at most 256 KiB, and larger pieces
 * now and then. Scratch memory of edits comes from the general allocator. */
typedef struct firma_allocator {
    uint32_t size;                                             /* sizeof(firma_allocator) */
    void* (*take)(size_t bytes, size_t alignment, void* user); /* null for no more: then FIRMA_ERROR_NO_MEMORY */
    void (*give_back)(void* memory, size_t bytes, size_t alignment, void* user);
    void* user;
} firma_allocator;

/* Before any world was made: FIRMA_ERROR_BAD_CALL once it is too late. Costs nothing by itself; every slab costs what
 * `take` costs. */
FIRMA_API firma_code firma_set_allocator(const firma_allocator* allocator);

/* How a batch, or making a world, is spread over threads. `run` calls work(context, k) once for each k below count, in
 * any order and on any threads, and returns when all have returned. When it returns earlier, a batch fails with
 * FIRMA_ERROR_BAD_CALL, a world with FIRMA_ERROR_INVALID; what it leaves undone must not be called later. */
typedef struct firma_tasks {
    uint32_t size; /* sizeof(firma_tasks) */
    void (*run)(size_t count, void (*work)(void* context, size_t k), void* context, void* user);
    void* user;
} firma_tasks;

/* For all batches, and all worlds made of levels, that begin from now on; null: in the calling thread (the default).
 * Answers and worlds do not depend on it. For a world it is called several times, one after the other. A batch that is
 * spread takes memory, 150 KB in each thread at work and a byte for each piece of work of 256 casts. `work` may be
 * called by any number of threads at once. */
FIRMA_API firma_code firma_set_tasks(const firma_tasks* tasks);

/* Handles that are not released yet, of all kinds: 0 when nothing has leaked. */
FIRMA_API size_t firma_live_handles(void);

typedef struct firma_world {
    uint64_t id;
} firma_world;
typedef struct firma_level {
    uint64_t id;
} firma_level;
typedef struct firma_cutter {
    uint64_t id;
} firma_cutter;
typedef struct firma_job {
    uint64_t id;
} firma_job;
typedef struct firma_edit {
    uint64_t id;
} firma_edit;
typedef struct firma_store {
    uint64_t id;
} firma_store;
typedef struct firma_diff {
    uint64_t id;
} firma_diff;
typedef struct firma_faces {
    uint64_t id;
} firma_faces;
typedef struct firma_triangles {
    uint64_t id;
} firma_triangles;
typedef struct firma_region_meshes {
    uint64_t id;
} firma_region_meshes;
typedef struct firma_bytes {
    uint64_t id;
} firma_bytes;
typedef struct firma_convex_pieces {
    uint64_t id;
} firma_convex_pieces;
typedef struct firma_chunks {
    uint64_t id;
} firma_chunks;
typedef struct firma_matters {
    uint64_t id;
} firma_matters;
typedef struct firma_command {
    uint64_t id;
} firma_command;
typedef struct firma_log {
    uint64_t id;
} firma_log;
typedef struct firma_replay {
    uint64_t id;
} firma_replay;
typedef struct firma_hull {
    uint64_t id;
} firma_hull;
typedef struct firma_parts {
    uint64_t id;
} firma_parts;
typedef struct firma_player_shape {
    uint64_t id;
} firma_player_shape;
typedef struct firma_body_shape {
    uint64_t id;
} firma_body_shape;
typedef struct firma_bodies {
    uint64_t id;
} firma_bodies;
typedef struct firma_body_index {
    uint64_t id;
} firma_body_index;
typedef struct firma_shot_events {
    uint64_t id;
} firma_shot_events;
typedef struct firma_piercing {
    uint64_t id;
} firma_piercing;
typedef struct firma_debris {
    uint64_t id;
} firma_debris;
typedef struct firma_supports {
    uint64_t id;
} firma_supports;
typedef struct firma_game {
    uint64_t id;
} firma_game;
typedef struct firma_recording {
    uint64_t id;
} firma_recording;

/* ---- matter ----------------------------------------------------------------------------------------------------- */

/* What levels are made of: docs/matter.md. A table lists matters, and patterns that say which textures are of which. A
 * world is made by one (firma_world_options); everything that it says of a matter is by its number there. */

/* How something breaks: for what a game shows and hears of it. No edit goes by it. */
typedef enum firma_fracture {
    FIRMA_FRACTURE_CHUNKS = 0,    /* brick, concrete, rock */
    FIRMA_FRACTURE_SPLINTERS = 1, /* wood */
    FIRMA_FRACTURE_BENDS = 2,     /* steel */
    FIRMA_FRACTURE_PANE = 3       /* glass */
} firma_fracture;

typedef struct firma_matter {
    const char* name;   /* UTF-8; null is "" */
    const char* inside; /* the material of faces that a cut leaves in it; "" or null: that without a name */
    double density;     /* kilograms a cubic metre, > 0 */
    double strength;    /* megapascals of tension that it bears, >= 0 */
    double hardness;   /* 0..1: 1 may not be carved; below, a cutter whose centre is nearest to this matter is shrunk to
                          (1 - hardness) of its scale; 0 is cut as it is */
    uint32_t fracture; /* firma_fracture */
    uint32_t reserved; /* must be 0 */
} firma_matter;

/* `*` stands for any letters, case does not matter. One without `/` is compared with what follows the last `/` of a
 * name, one with `/` with the whole name. */
typedef struct firma_matter_pattern {
    const char* pattern;
    uint32_t matter; /* index into the matters */
    uint32_t reserved;
} firma_matter_pattern;

typedef struct firma_matter_table {
    uint32_t size;               /* sizeof(firma_matter_table) */
    uint32_t reserved;           /* must be 0 */
    const firma_matter* matters; /* at least one, at most 4,096: the first is that of what no pattern fits */
    size_t matter_count;
    const firma_matter_pattern* patterns; /* the first that fits counts; at most 4,096 */
    size_t pattern_count;
} firma_matter_table;

/* The built-in table, which worlds are made by where none is given. */
FIRMA_API firma_code firma_matters_default(firma_matters* matters);
/* A table as text: docs/formats.md has the form. `name`, for messages, may be null. FIRMA_ERROR_MALFORMED with file and
 * line for what is no such text. Costs the text. */
FIRMA_API firma_code firma_matters_from_text(const char* text, size_t length, const char* name, firma_matters* matters);
/* The same from a file. Not in the modules for browsers and node. */
FIRMA_API firma_code firma_matters_load(const char* path, firma_matters* matters);
/* The table that a world was made by. Costs a copy of it. */
FIRMA_API firma_code firma_world_matters(firma_world world, firma_matters* matters);
/* Good until the handle is released; also as it is for firma_world_options. */
FIRMA_API firma_code firma_matters_get_view(firma_matters matters, firma_matter_table* table);
FIRMA_API firma_code firma_matters_release(firma_matters matters);

/* What a place is made of, whether or not a cut has made air of it since: the number of a matter. Where pieces of the
 * level overlap, one that may not be carved wins, then the lower number. What is in no piece is the rest.
 * FIRMA_ERROR_OUT_OF_RANGE for a point that is not finite. Takes no memory; costs the pieces whose boxes hold it. */
FIRMA_API firma_code firma_world_matter_at(firma_world world, const double point[3], uint32_t* matter);
/* That of a face by its id and first corner, as in firma_hit: of its brush or closed mesh; of a face that an edit made
 * what is just behind its middle. FIRMA_ERROR_INVALID for a face that the world does not have. */
FIRMA_API firma_code firma_world_matter_of(firma_world world, uint32_t face, const int32_t corner[3], uint32_t* matter);

typedef struct firma_matter_counts {
    uint32_t size;             /* sizeof(firma_matter_counts) */
    uint32_t rest;             /* the matter of what lies in no piece */
    uint64_t pieces;           /* of the level, that bound solid: brushes, closed meshes */
    uint64_t protected_pieces; /* of these, how many may not be carved */
    uint64_t matter_count;     /* of the table */
} firma_matter_counts;

/* `of_matter` gets how many pieces are of each matter, of the first `capacity`; it may be null when that is 0. Goes
 * through the pieces. */
FIRMA_API firma_code firma_world_count_matters(firma_world world, uint64_t* of_matter, size_t capacity,
                                               firma_matter_counts* counts);

/* ---- worlds ----------------------------------------------------------------------------------------------------- */

#define FIRMA_NO_FACE UINT32_MAX
#define FIRMA_NO_PORTAL UINT32_MAX
/* In place of a room: all of them, or the one that a cast's start lies in, which the cast finds out. */
#define FIRMA_NO_ROOM UINT32_MAX
#define FIRMA_ANY_ROOM FIRMA_NO_ROOM
#define FIRMA_LOCATE_ROOM (UINT32_MAX - 1)

/* How a world is made; a null pointer to it takes the defaults, as firma_world_options_defaults() sets them. */
typedef struct firma_world_options {
    uint32_t size;          /* sizeof(firma_world_options) */
    uint32_t surface_area;  /* 1, the default: split by surface area; 0: in half (of several rooms, those of up to 64
                               faces) */
    int32_t max_depth;      /* 0..64 */
    int32_t faces_per_leaf; /* >= 1 */
    double min_node_volume; /* cubic metres */
    double contact_offset;  /* metres: how far movers stay from surfaces */
    double scale;           /* metres a unit of the file or mesh; 0: the format's own (1; 1/32 for .bsp and .map) */
    uint32_t no_textures;   /* 1: how textures lie is not kept, and firma_world_texture() finds nothing of the file */
    uint32_t reserved;      /* must be 0 */
    const firma_matter_table* matters; /* what the level is made of, copied; null: firma_matters_default() */
} firma_world_options;

FIRMA_API void firma_world_options_defaults(firma_world_options* options);

/* A mesh of polygons. Counter-clockwise seen from the air; each is divided where it is not convex and planar on the
 * grid of 1/4096 m. Arrays that are null have the value said. */
typedef struct firma_mesh {
    uint32_t size; /* sizeof(firma_mesh) */
    uint32_t material_count;
    const double* positions; /* three for each vertex */
    size_t vertex_count;
    const uint32_t* corners;       /* indices of vertices, face after face */
    const uint32_t* corner_counts; /* for each face, >= 3; null: all are triangles */
    size_t face_count;
    const uint32_t* materials;         /* for each face, an index of material_names; null: the first, or none */
    const char* const* material_names; /* UTF-8; null when material_count is 0. The world numbers them so, too */
    const uint32_t* masks;             /* for each face; null: all bits */
    const uint8_t* two_sided;          /* for each face, 0 or 1; null: none */
    const double* uvs;                 /* texture coordinates, two for each of the corners, in repeats, which come out
                                          as they are given; null: none */
} firma_mesh;

/* Closed pieces of a level can be carved; other faces can be cast against only. `name` is for messages and may be null;
 * `options` may be null. A level of which no face is left is FIRMA_ERROR_MALFORMED, with what was left out.
 * Time and memory grow with the mesh or the file, here and below: time a little faster than in proportion, as faces are
 * sorted into a tree, and with the pairs of faces close together, as they are tested for crossings. The mesh is copied
 * first. */
FIRMA_API firma_code firma_world_from_mesh(const firma_mesh* mesh, const char* name, const firma_world_options* options,
                                           firma_world* world);
FIRMA_API firma_code firma_world_from_obj(const char* text, size_t length, const char* name,
                                          const firma_world_options* options, firma_world* world);
/* A Quake .map, a Quake 3 .bsp (version 46): the brushes become one solid, the air rooms, divided by the portals.
 * docs/rooms.md, docs/formats.md. The cost grows also with the brushes and portals that each brush meets. */
FIRMA_API firma_code firma_world_from_bsp(const void* data, size_t length, const char* name,
                                          const firma_world_options* options, firma_world* world);
FIRMA_API firma_code firma_world_from_map(const char* text, size_t length, const char* name,
                                          const firma_world_options* options, firma_world* world);
/* Of a .bsp the surfaces that are drawn: one room, seldom a closed piece. Not in the module for browsers and node. */
FIRMA_API firma_code firma_world_from_bsp_surfaces(const void* data, size_t length, const char* name,
                                                   const firma_world_options* options, firma_world* world);
/* A file by its ending: .obj, .bsp (its brushes), .map, or .firma (`options` must then be null: the file has its own).
 * It is read into memory first. FIRMA_ERROR_UNSUPPORTED for another ending, and in the module for browsers and node. */
FIRMA_API firma_code firma_world_load(const char* path, const firma_world_options* options, firma_world* world);

/* A .firma file, written aside, flushed and renamed. `exact` 0 leaves the exact part out: the world read back can be
 * cast against, but not carved. Costs firma_world_pack(), writing the bytes, and two flushes that wait for the disk. */
FIRMA_API firma_code firma_world_save(firma_world world, const char* path, uint32_t exact);
/* The bytes of such a file, and back. Either way it costs all faces, in time and memory; back with the checks of the
 * whole world, as firma_world_check() makes them. FIRMA_ERROR_MALFORMED for damage. */
FIRMA_API firma_code firma_world_pack(firma_world world, uint32_t exact, firma_bytes* bytes);
FIRMA_API firma_code firma_world_unpack(const void* data, size_t length, const char* name, firma_world* world);

/* ---- levels ----------------------------------------------------------------------------------------------------- */

/* A level of brushes as its file has it: for its entities, and for a world of it. `scale`: metres a unit, 0 for the
 * format's own. Time and memory grow with the file, time also with the square of a brush's sides; brushes are not
 * joined yet. */
FIRMA_API firma_code firma_level_from_map(const char* text, size_t length, const char* name, double scale,
                                          firma_level* level);
FIRMA_API firma_code firma_level_from_bsp(const void* data, size_t length, const char* name, double scale,
                                          firma_level* level);
/* A .map or .bsp by its file, read into memory first. Not in the module for browsers and node. */
FIRMA_API firma_code firma_level_load(const char* path, double scale, firma_level* level);
/* The world that firma_world_from_map() would make; the scale of the options is ignored. Costs what that costs, less
 * the reading. */
FIRMA_API firma_code firma_world_from_level(firma_level level, const firma_world_options* options, firma_world* world);

typedef struct firma_entity {
    const char* classname;     /* "" where it has none */
    const char* const* keys;   /* UTF-8, in the file's order, as written */
    const char* const* values; /* for each key */
    size_t key_count;
    double origin[3];    /* metres; where has_origin is 1 */
    uint32_t has_origin; /* 1: its `origin` is three numbers */
    uint32_t line;       /* where it begins in the file, from 1; 0 where the format has none */
} firma_entity;

/* Things of one kind that a file holds and a world of it will not. */
typedef struct firma_omission {
    const char* what;  /* in the plural: "primitives 'brushDef9'", "faces without area" */
    const char* first; /* the place of the first; "" where the format has none */
    uint64_t count;
} firma_omission;

/* Metres; along each axis from `low` to `high`. */
typedef struct firma_box {
    double low[3], high[3];
} firma_box;

typedef struct firma_level_view {
    uint32_t size;                /* sizeof(firma_level_view) */
    const firma_entity* entities; /* the first is the world */
    size_t entity_count;
    const char* const* notes; /* for people: what was dropped, replaced or not understood, with its place */
    size_t note_count;
    const firma_omission* omissions; /* what the file holds and casts will not meet */
    size_t omission_count;
    double metres_a_unit;     /* for numbers in the entities' values */
    const firma_box* anchors; /* around each brush of its entities firma_anchor: `volumes` of firma_anchors */
    size_t anchor_count;
} firma_level_view;

/* Views are good until the handle is released. Made with the level. */
FIRMA_API firma_code firma_level_get_view(firma_level level, firma_level_view* view);
FIRMA_API firma_code firma_level_release(firma_level level);

/* Another handle to the same value: shares all of it. */
FIRMA_API firma_code firma_world_copy(firma_world world, firma_world* copy);
FIRMA_API firma_code firma_world_release(firma_world world);

typedef struct firma_world_facts {
    uint32_t size;    /* sizeof(firma_world_facts) */
    uint32_t edits;   /* cuts and fills so far */
    uint64_t version; /* 0 as read; every edit adds one */
    uint64_t face_count;
    uint64_t room_count;    /* those that edits joined to others counted */
    uint64_t portal_count;  /* those without polygons counted */
    double low[3], high[3]; /* bounds of all faces; low > high when there are none */
    double contact_offset;
    uint32_t material_count;
    uint32_t reserved;
} firma_world_facts;

/* Takes no memory. Costs a few walks through the index, for the bounds; more where many faces reach to within a float's
 * rounding of them. */
FIRMA_API firma_code firma_world_get_facts(firma_world world, firma_world_facts* facts);
/* Of everything the world holds: equal edits in equal order give equal ones on every machine. Kept as edits go: costs a
 * few nanoseconds a material, whatever the faces. */
FIRMA_API firma_code firma_world_hash(firma_world world, uint64_t* hash);
/* Of the solid's set of points alone: equal for equal solids, however they came about. Kept as edits go. */
FIRMA_API firma_code firma_world_hash_solid(firma_world world, uint64_t* hash);
/* Sets `same` to 1 when the solids of two worlds are the same set of points, exactly, however their surfaces are
 * divided, else to 0. Ids, materials, rooms and faces that are castable only do not count. Different hashes of solids
 * cost nothing; else the cost grows with the faces of what the worlds do not share. */
FIRMA_API firma_code firma_world_same_solid(firma_world a, firma_world b, uint32_t* same);

/* Of a cube of 32 m: from region * 32 m to (region + 1) * 32 m along each axis. */
typedef struct firma_region_hash {
    int32_t region[3];
    uint32_t reserved;
    uint64_t faces;  /* of all that faces are whose lowest corner lies there */
    uint64_t points; /* of the solid's set of points: of its corners there */
} firma_region_hash;

/* Of each region with anything in it, in an order that is the same everywhere: so two machines can find where their
 * worlds differ. `count` gets how many; the first `capacity` are written (`hashes` may be null when that is 0). Kept as
 * edits go: costs the regions that hold or held anything, whatever the faces. */
FIRMA_API firma_code firma_world_hash_regions(firma_world world, firma_region_hash* hashes, size_t capacity,
                                              size_t* count);
/* FIRMA_ERROR_BROKEN when an invariant of faces, trees or the exact solid does not hold: the message names it. Costs
 * all faces, in time and memory, and sorting them. */
FIRMA_API firma_code firma_world_check(firma_world world);
/* The exact solid's volume, cubic metres (where rock reaches to infinity, minus that of its air), and its area, square
 * metres. Either pointer may be null. Costs all faces, in time and memory. */
FIRMA_API firma_code firma_world_measure(firma_world world, double* volume, double* area);
/* Bytes that several worlds hold together; what they share counts once. Goes through every block, room and portal of
 * them, with a table of those seen: grows with all faces. */
FIRMA_API firma_code firma_world_memory(const firma_world* worlds, size_t count, uint64_t* bytes);
/* UTF-8; good as long as the handle. Materials have a number each in a world: of a mesh, the caller's own; of a file, 0
 * is "", of faces without one. Everything that a world says or is told of a material is by that number.
 * FIRMA_ERROR_INVALID for one that the world does not have. Takes no memory. */
FIRMA_API firma_code firma_world_material(firma_world world, uint32_t material, const char** name);

/* Regions and materials that refuse a cut (hardness 1) or shrink it, and limits; 0 for a limit takes the default. */
typedef struct firma_zone {
    const char* name; /* for messages; may be null */
    double low[3], high[3];
    double hardness; /* 0..1 */
} firma_zone;

typedef struct firma_rules {
    uint32_t size;     /* sizeof(firma_rules) */
    uint32_t reserved; /* must be 0, else FIRMA_ERROR_INVALID */
    const firma_zone* zones;
    size_t zone_count;
    const double* hardness; /* by number of the material in the world; missing ones are 0 */
    size_t hardness_count;
    uint64_t max_faces, max_candidate_faces, max_new_faces, max_cutter_triangles, max_pairs, max_corners;
    double max_cutter_size; /* metres */
    double merge_share;     /* rooms become one where open portals that carvings made between them are larger than this
                               share of the walls of the one that has less; never across a closed portal. 0: they stay */
    /* 0: a carving also takes, of faces that bound no solid (sheets, decals, clips, glass), what lies in the cutter;
     * liquids stay, and what else stops neither walkers nor shots nor sight. 1: all of them stay. */
    uint32_t no_open_faces;
    uint32_t reserved2; /* must be 0 */
} firma_rules;

/* The same world under other rules for carving, which are copied; shares all else. FIRMA_ERROR_INVALID for a hardness
 * that is not within 0..1, a box that is empty or not of numbers, a max_cutter_size that is no length, a no_open_faces
 * that is not 0 or 1. Costs the zones and hardnesses. */
FIRMA_API firma_code firma_world_with_rules(firma_world world, const firma_rules* rules, firma_world* with_rules);

/* ---- faces ------------------------------------------------------------------------------------------------------ */

/* What faces stop: bits of their masks, and of casts'. Faces of formats that know no contents have all bits. */
#define FIRMA_STOPS_WALK 1u   /* bodies that walk: walls, glass, clip brushes */
#define FIRMA_STOPS_SHOTS 2u  /* walls, glass */
#define FIRMA_STOPS_SIGHT 4u  /* walls, but no glass */
#define FIRMA_STOPS_LIQUID 8u /* the surface of water, slime, lava */
#define FIRMA_IS_SKY 16u      /* in addition to what a wall stops: the sky is painted on it */
#define FIRMA_STOPS_SOLID (FIRMA_STOPS_WALK | FIRMA_STOPS_SHOTS | FIRMA_STOPS_SIGHT)

#define FIRMA_FACE_TWO_SIDED 1u
#define FIRMA_FACE_SOLID 2u /* bounds a closed solid, which can be carved */

typedef struct firma_face {
    double normal[3]; /* unit, of the exact plane that the face was cut from */
    uint32_t id;
    uint32_t source;      /* index of the face in the level's file, or see source_edit */
    uint32_t source_edit; /* 0: of the level's file; else the number of the edit whose cutter's triangle `source` is, of
                             several in one plane the lowest */
    uint32_t material;
    uint32_t mask;
    uint32_t flags;        /* FIRMA_FACE_... */
    uint32_t room;         /* that it looks into */
    uint32_t first_corner; /* in firma_faces_view.corners, counted in points */
    uint32_t corner_count;
    int32_t corner[3]; /* its first, in steps of 1/262144 m: where to look for it */
} firma_face;

typedef struct firma_faces_view {
    uint32_t size; /* sizeof(firma_faces_view) */
    const firma_face* faces;
    size_t face_count;
    const double* corners; /* three for each */
    size_t corner_count;
} firma_faces_view;

/* Which faces; a null pointer takes all. At most one of room, box and region. */
typedef struct firma_face_filter {
    uint32_t size;         /* sizeof(firma_face_filter) */
    uint32_t room;         /* those that look into it, or into the one that it became part of; or FIRMA_ANY_ROOM */
    const double* box;     /* six: low, high. Those whose own box shares a point with it; may be null */
    const int32_t* region; /* three: those whose lowest corner lies in the cube of 32 m from region * 32 m on; may be
                              null */
} firma_face_filter;

FIRMA_API void firma_face_filter_defaults(firma_face_filter* filter);

/* Gets a face and its corners, three doubles for each; both are good until it returns. Returns 1 to go on, 0 to stop.
 */
typedef uint32_t (*firma_face_visitor)(const firma_face* face, const double* corners, void* user);

/* All faces, in order of id. Costs some hundred nanoseconds a face, and sorting them; holds them twice until it
 * returns. */
FIRMA_API firma_code firma_world_faces(firma_world world, firma_faces* faces);
/* Some, in no particular order. Costs the faces that the filter takes, and the walk through the index down to them: of
 * a box or region to what lies near it. FIRMA_ERROR_INVALID for a room that the world does not have, and for more than
 * one of the three; FIRMA_ERROR_OUT_OF_RANGE for a box that is not finite. */
FIRMA_API firma_code firma_world_faces_in(firma_world world, const firma_face_filter* filter, firma_faces* faces);
/* The same one by one, without taking memory, up to where the visitor stops it. `completed` gets 0 when it did, else 1;
 * it may be null. */
FIRMA_API firma_code firma_world_each_face(firma_world world, const firma_face_filter* filter, firma_face_visitor visit,
                                           void* user, uint32_t* completed);
/* The face of a hit, a firma_near or a firma_face by its id and first corner: a list of one. FIRMA_ERROR_INVALID when
 * the world has no such face: cut since, or of another world. Costs a walk through the index. */
FIRMA_API firma_code firma_world_face(firma_world world, uint32_t id, const int32_t corner[3], firma_faces* faces);
/* One face by its id; none in the list when the world has no such face. Goes through all faces of the world. */
FIRMA_API firma_code firma_world_find_face(firma_world world, uint32_t id, firma_faces* faces);
/* Views are good until the handle is released. */
FIRMA_API firma_code firma_faces_get_view(firma_faces faces, firma_faces_view* view);
FIRMA_API firma_code firma_faces_release(firma_faces faces);

/* ---- textures --------------------------------------------------------------------------------------------------- */

/* What texture coordinates count. u goes to the right in the picture, v down, (0, 0) is its top left corner. */
typedef enum firma_texture_unit {
    FIRMA_TEXELS = 0,  /* pixels of the picture, whose size the file does not say: divided by it they are repeats */
    FIRMA_REPEATS = 1, /* the whole picture is 1 wide and 1 high */
    FIRMA_METRES = 2   /* of no file */
} firma_texture_unit;

/* u = u_axis . p + u_offset of a point p of the face, in metres; v likewise. */
typedef struct firma_texture {
    uint32_t size; /* sizeof(firma_texture) */
    uint32_t unit; /* firma_texture_unit */
    double u_axis[3], u_offset;
    double v_axis[3], v_offset;
} firma_texture;

/* How the texture lies on a face, as the level's file says it of the face that it was cut from. Of a face that an edit
 * made, and where the file says nothing, FIRMA_METRES: straight along the axis nearest to its normal, in metres from
 * the world's origin. `corner` is the face's first, as in firma_hit: then it costs a walk through the index, and a
 * search among the faces of the file; null: all faces are searched. FIRMA_ERROR_INVALID for a face that the world
 * does not have. */
FIRMA_API firma_code firma_world_texture(firma_world world, uint32_t face, const int32_t corner[3],
                                         firma_texture* texture);

/* ---- triangles -------------------------------------------------------------------------------------------------- */

/* Of one material, one behind the other: a draw call. */
typedef struct firma_triangle_run {
    uint32_t material;
    uint32_t first_triangle, triangle_count;
    uint32_t first_vertex, vertex_count; /* which its triangles name, and no other run's do */
    uint32_t reserved;
} firma_triangle_run;

/* A face, and where it came from. */
typedef struct firma_triangle_source {
    uint32_t face;
    uint32_t room;                /* that it looks into */
    uint32_t source, source_edit; /* as in firma_face */
    uint32_t material, mask;
    uint32_t flags; /* FIRMA_FACE_... */
    uint32_t first_triangle, triangle_count;
    uint32_t first_vertex, vertex_count;
    uint32_t uv_unit; /* firma_texture_unit: what its uvs count; FIRMA_METRES where none were asked for */
} firma_triangle_source;

typedef struct firma_triangles_view {
    uint32_t size;          /* sizeof(firma_triangles_view) */
    const float* positions; /* three for each vertex: metres from the origin of the options */
    const float* normals;   /* three for each vertex, unit */
    size_t vertex_count;
    const uint32_t* corners; /* three for each triangle: vertices, counter-clockwise seen from the front */
    const uint32_t* faces;   /* of each triangle */
    size_t triangle_count;
    const firma_triangle_run* runs; /* in order of material */
    size_t run_count;
    const firma_triangle_source* sources; /* in order of material, then face */
    size_t source_count;
    const float* uvs; /* two for each vertex, in the unit that the source says; null unless asked for */
} firma_triangles_view;

/* A null pointer takes the defaults: all faces of the world, from the world's origin. */
typedef struct firma_triangle_options {
    uint32_t size;         /* sizeof(firma_triangle_options) */
    uint32_t mask;         /* faces that share a bit */
    uint32_t solid_only;   /* 1: without the faces that bound no solid */
    uint32_t room;         /* only faces that look into this room; or FIRMA_ANY_ROOM */
    double origin[3];      /* metres: what positions are told from. Near the faces, floats lose least */
    const int32_t* region; /* three: only faces whose lowest corner lies in the cube of 32 m from region * 32 m on;
                              null: all. Not together with a room */
    const double* texture_sizes; /* texels across and down of pictures, by number of the material in the world: where
                                    both are above 0, texels become repeats; may be null when the count is 0 */
    size_t texture_size_count;   /* how many pairs; missing ones are unknown */
    uint32_t uvs;                /* 1: texture coordinates too */
    uint32_t reserved;           /* must be 0, else FIRMA_ERROR_INVALID */
} firma_triangle_options;

FIRMA_API void firma_triangle_options_defaults(firma_triangle_options* options);

/* Faces as triangles, for a renderer or another engine's collider. None is without area on the surface grid. Costs some
 * hundred nanoseconds a face that the options take, and sorting them; with texture coordinates a search a face besides.
 * FIRMA_ERROR_INVALID for a room that the world does not have, FIRMA_ERROR_OUT_OF_RANGE for an origin that is not
 * finite. */
FIRMA_API firma_code firma_world_triangles(firma_world world, const firma_triangle_options* options,
                                           firma_triangles* triangles);
/* Views are good until the handle is released. */
FIRMA_API firma_code firma_triangles_get_view(firma_triangles triangles, firma_triangles_view* view);
FIRMA_API firma_code firma_triangles_release(firma_triangles triangles);

/* ---- meshes by region ------------------------------------------------------------------------------------------- */

/* Triangles that are drawn alike, one behind the other: a draw call. */
typedef struct firma_region_run {
    uint32_t material;
    uint32_t cut;       /* 1: of faces that edits made */
    uint32_t two_sided; /* 1: also seen from behind */
    uint32_t uv_unit;   /* firma_texture_unit: what their uvs count */
    uint32_t first_triangle, triangle_count;
    uint32_t first_vertex, vertex_count; /* which its triangles name, and no other run's do */
} firma_region_run;

/* A face, and where it came from. */
typedef struct firma_region_part {
    uint32_t face;
    int32_t corner[3];            /* its first, as in firma_hit */
    uint32_t source, source_edit; /* as in firma_face */
    uint32_t mask;
    uint32_t flags; /* FIRMA_FACE_... */
    uint32_t first_triangle, triangle_count;
    uint32_t first_vertex, vertex_count;
} firma_region_part;

/* The triangles of the faces whose lowest corner (by x, then y, then z) lies in one cube. Arrays are null when they
 * have no entry, those of textures also without textures. docs/drawing.md says what they mean. */
typedef struct firma_region_mesh_view {
    uint32_t size;          /* sizeof(firma_region_mesh_view) */
    int32_t place[3];       /* the cube is from place * region_size to (place + 1) * region_size */
    double origin[3];       /* metres: place * region_size; what positions are told from */
    double low[3], high[3]; /* metres: around all corners; low is above high where there is none */
    const float* positions; /* three for each vertex: metres from the origin, exact up to 64 m */
    const float* normals;   /* three for each vertex, unit */
    const float* tangents;  /* four for each vertex: unit, where u grows and v stays; 1, or -1 where mirrored */
    const float* uvs;       /* two for each vertex, in the unit that the run says */
    const uint8_t* blends;  /* four for each vertex, 255 in all: of the pictures along x, y, z, and of that by uvs */
    size_t vertex_count;
    const uint32_t* corners; /* three for each triangle: vertices, counter-clockwise seen from the front */
    const uint32_t* faces;   /* of each triangle */
    size_t triangle_count;
    const firma_region_run* runs; /* in order of material, cut, two_sided, uv_unit */
    size_t run_count;
    const firma_region_part* parts; /* in the order of runs, in each of face */
    size_t part_count;
} firma_region_mesh_view;

/* A null pointer takes the defaults. */
typedef struct firma_region_options {
    uint32_t size;               /* sizeof(firma_region_options) */
    uint32_t mask;               /* faces that share a bit; all */
    uint32_t solid_only;         /* 1: without the faces that bound no solid */
    uint32_t no_textures;        /* 1: without tangents, uvs and blends */
    double region_size;          /* metres: the edge of each cube, 1 to 1024, in whole sixteenths; 16 */
    const double* texture_sizes; /* as in firma_triangle_options, each finite and not negative */
    size_t texture_size_count;
} firma_region_options;

FIRMA_API void firma_region_options_defaults(firma_region_options* options);

/* The meshes of all cubes with triangles to draw, in order of place. FIRMA_ERROR_INVALID for options that are none,
 * naming which. Costs some microseconds a face. */
FIRMA_API firma_code firma_world_region_meshes(firma_world world, const firma_region_options* options,
                                               firma_region_meshes* meshes);
/* Of two versions of one level: those of the cubes that differ, as they are in `after`. A cube that has nothing to draw
 * any more, or had nothing, has an empty mesh. Costs the faces that only one of them has, and all faces of those cubes.
 */
FIRMA_API firma_code firma_world_changed_region_meshes(firma_world before, firma_world after,
                                                       const firma_region_options* options,
                                                       firma_region_meshes* meshes);
FIRMA_API firma_code firma_region_meshes_get_count(firma_region_meshes meshes, size_t* count);
/* FIRMA_ERROR_OUT_OF_RANGE beyond the count. Views are good until the handle is released. */
FIRMA_API firma_code firma_region_meshes_get_view(firma_region_meshes meshes, size_t mesh,
                                                  firma_region_mesh_view* view);
FIRMA_API firma_code firma_region_meshes_release(firma_region_meshes meshes);

/* ---- rooms ------------------------------------------------------------------------------------------------------ */

/* Rooms are volumes of air, bounded by faces and by portals, through which their air passes into other rooms. A level
 * that knows no rooms makes a world of one. Rooms and portals keep their numbers through edits: docs/rooms.md. */

typedef enum firma_where {
    FIRMA_AIR = 0,
    FIRMA_SOLID = 1,
    FIRMA_SURFACE = 2, /* on a face that bounds the solid, exactly */
    FIRMA_UNKNOWN = 3  /* in a fold of the surface that rounding to the grid made; docs/rooms.md has more */
} firma_where;

/* Where a point is. `where` gets a firma_where, `room` the room, with FIRMA_AIR, or FIRMA_NO_ROOM; it may be null.
 * FIRMA_ERROR_OUT_OF_RANGE for numbers that are not finite or too large. Takes no memory. Costs a cast or two; up to
 * eight, and a search of the faces around the point, for one on the surface; among several rooms a look at each for one
 * that sees nothing. */
FIRMA_API firma_code firma_world_locate(firma_world world, const double point[3], uint32_t* where, uint32_t* room);

/* What pointers show is good as long as the handle of the world. */
typedef struct firma_room {
    uint32_t size;          /* sizeof(firma_room) */
    uint32_t exterior;      /* 1: reaches to infinity */
    double low[3], high[3]; /* of its faces and portals; low > high when there are none */
    uint64_t face_count;
    const char* name;        /* UTF-8; "" where the level gives none */
    const uint32_t* portals; /* ascending */
    size_t portal_count;
    uint32_t merged_into; /* itself; of a room that an edit joined to another: that one, and it is empty */
    uint32_t reserved;
} firma_room;

/* FIRMA_ERROR_INVALID for a room that the world does not have, here and below, and for such a portal. Takes no memory;
 * costs the same for every room, but for a few steps more where edits joined many rooms. */
FIRMA_API firma_code firma_world_room(firma_world world, uint32_t room, firma_room* info);

/* The room of a name, the first of several, or FIRMA_NO_ROOM; a portal of a name, or FIRMA_NO_PORTAL. Takes no memory;
 * costs a look at each room or portal, up to the one found. */
FIRMA_API firma_code firma_world_find_room(firma_world world, const char* name, uint32_t* room);
FIRMA_API firma_code firma_world_find_portal(firma_world world, const char* name, uint32_t* portal);

typedef struct firma_portal {
    uint32_t size; /* sizeof(firma_portal) */
    uint32_t material;
    double low[3], high[3]; /* low > high when it has no polygons */
    const char* name;       /* UTF-8; "" where the level gives none */
    uint32_t rooms[2];
    uint32_t mask;          /* what it stops while closed: FIRMA_STOPS_... */
    uint32_t open;          /* 0 or 1 */
    uint32_t polygon_count; /* 0: an edit joined its rooms, or filled it, and it leads nowhere */
    uint32_t reserved;
} firma_portal;

/* What a portal is. `name` is good as long as the handle of the world. Takes no memory; costs as firma_world_room(). */
FIRMA_API firma_code firma_world_portal(firma_world world, uint32_t portal, firma_portal* info);
/* Its polygons as a list of faces: convex, counter-clockwise seen from rooms[0]; `source` is the portal, `id`
 * FIRMA_NO_FACE. Costs copying them. */
FIRMA_API firma_code firma_world_portal_polygons(firma_world world, uint32_t portal, firma_faces* polygons);
/* Opens (1) or closes (0) it: one version on, or, when it is so already or has no polygons, another handle to the same
 * world. Costs a few small copies, however many portals and faces there are, and the corners of this portal. */
FIRMA_API firma_code firma_world_set_portal_open(firma_world world, uint32_t portal, uint32_t open, firma_world* after);

/* The rooms that portals, open or closed, join to a room, ascending. `count` gets how many; the first `capacity` of
 * them are written (`rooms` may be null when that is 0). Costs the room's portals, and sorting them. */
FIRMA_API firma_code firma_world_neighbours(firma_world world, uint32_t room, uint32_t* rooms, size_t capacity,
                                            size_t* count);
/* The way between two rooms by the fewest portals: through open ones, or, with `all_open` 1, through closed ones, too.
 * `found` gets 0 when there is none; `count` how many portals it passes (none within one room), of which the first
 * `capacity` are written (`portals` may be null when that is 0). Goes through the rooms no farther from `to`
 * than `from` is, and their portals, and takes memory for each room of the world. */
FIRMA_API firma_code firma_world_path(firma_world world, uint32_t from, uint32_t to, uint32_t all_open,
                                      uint32_t* portals, size_t capacity, size_t* count, uint32_t* found);

/* ---- casts ------------------------------------------------------------------------------------------------------ */

/* What casts cost grows with the logarithm of the faces, and with the faces near the path: up to the first touch for
 * firma_cast(), up to any for firma_cast_any(), up to where the visitor ends it for firma_cast_each(), along all of it
 * for firma_cast_all(). For firma_overlap() these are the faces near the ball, for firma_closest() those about as near
 * as the nearest. By room it is the faces of the rooms reached alone, and the box of each of their portals; two bits
 * for each room of the world are cleared. FIRMA_LOCATE_ROOM adds firma_world_locate(). Those that write one struct, and
 * those with a visitor, take no memory; but by room, where there are more than 4,096 rooms or more than 256 wait at a
 * time, a thread's first such casts take some that it keeps. */

typedef enum firma_status { FIRMA_MISS = 0, FIRMA_HIT = 1, FIRMA_INITIAL_OVERLAP = 2, FIRMA_INVALID = 3 } firma_status;
typedef enum firma_feature { FIRMA_FACE = 0, FIRMA_EDGE = 1, FIRMA_VERTEX = 2 } firma_feature;

/* A sphere and its path; radius 0 casts a particle. */
typedef struct firma_cast_input {
    double centre[3];
    double radius;
    double path[3];
} firma_cast_input;

/* A null pointer takes the defaults: all bits, one-sided, all rooms, the world's contact offset. */
typedef struct firma_cast_options {
    uint32_t size;         /* sizeof(firma_cast_options) */
    uint32_t mask;         /* faces that share a bit are met */
    uint32_t sides;        /* 0: the front, where the face does not say both; 1: both sides of all */
    uint32_t room;         /* the one that the start lies in, and the cast goes on through portals; or FIRMA_ANY_ROOM,
                              FIRMA_LOCATE_ROOM. From the air, clear of faces, the answer is the same: docs/rooms.md */
    double contact_offset; /* metres, finite; negative takes the world's */
    uint32_t* passed;      /* gets the rooms that firma_cast() passes, in the order in which they are reached, the first
                              `passed_capacity` of them; may be null when that is 0. Of no use to the other calls */
    size_t passed_capacity;
    uint32_t* passed_count; /* gets how many there were, the first included: 0 when all rooms of a world of several were
                               asked; may be null */
    uint32_t* passed_portals; /* gets for each of these rooms the portal that it was reached through first,
                                 FIRMA_NO_PORTAL for the first room; as long as `passed`; may be null */
} firma_cast_options;

FIRMA_API void firma_cast_options_defaults(firma_cast_options* options);

/* A miss has fraction and safe_fraction 1, and the end of the path as its centre; FIRMA_INVALID has fraction 0. What
 * else there is to know of the face met tells firma_world_hit_info(). */
typedef struct firma_hit {
    double fraction;      /* of the path, 0..1 */
    double safe_fraction; /* how far to go so that the contact offset is kept */
    double centre[3];     /* of the sphere at `fraction` */
    double point[3];      /* of the surface */
    double normal[3];     /* unit, from `point` toward the centre */
    double face_normal[3];
    uint32_t status;  /* firma_status; FIRMA_INVALID: a number of the input is non-finite or out of range, or the world
                         does not have the room: nothing was asked */
    uint32_t feature; /* firma_feature */
    uint32_t feature_index; /* corner of the vertex, or of the edge's first corner */
    uint32_t face;          /* FIRMA_NO_FACE for a miss, and where a closed portal was met */
    int32_t corner[3];      /* the face's first, in steps of 1/262144 m: where to look for it */
    uint32_t portal;        /* the closed one met, or FIRMA_NO_PORTAL */
    uint32_t material;      /* of the face, or of the portal */
    uint32_t reserved;
} firma_hit;

/* What only some ask of a hit. */
typedef struct firma_hit_info {
    uint32_t size;                /* sizeof(firma_hit_info) */
    uint32_t room;                /* that the face looks into; of a portal the one on the side that was met */
    uint32_t source, source_edit; /* as in firma_face; 0 for a portal */
    uint32_t mask;
    uint32_t flags;      /* FIRMA_FACE_...; 0 for a portal */
    uint32_t other_face; /* across the edge met, or FIRMA_NO_FACE */
    uint32_t reserved;
} firma_hit_info;

/* FIRMA_ERROR_INVALID for a miss, and for a face or portal that the world does not have: of another world or version,
 * or cut since. Takes no memory; costs a walk through the index, and another one at an edge. */
FIRMA_API firma_code firma_world_hit_info(firma_world world, const firma_hit* hit, firma_hit_info* info);

/* What casts tested; added to. */
typedef struct firma_cast_counts {
    uint64_t nodes, boxes, faces, precise;
} firma_cast_counts;

/* The first touch. Bad numbers in the input, and a room that the world does not have, give FIRMA_OK with status
 * FIRMA_INVALID; options that make no sense, as a contact offset that is not finite, FIRMA_ERROR_INVALID. `counts` may
 * be null. */
FIRMA_API firma_code firma_cast(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                                firma_hit* hit, firma_cast_counts* counts);
/* Whether there is any touch: firma_status. */
FIRMA_API firma_code firma_cast_any(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                                    uint32_t* status);
/* Every face and closed portal met along the whole path, by fraction, then id. `count` gets how many there are; the
 * first `capacity` of them are written (`hits` may be null when that is 0). Takes memory for all of them, and sorts
 * them. Where firma_cast() gives FIRMA_INVALID: FIRMA_ERROR_OUT_OF_RANGE for numbers, FIRMA_ERROR_INVALID for a room
 * that the world does not have. */
FIRMA_API firma_code firma_cast_all(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                                    firma_hit* hits, size_t capacity, size_t* count);
/* Gets one hit at a time, good until it returns. Returns the fraction up to which to look on: 1 goes on as before,
 * hit->fraction asks for nothing later than this hit, 0 or less ends the cast. It can only bring the end nearer. */
typedef double (*firma_hit_visitor)(const firma_hit* hit, void* user);
/* Every face and closed portal that the sphere would meet along the path, as if alone, in no particular order: to
 * filter, to stop early, to collect. Takes no memory. `status` gets FIRMA_MISS when the visitor was given nothing,
 * FIRMA_INVALID as firma_cast(), else FIRMA_HIT; it may be null. */
FIRMA_API firma_code firma_cast_each(firma_world world, const firma_cast_input* input,
                                     const firma_cast_options* options, firma_hit_visitor visit, void* user,
                                     uint32_t* status);
/* Many casts: hits[k] answers inputs[k], as firma_cast() would. `counts` may be null. When firma_tasks.run does not do
 * all of it: FIRMA_ERROR_BAD_CALL, all hits have status FIRMA_INVALID, and nothing is added to `counts`. Over
 * millions of faces it costs 0.5 to 0.7 of its casts one by one, over fewer than a hundred thousand as much; each
 * thread at work takes 150 KB meanwhile, and some bytes where `counts` is given or firma_set_tasks() was called. For
 * other shapes, columns, progress: firma_cast_many(). */
FIRMA_API firma_code firma_cast_batch(firma_world world, const firma_cast_input* inputs, size_t count,
                                      const firma_cast_options* options, firma_hit* hits, firma_cast_counts* counts);

/* ---- other shapes that move ------------------------------------------------------------------------------------- */

/* The convex hull of points, made once, for the way it is turned, and put anywhere; it never changes. At most 64
 * points, three doubles each, metres, from where it is put. FIRMA_ERROR_TOO_LARGE for more; FIRMA_ERROR_OUT_OF_RANGE,
 * with the point, for a number that is not finite or beyond 2^199; FIRMA_ERROR_INVALID for fewer than four points, for
 * points in one plane, and for a hull that the place it is put at lies outside of. Costs some microseconds for a box,
 * some hundred for 64 points. */
FIRMA_API firma_code firma_hull_from_points(const double* points, size_t count, firma_hull* hull);
/* A box around its middle. `half`: metres, > 0. `axes`: three unit vectors, perpendicular to each other; null: upright.
 * docs/casting.md says which doubles its corners are. Errors and costs as above. */
FIRMA_API firma_code firma_hull_box(const double half[3], const double axes[9], firma_hull* hull);
/* Those of the points that the hull needs, in no particular order: `count` gets how many, at most 64, and the first
 * `capacity` of them are written, three doubles each (`corners` may be null when that is 0). */
FIRMA_API firma_code firma_hull_corners(firma_hull hull, double* corners, size_t capacity, size_t* count);
FIRMA_API firma_code firma_hull_release(firma_hull hull);

typedef enum firma_mover_kind {
    FIRMA_MOVER_SPHERE = 0,  /* radius 0 is a particle */
    FIRMA_MOVER_CAPSULE = 1, /* all within the radius of a segment; with both ends at one place a sphere */
    FIRMA_MOVER_HULL = 2     /* a convex hull or box */
} firma_mover_kind;

/* A shape that moves, without turning. */
typedef struct firma_mover {
    uint32_t size;   /* sizeof(firma_mover) */
    uint32_t kind;   /* firma_mover_kind */
    double at[3];    /* a sphere's centre, an end of a capsule's segment, the place where a hull is put */
    double to[3];    /* the other end of a capsule's segment; not of other kinds */
    double radius;   /* of a sphere or capsule, >= 0 */
    firma_hull hull; /* of a hull */
} firma_mover;

/* As firma_cast(), firma_cast_any(), firma_cast_all() and firma_cast_each(), of any mover. `path`: three doubles. What
 * these say of a sphere's centre is the middle of a capsule's segment, and the place where a hull is put: of
 * firma_hit.centre, of the room that the options name, of FIRMA_LOCATE_ROOM. FIRMA_ERROR_INVALID for a kind that is
 * none, FIRMA_ERROR_BAD_HANDLE for a hull that is not held. They cost as a sphere, and for each face near a capsule
 * about two spheres more, for each near a hull the product of the edges of both at most. */
FIRMA_API firma_code firma_cast_mover(firma_world world, const firma_mover* mover, const double path[3],
                                      const firma_cast_options* options, firma_hit* hit, firma_cast_counts* counts);
FIRMA_API firma_code firma_cast_mover_any(firma_world world, const firma_mover* mover, const double path[3],
                                          const firma_cast_options* options, uint32_t* status);
FIRMA_API firma_code firma_cast_mover_all(firma_world world, const firma_mover* mover, const double path[3],
                                          const firma_cast_options* options, firma_hit* hits, size_t capacity,
                                          size_t* count);
FIRMA_API firma_code firma_cast_mover_each(firma_world world, const firma_mover* mover, const double path[3],
                                           const firma_cast_options* options, firma_hit_visitor visit, void* user,
                                           uint32_t* status);

/* Where a hull touches the face or closed portal that it met: up to four points of that, three doubles each, in order
 * around the normal; none for a miss. `points` has room for twelve. Of a portal of several polygons, points of the one
 * nearest to `hit->point`. FIRMA_ERROR_INVALID where the world does not have the face or portal: cut since, or of
 * another world. Takes memory for the face's corners. docs/casting.md says which points. */
FIRMA_API firma_code firma_contact_points(firma_world world, firma_hull hull, const firma_hit* hit, double points[12],
                                          uint32_t* count);

/* Many casts of one kind of mover. Number k of a column is `stride` bytes * k from its start: columns of their own
 * (`stride` 0: 8), or fields of structs of the caller's (`stride` their size). */
typedef struct firma_casts {
    uint32_t size;           /* sizeof(firma_casts) */
    uint32_t kind;           /* firma_mover_kind, of all */
    size_t count;            /* how many */
    size_t stride;           /* a multiple of 8 */
    const double *x, *y, *z; /* as firma_mover.at */
    const double *path_x, *path_y, *path_z;
    const double *to_x, *to_y, *to_z; /* of capsules, as firma_mover.to */
    const double* radius;             /* of spheres and capsules; null: 0 for all */
    const firma_hull* hulls;          /* of hulls: those that are cast; one after the other, without a stride */
    size_t hull_count;
    const uint32_t* hull_of; /* of each cast, one after the other, which of the hulls; null: the first */
} firma_casts;

/* Answers, each as long as there are casts; null where it is not wanted. What they say is in firma_hit. */
typedef struct firma_answers {
    uint32_t size; /* sizeof(firma_answers) */
    uint32_t reserved;
    firma_hit* hits;
    uint32_t* status;
    double *fraction, *safe_fraction;
    double *normal_x, *normal_y, *normal_z;
    uint32_t *face, *portal, *material;
} firma_answers;

/* Is told after each piece of work, by whichever thread did it, one at a time, how many casts are done; returns 1 to go
 * on, 0 to stop. It must not cast many itself. */
typedef uint32_t (*firma_progress)(size_t done, size_t count, void* user);

/* A null pointer takes the defaults: all zero. */
typedef struct firma_many_options {
    uint32_t size; /* sizeof(firma_many_options) */
    uint32_t any;  /* 1: only whether there is any touch, as firma_cast_any(), which costs less: of the answers only
                      `status` may then be wanted */
    firma_progress progress; /* null: nobody is told */
    void* user;              /* handed to progress */
} firma_many_options;

/* Each answer is that of the single cast, to the bit, whatever the threads (firma_set_tasks()), and what
 * else is cast. `cancelled` gets 1 when progress stopped it before all was done, else 0: answers of casts that were not
 * made are then FIRMA_INVALID; it may be null. `counts` may be null; nothing is added to it when the call fails.
 * FIRMA_ERROR_INVALID for a kind, an `any` or a stride that is none, and for a cast whose hull there is not, with its
 * number; FIRMA_ERROR_BAD_HANDLE for a hull that is not held; FIRMA_ERROR_BAD_CALL as firma_cast_batch(). Costs
 * and takes as much as firma_cast_batch(), and memory for hulls. */
FIRMA_API firma_code firma_cast_many(firma_world world, const firma_casts* casts, const firma_cast_options* options,
                                     const firma_many_options* many, const firma_answers* answers,
                                     firma_cast_counts* counts, uint32_t* cancelled);

/* ---- without motion --------------------------------------------------------------------------------------------- */

typedef struct firma_near {
    double point[3];
    double distance;
    double direction[3]; /* of firma_overlap(): unit, the way out */
    double depth;        /* metres to go that way until the sphere touches this face in a point at most */
    uint32_t face;       /* FIRMA_NO_FACE: it is a closed portal */
    int32_t corner[3];   /* the face's first, in steps of 1/262144 m */
    uint32_t feature, feature_index;
    uint32_t portal; /* or FIRMA_NO_PORTAL */
    uint32_t material;
} firma_near;

/* A null pointer takes the defaults: all bits, all rooms. */
typedef struct firma_near_options {
    uint32_t size;     /* sizeof(firma_near_options) */
    uint32_t mask;     /* faces and closed portals that share a bit */
    uint32_t room;     /* only what bounds this room; or FIRMA_ANY_ROOM */
    uint32_t reserved; /* must be 0 */
} firma_near_options;

FIRMA_API void firma_near_options_defaults(firma_near_options* options);

/* Faces that a closed ball touches, in order of id, then closed portals; as for firma_cast_all(). For a centre behind a
 * one-sided face the way out is that face's normal. FIRMA_ERROR_OUT_OF_RANGE for numbers that are not finite or too
 * large, and a negative radius; FIRMA_ERROR_INVALID for a room that the world does not have. Takes memory for all it
 * finds, and sorts it. */
FIRMA_API firma_code firma_overlap(firma_world world, const double centre[3], double radius,
                                   const firma_near_options* options, firma_near* found, size_t capacity,
                                   size_t* count);
/* Gets one at a time, in no particular order; good until it returns. Returns 1 to go on, 0 to stop. */
typedef uint32_t (*firma_overlap_visitor)(const firma_near* found, void* user);
/* The same without taking memory. `found` gets 1 when the visitor was given anything, else 0; it may be null. */
FIRMA_API firma_code firma_overlap_each(firma_world world, const double centre[3], double radius,
                                        const firma_near_options* options, firma_overlap_visitor visit, void* user,
                                        uint32_t* found);
/* The same of any mover, where it is. Of a capsule the nearest point of its segment stands for the centre, and for what
 * is behind a one-sided face its middle; where the segment meets the face itself, and of a hull, the way out is the
 * shortest one. Of a hull `point` is where on the face it still touches when it is out, and `distance` is 0. Cost as a
 * sphere that holds it, and for each face near that what a cast costs. */
FIRMA_API firma_code firma_overlap_mover(firma_world world, const firma_mover* mover, const firma_near_options* options,
                                         firma_near* found, size_t capacity, size_t* count);
FIRMA_API firma_code firma_overlap_mover_each(firma_world world, const firma_mover* mover,
                                              const firma_near_options* options, firma_overlap_visitor visit,
                                              void* user, uint32_t* found);
/* The nearest point of all faces within `reach` metres (INFINITY: anywhere); `found` gets 0 or 1.
 * Errors as above, and FIRMA_ERROR_OUT_OF_RANGE for a negative reach. A short reach where nothing is near costs
 * least. */
FIRMA_API firma_code firma_closest(firma_world world, const double point[3], double reach,
                                   const firma_near_options* options, firma_near* near, uint32_t* found);

/* ---- parts that move -------------------------------------------------------------------------------------------- */

/* Doors, lifts, trains, blades: solids of their own, each in a frame that moves from fraction 0 to 1 of the time at
 * hand. Casts of a scene move their shape meanwhile. docs/moving.md has the contract. */

/* In place of a part: the level itself, or nothing. */
#define FIRMA_NO_PART UINT32_MAX

/* The frame's origin goes straight, at an even pace, while all else turns about it, evenly as well. */
typedef struct firma_motion {
    double position[3]; /* of the origin at the start, metres */
    double rotation[4]; /* x, y, z, w, at the start; not all zero */
    double path[3];     /* of the origin, metres */
    double turn[3];     /* axis times angle, radians, in the world's axes; at most 8 long */
} firma_motion;

typedef struct firma_part {
    uint32_t size;     /* sizeof(firma_part) */
    uint32_t mask;     /* met by what shares a bit with it, and with the face */
    firma_world world; /* the solid in the part's frame, of one room; shared: the handle may be released */
    firma_motion motion;
} firma_part;

/* All bits, standing at the origin, without a world. */
FIRMA_API void firma_part_defaults(firma_part* part);

/* An empty list of parts. */
FIRMA_API firma_code firma_parts_create(firma_parts* parts);
/* Puts a part at the end; `index` gets its number, and may be null. FIRMA_ERROR_INVALID for a world of several rooms,
 * FIRMA_ERROR_OUT_OF_RANGE for a motion with a number that is not finite, a rotation of zero, or a turn longer than 8.
 * Costs the bounds of the world. */
FIRMA_API firma_code firma_parts_add(firma_parts parts, const firma_part* part, uint32_t* index);
/* Another part in place of one: another solid, as after a cut. Numbers of the others stay. Errors as above, and
 * FIRMA_ERROR_OUT_OF_RANGE for a part that is not there. */
FIRMA_API firma_code firma_parts_set(firma_parts parts, uint32_t index, const firma_part* part);
/* The motions of all parts for this tick, one each, in order: all, or none when one is refused. FIRMA_ERROR_INVALID for
 * another count than there are parts; else errors as above. Takes no memory. */
FIRMA_API firma_code firma_parts_set_motions(firma_parts parts, const firma_motion* motions, size_t count);
FIRMA_API firma_code firma_parts_get_count(firma_parts parts, size_t* count);
FIRMA_API firma_code firma_parts_release(firma_parts parts);

/* A level with its parts. firma_scene_defaults() sets all, but for the world. */
typedef struct firma_scene {
    uint32_t size;     /* sizeof(firma_scene) */
    uint32_t reserved; /* must be 0 */
    firma_world world;
    firma_parts parts; /* 0: none */
    double from, to;   /* which stretch of the parts' motions the fractions 0 to 1 of questions stand for, itself in
                          fractions of them, 0 <= from <= to <= 1; by default 0 and 1. Equal: they stand there */
} firma_scene;

FIRMA_API void firma_scene_defaults(firma_scene* scene);

/* A hit of the level or of a part. */
typedef struct firma_part_hit {
    firma_hit hit;              /* face and material are those of the part's world; a corner is in its frame */
    double surface_velocity[3]; /* of the part's surface at the touch: metres from fraction 0 to 1 at that pace */
    uint32_t part;              /* FIRMA_NO_PART: the level, or a miss */
    uint32_t reserved;
} firma_part_hit;

/* The first touch of a mover with the level, or with a part that moves meanwhile; of several at the same fraction the
 * level's, then that of the part with the lowest number. A path of zero is met by parts that come. Against a part that
 * turns a touch is at most 0.06 mm early. `room` and `passed` of the options are of the level. Status FIRMA_INVALID as
 * firma_cast_mover(), and for a stretch of the scene that is none. Takes no memory. Costs a cast through the level, a
 * look at each part's box or ball, and a cast through each part that is near: of one that turns, some searches for the
 * nearest points with each face near the way. */
FIRMA_API firma_code firma_cast_scene(const firma_scene* scene, const firma_mover* mover, const double path[3],
                                      const firma_cast_options* options, firma_part_hit* hit);
/* Whether there is any touch: firma_status. */
FIRMA_API firma_code firma_cast_scene_any(const firma_scene* scene, const firma_mover* mover, const double path[3],
                                          const firma_cast_options* options, uint32_t* status);

/* What is overlapped, of the level or of a part. */
typedef struct firma_part_near {
    firma_near near;
    double surface_velocity[3]; /* of the part at `near.point`, as in firma_part_hit */
    uint32_t part;              /* FIRMA_NO_PART: of the level */
    uint32_t reserved;
} firma_part_near;

/* The faces that a mover overlaps, the parts where they are at a fraction, 0 to 1, of the scene's stretch: those of the
 * level first, then part by part, in no particular order within one. `count` gets how many, and the first `capacity`
 * are written. FIRMA_ERROR_OUT_OF_RANGE also for a fraction or a stretch that is none; else as firma_overlap_mover().
 */
FIRMA_API firma_code firma_overlap_scene(const firma_scene* scene, const firma_mover* mover, double fraction,
                                         const firma_near_options* options, firma_part_near* found, size_t capacity,
                                         size_t* count);
/* The point of the level and its parts that is nearest to a point, as firma_closest(), the parts where they are at a
 * fraction, 0 to 1, of the scene's stretch; of several at the same distance the level's, then that of the part with the
 * lowest number. `found` gets 0 or 1. `room` of the options is of the level. FIRMA_ERROR_OUT_OF_RANGE also for a
 * fraction or a stretch that is none. Takes no memory. Costs a search in the level, and in each part that may be
 * nearer. */
FIRMA_API firma_code firma_closest_scene(const firma_scene* scene, const double point[3], double reach, double fraction,
                                         const firma_near_options* options, firma_part_near* near, uint32_t* found);

/* ---- sets of spheres -------------------------------------------------------------------------------------------- */

/* Spheres that keep their places to each other go straight and turn meanwhile: a firma_motion. Sets are four doubles
 * for each sphere, centre and radius >= 0, in a frame of their own. docs/bodies.md. */

/* In place of the number of a sphere: none. */
#define FIRMA_NO_SPHERE UINT32_MAX

typedef struct firma_set_hit {
    firma_hit hit;   /* `centre` is that of the sphere that touches */
    uint32_t sphere; /* its number in the set; FIRMA_NO_SPHERE when nothing was touched */
    uint32_t reserved;
} firma_set_hit;

/* The first touch of a set with the world. Of one that does not turn it is that of the cast of each sphere, the
 * smallest fraction, then the lowest number; of one that turns it is at most 0.06 mm early, and at most 0.03 mm late,
 * where an arc turns away from a face it has just begun to come nearer to; safe_fraction is reckoned from the speed
 * along the normal. `room` of the options has to hold all of the set, or be FIRMA_ANY_ROOM; `passed` is of no use.
 * Status FIRMA_INVALID as firma_cast(), and for a rotation of zero or a turn beyond 2^20 radians; FIRMA_MISS for no
 * sphere. FIRMA_ERROR_TOO_LARGE for more than 4,096. Takes memory for a copy of the spheres. Costs a look for what a
 * sphere around all of it comes near; where that finds anything, a cast for each sphere, and when turning one for each
 * piece of its arc that comes near anything. */
FIRMA_API firma_code firma_cast_set(firma_world world, const double* spheres, size_t count, const firma_motion* motion,
                                    const firma_cast_options* options, firma_set_hit* hit);

/* The first touch of a set with a level or its parts, which move meanwhile. */
typedef struct firma_set_part_hit {
    firma_part_hit hit; /* `hit.hit.centre` is that of the sphere that touches */
    uint32_t sphere;    /* its number in the set; FIRMA_NO_SPHERE when nothing was touched */
    uint32_t reserved;
} firma_set_part_hit;

/* The same in a level with parts: what firma_cast_scene() says of these holds here. */
FIRMA_API firma_code firma_cast_set_scene(const firma_scene* scene, const double* spheres, size_t count,
                                          const firma_motion* motion, const firma_cast_options* options,
                                          firma_set_part_hit* hit);

/* The first touch of two sets, both of which move. */
typedef struct firma_set_pair_hit {
    double fraction;             /* 1 of a miss; of FIRMA_INVALID 0 */
    double point[3];             /* where they touch, metres */
    double normal[3];            /* unit, from b's sphere toward a's */
    uint32_t status;             /* firma_status; FIRMA_INITIAL_OVERLAP: two overlap at the start and come nearer */
    uint32_t sphere_a, sphere_b; /* or FIRMA_NO_SPHERE */
    uint32_t reserved;
} firma_set_pair_hit;

/* Both go from fraction 0 to 1 at once. What firma_cast_set() says of sets that turn, of counts and of numbers holds
 * here of both. Takes memory for copies of the spheres. Costs the pairs of spheres that come near each other. */
FIRMA_API firma_code firma_cast_set_pair(const double* a, size_t a_count, const firma_motion* motion_a, const double* b,
                                         size_t b_count, const firma_motion* motion_b, firma_set_pair_hit* hit);

/* ---- players ---------------------------------------------------------------------------------------------------- */

/* Upright shapes that walk, jump, crouch, climb steps, slide along walls and ride on parts. A player is plain data,
 * copied, saved and rolled back as such; nothing is kept between moves. docs/players.md. */

/* What a player is, standing and crouched; it never changes. Metres, ends of a capsule included. A null pointer takes
 * the defaults. */
typedef struct firma_player_size {
    uint32_t size;                          /* sizeof(firma_player_size) */
    uint32_t reserved;                      /* must be 0 */
    double radius, height, crouched_height; /* 0.3, 1.8, 1.1 */
    double up[3];                           /* 0, 0, 1; made unit */
} firma_player_size;

FIRMA_API void firma_player_size_defaults(firma_player_size* size);

/* FIRMA_ERROR_INVALID for a number that is not finite or not above zero, an `up` shorter than 1e-3, a height below
 * twice the radius, and a crouched height above the other. */
FIRMA_API firma_code firma_player_shape_capsule(const firma_player_size* size, firma_player_shape* shape);
/* A box as wide and as deep as twice the radius; it may be lower than it is wide. */
FIRMA_API firma_code firma_player_shape_box(const firma_player_size* size, firma_player_shape* shape);
/* Spheres around a middle axis that leads up from the origin, four doubles each: centre, radius. `crouched` may be null
 * when its count is 0: as standing. `up` may be null: 0, 0, 1. FIRMA_ERROR_INVALID for a number that is not finite, a
 * radius that is not above zero, none, and more than 4,096. */
FIRMA_API firma_code firma_player_shape_spheres(const double* standing, size_t standing_count, const double* crouched,
                                                size_t crouched_count, const double up[3], firma_player_shape* shape);
/* Its radius, heights and `up`, as it was made; of spheres how far they reach sideways, and up. */
FIRMA_API firma_code firma_player_shape_get_size(firma_player_shape shape, firma_player_size* size);
FIRMA_API firma_code firma_player_shape_release(firma_player_shape shape);

/* One player between two moves. All of it may be set; firma_player_defaults() sets all, at the origin. */
typedef struct firma_player {
    double position[3];           /* of the feet, metres */
    double velocity[3];           /* metres a second; on the ground over what it stands on */
    double ground_normal[3];      /* of the face that it stands on; with on_ground */
    double ground_velocity[3];    /* of the part that it stands on, at its feet, metres a second */
    uint64_t world_hash;          /* firma_world_hash() of the world that it was last moved in; 0 before */
    uint32_t mask;                /* faces that share a bit are met */
    uint32_t room;                /* where its middle was last in air; FIRMA_NO_ROOM before */
    uint32_t ground_part;         /* that it stands on, or FIRMA_NO_PART */
    uint32_t on_ground, crouched; /* 0 or 1 */
    uint32_t stuck;               /* 1: it overlaps, and no place to go was found */
} firma_player;

FIRMA_API void firma_player_defaults(firma_player* player);

/* What is wished of it for one move. Zero but for `size`: to stand. */
typedef struct firma_player_wish {
    uint32_t size;      /* sizeof(firma_player_wish) */
    uint32_t jump;      /* 1: from the ground */
    uint32_t crouch;    /* 1: as long as it is set, and on as long as there is no room to stand */
    uint32_t careful;   /* 1: it does not walk where the ground is more than firma_player_rules.max_drop lower */
    double velocity[3]; /* metres a second; what of it is along `up` does not count */
} firma_player_wish;

/* How players move; a null pointer takes the defaults. */
typedef struct firma_player_rules {
    uint32_t size;              /* sizeof(firma_player_rules) */
    uint32_t reserved;          /* must be 0 */
    double gravity;             /* 9.81 m/s2, against `up` */
    double max_slope;           /* a quarter of pi, radians: of faces that it walks on */
    double step_height;         /* 0.45 m: higher steps are walls */
    double max_drop;            /* 0.6 m; see firma_player_wish.careful */
    double overhang;            /* 0.7 radii: so far beyond an edge its middle may be where nothing is below */
    double jump_speed;          /* 4.4 m/s */
    double ground_acceleration; /* 60 m/s2 */
    double air_acceleration;    /* 12 m/s2 */
    double crouched_speed;      /* 0.5 of the speed that is wished */
    double max_push;            /* 4 m: so far at most it is moved out of what came where it was */
    double contact_offset;      /* metres kept from what it touches; 0, the default, takes the world's */
} firma_player_rules;

FIRMA_API void firma_player_rules_defaults(firma_player_rules* rules);

typedef enum firma_contact_kind {
    FIRMA_CONTACT_GROUND = 0,
    FIRMA_CONTACT_WALL = 1,
    FIRMA_CONTACT_CEILING = 2
} firma_contact_kind;

/* What a player touched on its way. */
typedef struct firma_player_contact {
    double point[3];       /* metres */
    double normal[3];      /* unit, toward the player */
    double face_normal[3]; /* unit; of ground, of the flattest face there */
    uint32_t kind;         /* firma_contact_kind */
    uint32_t face;         /* FIRMA_NO_FACE of a closed portal */
    int32_t corner[3];     /* the face's first, as in firma_hit */
    uint32_t portal;       /* the closed one, or FIRMA_NO_PORTAL */
    uint32_t part;         /* that the face is of; FIRMA_NO_PART: of the level */
    uint32_t material;
} firma_player_contact;

#define FIRMA_MAX_PLAYER_CONTACTS 8

/* Where a move led to. */
typedef struct firma_player_move {
    uint32_t size;          /* sizeof(firma_player_move) */
    uint32_t contact_count; /* of `contacts` */
    firma_player player;
    double pushed[3];    /* metres: the way out of what came where it was, and what it backed off by */
    double carried[3];   /* metres: with the part that it stood on, and out of the way of parts */
    double landed_speed; /* metres a second against the ground, where it came down; else 0 */
    uint32_t pushed_by;  /* a part that came where it was, the last one; or FIRMA_NO_PART */
    uint32_t crushed_by; /* a part that it is pressed by without room to give way: it overlaps that, never the level.
                            The game decides what comes of it. Or FIRMA_NO_PART */
    uint32_t jumped, stepped; /* 0 or 1; stepped: up a step */
    firma_player_contact contacts[FIRMA_MAX_PLAYER_CONTACTS];
} firma_player_move;

/* Moves a player by one tick of 0 to 1 seconds, among parts that go from fraction 0 to 1 of their motions meanwhile:
 * part k has to be the same one from tick to tick. `move` gets where it is then; `player` stays, and may be
 * &move->player. FIRMA_ERROR_OUT_OF_RANGE for a number of the player, wish, seconds, rules or scene that is not finite
 * or out of range; FIRMA_ERROR_INVALID for a 0 or 1 that is neither. The same bits on every machine. Takes no memory.
 * Costs two to four casts on plain ground, some more at walls and steps; at most a few hundred where a way out is
 * looked for, and some thousand, milliseconds, where none is near, in the first move in a world alone. */
FIRMA_API firma_code firma_move_player(const firma_scene* scene, firma_player_shape shape, const firma_player* player,
                                       const firma_player_wish* wish, double seconds, const firma_player_rules* rules,
                                       firma_player_move* move);
/* Whether there is room for a player, its middle in air: for places to begin at. Parts are where they are at `from` of
 * the scene. `fits` gets 0 or 1. FIRMA_ERROR_OUT_OF_RANGE for a position that is not finite. Takes no memory. */
FIRMA_API firma_code firma_player_fits(const firma_scene* scene, firma_player_shape shape, const double position[3],
                                       uint32_t crouched, uint32_t mask, uint32_t* fits);

/* ---- carving ---------------------------------------------------------------------------------------------------- */

typedef enum firma_shape {
    FIRMA_ROCKY = 0, /* 180 triangles, radii 0.78 to 1.2 */
    FIRMA_SPIKY = 1,
    FIRMA_DRILL = 2,
    FIRMA_WEDGE = 3,
    FIRMA_BOX = 4 /* from -1 to 1 */
} firma_shape;

/* A shape of mean radius about 1 around the origin, from a seed. FIRMA_ERROR_INVALID for no shape. Takes memory for its
 * triangles: make it once and place it often. */
FIRMA_API firma_code firma_cutter_crater(uint32_t shape, uint64_t seed, firma_cutter* cutter);
/* A closed mesh of triangles: three doubles a vertex, three indices a triangle. `name` may be null.
 * FIRMA_ERROR_MALFORMED for one that is not closed, FIRMA_ERROR_TOO_LARGE beyond 4,000,000 triangles. Costs the
 * vertices and triangles, copied, and sorting the edges; of an .obj also reading it. */
FIRMA_API firma_code firma_cutter_from_mesh(const double* positions, size_t vertex_count, const uint32_t* corners,
                                            size_t triangle_count, const char* name, firma_cutter* cutter);
FIRMA_API firma_code firma_cutter_from_obj(const char* text, size_t length, const char* name, firma_cutter* cutter);
/* The solid of a world: a chunk that cuts left, a prefab that has been carved. `name` may be null. At scale 1, turned
 * by quarter turns about the axes, it cuts exactly, its position snapped to 1/4096 m; at any other pose it is what its
 * facets bound once snapped, and is refused where they cross. FIRMA_ERROR_INVALID for a world without solid faces, or
 * with rock that reaches to infinity; FIRMA_ERROR_TOO_LARGE beyond 4,000,000 triangles. Costs its facets, copied. */
FIRMA_API firma_code firma_cutter_from_world(firma_world world, const char* name, firma_cutter* cutter);
FIRMA_API firma_code firma_cutter_release(firma_cutter cutter);

/* Where a cutter goes: turned, scaled, moved. */
typedef struct firma_pose {
    double position[3];
    double rotation[4]; /* x, y, z, w, of any length but zero */
    double scale;       /* metres a unit of the cutter, > 0 */
} firma_pose;

/* A random turn, evenly distributed, the same on every machine. */
FIRMA_API void firma_random_turn(uint64_t seed, double rotation[4]);

typedef struct firma_carve_options {
    uint32_t size;        /* sizeof(firma_carve_options) */
    uint32_t fill;        /* 0: the cutter is taken away; 1: added */
    const char* material; /* of the faces it leaves; null: "" */
    /* Where the shot came from, metres: what a carving opens between rooms becomes air of the room that this lies in,
     * where it touches that. Only with has_from 1. */
    uint32_t has_from;
    uint32_t reserved; /* 0 */
    double from[3];
    /* 1: look for pieces that the cut leaves loose. They leave the world within the same edit; the report has them.
     * Ask for it in all edits of a world, or in none. firma_world_with_anchors() says what holds a piece. */
    uint32_t chunks;
    /* The number of the edit: 0, the one after the last; or 1 to 2^21 - 1, above that of every edit made before, for
     * worlds that are to agree on it although they may lack others. */
    uint32_t edit;
    double min_chunk_volume; /* cubic metres; pieces of less are only counted, as crumbs. 0: 0.001 */
    double density;          /* of chunks, kilograms a cubic metre. 0: of each matter that they are made of */
} firma_carve_options;

typedef enum firma_carve_status {
    FIRMA_CARVE_DONE = 0,
    FIRMA_CARVE_NOTHING = 1,
    FIRMA_CARVE_REFUSED = 2
} firma_carve_status;

typedef struct firma_carve_report {
    uint32_t size;    /* sizeof(firma_carve_report) */
    uint32_t status;  /* firma_carve_status; for FIRMA_CARVE_REFUSED firma_error_message() says why */
    uint32_t retries; /* always 0, as no cutter is moved */
    uint32_t reserved;
    uint64_t candidate_faces, faces_cut, faces_removed, faces_added;
    double scale;  /* what zones and materials left of the cutter's scale */
    double volume; /* cubic metres taken; negative when added */
    /* Microseconds. */
    double place_us, gather_us, cut_us, label_us, trace_us, facets_us, tree_us;
    /* That reach into the cutter and are left as they are, as they bound no solid: with FIRMA_CARVE_NOTHING and none of
     * them the cutter met only air. */
    uint64_t faces_castable_only;
    uint64_t portals, rooms; /* that it made: holes between rooms, pockets in rock */
    /* Of pieces that came loose, where they were looked for: not in `volume`. */
    uint64_t chunks;         /* that are in `loose` */
    uint64_t crumbs;         /* too small for that: removed, too */
    double chunk_volume;     /* cubic metres */
    double crumb_volume;     /* likewise */
    uint64_t faces_searched; /* exact faces read beyond the candidates, to find out what is loose */
    double chunks_us;
    firma_chunks loose; /* the chunks, to be released by firma_chunks_release(); 0 where there are none */
    uint64_t cut_short; /* zones and pieces of the level that may not be carved, and took part of the cutter */
    /* Of faces that bound no solid: of which the cutter took a part; that went whole; panes that went whole; of the
     * first two, those that stop walkers alone, or shots alone. */
    uint64_t open_trimmed, open_removed, panes, clips;
} firma_carve_report;

/* One edit. FIRMA_OK also when the edit is refused or meets nothing: `after` is then another handle to the world
 * before. `options` and `report` may be null.
 * The cutter is taken away, or added, exactly where it lies, also where it touches: nothing is moved.
 * The cost grows with the cutter's triangles and with the faces near them (candidate_faces), and with the logarithm of
 * the world's faces; a cutter that touches is cut up to twice; where portals are made also with their rooms' lists of
 * them. The material is searched by its name among the world's, and a new one copies their list. Takes memory for what
 * is made anew; all else is shared. firma_world_with_rules() bounds it. Looking for loose pieces costs the faces that
 * the cut made and those near it, and those of the smaller pieces (faces_searched). Without a report, chunks are lost.
 */
FIRMA_API firma_code firma_carve(firma_world world, firma_cutter cutter, const firma_pose* pose,
                                 const firma_carve_options* options, firma_world* after, firma_carve_report* report);

/* One edit in slices: run until finished, then take the result, or release it at any time. Starting it does nothing yet
 * but to search the material. */
FIRMA_API firma_code firma_job_start(firma_world world, firma_cutter cutter, const firma_pose* pose,
                                     const firma_carve_options* options, firma_job* job);
/* Of firma_job_start() or firma_command_start(). Goes on for about so long, and does at least one piece of work: some
 * ten microseconds with a cutter of some hundred triangles, more where placing or judging one of many thousand is the
 * piece. `finished` gets 0 or 1. FIRMA_ERROR_INVALID for a negative time. A job that ran out of memory cannot go on:
 * every later call gives FIRMA_ERROR_NO_MEMORY again. */
FIRMA_API firma_code firma_job_run(firma_job job, double microseconds, uint32_t* finished);
/* As firma_carve(); FIRMA_ERROR_BAD_CALL before it is finished. Costs a handle and the report, whatever was cut. */
FIRMA_API firma_code firma_job_result(firma_job job, firma_world* after, firma_carve_report* report);
FIRMA_API firma_code firma_job_release(firma_job job);

/* Several edits that become one version. */
FIRMA_API firma_code firma_edit_begin(firma_world world, firma_edit* edit);
/* One of them, on the world as edited so far: as firma_carve(), and at its cost. */
FIRMA_API firma_code firma_edit_carve(firma_edit edit, firma_cutter cutter, const firma_pose* pose,
                                      const firma_carve_options* options, firma_carve_report* report);
/* The world as edited so far, one version on; the one begun with when nothing was done. Costs the same for every number
 * of edits. The edit can go on afterwards. */
FIRMA_API firma_code firma_edit_finish(firma_edit edit, firma_world* after);
FIRMA_API firma_code firma_edit_release(firma_edit edit);

/* ---- loose chunks ----------------------------------------------------------------------------------------------- */

/* What holds a piece of a world's solid. A piece with one face that holds stays, as does what reaches around air. */
typedef struct firma_anchors {
    uint32_t size;                /* sizeof(firma_anchors) */
    uint32_t no_hanging;          /* 0: what hangs free now stays by intent; 1: it does not. docs/chunks.md */
    const char* const* materials; /* UTF-8: faces of these hold; names that the world does not have hold nothing */
    size_t material_count;
    const uint32_t* sources; /* faces that come from these of the level's file hold; of brushes, from these sides */
    size_t source_count;
    const firma_box* volumes; /* solid that reaches into one is held: those of a level, `anchors` of firma_level_view,
                                 say. One that is empty, or not finite, holds nothing */
    size_t volume_count;
} firma_anchors;

/* The same world with what holds its pieces said anew, of the same version. Edits and files keep it, no hash sees it. A
 * cut that looks for loose pieces in a world of which nothing is said takes the defaults (`anchors` null), at this
 * cost: say it when the level is read. FIRMA_ERROR_INVALID for a no_hanging that is not 0 or 1. Costs all faces, in
 * time and in memory. */
FIRMA_API firma_code firma_world_with_anchors(firma_world world, const firma_anchors* anchors,
                                              firma_world* with_anchors);

/* Of a body. */
typedef struct firma_mass {
    double volume;     /* cubic metres */
    double mass;       /* kilograms */
    double centre[3];  /* of mass, metres */
    double inertia[9]; /* the tensor about the centre, kg m2, a row after the other: symmetric */
} firma_mass;

/* Of a world's exact solid, of `density` kilograms a cubic metre; all 0 for one without faces and for one with rock
 * that reaches to infinity. FIRMA_ERROR_OUT_OF_RANGE for a density that is not finite, or negative. Costs all faces, in
 * time and in memory. */
FIRMA_API firma_code firma_world_mass(firma_world world, double density, firma_mass* mass);

/* How much of a chunk is of one matter. */
typedef struct firma_matter_volume {
    uint32_t matter; /* its number in the world that the chunk left */
    uint32_t reserved;
    double volume; /* cubic metres */
} firma_matter_volume;

typedef struct firma_chunk {
    uint32_t size; /* sizeof(firma_chunk) */
    uint32_t reserved;
    double origin[3];       /* where its frame's origin lay in the world, metres: a point of it lay at origin + point */
    firma_mass mass;        /* in its frame */
    uint64_t face_count;    /* that casts meet */
    double low[3], high[3]; /* bounds in its frame, metres */
    const firma_matter_volume* matters; /* what it is made of, ascending; good until the handle is released. None of
                                           firma_world_pieces() */
    size_t matter_count;
} firma_chunk;

FIRMA_API firma_code firma_chunks_get_count(firma_chunks chunks, size_t* count);
/* In an order that is the same everywhere. FIRMA_ERROR_OUT_OF_RANGE for one that is not there, here and below. */
FIRMA_API firma_code firma_chunks_get(firma_chunks chunks, size_t chunk, firma_chunk* out);
/* A world of one room around a chunk, in its frame: to cast at, to draw, to cut. Sources, numbers and names of
 * materials and the contact offset are those that it had; rules are the defaults. Costs a look at each of its faces,
 * which it shares. */
FIRMA_API firma_code firma_chunks_world(firma_chunks chunks, size_t chunk, firma_world* world);
FIRMA_API firma_code firma_chunks_release(firma_chunks chunks);

/* The bodies that a world's solid is made of, what faces that share edges enclose, each with its hollows: what is left
 * of a chunk that was cut. They stay in the world's frame: `origin` is 0. In order of the lowest id of their faces, but
 * rock that reaches to infinity is the first. Mass by `density`, as firma_world_mass(). Costs all faces, and a search
 * among the bodies for each hollow. */
FIRMA_API firma_code firma_world_pieces(firma_world world, double density, firma_chunks* pieces);

typedef struct firma_rest {
    uint32_t size;        /* sizeof(firma_rest) */
    uint32_t mended;      /* triangles that were taken out, as snapping made them cross others */
    firma_pose pose;      /* where the cutter goes */
    double volume_change; /* cubic metres that snapping added; negative where it took some */
} firma_rest;

/* A world's solid where it came to rest, as a cutter: firma_carve() with `fill` and the pose of `rest` makes it ground.
 * By quarter turns about the axes, at scale 1, it is placed exactly; at any other pose each corner of its facets is
 * snapped to 1/4096 m, and thin triangles that then cross others are taken out. `name`, for messages, may be null.
 * Errors of firma_cutter_from_world(), and of a pose that is not finite or leads out of the world; FIRMA_ERROR_INVALID
 * where triangles still cross, with a place: it stays a body then. Costs its facets, and testing those near each other
 * against each other, again for each time that some are mended. */
FIRMA_API firma_code firma_cutter_at_rest(firma_world world, const firma_pose* pose, const char* name,
                                          firma_cutter* cutter, firma_rest* rest);

/* ---- convex pieces ---------------------------------------------------------------------------------------------- */

/* How a solid is divided into convex pieces, for another engine. A null pointer, and zeros, take the defaults. */
typedef struct firma_convex_options {
    uint32_t size;        /* sizeof(firma_convex_options) */
    uint32_t max_pieces;  /* 1 to 16,384; 0: 256 */
    double max_concavity; /* metres. 0: each piece is convex. Above: what is convex but for less is one piece, of which
                             its hull is given, no point of which is farther than this from the piece */
    double density;       /* kilograms a cubic metre, for firma_convex_piece.mass; 0: 2,400 */
} firma_convex_options;

typedef struct firma_convex_face {
    double normal[3]; /* unit, outward */
    double offset;    /* metres: normal . p = offset on it */
    uint32_t first;   /* its corners, counter-clockwise seen from outside: loops[first] to [first + count - 1] */
    uint32_t count;   /* 3 or more */
} firma_convex_face;

typedef struct firma_convex_piece {
    uint32_t size;         /* sizeof(firma_convex_piece) */
    uint32_t exact;        /* 1: the piece is convex, exactly; 0: corners and faces are those of its hull */
    firma_mass mass;       /* of the piece, not of its hull: volumes add up to the whole's */
    double hull_volume;    /* cubic metres: of the hull of the corners */
    double overhang;       /* metres: no point of the hull is farther from the piece; 0 for an exact one */
    const double* corners; /* x, y, z each, metres: rounded by at most 3.3 um. All pointers: good until the handle is
                              released */
    size_t corner_count;
    const firma_convex_face* faces;
    size_t face_count;
    const uint32_t* loops; /* numbers of corners, of all faces */
    size_t loop_count;
} firma_convex_piece;

/* A world's solid as convex pieces that fill it: none crosses another, and their exact volumes add up to its volume.
 * Divided at reflex edges by planes of its faces, and merged where pieces are convex together. FIRMA_ERROR_INVALID for
 * a world without solid faces or with rock that reaches to infinity, and for options out of range;
 * FIRMA_ERROR_TOO_LARGE where it takes more than max_pieces. Costs microseconds for a box with a notch, a second for
 * some hundred reflex edges. docs/convex.md. */
FIRMA_API firma_code firma_world_convex_pieces(firma_world world, const firma_convex_options* options,
                                               firma_convex_pieces* pieces);
/* The same of a chunk, in its frame. FIRMA_ERROR_OUT_OF_RANGE for one that is not there. */
FIRMA_API firma_code firma_chunks_convex_pieces(firma_chunks chunks, size_t chunk, const firma_convex_options* options,
                                                firma_convex_pieces* pieces);
FIRMA_API firma_code firma_convex_pieces_get_count(firma_convex_pieces pieces, size_t* count);
/* In an order that is the same everywhere. FIRMA_ERROR_OUT_OF_RANGE for one that is not there. */
FIRMA_API firma_code firma_convex_pieces_get(firma_convex_pieces pieces, size_t piece, firma_convex_piece* out);
FIRMA_API firma_code firma_convex_pieces_release(firma_convex_pieces pieces);

/* ---- bodies ----------------------------------------------------------------------------------------------------- */

/* Rigid bodies of spheres that hit the world and each other, come to rest and sleep. They are held outside of worlds: a
 * snapshot of a game is a world and a copy of its bodies. docs/bodies.md. */

/* The mass of a solid ball, and of a solid box, around the origin. `half`: metres. FIRMA_ERROR_OUT_OF_RANGE for a
 * number that is not finite or not above zero. */
FIRMA_API firma_code firma_mass_of_ball(double radius, double density, firma_mass* mass);
FIRMA_API firma_code firma_mass_of_box(const double half[3], double density, firma_mass* mass);

/* What bodies are made of, shared by all that are: 1 to 4,096 spheres, four doubles each (centre, radius > 0), and the
 * mass of the solid that they stand for, in the same frame. It never changes. FIRMA_ERROR_INVALID for a number that is
 * not finite, a radius, mass or inertia that is not above zero, or another count. */
FIRMA_API firma_code firma_body_shape_spheres(const double* spheres, size_t count, const firma_mass* mass,
                                              firma_body_shape* shape);
/* Its spheres, four doubles each, as given: `count` gets how many, the first `capacity` are written. */
FIRMA_API firma_code firma_body_shape_get_spheres(firma_body_shape shape, double* spheres, size_t capacity,
                                                  size_t* count);
/* Bodies of a shape keep it: the handle may be released. */
FIRMA_API firma_code firma_body_shape_release(firma_body_shape shape);

/* How spheres are fitted into a solid. A null pointer, and zeros, take the defaults. */
typedef struct firma_fit_options {
    uint32_t size;        /* sizeof(firma_fit_options) */
    uint32_t max_spheres; /* 1 to 4,096; 0: 64 */
    double max_error;     /* metres that a point of the surface may be from the nearest sphere; 0: a twentieth of the
                             longest side of the solid's box */
    double margin;        /* metres that spheres are inside by */
} firma_fit_options;

/* Spheres that cover a world's solid from inside: of a mesh that is closed (firma_world_from_mesh()), of a chunk
 * (firma_chunks_world()) or a part; for firma_body_shape_spheres(), with the mass of firma_world_mass(). Four doubles
 * each, largest first, in the world's frame: `count` gets how many, at most `max_spheres`; the first `capacity` are
 * written. `error` gets how far, in metres, a point of the solid's surface may be from the nearest sphere: more than
 * `max_error` where `max_spheres` did not do, or a thin edge has no room for spheres near it; it may be null.
 * FIRMA_ERROR_INVALID for a world without solid faces, with rock that reaches to infinity, or without room for any
 * sphere, and for bad options. The same bits on every machine. Costs some thousand searches for nearest facets, and
 * their product with the surface's points. */
FIRMA_API firma_code firma_world_fit_spheres(firma_world world, const firma_fit_options* fit, double* spheres,
                                             size_t capacity, size_t* count, double* error);

/* Names a body, as long as it is there: a slot is used again with another number. All that take one say
 * FIRMA_ERROR_INVALID for a body that is not there any more. */
typedef struct firma_body_id {
    uint32_t slot, use;
} firma_body_id;

/* In place of a slot: no body, or the world. */
#define FIRMA_NO_BODY UINT32_MAX

typedef struct firma_body {
    uint32_t size;      /* sizeof(firma_body) */
    uint32_t mask;      /* faces and bodies that share a bit are met */
    double position[3]; /* of the centre of mass, metres */
    double rotation[4]; /* x, y, z, w, of the shape's frame; not all zero */
    double velocity[3]; /* of the centre of mass, metres a second */
    double spin[3];     /* radians a second, in the world's axes */
    double force[3];    /* newtons, besides gravity; kept from step to step */
    double torque[3];   /* newton metres */
    double friction;    /* >= 0, 0.6: of two that touch the geometric mean counts, with the world's */
    double restitution; /* 0..1, 0.1: of two that touch the larger counts */
    double rolling;     /* >= 0, 0.02: resistance to rolling, in radii of the sphere that rolls */
    double mass;        /* kilograms. Told, not taken, as all below */
    uint32_t asleep;    /* 0 or 1 */
    uint32_t stuck;     /* 1: a sphere's centre was in solid in the last step */
    uint32_t crushed;   /* 1: a part came upon it in the last step, and it could not give way */
    uint32_t reserved;
} firma_body;

/* At rest at the origin, of no mass. */
FIRMA_API void firma_body_defaults(firma_body* body);
/* No bodies. */
FIRMA_API firma_code firma_bodies_create(firma_bodies* bodies);
/* Others that go the same way from here: a snapshot. Costs their arrays; shapes are shared. */
FIRMA_API firma_code firma_bodies_copy(firma_bodies bodies, firma_bodies* copy);
FIRMA_API firma_code firma_bodies_release(firma_bodies bodies);
/* Of those that are there. Costs their slots, here and below. */
FIRMA_API firma_code firma_bodies_get_count(firma_bodies bodies, size_t* count);
/* Their names, by slot: `count` gets how many, the first `capacity` are written. */
FIRMA_API firma_code firma_bodies_list(firma_bodies bodies, firma_body_id* ids, size_t capacity, size_t* count);

/* A body at rest, with its shape's frame at a pose, whose scale does not count. FIRMA_ERROR_OUT_OF_RANGE for a pose
 * that is not finite, or a rotation of zero. */
FIRMA_API firma_code firma_bodies_add(firma_bodies bodies, firma_body_shape shape, const firma_pose* pose,
                                      firma_body_id* id);
/* A chunk as a body at rest where it came loose: spheres fitted into its solid, its mass. `fit` may be null.
 * FIRMA_ERROR_OUT_OF_RANGE for a chunk that is not there; FIRMA_ERROR_INVALID for one without mass, one without room
 * for spheres, and bad options. Costs the fit: some thousand searches for nearest facets, and their product with the
 * surface's points. */
FIRMA_API firma_code firma_bodies_add_chunk(firma_bodies bodies, firma_chunks chunks, size_t chunk,
                                            const firma_fit_options* fit, firma_body_id* id);
/* What it touched wakes up. */
FIRMA_API firma_code firma_bodies_remove(firma_bodies bodies, firma_body_id id);
FIRMA_API firma_code firma_bodies_get(firma_bodies bodies, firma_body_id id, firma_body* body);
/* Wakes it, and what sleeps with it. What a shorter struct lacks stays. FIRMA_ERROR_OUT_OF_RANGE for a number that is
 * not finite or out of its range, and a rotation of zero. */
FIRMA_API firma_code firma_bodies_set(firma_bodies bodies, firma_body_id id, const firma_body* body);
/* Where its shape's frame is, at scale 1: where to draw what the shape was made of. */
FIRMA_API firma_code firma_bodies_get_pose(firma_bodies bodies, firma_body_id id, firma_pose* pose);
/* Its shape, shared. */
FIRMA_API firma_code firma_bodies_shape(firma_bodies bodies, firma_body_id id, firma_body_shape* shape);
/* Wakes what sleeps with it, too. */
FIRMA_API firma_code firma_bodies_wake(firma_bodies bodies, firma_body_id id);
/* A push at a point: newton seconds, metres; wakes it. FIRMA_ERROR_OUT_OF_RANGE for what is not finite. */
FIRMA_API firma_code firma_bodies_push(firma_bodies bodies, firma_body_id id, const double impulse[3],
                                       const double point[3]);

/* A null pointer takes the defaults. */
typedef struct firma_step_options {
    uint32_t size;              /* sizeof(firma_step_options) */
    uint32_t substeps_a_second; /* at least, 1 to 10,000; 240 */
    uint32_t max_bounces;       /* of one body on its way in one step, at most 1,000; 4 */
    uint32_t reserved;          /* must be 0 */
    double gravity[3];          /* 0, 0, -9.81 m/s2 */
    double contact_friction;    /* of the world, >= 0; 0.6 */
    double contact_offset;      /* metres that spheres may sink in; 0, the default, takes the world's */
    double sleep_speed;         /* metres a second: what moves less far in sleep_after is still; 0.05 */
    double sleep_after;         /* seconds still; INFINITY: never; 0.5 */
} firma_step_options;

FIRMA_API void firma_step_options_defaults(firma_step_options* options);

typedef struct firma_step_report {
    uint32_t size; /* sizeof(firma_step_report) */
    uint32_t reserved;
    uint64_t awake, contacts, swept, bounces, woken;
    uint64_t stuck;   /* bodies with a sphere whose centre is in solid that came where they were: they move out */
    uint64_t crushed; /* bodies that a part came upon and that could not give way: the part goes over them */
} firma_step_report;

/* Moves all bodies on. `seconds`: above zero; of more than a quarter of a second, a quarter is made. `report` may be
 * null. No sphere of a body that was clear of the world ends deeper in it than the contact offset, and none passes a
 * wall, at any speed. FIRMA_ERROR_OUT_OF_RANGE for seconds and options that are not finite or out of range. The same
 * bits on every machine. Costs the bodies that are awake, with the faces near them. Takes memory; where there is none,
 * the bodies are lost: all but releasing them says FIRMA_ERROR_NO_MEMORY from then on. */
FIRMA_API firma_code firma_bodies_step(firma_bodies bodies, firma_world world, double seconds,
                                       const firma_step_options* options, firma_step_report* report);
/* The same among parts that go along the scene's stretch of their motions meanwhile, which carry, push and crush.
 * Bodies do not move them. Part k has to be the same one from step to step. FIRMA_ERROR_OUT_OF_RANGE also for a stretch
 * that is none. Costs also a look at each part for each body that is awake. docs/bodies.md. */
FIRMA_API firma_code firma_bodies_step_scene(firma_bodies bodies, const firma_scene* scene, double seconds,
                                             const firma_step_options* options, firma_step_report* report);

/* What was pressed together in the last step. */
typedef struct firma_body_contact {
    firma_body_id body, other; /* slot FIRMA_NO_BODY of `other`: the world */
    double point[3];           /* metres */
    double normal[3];          /* unit, toward `body` */
    double force;              /* along the normal, newtons */
    uint32_t face;             /* of the world or the part; FIRMA_NO_FACE of a body or a closed portal */
    int32_t corner[3];         /* the face's first, as in firma_hit */
    uint32_t portal;           /* a closed one, or FIRMA_NO_PORTAL */
    uint32_t part;             /* that the face is of; FIRMA_NO_PART: of the level, of a body or a portal */
} firma_body_contact;

/* By slot of `body`, then of `other`; `count` gets how many, the first `capacity` are written. */
FIRMA_API firma_code firma_bodies_contacts(firma_bodies bodies, firma_body_contact* contacts, size_t capacity,
                                           size_t* count);
/* A hash of all that the next steps depend on. Costs all of it. */
FIRMA_API firma_code firma_bodies_hash(firma_bodies bodies, uint64_t* hash);

/* ---- casts at bodies -------------------------------------------------------------------------------------------- */

/* Where bodies are, or go within a time, for many casts at them. Holds what it needs: bodies may change meanwhile, or
 * be released. They go on as they move for `seconds` while a cast goes along its way, straight and turning evenly,
 * whatever they meet; 0: they stand. Bodies with numbers that are not finite or beyond 2^200 are left out.
 * FIRMA_ERROR_OUT_OF_RANGE for seconds that are not finite or below 0. Costs a sort of the bodies. */
FIRMA_API firma_code firma_body_index_create(firma_bodies bodies, double seconds, firma_body_index* index);
FIRMA_API firma_code firma_body_index_release(firma_body_index index);

/* The first touch with a body. A miss has fractions of 1, FIRMA_INVALID of 0. */
typedef struct firma_body_hit {
    double fraction;            /* of the way */
    double safe_fraction;       /* the contact offset before it, by the speed along the normal; at least 0 */
    double centre[3];           /* of the sphere that was cast, at the touch, metres */
    double point[3];            /* metres */
    double normal[3];           /* unit, from the body toward what was cast */
    double surface_velocity[3]; /* of the body there, metres a second */
    firma_body_id body;         /* of several at one fraction that of the lowest slot; slot FIRMA_NO_BODY of a miss */
    uint32_t body_sphere;       /* of the body's shape; FIRMA_NO_SPHERE of a miss */
    uint32_t sphere;            /* of the set that was cast; 0 of a single one; FIRMA_NO_SPHERE of a miss */
    uint32_t status;            /* firma_status */
    uint32_t reserved;
} firma_body_hit;

/* A null pointer takes the defaults. */
typedef struct firma_body_cast_options {
    uint32_t size;         /* sizeof(firma_body_cast_options) */
    uint32_t mask;         /* bodies that share a bit are met; all */
    firma_body_id except;  /* is not: who casts; slot FIRMA_NO_BODY: none */
    double contact_offset; /* metres for safe_fraction; below 0 counts as 0; 0.001 */
} firma_body_cast_options;

FIRMA_API void firma_body_cast_options_defaults(firma_body_cast_options* options);

/* A sphere, or a ray, of radius 0. It meets the spheres of bodies, not the solids that these stand for; what begins in
 * a sphere meets it at once where it comes nearer to its middle (FIRMA_INITIAL_OVERLAP), else not at all. Against
 * bodies that turn a touch is never late, and at most 0.06 mm early. Status FIRMA_INVALID for numbers that are not
 * finite or out of range, and a negative radius. Takes no memory. Costs the logarithm of the bodies, and the spheres of
 * those near the way. */
FIRMA_API firma_code firma_body_index_cast(firma_body_index index, const firma_cast_input* input,
                                           const firma_body_cast_options* options, firma_body_hit* hit);
/* The same of a set, as of firma_cast_set(): FIRMA_MISS for no sphere, FIRMA_ERROR_TOO_LARGE for more than 4,096. Takes
 * memory for a copy of the spheres. */
FIRMA_API firma_code firma_body_index_cast_set(firma_body_index index, const double* spheres, size_t count,
                                               const firma_motion* motion, const firma_body_cast_options* options,
                                               firma_body_hit* hit);

/* ---- projectiles ------------------------------------------------------------------------------------------------ */

/* Thousands of fast particles that fall, ricochet, go through walls or stay in them: an array of the caller's, whose
 * copy is a snapshot. docs/projectiles.md. */

typedef enum firma_projectile_state {
    FIRMA_PROJECTILE_FLYING = 0,
    FIRMA_PROJECTILE_STOPPED = 1, /* at a face, in solid, at a body or a part: its velocity is zero, but for a
                                     part that moves: as fast as that there, as the step ends */
    FIRMA_PROJECTILE_EXPIRED = 2  /* flew longer than firma_fly_options.max_age, or out of reach: 16,384 m */
} firma_projectile_state;

/* All of it may be set between steps; firma_projectile_defaults() sets all, at the origin. */
typedef struct firma_projectile {
    double position[3];  /* metres; to begin with in air */
    double velocity[3];  /* metres a second; at most 2^20 */
    double mass;         /* kilograms, > 0; 0.01 */
    double age;          /* seconds that it flew */
    uint64_t world_hash; /* firma_world_hash() of the world that it flew in last; 0 before */
    uint32_t mask;       /* faces, closed portals, parts and bodies that share a bit are met */
    uint32_t user;       /* the caller's: no answer depends on it */
    uint32_t state;      /* firma_projectile_state */
    uint32_t reserved;   /* must be 0 */
} firma_projectile;

FIRMA_API void firma_projectile_defaults(firma_projectile* projectile);

/* What something does to a projectile that meets it. */
typedef struct firma_shot_terms {
    double ricochet_below; /* radians between path and face: at less it ricochets; 0: never */
    double restitution;    /* 0..1: what is left of the speed along the normal */
    double friction;       /* of the change of speed along the normal, so much is lost along the face */
    double resistance; /* newtons: joules that it loses for each metre it goes through; from 2^200 it is not entered */
} firma_shot_terms;

/* 0.25, 0.4, 0.3, and not entered. */
FIRMA_API void firma_shot_terms_defaults(firma_shot_terms* terms);

/* What a projectile meets. */
typedef struct firma_shot_impact {
    double point[3];     /* metres */
    double normal[3];    /* unit, toward where it came from */
    double velocity[3];  /* metres a second, before */
    double surface[3];   /* of the part there, metres a second; zero of no part */
    double mass;         /* kilograms */
    uint32_t projectile; /* its index */
    uint32_t face;       /* FIRMA_NO_FACE of portals and bodies; of a part of its world */
    int32_t corner[3];   /* the face's first, as in firma_hit */
    uint32_t portal;     /* a closed one, or FIRMA_NO_PORTAL */
    firma_body_id body;  /* slot FIRMA_NO_BODY: none */
    uint32_t material;   /* of the face or portal */
    uint32_t pane;       /* 1: a face that bounds no solid, or a closed portal */
    uint32_t part;       /* that is met: face, material and matter are of its world; FIRMA_NO_PART: none */
    uint32_t reserved;
} firma_shot_impact;

/* What a matter (of a body: 0) does in an impact: asked once for the face, and for each matter on the way through.
 * `terms` holds firma_fly_options.bodies for a body, else `other`, and is changed where the game wants it otherwise;
 * out of range it stops the projectile. Called from any thread that firma_set_tasks() gives, so its answers must depend
 * on what it is given alone. It must not release what the call was given. */
typedef void (*firma_shot_rule)(const firma_shot_impact* impact, uint32_t matter, firma_shot_terms* terms, void* user);

/* A null pointer takes the defaults. */
typedef struct firma_fly_options {
    uint32_t size;                   /* sizeof(firma_fly_options) */
    uint32_t max_impacts;            /* of one projectile in one step, 1 to 1,000: with the last one it stops; 8 */
    double gravity[3];               /* 0, 0, -9.81 m/s2 */
    double max_bow;                  /* metres: no chord of the parabola is farther from it, at any time; 0.001 */
    double max_age;                  /* seconds; 10 */
    double stop_speed;               /* metres a second: what an impact leaves slower stops there; 1 */
    double max_thickness;            /* metres through solid: what would take more stops; 4 */
    double pane_energy;              /* joules that it takes to go through a pane; 2^200: none does */
    firma_shot_terms other;          /* of matters beyond `matters`; firma_shot_terms_defaults() */
    firma_shot_terms bodies;         /* their resistance does not count: what does not ricochet stops; likewise */
    const firma_shot_terms* matters; /* by number of matter of the world, a part's by their names in that table; may be
                                        null when the count is 0 */
    size_t matter_count;
    firma_shot_rule rule; /* in place of `matters`; null: none */
    void* user;           /* handed to rule */
} firma_fly_options;

FIRMA_API void firma_fly_options_defaults(firma_fly_options* options);

typedef enum firma_shot_event_kind {
    FIRMA_SHOT_RICOCHET = 0,
    FIRMA_SHOT_ENTERED = 1, /* went into solid: LEFT or STOPPED comes next */
    FIRMA_SHOT_LEFT = 2,    /* came out of it */
    FIRMA_SHOT_PASSED = 3,  /* went through a pane */
    FIRMA_SHOT_STOPPED = 4, /* at a face, a pane or a body; after ENTERED in the solid */
    FIRMA_SHOT_EXPIRED = 5
} firma_shot_event_kind;

typedef struct firma_shot_event {
    double time;           /* seconds from the start of the step */
    double point[3];       /* metres; where it stopped or left */
    double normal[3];      /* unit, of what was met, toward where it came from; of LEFT out of the solid */
    double velocity[3];    /* metres a second, after it; of what stopped at a part that of its surface */
    double impulse[3];     /* newton seconds that it gave to what it met */
    double energy;         /* joules that it lost, as the surface of what it met sees it */
    double thickness;      /* metres that it went through: of LEFT, and of STOPPED in solid */
    double in_part[3];     /* `point` in the part's frame, metres; zero of no part */
    uint32_t kind;         /* firma_shot_event_kind */
    uint32_t projectile;   /* its index */
    uint32_t number;       /* among the events of this projectile in this step */
    uint32_t face;         /* that was met, or where it came out; FIRMA_NO_FACE of portals, bodies, and none */
    int32_t corner[3];     /* the face's first, as in firma_hit */
    uint32_t portal;       /* a closed one, or FIRMA_NO_PORTAL */
    firma_body_id body;    /* slot FIRMA_NO_BODY: none */
    uint32_t material;     /* of the face or portal */
    uint32_t matter;       /* of the face; of LEFT the last one, of STOPPED where it stopped */
    uint32_t first_length; /* in firma_shot_view.lengths: what it went through */
    uint32_t length_count;
    uint32_t part; /* that was met: face, material and matters are of its world; FIRMA_NO_PART: none */
    uint32_t reserved;
} firma_shot_event;

/* A piece of a way through solid that is of one matter. */
typedef struct firma_shot_length {
    double from, to; /* fractions of the way */
    uint32_t matter;
    uint32_t reserved;
} firma_shot_length;

typedef struct firma_shot_view {
    uint32_t size; /* sizeof(firma_shot_view) */
    uint32_t reserved;
    const firma_shot_event* events; /* by time, then projectile, then number */
    size_t event_count;
    const firma_shot_length* lengths;
    size_t length_count;
} firma_shot_view;

/* Where firma_fly() puts what happened; made once, used for step after step. */
FIRMA_API firma_code firma_shot_events_create(firma_shot_events* events);
/* Of the last step that was made with it; good until the next one, or its release. */
FIRMA_API firma_code firma_shot_events_get_view(firma_shot_events events, firma_shot_view* view);
FIRMA_API firma_code firma_shot_events_release(firma_shot_events events);

typedef struct firma_fly_report {
    uint32_t size; /* sizeof(firma_fly_report) */
    uint32_t reserved;
    uint64_t flying, chords, impacts; /* flying: how many still do */
} firma_fly_report;

/* Lets projectiles fly on, those that fly. `seconds`: above zero, at most 1. `bodies`: 0 for none; what is met of them
 * is pushed when all have flown. `events` is replaced, and may be 0; `report` may be null. FIRMA_ERROR_OUT_OF_RANGE for
 * seconds that are not, and for a projectile with a number that is not finite or out of range, with its index;
 * FIRMA_ERROR_INVALID for options that are out of range, a state that is none, and where firma_tasks.run does not do
 * all of it; FIRMA_ERROR_TOO_LARGE where gravity and max_bow divide the step into more than 4,096 chords. Then nothing
 * has moved, and the events are those of before. The same bits on every machine, however firma_set_tasks() spreads it.
 * Takes memory: a copy of the projectiles. Costs a cast for each chord, three more for each impact, two searches for
 * each way through solid. Where memory runs out, bodies may be lost as in firma_bodies_step(). */
FIRMA_API firma_code firma_fly(firma_projectile* projectiles, size_t count, firma_world world, firma_bodies bodies,
                               double seconds, const firma_fly_options* options, firma_shot_events events,
                               firma_fly_report* report);
/* The same among parts that go along the scene's stretch of their motions meanwhile. They are met by the velocity that
 * their surfaces see; what stops at one goes along with it until the step ends, and its event says where it stays.
 * Without parts the answers have the same bits. FIRMA_ERROR_OUT_OF_RANGE also for a stretch that is none,
 * FIRMA_ERROR_INVALID for a part that goes faster than 2^60 m/s. docs/projectiles.md. */
FIRMA_API firma_code firma_fly_scene(firma_projectile* projectiles, size_t count, const firma_scene* scene,
                                     firma_bodies bodies, double seconds, const firma_fly_options* options,
                                     firma_shot_events events, firma_fly_report* report);
/* A hash of all that the next steps depend on. FIRMA_ERROR_INVALID for a state that is none. */
FIRMA_API firma_code firma_projectiles_hash(const firma_projectile* projectiles, size_t count, uint64_t* hash);

/* ---- what a path goes through ----------------------------------------------------------------------------------- */

/* Where a path goes into solid, or comes out. */
typedef struct firma_pierce_end {
    double fraction;  /* of the path */
    double point[3];  /* metres, on the path */
    double normal[3]; /* unit, of the face, out of the solid; zero where there is none */
    uint32_t face;    /* FIRMA_NO_FACE where the path starts or ends in the solid, and of a closed portal */
    int32_t corner[3];
    uint32_t material;
    uint32_t reserved;
} firma_pierce_end;

/* A stretch of solid that a path goes through, or a pane, which has no thickness. */
typedef struct firma_pierce_span {
    firma_pierce_end in, out; /* of a pane the same */
    double thickness;         /* metres along the path */
    uint32_t first_length;    /* in firma_piercing_view.lengths */
    uint32_t length_count;    /* 0 of panes, and where matters were not asked for */
    uint32_t portal;          /* a closed one, or FIRMA_NO_PORTAL */
    uint32_t pane;            /* 1: a face that bounds no solid, or a closed portal */
    uint32_t starts_inside;   /* 1: the path starts in this solid */
    uint32_t ends_inside;     /* 1: and ends in it */
} firma_pierce_span;

typedef struct firma_piercing_view {
    uint32_t size; /* sizeof(firma_piercing_view) */
    uint32_t reserved;
    const firma_pierce_span* spans; /* by the fraction at which they begin */
    size_t span_count;
    const firma_shot_length* lengths; /* of all stretches in a row: what is of one matter, in fractions of the path */
    size_t length_count;
    double thickness; /* metres of solid in all that is told */
} firma_piercing_view;

/* A null pointer takes the defaults. */
typedef struct firma_pierce_options {
    uint32_t size;       /* sizeof(firma_pierce_options) */
    uint32_t mask;       /* panes that share a bit are told, and stretches whose face where the path goes in does */
    uint32_t both_sides; /* 1: panes are met from behind, too; 0 */
    uint32_t no_panes;   /* 1: panes are left out; 0 */
    uint32_t no_matters; /* 1: what stretches are of is not asked; 0 */
    uint32_t reserved;   /* must be 0 */
} firma_pierce_options;

FIRMA_API void firma_pierce_options_defaults(firma_pierce_options* options);
/* Where firma_pierce() puts what it finds; made once, used again. */
FIRMA_API firma_code firma_piercing_create(firma_piercing* piercing);
/* Of the last call that was made with it; good until the next one, or its release. */
FIRMA_API firma_code firma_piercing_get_view(firma_piercing piercing, firma_piercing_view* view);
FIRMA_API firma_code firma_piercing_release(firma_piercing piercing);
/* All solid that a straight path goes through, and the panes: docs/projectiles.md has the contract. `status` gets a
 * firma_status: FIRMA_INITIAL_OVERLAP when the path starts in solid that is told, FIRMA_HIT when it meets anything,
 * FIRMA_MISS when not. FIRMA_ERROR_OUT_OF_RANGE for a number that is not finite or too large: what was found before
 * stays. Takes memory only to hold more than before. Costs a cast of all that the path meets. */
FIRMA_API firma_code firma_pierce(firma_world world, const double start[3], const double path[3],
                                  const firma_pierce_options* options, firma_piercing piercing, uint32_t* status);

/* ---- fracture and debris ---------------------------------------------------------------------------------------- */

/* Solids broken into pieces exactly, and bodies that know their solids: they break, lie about, become ground again.
 * docs/debris.md. */

typedef enum firma_crack_style {
    FIRMA_CRACK_LUMPS = 0,  /* across the longest way through each piece, crooked: concrete, rock, splinters */
    FIRMA_CRACK_BRICKS = 1, /* rows along z, every other row half a brick on */
    FIRMA_CRACK_SHARDS = 2  /* away from the point of impact, around z, and across these: glass */
} firma_crack_style;

/* What pieces look like. firma_fracture_pattern_of() has one for each matter. */
typedef struct firma_fracture_pattern {
    uint32_t size;             /* sizeof(firma_fracture_pattern) */
    uint32_t style;            /* firma_crack_style */
    double size_of_piece[3];   /* metres, > 0, along the pattern's axes; of shards x is how far apart cracks around the
                                  impact are, y how wide a shard is */
    double growth;             /* by how much of itself a piece is larger a metre from the impact, >= 0 */
    double crooked;            /* 0 to 1 */
    uint32_t has_axes;         /* 1: `axes` counts; 0: found from the solid's flat sides */
    uint32_t has_brick_corner; /* 1: `brick_corner` counts; 0: the low corner of the solid */
    double axes[4];            /* x, y, z, w: the pattern's axes in the solid's frame */
    double brick_corner[3];    /* a corner of a brick of an even row */
} firma_fracture_pattern;

/* How a matter of a world breaks. FIRMA_ERROR_INVALID for a matter that the world does not have. */
FIRMA_API firma_code firma_fracture_pattern_of(firma_world world, uint32_t matter, firma_fracture_pattern* pattern);

/* A null pointer, and zeros, take the defaults. */
typedef struct firma_fracture_options {
    uint32_t size;       /* sizeof(firma_fracture_options) */
    uint32_t max_pieces; /* 1 to 4,096; 0: 32. Cracks end when there are so many */
    uint32_t material;   /* of the faces along cracks; 0 */
    uint32_t has_impact; /* 1: `impact` counts */
    double impact[3];    /* metres: where pieces are smallest; of a world in its frame, of a body in the world */
    double min_volume;   /* cubic metres: a piece of less is not divided, and of a body it becomes dust; 0: 0.001 */
    double density;      /* kilograms a cubic metre; 0: 2,400. Of a body its own counts */
    uint64_t seed;       /* of crooked cracks; 0: 1 */
} firma_fracture_options;

/* Breaks the solid of a world, of a chunk say (firma_chunks_world()), into pieces that fill it exactly: chunks in its
 * frame, with origin 0, their matters not told. FIRMA_ERROR_INVALID for a world without solid or with rock outside, and
 * for a pattern or options out of range; FIRMA_ERROR_OUT_OF_RANGE at the world's rim. The same bits on every machine.
 * Costs two subtractions a crack. */
FIRMA_API firma_code firma_world_fracture(firma_world world, const firma_fracture_pattern* pattern,
                                          const firma_fracture_options* options, firma_chunks* pieces);

/* What bodies are made of, by the slots of a firma_bodies; each call is given both. A copy of both is a snapshot. As
 * with bodies: where memory runs out within a call that changes them, both are lost. */
FIRMA_API firma_code firma_debris_create(firma_debris* debris);
FIRMA_API firma_code firma_debris_copy(firma_debris debris, firma_debris* copy);
FIRMA_API firma_code firma_debris_release(firma_debris debris);
FIRMA_API firma_code firma_debris_hash(firma_debris debris, uint64_t* hash);

/* A chunk as a body at rest where it came loose, that knows its solid. As firma_bodies_add_chunk(). */
FIRMA_API firma_code firma_debris_add_chunk(firma_debris debris, firma_bodies bodies, firma_chunks chunks, size_t chunk,
                                            const firma_fit_options* fit, firma_body_id* id);

typedef struct firma_debris_piece {
    uint32_t size;         /* sizeof(firma_debris_piece) */
    uint32_t matter;       /* what it is most of: its number in the world that it came from */
    double origin[3];      /* metres: where its frame's origin lay there */
    double age;            /* seconds, since it is a body of its own */
    double asleep_for;     /* seconds */
    uint64_t face_count;   /* of its solid */
    uint32_t broken;       /* how often what it was part of broke since it left the world */
    uint32_t never_ground; /* 1: it was to become ground, and could not */
    uint32_t of_part;      /* 1: it came off a part of the level */
    uint32_t reserved;
} firma_debris_piece;

/* FIRMA_ERROR_INVALID for a body that is not there, or is no debris; likewise below. */
FIRMA_API firma_code firma_debris_get(firma_debris debris, firma_bodies bodies, firma_body_id id,
                                      firma_debris_piece* piece);
/* Its solid as a world of one room, in the frame of the body's shape: to draw at firma_bodies_get_pose(). Materials
 * have no names there: their numbers are those of the world that it came from. Costs a look at each of its faces. */
FIRMA_API firma_code firma_debris_world(firma_debris debris, firma_bodies bodies, firma_body_id id, firma_world* world);
/* Takes the body out, too. */
FIRMA_API firma_code firma_debris_remove(firma_debris debris, firma_bodies bodies, firma_body_id id);

typedef enum firma_debris_list {
    FIRMA_DEBRIS_LOOSE = 0,    /* bodies of what came loose, and of its pieces */
    FIRMA_DEBRIS_PIECES = 1,   /* pieces of what broke */
    FIRMA_DEBRIS_REMOVED = 2,  /* that went */
    FIRMA_DEBRIS_TO_GROUND = 3 /* that became ground */
} firma_debris_list;

/* Bodies that the last firma_shatter(), firma_explode(), firma_debris_tend(), firma_parts_break() or
 * firma_parts_carve() with this debris named: `count` gets how many, the first `capacity` are written. Lists that the
 * call does not fill are empty. FIRMA_ERROR_INVALID for a list that is none. */
FIRMA_API firma_code firma_debris_named(firma_debris debris, uint32_t list, firma_body_id* ids, size_t capacity,
                                        size_t* count);

/* A null pointer, and zeros, take the defaults. */
typedef struct firma_shatter_options {
    uint32_t size;        /* sizeof(firma_shatter_options) */
    uint32_t max_spheres; /* of a piece, 1 to 4,096; 0: 12 */
    firma_world world; /* the world that it lies in, of the level that it came from: each piece is of the matter of its
                          place there, its spheres keep clear of what is solid. 0: all are of the body's matter */
} firma_shatter_options;

typedef struct firma_shattered {
    uint32_t size; /* sizeof(firma_shattered) */
    uint32_t reserved;
    uint64_t pieces;                 /* FIRMA_DEBRIS_PIECES names them; the body itself where nothing divided it */
    uint64_t dust;                   /* pieces too small to be bodies, or without room for a sphere, or buried */
    uint64_t cracks, refused;        /* planes that divided something, and that could not be cut */
    double dust_mass;                /* kilograms */
    double dust_momentum[3];         /* newton seconds */
    double dust_angular_momentum[3]; /* newton metre seconds, about where the body's centre of mass was */
} firma_shattered;

/* Breaks a body: its pieces take its place, and keep its momentum and angular momentum. `fracture`, `options` and
 * `report` may be null. Errors as firma_world_fracture(): then all is as it was. */
FIRMA_API firma_code firma_shatter(firma_debris debris, firma_bodies bodies, firma_body_id id,
                                   const firma_fracture_pattern* pattern, const firma_fracture_options* fracture,
                                   const firma_shatter_options* options, firma_shattered* report);

/* How much debris a game keeps. firma_debris_rules_defaults() sets all; a null pointer takes the same. */
typedef struct firma_debris_rules {
    uint32_t size;            /* sizeof(firma_debris_rules) */
    uint32_t to_ground;       /* 1: sleepers become part of the world instead of going; 0 */
    uint64_t max_bodies;      /* 256 */
    uint64_t max_spheres;     /* of all debris together; 4,096 */
    double max_age;           /* seconds: what is older goes, asleep or not; INFINITY: nothing for its age alone */
    double max_asleep;        /* seconds; 20 */
    uint64_t max_to_ground;   /* a call: each is an edit of the world; 1 */
    double min_to_ground;     /* cubic metres: what is less goes; 0.01 */
    double max_overlap;       /* metres: so deep another body may be in what becomes ground; 0.02 */
    const double* keep_clear; /* spheres in the world that stay clear, players say: x, y, z, radius each; may be null */
    size_t keep_clear_count;
} firma_debris_rules;

FIRMA_API void firma_debris_rules_defaults(firma_debris_rules* rules);

typedef struct firma_debris_report {
    uint32_t size; /* sizeof(firma_debris_report) */
    uint32_t reserved;
    uint64_t removed;   /* FIRMA_DEBRIS_REMOVED */
    uint64_t to_ground; /* FIRMA_DEBRIS_TO_GROUND: each an edit, firma_debris_fill() */
    uint64_t refused;   /* that could not become ground */
    uint64_t waiting;   /* that wait, as a body or a player is in the way, or for another call */
} firma_debris_report;

/* Lets debris age, and keeps it within rules: once a frame, after firma_bodies_step(). `after` gets the world after all
 * that became ground. FIRMA_ERROR_OUT_OF_RANGE for seconds that are not finite, or negative, and for rules that are not
 * a number, or negative. */
FIRMA_API firma_code firma_debris_tend(firma_debris debris, firma_bodies bodies, firma_world world, double seconds,
                                       const firma_debris_rules* rules, firma_world* after,
                                       firma_debris_report* report);
/* One of the edits of the last firma_debris_tend(): firma_carve() with `fill`, this cutter, this pose and `material`
 * makes it again, for a log. The name is good as long as that world, or one that came of it. FIRMA_ERROR_OUT_OF_RANGE
 * for one that is not there. */
FIRMA_API firma_code firma_debris_fill(firma_debris debris, size_t fill, firma_cutter* cutter, firma_pose* pose,
                                       const char** material);

/* ---- blasts ----------------------------------------------------------------------------------------------------- */

typedef struct firma_blast {
    uint32_t size; /* sizeof(firma_blast) */
    uint32_t reserved;
    double at[3];   /* metres */
    double radius;  /* metres, > 0: nothing is felt from there on; 6 */
    double impulse; /* newton seconds a square metre that faces it, at `at`; >= 0; 3,000 */
} firma_blast;

/* At the origin. */
FIRMA_API void firma_blast_defaults(firma_blast* blast);

/* What is left of it at a distance: (1 - distance / radius)^2, 0 from the radius on. FIRMA_ERROR_OUT_OF_RANGE for a
 * blast that is not finite or out of range, here and below. */
FIRMA_API firma_code firma_blast_share(const firma_blast* blast, double distance, double* share);
/* Newton seconds that it gives to `area` square metres at a point, of which a share `seen` (0 to 1) is not covered. */
FIRMA_API firma_code firma_blast_impulse(const firma_blast* blast, const double point[3], double area, double seen,
                                         double impulse[3]);
/* The share of spheres (x, y, z, radius each) that is seen from a point: five rays a sphere; closed portals and the
 * fronts of faces that share a bit with `mask` cover. 0 for none. Takes memory for a copy of the spheres. */
FIRMA_API firma_code firma_exposure(firma_world world, const double from[3], const double* spheres, size_t count,
                                    uint32_t mask, double* seen);
/* The same in a level with parts, which cover from where they are as the scene's stretch begins. Nothing is seen in a
 * scene that cannot be cast in. */
FIRMA_API firma_code firma_exposure_scene(const firma_scene* scene, const double from[3], const double* spheres,
                                          size_t count, uint32_t mask, double* seen);

/* A null pointer takes the defaults. */
typedef struct firma_push_options {
    uint32_t size;    /* sizeof(firma_push_options) */
    uint32_t mask;    /* faces that stop a blast; UINT32_MAX */
    double max_speed; /* metres a second: a push gives no body more; INFINITY is no limit; 30 */
} firma_push_options;

FIRMA_API void firma_push_options_defaults(firma_push_options* options);

typedef struct firma_push_report {
    uint32_t size; /* sizeof(firma_push_report) */
    uint32_t reserved;
    uint64_t reached; /* bodies with a sphere within the radius */
    uint64_t pushed;  /* of these, that were not wholly covered; they wake */
} firma_push_report;

/* Pushes all bodies near a blast, weaker farther away, and by what stands before them. `report` may be null. */
FIRMA_API firma_code firma_blast_push(firma_world world, firma_bodies bodies, const firma_blast* blast,
                                      const firma_push_options* options, firma_push_report* report);
/* The same in a level with parts, which cover as in firma_exposure_scene(). */
FIRMA_API firma_code firma_blast_push_scene(const firma_scene* scene, firma_bodies bodies, const firma_blast* blast,
                                            const firma_push_options* options, firma_push_report* report);

/* A null pointer takes the defaults. */
typedef struct firma_explode_options {
    uint32_t size;                    /* sizeof(firma_explode_options) */
    uint32_t max_broken;              /* what broke so often does not break again; 3 */
    uint32_t max_pieces;              /* that a body breaks into at most, 1 to 4,096; 12 */
    uint32_t max_spheres;             /* of a piece, and of what comes loose, 1 to 4,096; 12 */
    double break_radius;              /* metres around the blast: what is seen in it breaks; 0: nothing does; 3 */
    double min_volume;                /* cubic metres: pieces of less become dust; 0.001 */
    uint64_t seed;                    /* 1 */
    const firma_carve_options* carve; /* of the crater; null: the defaults, with `chunks` */
    firma_push_options push;
} firma_explode_options;

FIRMA_API void firma_explode_options_defaults(firma_explode_options* options);

typedef struct firma_explosion {
    uint32_t size;    /* sizeof(firma_explosion) */
    uint32_t status;  /* firma_carve_status of the crater; for FIRMA_CARVE_REFUSED firma_error_message() says why */
    uint64_t loose;   /* FIRMA_DEBRIS_LOOSE */
    uint64_t pieces;  /* FIRMA_DEBRIS_PIECES: of debris that broke */
    uint64_t broken;  /* bodies that broke, of both */
    uint64_t unfit;   /* chunks that could not be bodies: lost */
    uint64_t dust;    /* pieces too small to be bodies */
    double dust_mass; /* kilograms */
    uint64_t reached, pushed; /* as in firma_push_report */
    firma_carve_report carve; /* filled where its own `size` is set; its `loose` is 0 */
} firma_explosion;

/* A blast in one call: the crater; what comes loose becomes debris and breaks as its matter does; debris near it that
 * it sees breaks; then all bodies near it are pushed. A cutter of 0 carves nothing. Where the crater is refused all
 * else happens. `options` and `report` may be null. Errors of firma_carve() and firma_blast_push(). */
FIRMA_API firma_code firma_explode(firma_world world, firma_debris debris, firma_bodies bodies,
                                   const firma_blast* blast, firma_cutter crater, const firma_pose* pose,
                                   const firma_explode_options* options, firma_world* after, firma_explosion* report);
/* The same in a level with parts, which cover as in firma_exposure_scene() and stay as they are: firma_parts_carve()
 * cuts them. */
FIRMA_API firma_code firma_explode_scene(const firma_scene* scene, firma_debris debris, firma_bodies bodies,
                                         const firma_blast* blast, firma_cutter crater, const firma_pose* pose,
                                         const firma_explode_options* options, firma_world* after,
                                         firma_explosion* report);

/* ---- parts of levels -------------------------------------------------------------------------------------------- */

/* A place on a part's way. */
typedef struct firma_part_stop {
    double position[3]; /* of the part's frame, metres */
    double angle;       /* radians about the path's axis */
    double wait;    /* seconds that it stands here; INFINITY: it goes no further. At the first stop it comes first */
    double seconds; /* to the next stop, or from the last to the first; not above 0: it is there at once */
} firma_part_stop;

/* How a part moves by time: stops in turn, a swing, a spin. Pure data; no call changes it. */
typedef struct firma_part_path {
    uint32_t size;                /* sizeof(firma_part_path) */
    uint32_t repeats;             /* 1: goes round for ever; 0: once round, and rests at the first stop */
    const firma_part_stop* stops; /* may be null when the count is 0: it stands at the origin */
    size_t stop_count;            /* at most 65,536 */
    double rotation[4];           /* x, y, z, w, at angle 0 */
    double axis[3];               /* unit, in the world's axes, of all angles; 0, 0, 1 */
    double spin;                  /* radians a second about it */
    double swing_reach[3];        /* metres, to each side of the middle */
    double swing_angle;           /* radians about the axis, likewise */
    double swing_period;          /* seconds of a whole cycle; not above 0: none */
    double swing_phase;           /* of a cycle, at time 0 */
} firma_part_path;

FIRMA_API void firma_part_path_defaults(firma_part_path* path);
/* Where a part is at a time; before 0 it stands at its first stop, but for swing and spin. FIRMA_ERROR_OUT_OF_RANGE for
 * a time, place or spin that is not finite, here and below. All of these cost a copy of the stops. */
FIRMA_API firma_code firma_part_path_pose(const firma_part_path* path, double seconds, firma_pose* pose);
/* From one time to another, for firma_parts_set_motions(): both ends are exact, between them it goes evenly. */
FIRMA_API firma_code firma_part_path_motion(const firma_part_path* path, double from, double to, firma_motion* motion);
/* The first time after `seconds` at which it arrives at, or leaves, a stop; INFINITY where there is none. */
FIRMA_API firma_code firma_part_path_next_stop(const firma_part_path* path, double seconds, double* next);
/* 1 where it stands at its first stop: a door that is shut. */
FIRMA_API firma_code firma_part_path_at_first_stop(const firma_part_path* path, double seconds, uint32_t* is_there);

/* A part of each entity of a level that moves and has brushes, as they stand at time 0: docs/moving.md says which
 * classes and keys. Entities that make none, or not what their author meant, are noted. Errors as
 * firma_world_from_level(). Costs what joining all these brushes costs. */
FIRMA_API firma_code firma_parts_from_level(firma_level level, const firma_world_options* options, firma_parts* parts);

typedef enum firma_when_blocked {
    FIRMA_BLOCKED_STOPS = 0,   /* waits where it is: trains, blades */
    FIRMA_BLOCKED_RETURNS = 1, /* goes back: doors, lifts */
    FIRMA_BLOCKED_CRUSHES = 2  /* goes on, and what is in the way is hurt, or out of the way */
} firma_when_blocked;

typedef struct firma_part_info {
    uint32_t size;              /* sizeof(firma_part_info) */
    uint32_t entity;            /* number in firma_level_view.entities; FIRMA_NO_PART of one that no level made */
    uint32_t when_blocked;      /* firma_when_blocked */
    uint32_t waits_for_trigger; /* 1: its path is of the time since it is set off; 0: of the level's time */
    uint32_t breaks;            /* 1: to be destroyed: firma_parts_breakable() */
    uint32_t mask;
    double low[3], high[3]; /* bounds of its solid in its frame, metres; low > high for one without faces */
    uint64_t face_count;
    firma_motion motion;
} firma_part_info;

/* FIRMA_ERROR_OUT_OF_RANGE for a part that is not there, here and below. */
FIRMA_API firma_code firma_parts_get(firma_parts parts, uint32_t index, firma_part_info* info);
/* The path that a level gave it; of others one that stands at the origin. Its stops are good until the handle is
 * released, or a part added. */
FIRMA_API firma_code firma_parts_path(firma_parts parts, uint32_t index, firma_part_path* path);
/* Its solid, in its frame. */
FIRMA_API firma_code firma_parts_world(firma_parts parts, uint32_t index, firma_world* world);
/* What making the parts of a level noted: `count` gets how many; the first `capacity` entities and texts are written,
 * where the pointers are not null. Texts are good until the handle is released. */
FIRMA_API firma_code firma_parts_notes(firma_parts parts, uint32_t* entities, const char** notes, size_t capacity,
                                       size_t* count);
/* The portals that a part closes where its motion begins, ascending; `count` gets how many, the first `capacity` are
 * written. For a door that is shut: firma_world_set_portal_open(). */
FIRMA_API firma_code firma_parts_portals(firma_parts parts, uint32_t index, firma_world level, uint32_t* portals,
                                         size_t capacity, size_t* count);
/* A pose of the world as a part sees it at a fraction of its motion: where to carve its solid. */
FIRMA_API firma_code firma_parts_pose_in(firma_parts parts, uint32_t index, double fraction, const firma_pose* pose,
                                         firma_pose* seen);

/* ---- parts that break ------------------------------------------------------------------------------------------- */

/* In place of a matter: that which its textures say. */
#define FIRMA_NO_MATTER UINT32_MAX

/* What a part bears, and what is left of that: kept by the caller. */
typedef struct firma_breakable {
    uint32_t size;    /* sizeof(firma_breakable) */
    uint32_t matter;  /* of all of it, or FIRMA_NO_MATTER */
    double health;    /* what is left, by its author's measure; not above 0: nothing hurts it */
    double whole;     /* cubic metres of its solid before anything was taken of it */
    double max_taken; /* of `whole`: what has lost a larger share breaks; 1: carving alone breaks it never; 0.5 */
    double damage;    /* of the explosion that it makes, by its author's measure */
    uint32_t broken;  /* 1: it is */
    uint32_t reserved;
} firma_breakable;

/* Of a part, as its level has it; of one that no level made with a health of 0. Costs its faces. */
FIRMA_API firma_code firma_parts_breakable(firma_parts parts, uint32_t index, firma_breakable* breakable);
/* Takes from its health; `breaks` gets 1 where this breaks it: call firma_parts_break(). FIRMA_ERROR_OUT_OF_RANGE for a
 * damage that is not finite, or negative. */
FIRMA_API firma_code firma_breakable_hurt(firma_breakable* breakable, double damage, uint32_t* breaks);
/* The share of a blast that a part feels at its nearest point; 0 where the level stands before that. */
FIRMA_API firma_code firma_parts_blast_felt(firma_parts parts, uint32_t index, firma_world level,
                                            const firma_blast* blast, double fraction, double* share);

/* A null pointer takes the defaults. */
typedef struct firma_break_options {
    uint32_t size;           /* sizeof(firma_break_options) */
    uint32_t max_pieces;     /* of each connected piece, at most; 1 to 4,096; 12 */
    uint32_t max_spheres;    /* of a piece; 1 to 4,096; 12 */
    uint32_t unbroken;       /* 1: it falls as it is; 0 */
    uint32_t has_impact;     /* 1: `impact` counts; 0 */
    uint32_t reserved;       /* must be 0 */
    double impact[3];        /* in the world, metres: pieces are smallest there */
    double fraction;         /* of the part's motion, 0 to 1, where it breaks; 0 */
    double seconds;          /* that its motion takes: pieces go on as it went; 0: they begin at rest */
    double min_volume;       /* cubic metres: pieces of less become dust; 0.001 */
    uint64_t seed;           /* 1 */
    const uint32_t* portals; /* opened as well as those that it covers: that it closed when it was whole; may be null */
    size_t portal_count;
} firma_break_options;

FIRMA_API void firma_break_options_defaults(firma_break_options* options);

typedef struct firma_break_report {
    uint32_t size; /* sizeof(firma_break_report) */
    uint32_t reserved;
    uint64_t pieces;  /* FIRMA_DEBRIS_PIECES */
    uint64_t unfit;   /* pieces of its solid that could be no bodies: lost */
    uint64_t dust;    /* pieces too small to be bodies */
    double dust_mass; /* kilograms */
    uint64_t opened;  /* portals that it closed, and that are open now */
} firma_break_report;

/* Breaks a part: its pieces become debris where it stands. The part keeps its number, without a face; the portals that
 * it closed are opened in `after`. `breakable` becomes broken; it, `options` and `report` may be null. A part without
 * solid breaks into nothing. */
FIRMA_API firma_code firma_parts_break(firma_parts parts, uint32_t index, firma_world level, firma_breakable* breakable,
                                       firma_debris debris, firma_bodies bodies, const firma_break_options* options,
                                       firma_world* after, firma_break_report* report);

/* A null pointer takes the defaults. */
typedef struct firma_part_cut_options {
    uint32_t size; /* sizeof(firma_part_cut_options) */
    uint32_t
        hold_largest; /* 0: the level's faces hold what touches them; 1: the largest piece is held, by what moves it */
    double touch;     /* metres within which a face holds; 1/32 */
    const firma_carve_options* carve; /* of the cut; null: the defaults */
    firma_break_options pieces;
} firma_part_cut_options;

FIRMA_API void firma_part_cut_options_defaults(firma_part_cut_options* options);

typedef struct firma_part_cut {
    uint32_t size;   /* sizeof(firma_part_cut) */
    uint32_t status; /* firma_carve_status; for FIRMA_CARVE_REFUSED firma_error_message() says why */
    uint64_t loose;  /* FIRMA_DEBRIS_LOOSE: what the cut left that nothing holds, unbroken */
    uint64_t unfit;  /* such pieces that could be no bodies: lost */
    uint32_t broke;  /* 1: what was left broke or fell: FIRMA_DEBRIS_PIECES, and `rest` */
    uint32_t reserved;
    double volume;   /* cubic metres that the cutter took */
    uint64_t opened; /* portals that it closed before, and that are open now: it has a hole there, or it broke */
    firma_break_report rest; /* filled where its own `size` is set */
} firma_part_cut;

/* Carves a part where it stands. Pieces that nothing holds become bodies; where more than max_taken was taken, or
 * nothing holds any of it, the rest goes as by firma_parts_break(). `pose`: of the cutter, in the world. `breakable`,
 * `options` and `report` may be null. Errors of firma_carve(). */
FIRMA_API firma_code firma_parts_carve(firma_parts parts, uint32_t index, firma_world level, firma_breakable* breakable,
                                       firma_cutter cutter, const firma_pose* pose, firma_debris debris,
                                       firma_bodies bodies, const firma_part_cut_options* options, firma_world* after,
                                       firma_part_cut* report);

/* ---- what faces hold -------------------------------------------------------------------------------------------- */

typedef enum firma_support_kind {
    FIRMA_SUPPORT_TOUCHES = 0, /* whatever faces its sides touch */
    FIRMA_SUPPORT_STANDS = 1,  /* it is put down first; then what is below it */
    FIRMA_SUPPORT_HANGS = 2    /* whatever faces are as near as the nearest */
} firma_support_kind;

/* Something that faces may hold: docs/support.md. */
typedef struct firma_supported {
    uint32_t entity; /* the caller's number for it */
    uint32_t kind;   /* firma_support_kind */
    double low[3];   /* a box, metres */
    double high[3];
    double reach;      /* metres: from a side to what holds it; how far down; how far around */
    uint32_t mask;     /* faces that share a bit hold; 0: those that stop walkers */
    uint32_t reserved; /* must be 0 */
} firma_supported;

/* What holds things. FIRMA_ERROR_INVALID, with the thing's number, for one that is not finite or out of range. Costs
 * the faces near each. */
FIRMA_API firma_code firma_supports_find(firma_world world, const firma_supported* things, size_t count,
                                         firma_supports* supports);
/* Of the entities of a level that something may hold: parts, what is put down, what hangs. `parts` is
 * firma_parts_from_level() of it; 0: without them. */
FIRMA_API firma_code firma_supports_from_level(firma_world world, firma_level level, firma_parts parts,
                                               firma_supports* supports);

typedef struct firma_support {
    uint32_t size; /* sizeof(firma_support) */
    uint32_t entity;
    uint32_t kind; /* firma_support_kind */
    uint32_t reserved;
    uint64_t face_count; /* that hold it: firma_supports_faces() */
    double area;         /* square metres that hold it; 0: nothing does */
    double lowered;      /* metres that it stands below where it was given */
} firma_support;

FIRMA_API firma_code firma_supports_get_count(firma_supports supports, size_t* count);
/* FIRMA_ERROR_OUT_OF_RANGE for one that is not there, here and below. */
FIRMA_API firma_code firma_supports_get(firma_supports supports, size_t thing, firma_support* support);
/* The ids of the faces that hold it, ascending, and the square metres of each; either may be null. */
FIRMA_API firma_code firma_supports_faces(firma_supports supports, size_t thing, uint32_t* faces, double* areas,
                                          size_t capacity, size_t* count);
FIRMA_API firma_code firma_supports_release(firma_supports supports);

typedef enum firma_support_loss {
    FIRMA_SUPPORT_KEPT = 0, /* as much holds it as before, or more: other faces in place of those that went */
    FIRMA_SUPPORT_LESS = 1,
    FIRMA_SUPPORT_LOST = 2 /* nothing holds it any more */
} firma_support_loss;

typedef struct firma_support_change {
    uint32_t thing; /* its number in the supports */
    uint32_t entity;
    uint32_t loss;        /* firma_support_loss */
    uint32_t buried;      /* 1: its middle is in solid now: it was filled in */
    uint64_t lost;        /* how many of the faces that held it went */
    double before, after; /* square metres that hold it */
} firma_support_change;

/* The things whose supporting faces went or came between the world that `before` is of and another, by thing: `count`
 * gets how many, the first `capacity` are written. `after` gets the supports in that world, and may be null. `was`: the
 * world that `before` is of; with it only what is near the difference is searched; 0: all is. */
FIRMA_API firma_code firma_supports_diff(firma_supports before, firma_world was, firma_world world,
                                         firma_support_change* changes, size_t capacity, size_t* count,
                                         firma_supports* after);

/* ---- differences ------------------------------------------------------------------------------------------------ */

typedef struct firma_diff_view {
    uint32_t size; /* sizeof(firma_diff_view) */
    uint32_t too_many_tiles;
    const uint32_t* removed; /* ids, in order */
    size_t removed_count;
    const firma_face* added; /* in order of id */
    size_t added_count;
    const double* corners; /* of `added`, three for each */
    size_t corner_count;
    const int32_t* tiles; /* three for each: the cell from tile * size to (tile + 1) * size */
    size_t tile_count;
    /* Ascending. */
    const uint32_t* rooms; /* that a face left or came to, that became part of another, or that one world only has */
    size_t room_count;
    const uint32_t *opened, *closed; /* portals of both worlds */
    size_t opened_count, closed_count;
    const uint32_t *portals_added, *portals_removed; /* with polygons in one world only */
    size_t portals_added_count, portals_removed_count;
    const uint32_t* portals_changed; /* of both, with other rooms, polygons or names */
    size_t portals_changed_count;
    double low[3], high[3];          /* bounds of all that changed; low > high when nothing did */
    const firma_face* removed_faces; /* `removed` as the world before had them, with room and source; without corners
                                        (corner_count 0), which firma_world_face() of that world has */
} firma_diff_view;

/* What changed from one world to another. `tile_size` metres, 0 for no tiles; FIRMA_ERROR_INVALID for one below 1/16.
 * What the worlds share is not compared: for versions a few edits apart the cost follows the edits, with a walk through
 * the index for each face added; worlds that share nothing cost all faces of both. Tiles cost one entry for each tile
 * in a changed face's box, and sorting them. */
FIRMA_API firma_code firma_world_diff(firma_world before, firma_world after, double tile_size, firma_diff* diff);
FIRMA_API firma_code firma_diff_get_view(firma_diff diff, firma_diff_view* view);
FIRMA_API firma_code firma_diff_release(firma_diff diff);

/* ---- histories -------------------------------------------------------------------------------------------------- */

/* A store holds the newest world, which any thread may take at any time, and those before it, for undo. An editor takes
 * the current world, edits it, and publishes the result. */
typedef struct firma_store_facts {
    uint32_t size; /* sizeof(firma_store_facts) */
    uint32_t reserved;
    uint64_t oldest, current, newest; /* versions */
    uint64_t versions;                /* held, undone ones included */
    uint64_t bytes;                   /* held beside the newest version */
    uint64_t waiting;                 /* dropped versions that somebody held when it was last looked */
} firma_store_facts;

/* `max_bytes` bounds what versions other than the current one hold; with 0 there is no undo. Shares the world. */
FIRMA_API firma_code firma_store_open(firma_world first, uint64_t max_bytes, firma_store* store);
/* Another handle to the current world; never waits for an edit. Take one for a frame and cast on it. Costs a handle. */
FIRMA_API firma_code firma_store_current(firma_store store, firma_world* world);
/* Makes `after` the current world. `before` must be the current one, from which it was made: FIRMA_ERROR_INVALID, and
 * nothing changed, when somebody else was first, or when the version of `after` is not greater. Drops what was undone,
 * and the oldest versions beyond the bytes. Costs what the two do not share, and freeing what is dropped. */
FIRMA_API firma_code firma_store_publish(firma_store store, firma_world before, firma_world after);
/* The world that is current then. FIRMA_ERROR_INVALID when there is none. Costs a few handles, whatever the versions
 * differ in, and freeing what was dropped and nobody holds any more. */
FIRMA_API firma_code firma_store_undo(firma_store store, firma_world* world);
FIRMA_API firma_code firma_store_redo(firma_store store, firma_world* world);
/* FIRMA_ERROR_INVALID for a version that is not held. Costs a binary search among those that are. */
FIRMA_API firma_code firma_store_at(firma_store store, uint64_t version, firma_world* world);
/* Kept as versions come and go: costs the same however many are held. */
FIRMA_API firma_code firma_store_get_facts(firma_store store, firma_store_facts* facts);
/* Frees dropped versions that nobody holds any more; publish, undo and redo do so too. `waiting` may be null: how many
 * are still held. Costs a look at each version that waits, and what is freed. */
FIRMA_API firma_code firma_store_collect(firma_store store, uint64_t* waiting);
FIRMA_API firma_code firma_store_release(firma_store store);

/* ---- edits as bytes --------------------------------------------------------------------------------------------- */

/* Commands say what an edit does, logs are commands in order: a level and its log give the same world, to the bit, on
 * every machine. Commands never change. docs/edit_log.md. */
typedef enum firma_edit_kind {
    FIRMA_EDIT_CARVE = 0,
    FIRMA_EDIT_FILL = 1,
    FIRMA_EDIT_DOOR = 2, /* opens or closes a portal */
    FIRMA_EDIT_GROUP = 3 /* several of these as one version */
} firma_edit_kind;

/* In place of a shape: a cutter that is no crater of firma_cutter_crater(). */
#define FIRMA_NO_SHAPE UINT32_MAX

/* Puts the position and scale on steps of 1/4096, and the turn on four parts of 16 bits: few bytes. Doing it again
 * changes nothing. Off by at most 1/8192 m, 1/16,000 of a radian and 1/8192 m a unit of the cutter. What is not finite
 * or zero stays. `quantised` may be `pose`. */
FIRMA_API firma_code firma_pose_quantise(const firma_pose* pose, firma_pose* quantised);

/* An edit that carves or fills. `number` is 1 to 2^21 - 1, above that of every command before it; `edit` of the options
 * is not used. A cutter of firma_cutter_crater() is stored as its shape and seed. `options` may be null. */
FIRMA_API firma_code firma_command_edit(uint32_t number, firma_cutter cutter, const firma_pose* pose,
                                        const firma_carve_options* options, firma_command* command);
/* Opens or closes a portal. FIRMA_ERROR_INVALID for an `open` that is not 0 or 1. */
FIRMA_API firma_code firma_command_door(uint32_t number, uint32_t portal, uint32_t open, firma_command* command);
/* Several as one version; the numbers are those of the parts. FIRMA_ERROR_INVALID for none, for a group among them, and
 * for numbers that do not ascend. Copies the parts; cutters are shared. */
FIRMA_API firma_code firma_command_group(const firma_command* parts, size_t count, firma_command* command);
/* The same command with its poses and `from` quantised, but for turns that are those of the crater's seed
 * (firma_random_turn()), which take no bytes. Who shoots does this before anybody applies it, himself included. */
FIRMA_API firma_code firma_command_quantise(firma_command command, firma_command* quantised);
/* The bytes, and back. A crater with a quantised pose takes about 25 bytes and the name of its material. What is read
 * is taken as hostile. FIRMA_ERROR_INVALID, TOO_LARGE, OUT_OF_RANGE for numbers that are none, and poses that are not
 * finite; reading, FIRMA_ERROR_MALFORMED with the byte, and FIRMA_ERROR_UNSUPPORTED for another version. `name`, for
 * messages, may be null, here and below. Costs the bytes. */
FIRMA_API firma_code firma_command_pack(firma_command command, firma_bytes* bytes);
FIRMA_API firma_code firma_command_unpack(const void* data, size_t length, const char* name, firma_command* command);

typedef struct firma_command_view {
    uint32_t size;        /* sizeof(firma_command_view) */
    uint32_t kind;        /* firma_edit_kind */
    uint32_t number;      /* of a group 0 */
    uint32_t last_number; /* of a group that of its last part, else `number` */
    uint32_t part_count;  /* of a group */
    uint32_t portal;      /* of a door; else FIRMA_NO_PORTAL */
    uint32_t open;        /* likewise */
    uint32_t shape;       /* firma_shape of what carves or fills; else FIRMA_NO_SHAPE */
    uint64_t seed;        /* where there is a shape */
    firma_pose pose;      /* of what carves or fills */
    const char* material; /* good until the command is released */
    uint32_t chunks, has_from;
    double from[3];
    double min_chunk_volume, density; /* with `chunks` */
} firma_command_view;

FIRMA_API firma_code firma_command_get_view(firma_command command, firma_command_view* view);
/* A part of a group, as a command of its own. FIRMA_ERROR_OUT_OF_RANGE for one that is not there. */
FIRMA_API firma_code firma_command_part(firma_command command, size_t part, firma_command* out);
FIRMA_API firma_code firma_command_release(firma_command command);

/* As firma_carve(), for any command. The report of a group adds up its parts', with the smallest scale and the chunks
 * of all; of a door it says only the status. It is refused, too, where it carves or fills and its number is not above
 * that of the last edit, for a portal that is not there, and for what no command may be. Numbers of doors do not matter
 * here: put them in order first. Costs what its edits cost. */
FIRMA_API firma_code firma_command_apply(firma_world world, firma_command command, firma_world* after,
                                         firma_carve_report* report);
/* The same in slices, by firma_job_run() and firma_job_result(). Makes the crater of a seed; all else is left to them.
 */
FIRMA_API firma_code firma_command_start(firma_world world, firma_command command, firma_job* job);

/* ---- edit logs -------------------------------------------------------------------------------------------------- */

typedef struct firma_log_facts {
    uint32_t size;                   /* sizeof(firma_log_facts) */
    uint32_t level_edits;            /* of the world it begins from: numbers of commands are above it */
    uint64_t level_hash, rules_hash; /* of that world: firma_world_hash(), and of its rules for carving */
    uint64_t command_count, checkpoint_count;
    uint64_t patch_bytes;    /* of the patch that stands for a beginning that was compacted; else 0 */
    uint32_t last_number;    /* of the last command's edit; level_edits without any. The next one's is above it */
    uint32_t patched_number; /* of the last edit that the patch stands for; 0 without one */
} firma_log_facts;

/* A log that begins from this world, empty. */
FIRMA_API firma_code firma_log_begin(firma_world level, firma_log* log);
/* Puts a command at the end. Errors of firma_command_pack(); FIRMA_ERROR_INVALID for a number that is not above the
 * last one. Costs a copy of the command; cutters are shared. */
FIRMA_API firma_code firma_log_append(firma_log log, firma_command command);
/* Says what the world's hash is after the commands so far: a replay compares it. */
FIRMA_API firma_code firma_log_checkpoint(firma_log log, firma_world world);
FIRMA_API firma_code firma_log_get_facts(firma_log log, firma_log_facts* facts);
/* From 0. FIRMA_ERROR_OUT_OF_RANGE for one that is not there. */
FIRMA_API firma_code firma_log_command(firma_log log, size_t index, firma_command* command);
/* The bytes, and back: with a checksum, and read as hostile, as by firma_command_unpack(). Costs the bytes. */
FIRMA_API firma_code firma_log_pack(firma_log log, firma_bytes* bytes);
FIRMA_API firma_code firma_log_unpack(const void* data, size_t length, const char* name, firma_log* log);
/* The same log with a patch in place of its commands up to a number, which is tried: for players who join late.
 * FIRMA_ERROR_INVALID where `level` is not the world it begins from, or the number is below that of a patch that it
 * has; FIRMA_ERROR_MALFORMED where a checkpoint does not hold. Costs a replay, and making and applying the patch. */
FIRMA_API firma_code firma_log_compact(firma_log log, firma_world level, uint32_t number, firma_log* compacted);
FIRMA_API firma_code firma_log_release(firma_log log);

typedef struct firma_replay_facts {
    uint32_t size;            /* sizeof(firma_replay_facts) */
    uint32_t finished;        /* 0 or 1 */
    uint64_t commands_behind; /* it, of `commands_in_all` */
    uint64_t commands_in_all;
    uint64_t applied; /* commands: of these */
    uint64_t done, nothing, refused;
    uint64_t checkpoints; /* that were compared and hold */
    const char* error; /* why it ended early, "place: reason"; "" where it did not. Good until the handle is released.
                          firma_replay_result() gives the code */
} firma_replay_facts;

/* A log applied to the level it begins from, in slices. Commands with numbers above `last_number` are left out
 * (UINT32_MAX: none). Costs comparing hashes, and a copy of the log, cutters shared. */
FIRMA_API firma_code firma_replay_start(firma_world level, firma_log log, uint32_t last_number, firma_replay* replay);
/* As firma_job_run(); a patch is applied in one piece. */
FIRMA_API firma_code firma_replay_run(firma_replay replay, double microseconds, uint32_t* finished);
FIRMA_API firma_code firma_replay_get_facts(firma_replay replay, firma_replay_facts* facts);
/* The world after the commands that were applied, whether it is finished or not. Where it ended early, it fails instead
 * and says why: FIRMA_ERROR_INVALID for another level or other rules than the log's, and a `last_number` before its
 * patch; FIRMA_ERROR_MALFORMED for a checkpoint that does not hold, with the command; errors of a patch. */
FIRMA_API firma_code firma_replay_result(firma_replay replay, firma_world* world);
FIRMA_API firma_code firma_replay_release(firma_replay replay);

/* ---- patches ---------------------------------------------------------------------------------------------------- */

/* How two peers whose worlds differ come to agree. Regions are three integers each, as in firma_region_hash. */

/* The regions whose hashes differ, ascending, those that only one list has among them. `count` gets how many; the first
 * `capacity` are written. Costs both lists, sorted. */
FIRMA_API firma_code firma_differing_regions(const firma_region_hash* a, size_t a_count, const firma_region_hash* b,
                                             size_t b_count, int32_t* regions, size_t capacity, size_t* count);
/* What a world has in some regions, for another peer: 12 bytes a face, and a hash of its rooms and portals. Costs the
 * faces there, sorted. */
FIRMA_API firma_code firma_world_list_faces(firma_world world, const int32_t* regions, size_t region_count,
                                            firma_bytes* list);
/* The patch that makes this world out of the one that a list was made of. The list is taken as hostile:
 * FIRMA_ERROR_MALFORMED for bytes that are none. Costs the faces of the regions, and those around the ones that differ.
 */
FIRMA_API firma_code firma_world_make_patch(firma_world world, const void* list, size_t length, const char* name,
                                            firma_bytes* patch);
/* The same from a world at hand, whose ids, rules and textures it shares: in the regions where they differ. */
FIRMA_API firma_code firma_world_patch_from(firma_world world, firma_world from, firma_bytes* patch);
/* The world that a patch makes of this one, which is taken as hostile: of damage, of faces that do not close with those
 * around them, and of any world whose hash is not the one that the patch says, nothing comes. FIRMA_ERROR_INVALID for
 * another world than the one it was made for; else errors of firma_world_unpack(). Shares what the patch leaves. Time
 * grows with the patch and with all faces of the world, which are judged as by firma_world_check(). */
FIRMA_API firma_code firma_world_apply_patch(firma_world world, const void* patch, size_t length, const char* name,
                                             firma_world* patched);

/* ---- games ------------------------------------------------------------------------------------------------------ */

/* A whole game as one value: a world and the log of what was done to it, parts that move, players, weapons and what was
 * fired of them, bodies, debris, rules, and the tick. What happens from outside happens between two ticks;
 * firma_game_step() goes one tick on. The same game given the same events goes through the same bits on every machine.
 * docs/recordings.md.
 * A game is in one of three states: as it was made, read or copied; recorded, from firma_game_record() on; or a replay,
 * of firma_recording_replay(). What may not be done in a state gives FIRMA_ERROR_BAD_CALL. Where memory runs out within
 * a call that changes a game, the game is lost: all but releasing it says FIRMA_ERROR_NO_MEMORY from then on. */

/* In place of a tick: never. */
#define FIRMA_NO_TICK UINT64_MAX

/* A game in a level, at tick 0, with the weapons 0 "bullet" (of 10 g, goes into solid and ricochets), 1 "rocket" (flies
 * straight, explodes where it stops) and 2 "grenade" (bounces, explodes after 2.5 s). Where loose pieces are to be held
 * by something else than by default, say so first: firma_world_with_anchors(). `rate`: 4 to 1,000 ticks a second, else
 * FIRMA_ERROR_INVALID. Costs firma_log_begin(). */
FIRMA_API firma_code firma_game_begin(firma_world level, uint32_t rate, firma_game* game);
/* Another that goes the same way from here, neither recorded nor a replay. Costs its arrays; worlds and shapes are
 * shared. */
FIRMA_API firma_code firma_game_copy(firma_game game, firma_game* copy);
FIRMA_API firma_code firma_game_release(firma_game game);

typedef struct firma_game_facts {
    uint32_t size;       /* sizeof(firma_game_facts) */
    uint32_t rate;       /* ticks a second */
    uint64_t tick;       /* ticks behind it */
    uint64_t explosions; /* so far */
    uint64_t weapons, parts, players, projectiles, bodies;
    uint32_t recorded; /* 1: it is being recorded */
    uint32_t replay;   /* 1: it is a replay */
} firma_game_facts;

/* Costs its slots of bodies. */
FIRMA_API firma_code firma_game_get_facts(firma_game game, firma_game_facts* facts);

/* ---- what a game goes by ---- */

/* Set before anything happens, or between ticks, but not while a game is recorded, nor in a replay. */
typedef struct firma_game_rules {
    uint32_t size;             /* sizeof(firma_game_rules) */
    uint32_t no_chunks;        /* 1: what carvings leave loose stays; 0: it becomes debris */
    double min_chunk_volume;   /* cubic metres: pieces of less are lost; 0.001 */
    double chunk_density;      /* kilograms a cubic metre; 0, the default: of each matter */
    double max_blast_speed;    /* metres a second: a blast gives no body and no player more; 30 */
    uint64_t seed;             /* of craters and cracks; 1 */
    firma_step_options bodies; /* with sizes of their own, which have to be set, here and below */
    firma_debris_rules debris; /* keep_clear is not used: players are kept clear */
} firma_game_rules;

FIRMA_API void firma_game_rules_defaults(firma_game_rules* rules);
FIRMA_API firma_code firma_game_get_rules(firma_game game, firma_game_rules* rules);
/* Errors as firma_bodies_step() and firma_debris_tend() have them for options and rules. */
FIRMA_API firma_code firma_game_set_rules(firma_game game, const firma_game_rules* rules);

/* What explodes. */
typedef struct firma_charge {
    uint32_t size;        /* sizeof(firma_charge) */
    uint32_t shape;       /* firma_shape of the crater; FIRMA_ROCKY */
    double crater;        /* metres, at most 8,192: its mean radius; 0: it leaves none; 1.2 */
    double radius;        /* metres, > 0: nothing is felt from there on; 6 */
    double impulse;       /* newton seconds a square metre that faces it, >= 0; 3,000 */
    double break_radius;  /* metres, >= 0: debris in it that it sees breaks; 3 */
    uint32_t max_pieces;  /* that a body breaks into at most, 1 to 4,096; 12 */
    uint32_t reserved;    /* must be 0 */
    const char* material; /* of the faces that the crater leaves; null: "" */
} firma_charge;

FIRMA_API void firma_charge_defaults(firma_charge* charge);

/* A kind of projectile, and what becomes of it. */
typedef struct firma_weapon {
    uint32_t size;           /* sizeof(firma_weapon) */
    uint32_t lies;           /* 1: one that stops lies there until its fuse ends; 0: it goes at once */
    const char* name;        /* null: "" */
    double mass;             /* kilograms, of a projectile, > 0; 0.01 */
    double gravity[3];       /* 0, 0, -9.81 m/s2; at most 1,000 */
    double pane_energy;      /* joules that it takes to go through a pane; 2^200: none does */
    double stop_speed;       /* metres a second: what an impact leaves slower stops there; 1 */
    double fuse;             /* seconds from when it was fired, 0 to 3,600; 10: then it goes */
    firma_shot_terms terms;  /* of all matters, and of parts; firma_shot_terms_defaults() */
    firma_shot_terms bodies; /* likewise */
    uint32_t has_charge;     /* 1: it goes with `charge`; 0 */
    uint32_t reserved;       /* must be 0 */
    firma_charge charge;
} firma_weapon;

FIRMA_API void firma_weapon_defaults(firma_weapon* weapon);
/* Texts are good until the weapon is set, another is added, or the game released. FIRMA_ERROR_OUT_OF_RANGE for a weapon
 * that is not there. */
FIRMA_API firma_code firma_game_get_weapon(firma_game game, uint32_t index, firma_weapon* weapon);
/* Another weapon in place of one; what was fired of it flies on by it. FIRMA_ERROR_INVALID, naming it, for what is out
 * of range. */
FIRMA_API firma_code firma_game_set_weapon(firma_game game, uint32_t index, const firma_weapon* weapon);
/* `index` gets its number, and may be null. Errors as above. */
FIRMA_API firma_code firma_game_add_weapon(firma_game game, const firma_weapon* weapon, uint32_t* index);

/* A part that moves, and how it goes by time. */
typedef struct firma_game_part {
    uint32_t size;               /* sizeof(firma_game_part) */
    uint32_t mask;               /* met by what shares a bit with it, and with the face */
    firma_world world;           /* the solid in the part's frame, of one room; shared: the handle may be released */
    const firma_part_path* path; /* copied; null: it stands at the origin */
    const char* name;            /* for messages; null: "" */
    uint32_t entity;             /* of the level, or FIRMA_NO_PART */
    uint32_t waits;          /* 1: set off by firma_game_set_off(), and time 0 of its path is then; 0: it is tick 0 */
    uint32_t no_portals;     /* 1: only `portals`; 0: also those that its solid covers at its first stop, if it
                                waits */
    uint32_t when_blocked;   /* firma_when_blocked, where a player or body would be crushed; FIRMA_BLOCKED_CRUSHES */
    const uint32_t* portals; /* that are closed while it stands at its first stop, and open else; may be null */
    size_t portal_count;
} firma_game_part;

/* All bits, without a world, no entity. */
FIRMA_API void firma_game_part_defaults(firma_game_part* part);
/* Adds a part at its place at this tick. Parts of a level come from firma_parts_from_level(): firma_parts_world(),
 * firma_parts_path(), and `waits_for_trigger` of firma_parts_get(). `index` gets its number, and may be null.
 * FIRMA_ERROR_INVALID for a world of several rooms and for a path whose motion cannot be used; else errors of
 * firma_part_path_pose(). Costs the bounds of the world, and looking for portals. */
FIRMA_API firma_code firma_game_add_part(firma_game game, const firma_game_part* part, uint32_t* index);

/* A player as it comes in, and as it is. firma_game_player_defaults() sets all but the shape. */
typedef struct firma_game_player {
    uint32_t size;            /* sizeof(firma_game_player) */
    uint32_t reserved;        /* must be 0 */
    firma_player_shape shape; /* kept: the handle may be released. Told as 0: firma_game_player_shape() */
    double mass;              /* kilograms, > 0: what blasts push; 80 */
    firma_player player;
    firma_player_wish wish; /* from tick to tick, but for `jump`, which is of one tick */
    firma_player_rules rules;
} firma_game_player;

FIRMA_API void firma_game_player_defaults(firma_game_player* player);

/* ---- what happens ---- */

/* Each happens at once, and where the game is recorded it is kept with the tick. Not in a replay. A weapon, player or
 * part that is not there, and what is out of range, gives FIRMA_ERROR_INVALID; a number that is not finite
 * FIRMA_ERROR_OUT_OF_RANGE: then nothing happened. */

/* An edit of the world: a carving, a fill, a door, a group. Its numbers are not used: the log's next ones are given.
 * What carvings leave loose becomes debris by the game's rules, whatever its `chunks` say. `status` gets a
 * firma_carve_status, and may be null; of one that is refused firma_error_message() says why. Costs
 * firma_command_apply(), and firma_debris_add_chunk() for each chunk. */
FIRMA_API firma_code firma_game_edit(firma_game game, firma_command command, uint32_t* status);
/* An explosion: firma_explode() with the next crater of the game's seed, the same crater in each part, and a push on
 * each player by what of it is seen. firma_game_blast() tells what it did. */
FIRMA_API firma_code firma_game_explode(firma_game game, const double at[3], const firma_charge* charge);
/* A projectile of a weapon starts, in the air, at most 524,288 m/s fast along an axis. */
FIRMA_API firma_code firma_game_fire(firma_game game, uint32_t weapon, const double position[3],
                                     const double velocity[3]);
/* A body is put in, the frame of its shape at a pose, whose scale does not count. `body`: how it moves and what it is
 * like, of which position and rotation do not count; null: firma_body_defaults(). `id` may be null. */
FIRMA_API firma_code firma_game_add_body(firma_game game, firma_body_shape shape, const firma_pose* pose,
                                         const firma_body* body, firma_body_id* id);
/* A player comes in; `index` gets its number, and may be null. */
FIRMA_API firma_code firma_game_add_player(firma_game game, const firma_game_player* player, uint32_t* index);
/* A player wishes something else from now on. */
FIRMA_API firma_code firma_game_wish(firma_game game, uint32_t player, const firma_player_wish* wish);
/* A part that waits sets off, if it stands at its first stop; else this is in vain. */
FIRMA_API firma_code firma_game_set_off(firma_game game, uint32_t part);

/* One tick on: parts go, doors open and close, players move, projectiles fly, what explodes explodes, bodies step,
 * debris grows old. A game that is recorded keeps its hashes. A replay does what was recorded for this tick, and
 * compares: firma_game_get_replay(); after its last tick, and after the first that is not as it was recorded, it is
 * over, and another step gives FIRMA_ERROR_BAD_CALL. FIRMA_ERROR_INVALID, with the part, for a motion that cannot be
 * used: the game is as it was then. The same bits on every machine. Costs a firma_move_player() a player, a firma_fly()
 * a weapon, a firma_explode() a blast, firma_bodies_step_scene(), firma_debris_tend(). */
FIRMA_API firma_code firma_game_step(firma_game game);

/* ---- what is in a game ---- */

/* The world, shared: costs a handle. */
FIRMA_API firma_code firma_game_world(firma_game game, firma_world* world);
/* Snapshots, to be asked with the calls that there are for them: the log of all that was done to the world; the parts
 * where they go in the last tick, with their paths and entities; the bodies; the debris of these. Changing them changes
 * nothing in the game. Each costs a copy of its arrays. */
FIRMA_API firma_code firma_game_log(firma_game game, firma_log* log);
FIRMA_API firma_code firma_game_parts(firma_game game, firma_parts* parts);
FIRMA_API firma_code firma_game_bodies(firma_game game, firma_bodies* bodies);
FIRMA_API firma_code firma_game_debris(firma_game game, firma_debris* debris);

typedef struct firma_game_part_state {
    uint32_t size; /* sizeof(firma_game_part_state) */
    uint32_t mask;
    uint32_t entity;        /* or FIRMA_NO_PART */
    uint32_t waits;         /* 1: it has to be set off */
    uint32_t at_first_stop; /* 1: it stands there: a door that is shut */
    uint32_t when_blocked;  /* firma_when_blocked */
    uint64_t started;       /* the tick when it was set off; FIRMA_NO_TICK: never, or it does not wait */
    firma_motion motion;    /* of the last tick */
    const char* name;       /* good until a part is added, the game stepped or released */
} firma_game_part_state;

/* FIRMA_ERROR_OUT_OF_RANGE for a part, player or weapon that is not there, here and below. */
FIRMA_API firma_code firma_game_get_part(firma_game game, uint32_t index, firma_game_part_state* state);
FIRMA_API firma_code firma_game_get_player(firma_game game, uint32_t index, firma_game_player* player);
FIRMA_API firma_code firma_game_player_shape(firma_game game, uint32_t index, firma_player_shape* shape);
/* Those of a weapon that fly or lie: `count` gets how many, the first `capacity` are written. */
FIRMA_API firma_code firma_game_projectiles(firma_game game, uint32_t weapon, firma_projectile* projectiles,
                                            size_t capacity, size_t* count);

/* ---- what happened ---- */

/* In the last tick, and by what happened before it since the tick before; or, where something has happened since the
 * last tick, in that alone. */
typedef struct firma_game_report {
    uint32_t size; /* sizeof(firma_game_report) */
    uint32_t reserved;
    uint64_t moves;       /* players that moved: firma_game_move() */
    uint64_t blasts;      /* firma_game_blast() */
    uint64_t shot_events; /* firma_game_shot_events() */
    uint64_t edits;       /* of the world that were done: they are in the log */
    uint64_t nothing;     /* that came to nothing */
    uint64_t refused;     /* that were refused */
    const char* refusal;  /* why, of the first of these; "" without any. Good until the game is changed or released */
    uint64_t loose;       /* bodies of what came loose */
    uint64_t broken;      /* bodies that broke */
    uint64_t removed;     /* bodies that were too old or too many */
    uint64_t grounded;    /* bodies that became ground */
    firma_step_report bodies;
} firma_game_report;

FIRMA_API firma_code firma_game_get_report(firma_game game, firma_game_report* report);
/* How a player moved in the last tick. FIRMA_ERROR_OUT_OF_RANGE for one that did not, and below for what is not there.
 */
FIRMA_API firma_code firma_game_move(firma_game game, uint32_t player, firma_player_move* move);
/* A blast and its place; firma_explosion.carve is filled where its own `size` is set. `at` may be null. */
FIRMA_API firma_code firma_game_blast(firma_game game, size_t blast, double at[3], firma_explosion* explosion);
/* The bodies of a blast's FIRMA_DEBRIS_LOOSE or FIRMA_DEBRIS_PIECES, as firma_debris_named(). */
FIRMA_API firma_code firma_game_blast_bodies(firma_game game, size_t blast, uint32_t list, firma_body_id* ids,
                                             size_t capacity, size_t* count);
/* Of all weapons one after the other; `weapons` gets the weapon of each. Either may be null. What they went through is
 * not told: length_count is 0. */
FIRMA_API firma_code firma_game_shot_events(firma_game game, firma_shot_event* events, uint32_t* weapons,
                                            size_t capacity, size_t* count);

/* ---- hashes and bytes of games ---- */

/* What a game consists of, for comparing two. */
typedef enum firma_game_item {
    FIRMA_ITEM_WORLD = 0, /* one */
    FIRMA_ITEM_PART = 1,  /* by index */
    FIRMA_ITEM_PLAYER = 2,
    FIRMA_ITEM_PROJECTILE = 3, /* by weapon, then index */
    FIRMA_ITEM_BODY = 4,       /* by slot */
    FIRMA_ITEM_DEBRIS = 5,     /* by slot */
    FIRMA_ITEM_REST = 6        /* one: counters, contacts of bodies, rules, the log */
} firma_game_item;

/* A hash of all that the next ticks depend on. Costs all bodies and players; of the world firma_world_hash(). */
FIRMA_API firma_code firma_game_hash(firma_game game, uint64_t* hash);
/* 32 bits of each item of a kind: `count` gets how many, the first `capacity` are written. FIRMA_ERROR_INVALID for a
 * kind that is none. Costs twice as much as firma_game_hash(). */
FIRMA_API firma_code firma_game_hash_items(firma_game game, uint32_t item, uint32_t* hashes, size_t capacity,
                                           size_t* count);

/* The game as the bytes of a .firma file, whose world every reader of worlds reads: the same bytes on every machine.
 * FIRMA_ERROR_INVALID, naming it, for what could not be read again. Costs firma_world_pack() of the world, of each part
 * and of each piece of debris. */
FIRMA_API firma_code firma_game_pack(firma_game game, firma_bytes* bytes);
/* The game of such bytes, taken as hostile; stepped on, it gives the same bits. `name`, for messages, may be null.
 * Errors of firma_world_unpack(); FIRMA_ERROR_MALFORMED for a file with a world alone. */
FIRMA_API firma_code firma_game_unpack(const void* data, size_t length, const char* name, firma_game* game);
/* The same in files, which appear whole or not at all. Not in the modules for browsers and node. */
FIRMA_API firma_code firma_game_save(firma_game game, const char* path);
FIRMA_API firma_code firma_game_load(const char* path, firma_game* game);

typedef enum firma_bytes_kind {
    FIRMA_BYTES_OTHER = 0, /* a world alone, too */
    FIRMA_BYTES_GAME = 1,
    FIRMA_BYTES_RECORDING = 2
} firma_bytes_kind;

/* What bytes begin as: firma_bytes_kind. Reads the head alone. */
FIRMA_API firma_code firma_game_bytes_kind(const void* data, size_t length, uint32_t* kind);

/* ---- recordings ------------------------------------------------------------------------------------------------- */

/* From now on all that happens to a game is recorded, with its hashes after each tick. `level`: what it was read from,
 * for people; may be null. FIRMA_ERROR_BAD_CALL for one that is recorded already, and for a replay. Costs a copy of the
 * game; each tick from then on hashes of all that is in it. */
FIRMA_API firma_code firma_game_record(firma_game game, const char* level);
/* What was recorded so far, as a value of its own; the game goes on being recorded. FIRMA_ERROR_BAD_CALL for a game
 * that is not recorded, and where something has happened since its last tick: step it first. Costs a copy of the game
 * and of the recording. */
FIRMA_API firma_code firma_game_recording(firma_game game, firma_recording* recording);
/* As many ticks as were recorded, from the same start, by the same events: a replay, a game at its start. It is
 * stepped by firma_game_step(), and asked as any game; a copy of it goes its own way. Costs a copy of the start. */
FIRMA_API firma_code firma_recording_replay(firma_recording recording, firma_game* game);

typedef struct firma_game_replay {
    uint32_t size;         /* sizeof(firma_game_replay) */
    uint32_t finished;     /* 1: it is over */
    uint32_t differs;      /* 1: and is another game than was recorded */
    uint32_t at_end;       /* 1: all ticks are as recorded, and the game that the recording ended with is another */
    uint64_t ticks;        /* that are as they were recorded, */
    uint64_t ticks_in_all; /* of these */
    uint64_t tick;         /* where it differs: so many ticks were behind */
    uint64_t hash;         /* of the replay then, and as recorded */
    uint64_t recorded;
    const char* text; /* what differs: "tick 37: the hash is ..., recorded is ...; not as recorded: player 0, body 5";
                         or why a tick could not be done; "" else. Good until the game is released */
} firma_game_replay;

/* FIRMA_ERROR_BAD_CALL for a game that is no replay. */
FIRMA_API firma_code firma_game_get_replay(firma_game game, firma_game_replay* replay);

typedef struct firma_recording_facts {
    uint32_t size;       /* sizeof(firma_recording_facts) */
    uint32_t rate;       /* ticks a second */
    uint64_t first_tick; /* of the game that it starts with */
    uint64_t ticks;      /* that were recorded */
    uint64_t events;
    uint64_t level_hash; /* firma_world_hash() of the level */
    const char* level;   /* as given to firma_game_record(). Good until the handle is released */
} firma_recording_facts;

FIRMA_API firma_code firma_recording_get_facts(firma_recording recording, firma_recording_facts* facts);
/* The game that it starts with (`at_end` 0), or ended with (1), neither recorded nor a replay. Costs a copy of it. */
FIRMA_API firma_code firma_recording_game(firma_recording recording, uint32_t at_end, firma_game* game);

typedef enum firma_game_event_kind {
    FIRMA_EVENT_EDIT = 0,
    FIRMA_EVENT_BLAST = 1,
    FIRMA_EVENT_FIRE = 2,
    FIRMA_EVENT_BODY = 3,
    FIRMA_EVENT_PLAYER = 4, /* comes in */
    FIRMA_EVENT_WISH = 5,
    FIRMA_EVENT_PART = 6 /* sets off */
} firma_game_event_kind;

/* Something that happened, for a list of it. */
typedef struct firma_game_event {
    uint32_t size;  /* sizeof(firma_game_event) */
    uint32_t kind;  /* firma_game_event_kind */
    uint64_t tick;  /* so many were behind */
    uint32_t index; /* of the weapon, of the player that wishes, of the part; else 0 */
    uint32_t reserved;
    double position[3]; /* where: of edits that of the cutter; zero of doors, groups, wishes and parts */
    double velocity[3]; /* of what was fired, of a body or a player that comes in, or wished; else zero */
} firma_game_event;

/* By tick, in the order in which they happened. FIRMA_ERROR_OUT_OF_RANGE for one that is not there. */
FIRMA_API firma_code firma_recording_event(firma_recording recording, size_t index, firma_game_event* event);

/* The bytes, and back, taken as hostile, as firma_game_unpack(). Costs firma_game_pack() twice, and the hashes. */
FIRMA_API firma_code firma_recording_pack(firma_recording recording, firma_bytes* bytes);
FIRMA_API firma_code firma_recording_unpack(const void* data, size_t length, const char* name,
                                            firma_recording* recording);
/* Not in the modules for browsers and node. */
FIRMA_API firma_code firma_recording_save(firma_recording recording, const char* path);
FIRMA_API firma_code firma_recording_load(const char* path, firma_recording* recording);
FIRMA_API firma_code firma_recording_release(firma_recording recording);

/* ---- bytes ------------------------------------------------------------------------------------------------------ */

/* The bytes, good until the handle is released. */
FIRMA_API firma_code firma_bytes_get_view(firma_bytes bytes, const void** data, size_t* length);
FIRMA_API firma_code firma_bytes_release(firma_bytes bytes);

/* ---- names of version 0.1 --------------------------------------------------------------------------------------- */

/* For programs of version 0.1; the next version has them no more. docs/migration.md tells what else changed. */
#define FIRMA_TOUCHING FIRMA_INITIAL_OVERLAP
#define FIRMA_ROOM FIRMA_AIR
#define FIRMA_UNSURE FIRMA_UNKNOWN

/* firma_world_locate() says more. 1 in the solid, 0 in the air, 2 on a face or where that cannot be said. */
static inline firma_code firma_in_solid(firma_world world, const double point[3], uint32_t* where) {
    uint32_t found = FIRMA_UNKNOWN;
    const firma_code code = firma_world_locate(world, point, where ? &found : NULL, NULL);
    if (code == FIRMA_OK) *where = found == FIRMA_SOLID ? 1 : found == FIRMA_AIR ? 0 : 2;
    return code;
}

/* Members of structs, too, when the program defines this before it includes the header; they are macros then. */
#ifdef FIRMA_NAMES_0_1
#define skin contact_offset
#define bins nodes
#define faces_per_bin faces_per_leaf
#define min_bin_volume min_node_volume
#define most_faces max_faces
#define most_faces_looked_at max_candidate_faces
#define most_new_faces max_new_faces
#define most_cutter_triangles max_cutter_triangles
#define most_pairs max_pairs
#define most_corners max_corners
#define largest_cutter max_cutter_size
#define faces_looked_at candidate_faces
#define faces_gone faces_removed
#define faces_new faces_added
#define part_of merged_into
#define gone removed
#define gone_count removed_count
#define come added
#define come_count added_count
#endif

#ifdef __cplusplus
}
#endif

#endif
