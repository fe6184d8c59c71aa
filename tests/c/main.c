/* SPDX-License-Identifier: MIT */
/* The C API, tested from C17. The allocator first: it can be given only before anything was made. */
#include <stdlib.h>
#include <string.h>

#include "tests/c/check.h"

#ifdef _WIN32 /* has no aligned_alloc(), whose memory free() takes */
#include <malloc.h>
#define TAKE_ALIGNED(alignment, bytes) _aligned_malloc(bytes, alignment)
#define GIVE_BACK_ALIGNED _aligned_free
#else
#define TAKE_ALIGNED aligned_alloc
#define GIVE_BACK_ALIGNED free
#endif

int failures = 0;

static size_t slabs_taken = 0;
static size_t pieces_held = 0;

static void* take(size_t bytes, size_t alignment, void* user) {
    CHECK(user == &slabs_taken);
    ++slabs_taken;
    ++pieces_held;
    return TAKE_ALIGNED(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void give_back(void* memory, size_t bytes, size_t alignment, void* user) {
    (void)bytes, (void)alignment, (void)user;
    --pieces_held;
    GIVE_BACK_ALIGNED(memory);
}

static void test_allocator(void) {
    firma_allocator allocator = {0};
    CHECK_FAILS(firma_set_allocator(NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_set_allocator(&allocator), FIRMA_ERROR_BAD_CALL, "size");
    allocator.size = sizeof allocator;
    CHECK_FAILS(firma_set_allocator(&allocator), FIRMA_ERROR_BAD_CALL, "missing");
    allocator.take = take;
    allocator.give_back = give_back;
    allocator.user = &slabs_taken;
    CHECK_OK(firma_set_allocator(&allocator));
    const firma_world room = make_room();
    CHECK(slabs_taken > 0);
    CHECK_FAILS(firma_set_allocator(&allocator), FIRMA_ERROR_BAD_CALL, "too late");
    CHECK_OK(firma_world_release(room));
}

firma_world make_room(void) {
    static const double positions[] = {0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0, 0, 0, 4, 8, 0, 4, 8, 8, 4, 0, 8, 4};
    static const uint32_t corners[] = {0, 1, 2, 3, 4, 7, 6, 5, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    static const uint32_t materials[] = {0, 1, 2, 2, 2, 2};
    static const char* const names[] = {"floor", "ceiling", "wall"};
    firma_mesh mesh = {0};
    mesh.size = sizeof mesh;
    mesh.positions = positions;
    mesh.vertex_count = 8;
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    mesh.materials = materials;
    mesh.material_names = names;
    mesh.material_count = 3;
    firma_world world = {0};
    CHECK_OK(firma_world_from_mesh(&mesh, "room", NULL, &world));
    return world;
}

firma_cutter make_box(double x0, double y0, double z0, double x1, double y1, double z1) {
    const double positions[] = {x0, y0, z0, x1, y0, z0, x1, y1, z0, x0, y1, z0,
                                x0, y0, z1, x1, y0, z1, x1, y1, z1, x0, y1, z1};
    static const uint32_t corners[] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                       1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    firma_cutter cutter = {0};
    CHECK_OK(firma_cutter_from_mesh(positions, 8, corners, 12, "box", &cutter));
    return cutter;
}

uint64_t hash_of(firma_world world) {
    uint64_t hash = 0;
    CHECK_OK(firma_world_hash(world, &hash));
    return hash;
}

int main(int argc, char** argv) {
    test_allocator();
    test_library();
    test_worlds();
    test_casts();
    test_movers();
    test_players();
    test_visitors();
    test_structs();
    test_old_names();
    test_carving();
    test_chunks();
    test_convex_pieces();
    test_bodies();
    test_body_casts();
    test_sphere_sets();
    test_projectiles();
    test_debris();
    test_level_parts();
    test_supports();
    test_games(argc > 1 ? argv[1] : ".");
    test_recordings(argc > 1 ? argv[1] : ".");
    test_matters();
    test_commands();
    test_logs(argc > 2 ? argv[2] : ".");
    test_patches();
    test_stores();
    test_files(argc > 1 ? argv[1] : ".");
    test_rooms(argc > 1 ? argv[1] : ".");
    test_handles();
    CHECK(firma_live_handles() == 0);
    if (failures == 0) printf("the C API: all holds\n");
    return failures != 0;
}
