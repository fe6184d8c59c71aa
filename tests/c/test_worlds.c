/* SPDX-License-Identifier: MIT */
/* Worlds made well and badly, and what they say of themselves. */
#include <math.h>
#include <stdlib.h>

#include "tests/c/check.h"

static const char kTetrahedron[] =
    "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nusemtl rock\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

static void test_bad_meshes(void) {
    double positions[] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    uint32_t corners[] = {0, 1, 2};
    uint32_t counts[] = {3};
    const uint32_t materials[] = {1};
    firma_mesh mesh = {0};
    firma_world world = {0};
    CHECK_FAILS(firma_world_from_mesh(NULL, NULL, NULL, &world), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_BAD_CALL, "size");
    mesh.size = sizeof mesh;
    CHECK_FAILS(firma_world_from_mesh(&mesh, "empty", NULL, &world), FIRMA_ERROR_MALFORMED, "empty: has no faces");
    mesh.face_count = 1;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_BAD_CALL, "array");
    mesh.corners = corners;
    mesh.positions = positions;
    mesh.vertex_count = 2;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_MALFORMED, "face 0: names vertex 2 of 2");
    mesh.vertex_count = 3;
    positions[4] = NAN;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_OUT_OF_RANGE, "vertex 1: is not finite");
    positions[4] = 9000;
    CHECK_FAILS(firma_world_from_mesh(&mesh, "big", NULL, &world), FIRMA_ERROR_OUT_OF_RANGE,
                "big: vertex 1: lies outside");
    positions[4] = 0;
    counts[0] = 2;
    mesh.corner_counts = counts;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_MALFORMED, "2 corners");
    counts[0] = 3;
    mesh.materials = materials;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, &world), FIRMA_ERROR_MALFORMED, "material 1 of 0");
    mesh.materials = NULL;
    CHECK_FAILS(firma_world_from_mesh(&mesh, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(world.id == 0);
    CHECK_OK(firma_world_from_mesh(&mesh, NULL, NULL, &world));
    CHECK_OK(firma_world_release(world));
}

static void test_options(void) {
    firma_world_options options;
    firma_world_options_defaults(&options);
    firma_world world = {0};
    options.scale = 2;
    options.contact_offset = 0.25;
    CHECK_OK(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, "t", &options, &world));
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(world, &facts));
    CHECK(facts.high[0] == 8 && facts.contact_offset == 0.25);
    CHECK_OK(firma_world_release(world));
    options.size = 4;
    CHECK_FAILS(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, "t", &options, &world),
                FIRMA_ERROR_BAD_CALL, "size");
    firma_world_options_defaults(&options);
    options.contact_offset = -1;
    CHECK_FAILS(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, "t", &options, &world), FIRMA_ERROR_INVALID,
                "contact offset");
    firma_world_options_defaults(&options);
    options.faces_per_leaf = 0;
    CHECK_FAILS(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, "t", &options, &world), FIRMA_ERROR_INVALID,
                "tree");
    firma_world_options_defaults(&options);
    options.scale = INFINITY;
    CHECK_FAILS(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, "t", &options, &world), FIRMA_ERROR_INVALID,
                "scale");
}

static void test_obj(void) {
    firma_world world = {0};
    CHECK_FAILS(firma_world_from_obj("v 1 2 x\n", 8, "bad.obj", NULL, &world), FIRMA_ERROR_MALFORMED, "bad.obj:1");
    CHECK_FAILS(firma_world_from_obj(NULL, 8, "bad.obj", NULL, &world), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_from_bsp("IBSP", 4, "cut.bsp", NULL, &world), FIRMA_ERROR_MALFORMED, "cut.bsp");
    CHECK_FAILS(firma_world_from_bsp_surfaces("IBSP", 4, "cut.bsp", NULL, &world), FIRMA_ERROR_MALFORMED, "cut.bsp");
    CHECK_OK(firma_world_from_obj(kTetrahedron, sizeof kTetrahedron - 1, NULL, NULL, &world));
    const char* name = NULL;
    CHECK_OK(firma_world_material(world, 1, &name));
    CHECK(name && strcmp(name, "rock") == 0);
    CHECK_FAILS(firma_world_material(world, 9, &name), FIRMA_ERROR_INVALID, "no material 9");
    CHECK_OK(firma_world_release(world));
}

