#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the soak tests: ./test --full [CLAIM...] | --list

Each claim is a count of seeded checks to be made on the sources as they are. It is worked off in chunks; every chunk leaves a line
in bench/results/full.txt with its seed, count, result and the commit it ran on. Lines count until a file the claim exercises changes;
so a run can be broken off and resumed, and lines gathered in several goes add up. A line of a chunk that failed makes its claim fail
until such a file changes: more chunks cannot outvote it.
"""
import datetime
import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sanitized_shares as shares

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RESULTS = os.path.join(ROOT, 'bench', 'results', 'full.txt')
BUILD = os.path.join('build', 'test', 'bin')
FUZZ = os.path.join('build', 'sanitize', 'bin')
THREAD = os.path.join('build', 'thread', 'bin')
CANNOT_RUN = 3  # a program's exit code: nothing was checked

# What casts and carving are made of. Of the public headers those of files, brushes, histories, what moves, games and other
# languages do not count: claims that exercise them list them.
APART = ('blast.h', 'bodies.h', 'body_index.h', 'break_parts.h', 'brush_level.h', 'brush_parts.h', 'brush_world.h', 'cast_set.h', 'convex_pieces.h', 'debris.h', 'firma.h', 'firma_c.h', 'fracture.h',
         'game.h', 'mesh.h', 'motion.h', 'moving_parts.h', 'part_edits.h', 'part_path.h', 'pierce.h', 'players.h', 'projectiles.h', 'read_gltf.h', 'recording.h', 'save.h', 'sphere_set.h',
         'support.h', 'triangles.h', 'turn.h', 'versions.h')
HEADERS = [f'include/firma/{name}' for name in sorted(os.listdir(os.path.join(ROOT, 'include', 'firma'))) if name not in APART]


def public(*names):
    return [f'include/firma/{name}.h' for name in names]


# What src/brush and src/join include of those apart.
OF_BRUSHES = public('brush_level', 'brush_parts', 'brush_world', 'motion', 'moving_parts', 'part_path', 'support', 'turn')
# From a level to a world: of src/level nothing else.
MAKE_WORLD = [f'src/level/{name}' for name in (
    'make_world.cpp', 'judge_level.h', 'judge_level.cpp', 'find_solids.h', 'find_solids.cpp', 'solid_pieces.h', 'solid_pieces.cpp',
    'slab_tree.h', 'slab_tree.cpp', 'pair_edges.h', 'pair_edges.cpp', 'turn_pieces.cpp')]
CAST_SOURCES = HEADERS + ['src/base', 'src/geometry', 'src/cast', 'src/index', 'src/solid', 'src/world',
                'CMakeLists.txt', 'CMakePresets.json'] + MAKE_WORLD
# Compiled for Windows alone, where no claim runs.
OF_WINDOWS = ':(exclude)*_windows.cpp'
# All of src/level but what divides rooms by portals, which readers of glTF alone do.
OF_PORTALS = ('divide_mesh.', 'make_divided_world.', 'portal_polygons.')
LEVEL = [f'src/level/{name}' for name in sorted(os.listdir(os.path.join(ROOT, 'src', 'level'))) if not name.startswith(OF_PORTALS)]
# All scenes but those of levels with rooms and of cuts in contact, which claims that make them list.
OF_FEW = ('blast', 'brush_piles.', 'contact_families.', 'divided_building.', 'level_cuts.')
SCENES = [f'scenes/{name}' for name in sorted(os.listdir(os.path.join(ROOT, 'scenes'))) if not name.startswith(OF_FEW)]
CARVE_SOURCES = CAST_SOURCES + SCENES + LEVEL + ['src/arrange', 'src/carve', 'levels/first.obj']


def reference(*names):
    return [f'tests/reference/{name}.{ending}' for name in names for ending in ('h', 'cpp')]


ORACLE = reference('exact_number', 'exact_polygon', 'exact_oracle', 'judge', 'judge_scene', 'surely_apart')
SHAPES = ['tests/full/full_shapes.cpp', 'tests/full/options.h'] + reference('exact_number', 'exact_polygon', 'exact_hull', 'judge_shapes', 'surely_apart')
JUDGE_CUT = reference('carve_oracle', 'cut_history', 'directed_edges', 'facet_corners', 'judge_contact', 'judge_cut', 'judge_rooms', 'protected_part', 'world_facets')
CARVED = ORACLE + JUDGE_CUT + reference('judge_carved_casts')
JUDGE_JOINED = reference('brush_oracle', 'carve_oracle', 'directed_edges', 'facet_corners', 'judge_joined', 'judge_rooms', 'world_facets')

READ_SOURCES = HEADERS + LEVEL + ['src/base', 'src/geometry/check_polygon.cpp', 'src/geometry/polygon_shape.h',
                'src/geometry/polygon_shape.cpp', 'CMakeLists.txt', 'CMakePresets.json']
BRUSH_SOURCES = READ_SOURCES + OF_BRUSHES + ['src/brush'] + [
    f'src/geometry/{name}' for name in ('exact_plane.h', 'exact_plane.cpp', 'exact_integer.h', 'exact_integer.cpp', 'grid_orient.h', 'rounding.h')]


def fuzzer(name, *headers):
    return [f'tests/fuzz/fuzz_{name}.cpp', 'tests/fuzz/CMakeLists.txt'] + [f'tests/fuzz/{header}.h' for header in headers]

JOIN_SOURCES = CARVE_SOURCES + OF_BRUSHES + ['scenes', 'src/join', 'src/brush',
                                             'tests/full/full_levels.cpp', 'tests/full/options.h', 'tests/openarena_maps.h']


LOG_SOURCES = CARVE_SOURCES + OF_BRUSHES + ['scenes', 'include/firma/save.h', 'src/join', 'src/brush', 'src/save', 'src/log', 'levels/depot.map',
                               'tests/openarena_maps.h', 'tests/full/full_logs.cpp', 'tests/full/options.h',
                               'tests/save/changed_patches.h', 'tests/save/saved_worlds.h', 'tests/world/two_halves.h'] + reference('judge_logs')


class Claim:
    """`target`: what of its preset it needs built; everything unless given. `sources_of`: by seed what a chunk exercises, if that
    is not all `sources`."""

    def __init__(self, name, what, need, chunk, unit, sources, preset, command, target=None, sources_of=None):
        self.name, self.what, self.need, self.chunk, self.unit = name, what, need, chunk, unit
        self.sources, self.preset, self.command, self.target = sources, preset, command, target
        self.sources_of = sources_of or (lambda seed: sources)


def casts(seed, count):
    return [f'{BUILD}/full_casts', '--count', str(count), '--seed', str(seed), '--threads', '2']


def casts_by(kernel):
    return lambda seed, count: casts(seed, count) + ['--kernel', kernel]


def casts_neon(seed, count):
    return ['tests/full/casts_neon.sh', '--count', str(count), '--seed', str(seed), '--threads', '2']


def shapes(what):
    return lambda seed, count: [f'{BUILD}/full_shapes', '--what', what, '--count', str(count), '--seed', str(seed), '--threads', '2']


def world_shapes(seed, count):
    return [f'{BUILD}/full_world_shapes', '--count', str(count), '--seed', str(seed)]


def together(seed, count):
    return [f'{BUILD}/full_together', '--count', str(count), '--seed', str(seed)]


def watertight(seed, count):
    return [f'{BUILD}/full_watertight', '--count', str(count), '--seed', str(seed), '--threads', '2']


def carve(seed, count):
    return [f'{BUILD}/full_carve', '--count', str(count), '--seed', str(seed), '--threads', '2']


def contact(seed, count):
    subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
    return [f'{BUILD}/full_contact', '--count', str(count), '--seed', str(seed), '--threads', '2', '--maps', 'build/openarena']


def blasts(seed, count):
    subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
    return [f'{BUILD}/full_blasts', '--count', str(count), '--seed', str(seed), '--threads', '2', '--maps', 'build/openarena']


def logs(what):
    def command(seed, count):
        subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
        return [f'{BUILD}/full_logs', '--what', what, '--count', str(count), '--seed', str(seed), '--threads', '2', '--maps', 'build/openarena']
    return command


def cube_grid(seed, count):
    return [f'{BUILD}/full_cube_grid', '--count', str(count), '--seed', str(seed), '--threads', '2']


def long_cuts(what):
    return lambda seed, count: [f'{BUILD}/full_long_cuts', '--what', what, '--count', str(count), '--seed', str(seed), '--threads', '2']


def digs(what):
    return lambda seed, count: [f'{BUILD}/full_digs', '--what', what, '--count', str(count), '--seed', str(seed), '--threads', '2']


def chunks(seed, count):
    return [f'{BUILD}/full_chunks', '--count', str(count), '--seed', str(seed), '--threads', '2']


def index(seed, count):
    return [f'{BUILD}/full_index', '--count', str(count), '--seed', str(seed)]


def bodies(seed, count):
    subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
    return [f'{BUILD}/full_bodies', '--count', str(count), '--seed', str(seed), '--maps', 'build/openarena']


def players(seed, count):
    subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
    return [f'{BUILD}/full_players', '--count', str(count), '--seed', str(seed), '--maps', 'build/openarena']


def life(seed, count):
    return [f'{BUILD}/full_life', '--count', str(count), '--seed', str(seed)]


def carved(what):
    return lambda seed, count: [f'{BUILD}/full_carved_casts', '--what', what, '--count', str(count), '--seed', str(seed),
                                '--cuts', '1000', '--threads', '2']


def fuzz(reader):
    def command(seed, count):
        scratch = os.path.join('build', 'sanitize', f'corpus_{reader}')
        os.makedirs(os.path.join(ROOT, scratch), exist_ok=True)
        seeds = os.path.join('tests', 'fuzz', 'seeds', reader.removeprefix('read_').removeprefix('load_'))
        return [f'{FUZZ}/fuzz_{reader}', f'-seed={seed}', f'-max_total_time={count}', '-rss_limit_mb=2048', '-timeout=20',
                f'-artifact_prefix=build/sanitize/{reader}_', scratch] + [seeds] * os.path.isdir(os.path.join(ROOT, seeds))
    return command


def same_cuts(seed, count):
    return ['tools/same_bits.sh', '1000']


def same_everywhere(seed, count):
    return ['tools/same_everywhere.sh', '1000', '100000']


def same_games(seed, count):
    return ['tools/same_games.sh']


def levels(what):
    def command(seed, count):
        subprocess.run([os.path.join('tools', 'unpack_openarena.sh')], cwd=ROOT, check=True)
        return [f'{BUILD}/full_levels', '--what', what, '--count', str(count), '--seed', str(seed), '--threads', '2', '--maps', 'build/openarena']
    return command


def sanitized(seed, count):
    return ['tests/full/sanitized.sh', str(shares.HEAVY_PROGRAMS), str(seed), str(shares.HEAVY_SHARE)]


def sanitized_saves(seed, count):
    mine = shares.tests_that_reach_saves()[(seed - 1)::shares.SAVES_SHARES]
    return ['tools/sanitized_saves.sh', str(len(mine)), ':'.join(mine)]


def store(seed, count):
    return [f'{THREAD}/full_store', '--count', str(count), '--seed', str(seed)]


CLAIMS = [
    Claim('casts_vs_twin', 'casts judged by the exact oracle, no miss, false hit or penetration', 1_000_000, 50_000, 'casts',
          CAST_SOURCES + SCENES + ['tests/full/full_casts.cpp', 'tests/full/options.h'] + ORACLE, 'test', casts, 'full_casts'),
    Claim('casts_avx2', 'the same by lanes of AVX2', 1_000_000, 50_000, 'casts',
          CAST_SOURCES + SCENES + ['tests/full/full_casts.cpp', 'tests/full/options.h'] + ORACLE, 'test', casts_by('AVX2'), 'full_casts'),
    Claim('casts_sse4', 'the same by lanes of SSE4', 1_000_000, 50_000, 'casts',
          CAST_SOURCES + SCENES + ['tests/full/full_casts.cpp', 'tests/full/options.h'] + ORACLE, 'test', casts_by('SSE4'), 'full_casts'),
    Claim('casts_neon', 'the same by lanes of NEON, in a program for 64-bit ARM that qemu runs', 1_000_000, 50_000, 'casts',
          CAST_SOURCES + SCENES + ['tests/full/full_casts.cpp', 'tests/full/casts_neon.sh', 'tests/full/options.h', 'cmake/aarch64.cmake'] + ORACLE, 'test',
          casts_neon, 'full_casts'),
    Claim('casts_one_by_one', 'the same without lanes', 1_000_000, 50_000, 'casts',
          CAST_SOURCES + SCENES + ['tests/full/full_casts.cpp', 'tests/full/options.h'] + ORACLE, 'test', casts_by('none'), 'full_casts'),
    Claim('capsules_vs_twin', 'capsules against polygons, judged by the exact oracle, none wrong', 1_000_000, 100_000, 'casts',
          CAST_SOURCES + SCENES + SHAPES + reference('exact_capsule') + ['tests/reference/judge_capsules.cpp'], 'test', shapes('capsules'), 'full_shapes'),
    Claim('hulls_vs_twin', 'boxes and convex hulls against polygons, judged by the exact oracle, none wrong', 1_000_000, 100_000, 'casts',
          CAST_SOURCES + SCENES + SHAPES + ['tests/reference/judge_hulls.cpp'], 'test', shapes('hulls'), 'full_shapes'),
    Claim('shapes_by_kernel', 'casts of capsules, boxes and hulls through worlds by each kernel of the lanes, as without lanes', 1_000_000, 100_000, 'casts',
          CAST_SOURCES + SCENES + LEVEL + ['levels/first.obj', 'tests/full/full_world_shapes.cpp', 'tests/full/options.h', 'tests/every_kernel.h', 'tests/world/any_shape.h',
                                   'tests/world/hit_bits.h'], 'test', world_shapes, 'full_world_shapes'),
    Claim('casts_together', 'casts of all shapes made together, 1 to 8 at a time, by each kernel of the lanes, as made singly', 1_000_000, 100_000, 'casts',
          CAST_SOURCES + SCENES + LEVEL + OF_BRUSHES + ['levels/first.obj', 'levels/depot.map', 'src/brush', 'src/join', 'tests/full/full_together.cpp', 'tests/full/options.h',
                                   'tests/every_kernel.h', 'tests/world/any_shape.h', 'tests/world/hit_bits.h'], 'test', together, 'full_together'),
    Claim('watertight', 'rays and small spheres from inside closed meshes, none lost', 10_000_000, 1_000_000, 'rays',
          CAST_SOURCES + SCENES + ['tests/full/full_watertight.cpp', 'tests/full/options.h'] + ORACLE + reference('escapes'), 'test', watertight, 'full_watertight'),
    Claim('carve_cuts', 'cuts of every family, each judged by all that must hold after an edit', 20_000, 2_000, 'cuts',
          CARVE_SOURCES + ['tests/full/full_carve.cpp', 'tests/full/family_run.h', 'tests/full/options.h'] + JUDGE_CUT, 'test', carve, 'full_carve'),
    Claim('contact_cuts', 'cuts in forced contact, none refused, each judged by all that must hold after an edit', 20_000, 2_000, 'cuts',
          CARVE_SOURCES + OF_BRUSHES + ['scenes', 'src/join', 'src/brush', 'levels/depot.map', 'tests/openarena_maps.h', 'tests/full/full_contact.cpp', 'tests/brush/unprotected_world.h',
                           'tests/full/family_run.h', 'tests/full/options.h'] + JUDGE_CUT, 'test', contact, 'full_contact'),
    # All in one chunk: three edges, ordered and in three random orders.
    Claim('cube_grid', 'grids of 10 x 10 x 10 cubes filled one by one and carved again: nothing is left, none refused', 12, 12, 'grids',
          CARVE_SOURCES + ['tests/full/full_cube_grid.cpp', 'tests/full/options.h'] + reference('judge_cube_grid') + JUDGE_CUT, 'test', cube_grid,
          'full_cube_grid'),
    Claim('depot_craters', 'random craters in the depot, one after the other, none refused, volumes equal to 1e-12', 10_000, 10_000, 'craters',
          CARVE_SOURCES + OF_BRUSHES + ['scenes', 'src/join', 'src/brush', 'levels/depot.map', 'tests/full/full_long_cuts.cpp', 'tests/brush/unprotected_world.h', 'tests/full/options.h'],
          'test', long_cuts('craters'), 'full_long_cuts'),
    # All in one chunk: three tools at fourteen scales, 120 cuts each.
    Claim('sweeps', 'rows of overlapping tools along a path at scales of 1 to 8192 m, none refused, volumes equal to 1e-12', 42, 42, 'rows',
          CARVE_SOURCES + ['tests/full/full_long_cuts.cpp', 'tests/brush/unprotected_world.h', 'tests/full/options.h'], 'test', long_cuts('sweeps'), 'full_long_cuts'),
    Claim('lattice_digs', 'blocks of 16 cells a side dug out and filled in by boxes: each edit beside a list of the cells, nothing left at the end', 2_000, 500, 'digs',
          CARVE_SOURCES + ['tests/full/full_digs.cpp', 'tests/full/options.h'] + reference('judge_digs', 'judge_cut'), 'test', digs('lattice'), 'full_digs'),
    Claim('mixed_digs', 'large blocks cut and filled 80 times by blocks, wedges, gears and craters: none refused, boundary and volume after each, the same again nothing',
          1_000, 250, 'digs', CARVE_SOURCES + ['tests/full/full_digs.cpp', 'tests/full/options.h'] + reference('judge_digs', 'judge_cut'), 'test', digs('mixed'), 'full_digs'),
    Claim('chunks', 'halls of pillars and bridges shot at 100 times each: the loose pieces that each cut finds are those of a flood of all faces', 200, 50, 'halls',
          CARVE_SOURCES + ['tests/full/full_chunks.cpp', 'tests/full/options.h'] + reference('judge_chunks'), 'test', chunks, 'full_chunks'),
    Claim('index_is_free', 'cuts under different trees, each followed by equal hashes, ids and bytes', 1_000, 1_000, 'cuts',
          CARVE_SOURCES + ['src/save', 'tests/full/full_index.cpp', 'tests/full/options.h'] + JUDGE_CUT + reference('judge_index'), 'test', index,
          'full_index'),
    Claim('long_life', 'cuts and fills in three worlds by each Split, after which casts test no more boxes and take no longer than 1.15 times those in an index built anew',
          120_000, 120_000, 'edits', CARVE_SOURCES + OF_BRUSHES + ['src/join', 'src/brush', 'levels/depot.map', 'tests/full/full_life.cpp', 'tests/full/options.h'],
          'test', life, 'full_life'),
    Claim('carved_casts', 'casts through our level after 1,000 cuts, judged by the exact oracle', 1_000_000, 100_000, 'casts',
          CARVE_SOURCES + ['tests/full/full_carved_casts.cpp', 'tests/full/options.h'] + CARVED, 'test', carved('casts'), 'full_carved_casts'),
    Claim('carved_rays', 'rays from the air of our level after 1,000 cuts, none escapes', 10_000_000, 2_000_000, 'rays',
          CARVE_SOURCES + ['tests/full/full_carved_casts.cpp', 'tests/full/options.h'] + CARVED, 'test', carved('rays'), 'full_carved_casts'),
    # Seeds go through three levels, at 30 and at 60 steps a second, cut before or meanwhile.
    Claim('never_through', 'bodies thrown through the depot and two maps of OpenArena for a minute, judged in each frame: none in a wall, none lost', 12_000, 1_000, 'bodies',
          CARVE_SOURCES + OF_BRUSHES + public('bodies', 'cast_set', 'part_edits', 'pierce', 'projectiles', 'sphere_set')
          + ['scenes', 'src/join', 'src/brush', 'src/moving', 'src/body', 'levels/depot.map', 'tests/full/full_bodies.cpp', 'tests/full/options.h'] + reference('judge_bodies', 'rooms_outside'),
          'test', bodies, 'full_bodies'),
    # Seeds go through three levels and three shapes, at 30 and at 60 frames a second.
    Claim('player_walks', 'frames of players with random wishes in the depot and two maps of OpenArena, blasted, filled, undone and shut around them: never in solid, out of the level, held, or too fast',
          1_080_000, 60_000, 'frames',
          CARVE_SOURCES + OF_BRUSHES + public('cast_set', 'part_edits', 'players', 'sphere_set')
          + ['scenes', 'src/join', 'src/brush', 'src/moving', 'src/player', 'src/body/cast_set.cpp', 'src/body/cast_spheres.h', 'src/body/sphere_set_sweep.h', 'levels/depot.map', 'tests/brush/map_text.h', 'tests/full/full_players.cpp', 'tests/full/options.h',
             'tests/player/player_shapes.h'] + reference('changing_level', 'grown_player', 'judge_players', 'parts_near', 'player_overlap', 'rooms_outside'),
          'test', players, 'full_players'),
    Claim('same_cuts', 'compilers and options that make the same world of 1,000 cuts, to the bit', 6, 6, 'configurations',
          CARVE_SOURCES + ['tests/full/same_cuts.cpp', 'tools/same_bits.sh'], 'test', same_cuts, 'firma'),
    Claim('same_everywhere', 'ways to build and run that make the same of 1,000 cuts and 100,000 casts, of a log, and of 600 steps of bodies, players and projectiles, to the bit',
          7, 7, 'ways', ['include', *(f':(exclude)include/firma/{header}.h' for header in ('break_parts', 'brush_parts', 'convex_pieces', 'game', 'part_path', 'recording', 'support')), 'src', ':(exclude)src/convex', ':(exclude)src/fracture', ':(exclude)src/game', 'bindings/c', 'bindings/wasm', 'bindings/js/src', 'cmake', 'levels/first.obj', 'CMakeLists.txt', 'CMakePresets.json',
              'tools/same_everywhere.sh']
          + [f'tests/full/same_{ending}' for ending in ('everywhere.c', 'everywhere.mjs', 'everywhere_browser.mjs', 'games.c', 'games.mjs')] + ['tests/full/in_chromium.mjs'], 'test', same_everywhere, 'firma_c'),
    Claim('same_games', 'ways to build and run in which a recorded fight in the depot replays to the same hashes', 8, 8, 'ways',
          ['include', 'src', 'bindings/c', 'bindings/wasm', 'bindings/js/src', 'cmake', 'levels/depot.map', 'CMakeLists.txt', 'CMakePresets.json', 'tests/game/depot_fight.h', 'tools/same_games.sh',
           'tests/full/same_games.cpp', 'tests/full/in_chromium.mjs', 'tests/full/replay_recording.mjs', 'tests/full/replay_recording_browser.mjs'], 'test', same_games, 'firma'),
    Claim('store_threads', 'cuts published beside two readers under the thread sanitizer, no race, every answer its version\'s', 1_000,
          1_000, 'cuts', CARVE_SOURCES + ['include/firma/versions.h', 'src/store', 'tests/store/cratered.h', 'tests/threads/store_race.h',
                                          'tests/full/full_store.cpp'], 'thread', store, 'full_store'),
    Claim('join_piles', 'random piles of brushes joined: closed, of the right volume, points and ways in the right rooms', 2_000, 500, 'piles',
          JOIN_SOURCES + JUDGE_JOINED, 'test', levels('piles'), 'full_levels'),
    Claim('join_maps', 'the depot and all maps of OpenArena joined: closed, of the right volume, points and ways in the right rooms', 51, 51, 'maps',
          JOIN_SOURCES + JUDGE_JOINED + ['levels/depot.map'], 'test', levels('maps'), 'full_levels'),
    Claim('room_casts', 'casts by room that equal casts of all faces, a million on each of ten levels', 10_000_000, 1_000_000, 'casts',
          JOIN_SOURCES + ['levels/depot.map'] + reference('judge_rooms'), 'test', levels('casts'), 'full_levels'),
    Claim('room_rays', 'rays from closed rooms of ten levels, none escapes', 10_000_000, 1_000_000, 'rays',
          JOIN_SOURCES + ['levels/depot.map'] + reference('judge_rooms'), 'test', levels('rays'), 'full_levels'),
    # A chunk is all kinds of cuts in all six levels.
    Claim('level_cuts', 'cuts of every kind in the depot and five maps of OpenArena, each judged by all that must hold after an edit', 3_456,
          1_152, 'cuts', JOIN_SOURCES + ['levels/depot.map'] + JUDGE_CUT, 'test', levels('cuts'), 'full_levels'),
    Claim('blasts', 'blasts in the depot, maps of OpenArena and buildings on grids, a third of the doors closed, each judged by all that must hold of rooms', 10_000,
          2_000, 'blasts', CARVE_SOURCES + OF_BRUSHES + ['scenes', 'src/join', 'src/brush', 'levels/depot.map',
                                                         'tests/openarena_maps.h', 'tests/full/full_blasts.cpp', 'tests/full/family_run.h', 'tests/full/options.h']
          + JUDGE_CUT + reference('judge_blast', 'judge_chunks'), 'test', blasts, 'full_blasts'),
    Claim('region_repair', 'commands in the depot, a map and buildings, a hundredth of them lost by one peer, which regions repair: the same world, solid and hashes, and edits go on alike',
          10_000, 2_000, 'commands', LOG_SOURCES, 'test', logs('repair'), 'full_logs'),
    Claim('log_replay', 'commands in the depot, a map and buildings, replayed from bytes in four slices by one, two and four threads, and compacted: one world', 10_000,
          2_000, 'commands', LOG_SOURCES, 'test', logs('replay'), 'full_logs'),
    Claim('disjoint_edits', 'edits apart from each other in the depot, a map and buildings, in four orders: one solid', 10_000, 2_000, 'commands', LOG_SOURCES,
          'test', logs('disjoint'), 'full_logs'),
    Claim('log_sequences', 'commands of every kind in the depot, a map and buildings, check_world() and check_solid() after each', 100_000, 2_000, 'commands',
          LOG_SOURCES, 'test', logs('sequences'), 'full_logs'),
    # A share of the programs each chunk: the seed says which.
    Claim('sanitized', 'test programs under the address and undefined behaviour sanitizers: tests of a second or more, those with Boost, of glTF, of pictures, of the command line, of threads; none fails',
          shares.HEAVY_PROGRAMS, shares.HEAVY_SHARE, 'programs',
          shares.SANITIZED_SOURCES, 'sanitize', sanitized, 'heavy_tests', shares.sanitized_sources),
    Claim('sanitized_saves', 'shares of those of these tests that save worlds, keep logs of edits or play games, by themselves; none fails',
          shares.SAVES_SHARES, 1, 'shares', shares.SANITIZED_SOURCES + [':(exclude)cli', ':(exclude)tests/cli'], 'sanitize', sanitized_saves, 'firma_tests'),
    Claim('fuzz_carve', 'seconds of fuzzing cutters and poses, no crash, hang or broken world', 1_800, 300, 'seconds',
          CAST_SOURCES + LEVEL + ['src/arrange', 'src/carve'] + fuzzer('carve', 'bytes'), 'sanitize', fuzz('carve'), 'fuzz_carve'),
    Claim('fuzz_read_obj', 'seconds of fuzzing the .obj reader and check, no crash, hang or broken level', 600, 300, 'seconds',
          READ_SOURCES + fuzzer('read_obj', 'expect_sound_obj', 'expect_sound_level'), 'sanitize', fuzz('read_obj'), 'fuzz_read_obj'),
    Claim('fuzz_obj_mesh', 'seconds of fuzzing .obj meshes made of any bytes, no crash, hang or broken level', 600, 300, 'seconds',
          READ_SOURCES + fuzzer('obj_mesh', 'bytes', 'expect_sound_obj', 'expect_sound_level'), 'sanitize', fuzz('obj_mesh'), 'fuzz_obj_mesh'),
    Claim('fuzz_read_bsp', 'seconds of fuzzing the .bsp reader and check, no crash, hang or broken level', 600, 300, 'seconds',
          READ_SOURCES + fuzzer('read_bsp', 'expect_sound_level'), 'sanitize', fuzz('read_bsp'), 'fuzz_read_bsp'),
    Claim('fuzz_read_map', 'seconds of fuzzing the .map reader, no crash, hang or broken level of brushes', 600, 300, 'seconds',
          BRUSH_SOURCES + fuzzer('read_map', 'expect_sound_brushes', 'expect_sound_level'), 'sanitize', fuzz('read_map'), 'fuzz_read_map'),
    Claim('fuzz_bsp_brushes', 'seconds of fuzzing the reader of .bsp brushes, no crash, hang or broken level of brushes', 600, 300, 'seconds',
          BRUSH_SOURCES + fuzzer('read_bsp_brushes', 'expect_sound_brushes', 'expect_sound_level'), 'sanitize', fuzz('read_bsp_brushes'),
          'fuzz_read_bsp_brushes'),
    Claim('fuzz_read_gltf', 'seconds of fuzzing the glTF reader and its rooms, no crash, hang or broken world', 600, 300, 'seconds',
          READ_SOURCES + ['include/firma/read_gltf.h', 'include/firma/rooms.h', 'gltf']
          + ['src/level', 'src/geometry', 'src/cast', 'src/index', 'src/solid', 'src/join', 'src/world']
          + fuzzer('read_gltf', 'expect_sound_level', 'gltf_bytes', 'bytes'), 'sanitize', fuzz('read_gltf'), 'fuzz_read_gltf'),
    Claim('fuzz_load_firma', 'seconds of fuzzing .firma files, then casts and an edit, no crash, hang or broken world', 600, 300,
          'seconds', CARVE_SOURCES + ['include/firma/save.h', 'src/save', 'tests/save/saved_worlds.h', 'tests/world/two_halves.h'] + fuzzer('load_firma', 'bytes'), 'sanitize', fuzz('load_firma'), 'fuzz_load_firma'),
    Claim('fuzz_read_log', 'seconds of fuzzing edit logs and commands, then replays, no crash, hang or broken world', 600, 300, 'seconds',
          CARVE_SOURCES + ['include/firma/edit_log.h', 'src/save', 'src/log', 'tests/save/saved_worlds.h', 'tests/world/two_halves.h'] + fuzzer('read_log', 'bytes'),
          'sanitize', fuzz('read_log'), 'fuzz_read_log'),
    Claim('fuzz_read_patch', 'seconds of fuzzing patches and lists of faces, then an edit, no crash, hang or broken world', 600, 300, 'seconds',
          CARVE_SOURCES + ['include/firma/edit_log.h', 'include/firma/world_patch.h', 'src/save', 'src/log', 'tests/save/saved_worlds.h', 'tests/world/two_halves.h']
          + fuzzer('read_patch', 'bytes'), 'sanitize', fuzz('read_patch'), 'fuzz_read_patch'),
]


def git(*arguments):
    return subprocess.run(['git', '-C', ROOT, *arguments], capture_output=True, text=True)


def head():
    return git('rev-parse', 'HEAD').stdout.strip()


def same_sources(commit, sources):
    """Whether none of these differs between that commit and the files as they are."""
    return git('diff', '--quiet', commit, '--', *sources, OF_WINDOWS).returncode == 0


def fields(line):
    return dict(part.split('=', 1) for part in line.split() if '=' in part)


def lines_of(claim):
    """All lines of the sources as they are, of chunks that passed and of chunks that failed."""
    if not os.path.exists(RESULTS):
        return []
    known = {}
    found = []
    with open(RESULTS, encoding='utf-8') as file:
        for line in file:
            entry = fields(line)
            if entry.get('claim') != claim.name:
                continue
            sources = claim.sources_of(int(entry['seed']))
            key = (entry['commit'], *sources)
            if key not in known:
                known[key] = same_sources(entry['commit'], sources)
            if known[key]:
                found.append(entry)
    return found


def done(claim):
    return sum(int(entry['count']) for entry in lines_of(claim) if entry.get('result') == 'pass')


def failures(claim):
    return [entry for entry in lines_of(claim) if entry.get('result') != 'pass']


def next_seed(claim):
    """The lowest that no line has: of a claim that goes by shares, one may have lapsed by itself."""
    used = {int(entry['seed']) for entry in lines_of(claim)}
    return next(seed for seed in range(1, len(used) + 2) if seed not in used)


def leave(line):
    os.makedirs(os.path.dirname(RESULTS), exist_ok=True)
    with open(RESULTS, 'a', encoding='utf-8') as file:
        file.write(line + '\n')
        file.flush()
        os.fsync(file.fileno())
    print(line, flush=True)


def totals(output):
    """What the chunk's program said of all families together, as fields; empty when it says nothing of the kind."""
    for line in output.splitlines():
        entry = fields(line)
        if 'claim' in entry and 'total' in (entry.get('family'), entry.get('mesh')):
            return entry
    return {}


