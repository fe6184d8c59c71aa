# SPDX-License-Identifier: MIT
# Casts and cuts are compiled for speed, the rest of the module for size.
take_part(firma_hot "cast/[a-z_]*|geometry/(closest_point|polygon_shape|texture|triangulate_convex)|world/(cast|near)_world" -O3)
# Of the folders that follow, what no cut runs: checking, comparing and measuring solids, making cutters. 6 KB of the module
# of worlds.
take_part(firma_cold "carve/(cutter_from_level|cutter_topology|judge_rules|make_crater|make_cutter|write_reproduction)|solid/(boundary|bounds_of|check_boundary|measure_boundary|plane_chain|same_boundary)|index/statistics" -Oz)
# A crater takes two thirds of the time so, and the module 70 KB more.
take_part(firma_warm "geometry/exact_[a-z_]*|carve/[a-z_]*|solid/[a-z_]*|index/[a-z_]*" -O2)
