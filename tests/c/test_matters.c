/* SPDX-License-Identifier: MIT */
/* Matter: the built-in table and a game's own, what worlds say of places and faces, craters cut short, chunks of two
 * matters. The numbers are those of docs/matter.md. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

#define SIDE(a, b, c, texture) "( " a " ) ( " b " ) ( " c " ) " texture " 0 0 0 1 1\n"

/* A brick wall on a floor of wood, both in rock. */
static const char kWall[] = "{\n\"classname\" \"worldspawn\"\n{\n" SIDE("0 0 0", "0 1 0", "0 0 1", "old_brick")
    SIDE("8 0 0", "8 0 1", "8 1 0", "old_brick") SIDE("0 0 0", "0 0 1", "1 0 0", "old_brick")
        SIDE("0 1 0", "1 1 0", "0 1 1", "old_brick") SIDE("0 0 0", "1 0 0", "0 1 0", "old_brick")
            SIDE("0 0 4", "0 1 4", "1 0 4", "old_brick") "}\n{\n" SIDE("0 -8 0", "0 1 0", "0 0 1", "planks")
                SIDE("8 -8 0", "8 0 1", "8 1 0", "planks") SIDE("0 -8 0", "0 -8 1", "1 -8 0", "planks")
                    SIDE("0 8 0", "1 8 0", "0 8 1", "planks") SIDE("0 -8 -2", "1 0 -2", "0 1 -2", "planks")
                        SIDE("0 0 0", "0 1 0", "1 0 0", "planks") "}\n}\n";

/* Boxes side by side along x, 4 m deep and high: brick from 0, wood from 4, steel from 8 to 12. */
#define BOX(low, high, texture)                                                                                  \
    "{\n" SIDE(low " 0 0", low " 1 0", low " 0 1", texture) SIDE(high " 0 0", high " 0 1", high " 1 0", texture) \
        SIDE(low " 0 0", low " 0 1", high " 0 0", texture) SIDE(low " 4 0", high " 4 0", low " 4 1", texture)    \
            SIDE(low " 0 0", high " 0 0", low " 1 0", texture)                                                   \
                SIDE(low " 0 4", low " 1 4", high " 0 4", texture) "}\n"
static const char kThree[] = "{\n\"classname\" \"worldspawn\"\n" BOX("0", "4", "old_brick") BOX("4", "8", "wood_panel")
    BOX("8", "12", "steel") "}\n";

static const char kTable[] =
    "matter vault brick\n  texture *brick*\n  hardness 1\nmatter oak\n  texture planks\n  inside oak/split\n";

static firma_world world_of(const char* map, const firma_matter_table* table) {
    firma_world_options options;
    firma_world_options_defaults(&options);
    options.scale = 1;
    options.matters = table;
    firma_world world = {0};
    CHECK_OK(firma_world_from_map(map, strlen(map), "wall.map", &options, &world));
    return world;
}