def changed(claim):
    """Whether a file the claim exercises is not as committed."""
    return bool(git('status', '--porcelain', '--', *claim.sources, OF_WINDOWS).stdout.strip())


def run_chunk(claim, commit):
    """Runs one chunk of what was built at `commit` and leaves its line; False when it failed."""
    seed = next_seed(claim)
    count = min(claim.chunk, claim.need - done(claim))
    start = time.time()
    process = subprocess.run(claim.command(seed, count), cwd=ROOT, capture_output=True, text=True)
    if changed(claim) or not same_sources(commit, claim.sources):
        print(f'{claim.name}: sources changed meanwhile; this chunk does not count', file=sys.stderr)
        return False
    if process.returncode in (-signal.SIGHUP, -signal.SIGINT, -signal.SIGTERM):
        print(f'{claim.name}: broken off; this chunk leaves no line', file=sys.stderr)
        return False
    if process.returncode == CANNOT_RUN:
        print(f'{claim.name}: {process.stderr.strip()}; this chunk leaves no line', file=sys.stderr)
        return False
    result = 'pass' if process.returncode == 0 else 'fail'
    said = totals(process.stdout)
    line = {'claim': claim.name, 'count': said.get('count', count), 'unit': claim.unit, 'seed': seed}
    line.update((key, value) for key, value in said.items() if key not in line and key not in ('family', 'mesh', 'result'))
    line.update({'result': result, 'seconds': round(time.time() - start), 'commit': commit, 'date': datetime.date.today().isoformat()})
    leave(' '.join(f'{key}={value}' for key, value in line.items()))
    if result == 'fail':
        print((process.stdout + process.stderr)[-4000:], file=sys.stderr)
    return result == 'pass'