static void test_room(void) {
    const firma_world room = make_room();
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(room, &facts));
    CHECK(facts.face_count == 6 && facts.room_count == 1 && facts.version == 0 && facts.edits == 0);
    CHECK(facts.low[0] == 0 && facts.high[2] == 4 && facts.contact_offset == 0.001);
    CHECK_OK(firma_world_check(room));
    double volume = 0, area = 0;
    CHECK_OK(firma_world_measure(room, &volume, &area));
    CHECK(volume == -256 && area == 256);
    CHECK_OK(firma_world_measure(room, NULL, NULL));

    firma_world copy = {0};
    uint64_t hash = 0, hash_of_copy = 1, alone = 0, both = 1;
    CHECK_OK(firma_world_copy(room, &copy));
    CHECK(copy.id != room.id);
    CHECK_OK(firma_world_hash(room, &hash));
    CHECK_OK(firma_world_hash(copy, &hash_of_copy));
    CHECK(hash == hash_of_copy);
    const firma_world two[] = {room, copy};
    CHECK_OK(firma_world_memory(two, 1, &alone));
    CHECK_OK(firma_world_memory(two, 2, &both));
    CHECK(alone > 0 && both >= alone && both < alone + alone / 2);

    firma_faces faces = {0};
    firma_faces_view view = {.size = sizeof view};
    CHECK_OK(firma_world_faces(room, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == 6 && view.corner_count == 24);
    CHECK(view.faces[0].id == 0 && view.faces[0].normal[2] == 1 && view.faces[0].flags == FIRMA_FACE_SOLID);
    CHECK(view.faces[5].first_corner == 20 && view.faces[5].corner_count == 4);
    CHECK(view.corners[3] == 8 && view.corners[4] == 0);
    CHECK_OK(firma_faces_release(faces));
    CHECK_OK(firma_world_find_face(room, 3, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == 1 && view.faces[0].id == 3 && view.faces[0].normal[0] == -1);
    CHECK_OK(firma_faces_release(faces));
    CHECK_OK(firma_world_find_face(room, 1000, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == 0);
    CHECK_OK(firma_faces_release(faces));
    CHECK_OK(firma_world_release(copy));
    CHECK_OK(firma_world_release(room));
}

/* A box of 8 by 8 by 4 m seen from inside: six faces, twelve triangles. */
static void test_triangles(void) {
    const firma_world room = make_room();
    firma_triangles triangles = {0};
    firma_triangles_view view = {.size = sizeof view};
    CHECK_OK(firma_world_triangles(room, NULL, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.vertex_count == 24 && view.triangle_count == 12 && view.source_count == 6 && view.run_count == 3);
    double area = 0;
    size_t in_runs = 0;
    for (size_t t = 0; t < view.triangle_count; ++t) {
        const float* p[3];
        for (int k = 0; k < 3; ++k) p[k] = view.positions + 3 * view.corners[3 * t + k];
        double normal[3], square = 0, along = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] = (p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - (p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
            square += normal[axis] * normal[axis];
            along += normal[axis] * view.normals[3 * view.corners[3 * t] + axis];
        }
        CHECK(along > 0 && square > 0);
        area += sqrt(square) / 2;
    }
    CHECK(area == 2 * 64 + 4 * 32);
    for (size_t r = 0; r < view.run_count; ++r) {
        CHECK(view.runs[r].first_triangle == in_runs);
        in_runs += view.runs[r].triangle_count;
    }
    CHECK(in_runs == 12 && view.sources[0].flags == FIRMA_FACE_SOLID && view.sources[0].room == 0);
    CHECK(view.faces[view.sources[2].first_triangle] == view.sources[2].face);
    CHECK_OK(firma_triangles_release(triangles));

    firma_triangle_options options;
    firma_triangle_options_defaults(&options);
    options.room = 0;
    options.origin[0] = 4;
    CHECK_OK(firma_world_triangles(room, &options, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    float low = 9;
    for (size_t v = 0; v < view.vertex_count; ++v) low = view.positions[3 * v] < low ? view.positions[3 * v] : low;
    CHECK(view.triangle_count == 12 && low == -4);
    CHECK_OK(firma_triangles_release(triangles));
    const int32_t here[3] = {0, 0, 0}, elsewhere[3] = {1, 0, 0};
    options.region = here;
    CHECK_FAILS(firma_world_triangles(room, &options, &triangles), FIRMA_ERROR_INVALID, "not both");
    options.room = FIRMA_ANY_ROOM;
    CHECK_OK(firma_world_triangles(room, &options, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.triangle_count == 12);
    CHECK_OK(firma_triangles_release(triangles));
    options.region = elsewhere;
    CHECK_OK(firma_world_triangles(room, &options, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.triangle_count == 0 && view.vertex_count == 0 && view.run_count == 0);
    CHECK_OK(firma_triangles_release(triangles));
    CHECK_FAILS(firma_triangles_get_view(triangles, &view), FIRMA_ERROR_BAD_HANDLE, "triangles");
    options.region = NULL;
    options.room = 7;
    CHECK_FAILS(firma_world_triangles(room, &options, &triangles), FIRMA_ERROR_INVALID, "no such room");
    options.room = FIRMA_ANY_ROOM;
    options.origin[2] = NAN;
    CHECK_FAILS(firma_world_triangles(room, &options, &triangles), FIRMA_ERROR_OUT_OF_RANGE, "origin");
    options.origin[2] = 0;
    options.solid_only = 2;
    CHECK_FAILS(firma_world_triangles(room, &options, &triangles), FIRMA_ERROR_INVALID, "solid_only");
    options.size = 0;
    CHECK_FAILS(firma_world_triangles(room, &options, &triangles), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_world_triangles(room, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(room));
}

/* A wall of 4 by 2 m whose picture goes twice across and once up, and one that says nothing. */
static void test_textures(void) {
    static const double positions[] = {0, 0, 0, 4, 0, 0, 4, 0, 2, 0, 0, 2, 0, 4, 0, 4, 4, 0};
    static const uint32_t corners[] = {0, 1, 2, 3, 0, 4, 5, 1}, counts[] = {4, 4};
    double uvs[] = {0, 1, 2, 1, 2, 0, 0, 0, 0, 0, 1, 1, 2, 5, 7, 7};
    firma_mesh mesh = {0};
    mesh.size = sizeof mesh;
    mesh.positions = positions;
    mesh.vertex_count = 6;
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.face_count = 2;
    mesh.uvs = uvs;
    firma_world world = {0};
    uvs[9] = NAN;
    CHECK_FAILS(firma_world_from_mesh(&mesh, "m", NULL, &world), FIRMA_ERROR_OUT_OF_RANGE,
                "face 1: has texture coordinates that are not finite");
    uvs[9] = 0;
    CHECK_OK(firma_world_from_mesh(&mesh, "m", NULL, &world));
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(world, &facts));
    CHECK(facts.face_count == 3); /* no one map gives the second's */
    firma_texture texture = {.size = sizeof texture};
    CHECK_OK(firma_world_texture(world, 0, NULL, &texture));
    CHECK(texture.unit == FIRMA_REPEATS && texture.u_axis[0] == 0.5 && texture.u_axis[2] == 0);
    CHECK(texture.v_axis[2] == -0.5 && texture.v_offset == 1 && texture.u_offset == 0);

    firma_cast_input down = {{2, -1, 1}, 0, {0, 4, 0}};
    firma_hit hit;
    CHECK_OK(firma_cast(world, &down, NULL, &hit, NULL));
    firma_texture of_hit = {.size = sizeof of_hit};
    CHECK_OK(firma_world_texture(world, hit.face, hit.corner, &of_hit));
    CHECK(memcmp(&texture, &of_hit, sizeof texture) == 0);
    CHECK_FAILS(firma_world_texture(world, 9, NULL, &texture), FIRMA_ERROR_INVALID, "no such face");
    hit.corner[0] += 1;
    CHECK_FAILS(firma_world_texture(world, hit.face, hit.corner, &texture), FIRMA_ERROR_INVALID, "no such face");
    CHECK_FAILS(firma_world_texture(world, 0, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    texture.size = 0;
    CHECK_FAILS(firma_world_texture(world, 0, NULL, &texture), FIRMA_ERROR_BAD_CALL, "size");

    firma_triangle_options options;
    firma_triangle_options_defaults(&options);
    firma_triangles triangles = {0};
    firma_triangles_view view = {.size = sizeof view};
    CHECK_OK(firma_world_triangles(world, &options, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.uvs == NULL && view.sources[0].uv_unit == FIRMA_METRES);
    CHECK_OK(firma_triangles_release(triangles));
    options.uvs = 1;
    CHECK_OK(firma_world_triangles(world, &options, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.uvs != NULL && view.source_count == 3 && view.sources[0].uv_unit == FIRMA_REPEATS);
    for (uint32_t v = 0; v < 4; ++v) {
        CHECK(view.uvs[2 * v] == view.positions[3 * v] / 2);
        CHECK(view.uvs[2 * v + 1] == 1 - view.positions[3 * v + 2] / 2);
    }
    CHECK_OK(firma_triangles_release(triangles));
    CHECK_OK(firma_world_release(world));

    firma_world_options plain;
    firma_world_options_defaults(&plain);
    plain.no_textures = 2;
    CHECK_FAILS(firma_world_from_mesh(&mesh, "m", &plain, &world), FIRMA_ERROR_INVALID, "no_textures");
    plain.no_textures = 1;
    CHECK_OK(firma_world_from_mesh(&mesh, "m", &plain, &world));
    CHECK_OK(firma_world_texture(world, 0, NULL, &of_hit));
    CHECK(of_hit.unit == FIRMA_METRES);
    CHECK_OK(firma_world_release(world));

    /* Texels of a .map, and how large its picture is. */
    static const char kBrush[] =
        "{\n\"classname\" \"worldspawn\"\n{\n"
        "( 0 0 0 ) ( 0 64 0 ) ( 0 0 64 ) wall 8 0 0 2 1\n( 64 0 0 ) ( 64 0 64 ) ( 64 64 0 ) wall 8 0 0 2 1\n"
        "( 0 0 0 ) ( 0 0 64 ) ( 64 0 0 ) wall 8 0 0 2 1\n( 0 64 0 ) ( 64 64 0 ) ( 0 64 64 ) wall 8 0 0 2 1\n"
        "( 0 0 0 ) ( 64 0 0 ) ( 0 64 0 ) wall 8 0 0 2 1\n( 0 0 64 ) ( 0 64 64 ) ( 64 0 64 ) wall 8 0 0 2 1\n}\n}\n";
    CHECK_OK(firma_world_from_map(kBrush, sizeof kBrush - 1, "a.map", NULL, &world));
    const double sizes[] = {0, 0, 128, 256};
    options.texture_size_count = 2;
    CHECK_FAILS(firma_world_triangles(world, &options, &triangles), FIRMA_ERROR_BAD_CALL, "array");
    options.texture_sizes = sizes;
    for (uint32_t known = 0; known < 2; ++known) {
        options.texture_size_count = 2 * known;
        CHECK_OK(firma_world_triangles(world, &options, &triangles));
        CHECK_OK(firma_triangles_get_view(triangles, &view));
        CHECK(view.sources[0].uv_unit == (known ? FIRMA_REPEATS : FIRMA_TEXELS));
        for (size_t v = 0; v < view.vertex_count; ++v) {
            if (view.normals[3 * v + 2] < 0.5f) continue;
            CHECK(view.uvs[2 * v] == (view.positions[3 * v] * 32 / 2 + 8) / (known ? 128 : 1));
            CHECK(view.uvs[2 * v + 1] == -view.positions[3 * v + 1] * 32 / (known ? 256 : 1));
        }
        CHECK_OK(firma_triangles_release(triangles));
    }
    options.uvs = 2;
    CHECK_FAILS(firma_world_triangles(world, &options, &triangles), FIRMA_ERROR_INVALID, "uvs");
    options.uvs = 1;
    options.reserved = 1;
    CHECK_FAILS(firma_world_triangles(world, &options, &triangles), FIRMA_ERROR_INVALID, "reserved");
    CHECK_OK(firma_world_release(world));
}

/* Faces in view `mesh`, and whether runs and parts cover its triangles. */
static size_t whole_mesh(const firma_region_mesh_view* mesh) {
    size_t triangles = 0, vertices = 0;
    for (size_t r = 0; r < mesh->run_count; ++r) {
        CHECK(mesh->runs[r].first_triangle == triangles && mesh->runs[r].first_vertex == vertices);
        triangles += mesh->runs[r].triangle_count;
        vertices += mesh->runs[r].vertex_count;
    }
    CHECK(triangles == mesh->triangle_count && vertices == mesh->vertex_count);
    for (size_t p = 0; p < mesh->part_count; ++p)
        for (uint32_t t = 0; t < mesh->parts[p].triangle_count; ++t)
            CHECK(mesh->faces[mesh->parts[p].first_triangle + t] == mesh->parts[p].face);
    return mesh->part_count;
}

static void test_region_meshes(void) {
    const firma_world room = make_room();
    firma_region_options options;
    firma_region_options_defaults(&options);
    CHECK(options.size == sizeof options && options.region_size == 16 && options.mask == UINT32_MAX);
    firma_region_options_defaults(NULL);
    firma_region_meshes meshes = {0};
    firma_region_mesh_view view = {.size = sizeof view};
    size_t count = 0;
    CHECK_OK(firma_world_region_meshes(room, NULL, &meshes));
    CHECK_OK(firma_region_meshes_get_count(meshes, &count));
    CHECK(count == 1);
    CHECK_OK(firma_region_meshes_get_view(meshes, 0, &view));
    CHECK(whole_mesh(&view) == 6 && view.vertex_count == 24 && view.triangle_count == 12 && view.run_count == 3);
    CHECK(view.place[0] == 0 && view.origin[2] == 0 && view.low[0] == 0 && view.high[1] == 8 && view.high[2] == 4);
    for (size_t v = 0; v < view.vertex_count; ++v) {
        const float *n = view.normals + 3 * v, *t = view.tangents + 4 * v;
        CHECK(n[0] * t[0] + n[1] * t[1] + n[2] * t[2] == 0 && t[3] == 1);
        CHECK(view.blends[4 * v + 3] == 255 && view.uvs[2 * v] == view.uvs[2 * v]);
    }
    CHECK(view.parts[0].flags == FIRMA_FACE_SOLID && view.parts[0].source_edit == 0 && view.runs[0].cut == 0);
    firma_faces face = {0};
    CHECK_OK(firma_world_face(room, view.parts[3].face, view.parts[3].corner, &face));
    CHECK_OK(firma_faces_release(face));
    CHECK_FAILS(firma_region_meshes_get_view(meshes, 1, &view), FIRMA_ERROR_OUT_OF_RANGE, "no such mesh");
    view.size = 4;
    CHECK_FAILS(firma_region_meshes_get_view(meshes, 0, &view), FIRMA_ERROR_BAD_CALL, "size");
    view.size = sizeof view;
    CHECK_FAILS(firma_region_meshes_get_view(meshes, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_region_meshes_get_count(meshes, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_region_meshes_release(meshes));
    CHECK_FAILS(firma_region_meshes_get_count(meshes, &count), FIRMA_ERROR_BAD_HANDLE, "region meshes");
    CHECK_FAILS(firma_region_meshes_release(meshes), FIRMA_ERROR_BAD_HANDLE, "released");
    CHECK_OK(firma_region_meshes_release((firma_region_meshes){0}));

    /* A crater in a corner: in small regions only some change, and together with the others they are all again. */
    firma_cutter cutter = {0};
    firma_world after = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, 1, &cutter));
    const firma_pose pose = {{7.5, 7.5, 0.5}, {0, 0, 0, 1}, 1};
    CHECK_OK(firma_carve(room, cutter, &pose, NULL, &after, NULL));
    options.region_size = 4;
    options.no_textures = 1;
    size_t faces = 0, cut = 0;
    CHECK_OK(firma_world_changed_region_meshes(room, after, &options, &meshes));
    CHECK_OK(firma_region_meshes_get_count(meshes, &count));
    CHECK(count > 1);
    for (size_t k = 0; k < count; ++k) {
        CHECK_OK(firma_region_meshes_get_view(meshes, k, &view));
        CHECK(view.tangents == NULL && view.uvs == NULL && view.blends == NULL);
        faces += whole_mesh(&view);
        for (size_t r = 0; r < view.run_count; ++r) cut += view.runs[r].cut;
    }
    CHECK(cut > 0);
    CHECK_OK(firma_region_meshes_release(meshes));
    CHECK_OK(firma_world_changed_region_meshes(after, after, &options, &meshes));
    CHECK_OK(firma_region_meshes_get_count(meshes, &count));
    CHECK(count == 0);
    CHECK_OK(firma_region_meshes_release(meshes));
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(after, &facts));
    size_t all = 0;
    CHECK_OK(firma_world_region_meshes(after, &options, &meshes));
    CHECK_OK(firma_region_meshes_get_count(meshes, &count));
    for (size_t k = 0; k < count; ++k) {
        CHECK_OK(firma_region_meshes_get_view(meshes, k, &view));
        all += whole_mesh(&view);
    }
    CHECK(all == facts.face_count && faces <= all);
    CHECK_OK(firma_region_meshes_release(meshes));

    options.region_size = 0.5;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_INVALID, "size: must be from 1 to");
    CHECK_FAILS(firma_world_changed_region_meshes(room, after, &options, &meshes), FIRMA_ERROR_INVALID, "size");
    options.region_size = 4;
    const double sizes[] = {64, 64, -1, 64};
    options.texture_size_count = 2;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_BAD_CALL, "array");
    options.texture_sizes = sizes;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_INVALID,
                "texture_sizes: must be finite");
    options.texture_size_count = 0;
    options.solid_only = 2;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_INVALID, "solid_only");
    options.solid_only = 1;
    options.no_textures = 2;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_INVALID, "no_textures");
    options.size = 0;
    CHECK_FAILS(firma_world_region_meshes(room, &options, &meshes), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_world_region_meshes(room, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_changed_region_meshes(room, (firma_world){0}, NULL, &meshes), FIRMA_ERROR_BAD_HANDLE, "no");
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(room));
}

void test_worlds(void) {
    test_bad_meshes();
    test_options();
    test_obj();
    test_room();
    test_triangles();
    test_textures();
    test_region_meshes();
}