/* Square metres of the faces of a material that edits left. */
static double area_of(firma_world world, const char* material) {
    firma_faces faces = {0};
    firma_faces_view view = {.size = sizeof view};
    double area = 0;
    CHECK_OK(firma_world_faces(world, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    for (size_t k = 0; k < view.face_count; ++k) {
        const firma_face* face = &view.faces[k];
        const char* name = NULL;
        CHECK_OK(firma_world_material(world, face->material, &name));
        if (face->source_edit == 0 || strcmp(name, material) != 0) continue;
        const double* a = view.corners + 3 * (size_t)face->first_corner;
        double sum[3] = {0, 0, 0};
        for (uint32_t c = 2; c < face->corner_count; ++c) {
            const double *p = a + 3 * (size_t)(c - 1), *q = a + 3 * (size_t)c;
            for (int i = 0; i < 3; ++i) {
                const int u = (i + 1) % 3, v = (i + 2) % 3;
                sum[i] += (p[u] - a[u]) * (q[v] - a[v]) - (p[v] - a[v]) * (q[u] - a[u]);
            }
        }
        area += 0.5 * sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    }
    CHECK_OK(firma_faces_release(faces));
    return area;
}

static uint32_t number_of(const firma_matter_table* table, const char* name) {
    for (uint32_t k = 0; k < table->matter_count; ++k)
        if (strcmp(table->matters[k].name, name) == 0) return k;
    CHECK(!"there is such a matter");
    return 0;
}

static void test_tables(void) {
    firma_matters matters = {0};
    firma_matter_table table = {.size = sizeof table};
    CHECK_OK(firma_matters_default(&matters));
    CHECK_OK(firma_matters_get_view(matters, &table));
    CHECK(table.matter_count == 7 && table.pattern_count == 20 && table.matters[0].name[0] == '\0');
    const firma_matter* steel = &table.matters[number_of(&table, "steel")];
    CHECK(steel->density == 7850 && steel->strength == 400 && steel->fracture == FIRMA_FRACTURE_BENDS);
    CHECK(strcmp(steel->inside, "matter/steel") == 0 && steel->hardness == 0);
    CHECK(strcmp(table.patterns[2].pattern, "*brick*") == 0 && table.patterns[2].matter == 1);
    CHECK_OK(firma_matters_release(matters));
    CHECK_FAILS(firma_matters_get_view(matters, &table), FIRMA_ERROR_BAD_HANDLE, "table of matters");

    CHECK_OK(firma_matters_from_text(kTable, strlen(kTable), "game.matter", &matters));
    CHECK_OK(firma_matters_get_view(matters, &table));
    CHECK(table.matter_count == 3 && table.matters[1].hardness == 1 && table.matters[1].density == 2400);
    CHECK(strcmp(table.matters[2].inside, "oak/split") == 0 && table.patterns[1].matter == 2);
    table.size = 0;
    CHECK_FAILS(firma_matters_get_view(matters, &table), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_OK(firma_matters_release(matters));
    CHECK_FAILS(firma_matters_from_text("matter a\ndensity 0\n", 19, "t", &matters), FIRMA_ERROR_MALFORMED, "t:2:");
    CHECK_FAILS(firma_matters_from_text(NULL, 1, NULL, &matters), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_matters_load("no such file", &matters), FIRMA_ERROR_CANNOT_READ, "no such file");
}

/* Tables that make no world. */
static void test_bad_tables(void) {
    firma_matter matter = {.name = "jelly", .inside = NULL, .density = 1100};
    firma_matter_pattern pattern = {.pattern = "*jelly*", .matter = 1};
    firma_matter_table table = {.size = sizeof table, .matters = &matter, .matter_count = 1};
    firma_world_options options;
    firma_world_options_defaults(&options);
    options.matters = &table;
    firma_world world = {0};
#define REFUSED(code, word) \
    CHECK_FAILS(firma_world_from_map(kThree, strlen(kThree), "three", &options, &world), code, word)
    matter.density = -1;
    REFUSED(FIRMA_ERROR_INVALID, "density");
    matter.density = 1100;
    matter.fracture = 4;
    REFUSED(FIRMA_ERROR_INVALID, "fracture");
    matter.fracture = 0;
    matter.reserved = 1;
    REFUSED(FIRMA_ERROR_INVALID, "reserved");
    matter.reserved = 0;
    table.pattern_count = 1;
    REFUSED(FIRMA_ERROR_BAD_CALL, "array");
    table.patterns = &pattern;
    REFUSED(FIRMA_ERROR_INVALID, "pattern 0");
    table.matter_count = 0;
    REFUSED(FIRMA_ERROR_INVALID, "none");
    table.size = 4;
    REFUSED(FIRMA_ERROR_BAD_CALL, "size");
#undef REFUSED
}

static void test_places(firma_world wall) {
    firma_matters matters = {0};
    firma_matter_table table = {.size = sizeof table};
    firma_matter_counts counts = {.size = sizeof counts};
    uint64_t of_matter[8] = {0};
    uint32_t found = 77;
    const double inside[3] = {4, 0.5, 2}, below[3] = {4, 0.5, -1}, nowhere[3] = {NAN, 0, 0};
    CHECK_OK(firma_world_matters(wall, &matters));
    CHECK_OK(firma_matters_get_view(matters, &table));
    const uint32_t brick = number_of(&table, "brick"), wood = number_of(&table, "wood");
    CHECK_OK(firma_world_matter_at(wall, inside, &found));
    CHECK(found == brick && table.matters[found].density == 1900);
    CHECK_OK(firma_world_matter_at(wall, below, &found));
    CHECK(found == wood);
    CHECK_FAILS(firma_world_matter_at(wall, nowhere, &found), FIRMA_ERROR_OUT_OF_RANGE, "finite");
    CHECK_OK(firma_world_count_matters(wall, of_matter, 8, &counts));
    CHECK(counts.pieces == 2 && counts.protected_pieces == 0 && counts.matter_count == table.matter_count);
    CHECK(of_matter[brick] == 1 && of_matter[wood] == 1 && of_matter[0] == 0);
    CHECK_OK(firma_world_count_matters(wall, NULL, 0, &counts));
    CHECK_FAILS(firma_world_count_matters(wall, NULL, 1, &counts), FIRMA_ERROR_BAD_CALL, "null");

    const firma_cast_input shot = {{4, -4, 2}, 0, {0, 8, 0}};
    firma_hit hit;
    CHECK_OK(firma_cast(wall, &shot, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT);
    CHECK_OK(firma_world_matter_of(wall, hit.face, hit.corner, &found));
    CHECK(found == brick);
    CHECK_FAILS(firma_world_matter_of(wall, 1u << 30, hit.corner, &found), FIRMA_ERROR_INVALID, "no such face");
    CHECK_FAILS(firma_world_matter_of(wall, hit.face, NULL, &found), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_matters_release(matters));
}

/* At the foot of the wall: brick above, wood below; and where the brick may not be carved. */
static void test_craters(firma_world wall) {
    firma_cutter crater = {0};
    const firma_pose foot = {{4, 0, 0}, {0, 0, 0, 1}, 1.5}, middle = {{4, 0.5, 2}, {0, 0, 0, 1}, 0.3};
    firma_carve_report report = {.size = sizeof report};
    firma_world after = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, 3, &crater));
    CHECK_OK(firma_carve(wall, crater, &foot, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.cut_short == 0);
    CHECK(fabs(area_of(after, "matter/brick") - 5.5) < 0.05 && fabs(area_of(after, "matter/wood") - 14.9) < 0.05);
    CHECK_OK(firma_world_release(after));

    firma_matters matters = {0};
    firma_matter_table table = {.size = sizeof table};
    CHECK_OK(firma_matters_from_text(kTable, strlen(kTable), "game.matter", &matters));
    CHECK_OK(firma_matters_get_view(matters, &table));
    const firma_world vault = world_of(kWall, &table);
    CHECK_OK(firma_matters_release(matters)); /* the world has a copy */
    CHECK_OK(firma_carve(vault, crater, &foot, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.cut_short == 1);
    CHECK(fabs(area_of(after, "") - 2.9) < 0.05 && fabs(area_of(after, "oak/split") - 14.9) < 0.05);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_carve(vault, crater, &middle, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_REFUSED);
    CHECK(strstr(firma_error_message(), "matter vault brick may not be carved") != NULL);
    CHECK_OK(firma_world_release(after));
    report.size = offsetof(firma_carve_report, cut_short); /* an older program's */
    CHECK_OK(firma_carve(vault, crater, &foot, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(vault));
    CHECK_OK(firma_cutter_release(crater));
}

/* What is left of the wood, and the steel: their volumes, and a mass of both. */
static void test_chunk(void) {
    const firma_world three = world_of(kThree, NULL);
    const char* const held[] = {"old_brick"};
    const firma_anchors anchors = {.size = sizeof anchors, .no_hanging = 1, .materials = held, .material_count = 1};
    const firma_cutter blade = make_box(3, -1, -1, 5.25, 5, 5);
    const firma_pose here = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    firma_carve_options options = {.size = sizeof options, .chunks = 1};
    firma_carve_report report = {.size = sizeof report};
    firma_world world = {0}, after = {0};
    firma_chunk chunk = {.size = sizeof chunk};
    CHECK_OK(firma_world_with_anchors(three, &anchors, &world));
    const double wood = 2.75 * 16, steel = 4 * 16;
    for (int given = 0; given < 2; ++given) {
        options.density = given ? 1000 : 0;
        CHECK_OK(firma_carve(world, blade, &here, &options, &after, &report));
        CHECK(report.status == FIRMA_CARVE_DONE && report.chunks == 1);
        CHECK_OK(firma_chunks_get(report.loose, 0, &chunk));
        CHECK(chunk.matter_count == 2 && chunk.matters[0].matter == 3 && chunk.matters[1].matter == 4);
        CHECK(fabs(chunk.matters[0].volume - wood) < 1e-10 && fabs(chunk.matters[1].volume - steel) < 1e-10);
        const double mass = given ? 1000 * (wood + steel) : 600 * wood + 7850 * steel;
        const double x = given ? 8.625 : (600 * wood * 6.625 + 7850 * steel * 10) / mass;
        CHECK(fabs(chunk.mass.mass - mass) < 1e-12 * mass);
        CHECK(fabs(chunk.origin[0] + chunk.mass.centre[0] - x) < 1e-11);
        CHECK_OK(firma_chunks_release(report.loose));
        CHECK_OK(firma_world_release(after));
    }
    CHECK_OK(firma_cutter_release(blade));
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_world_release(three));
}

void test_matters(void) {
    test_tables();
    test_bad_tables();
    const firma_world wall = world_of(kWall, NULL);
    test_places(wall);
    test_craters(wall);
    CHECK_OK(firma_world_release(wall));
    test_chunk();
}