def build(preset, target=None):
    only = ['--target', target] if target else []
    for command in (['cmake', '--preset', preset], ['cmake', '--build', '--preset', preset] + only):
        process = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
        if process.returncode:
            sys.exit((process.stdout + process.stderr)[-4000:])


def work_off(claim):
    if changed(claim):
        print(f'{claim.name}: commit your changes first; a line must name the commit it ran on', file=sys.stderr)
        return
    commit = head()
    build(claim.preset, claim.target)
    while done(claim) < claim.need and not failures(claim) and run_chunk(claim, commit):
        pass


def summary(claim):
    """Prints how a claim stands. Returns whether it holds."""
    have, failed = done(claim), failures(claim)
    state = 'FAILS' if failed else 'holds' if have >= claim.need else 'open'
    print(f'{claim.name:18} {have:>10,} of {claim.need:,} {claim.unit}: {state}   ({claim.what})')
    for entry in failed:
        print(f'{"":18} failed: seed={entry.get("seed")} count={entry.get("count")} commit={entry["commit"]}')
    return state == 'holds'


def main():
    names = [argument for argument in sys.argv[1:] if not argument.startswith('-')]
    options = [argument for argument in sys.argv[1:] if argument.startswith('-')]
    unknown = [name for name in names if name not in [claim.name for claim in CLAIMS]]
    if unknown or any(option != '--list' for option in options):
        print(__doc__, 'claims: ' + ', '.join(claim.name for claim in CLAIMS), sep='\n', file=sys.stderr)
        return 2
    chosen = [claim for claim in CLAIMS if not names or claim.name in names]
    if options:
        return 0 if all([summary(claim) for claim in chosen]) else 1
    for claim in chosen:
        if done(claim) < claim.need and not failures(claim):
            work_off(claim)
    return 0 if all([summary(claim) for claim in chosen]) else 1


if __name__ == '__main__':
    sys.exit(main())
