# SPDX-License-Identifier: MIT
# Casts and cuts are compiled for speed, the rest of the module for size.
take_part(firma_hot "cast/[a-z_]*|geometry/(closest_point|polygon_shape|texture|triangulate_convex)|world/(cast|near)_world" -O3)
# Of the folders that follow, what no cut runs (checking, comparing and measuring solids, making cutters), and what few cuts
# spend time in: pieces that come loose and come to rest, matter, solids as cutters.
take_part(firma_cold "carve/(arrange_cut|clip_sheets|connected_pieces|cut_job|cut_solid|cutter_from_level|cutter_pairs|cutter_solid|cutter_topology|exact_ray|face_groups|find_loose|find_pockets|judge_rules|make_chunk|make_crater|make_cutter|matter_shares|mend_mesh|mesh_polygons|nearest_facet|overlay_operands|place_solid|point_within|pose_turn|resting_solid|side_of_solid|snap_solid|split_matter|trim_cutter|trim_polygons|wall_column|write_reproduction)|solid/(anchors|boundary|bounds_of|check_boundary|matter_pieces|measure_boundary|moment_sum|part_of_solid|plane_chain|same_boundary|shells)|index/statistics" -Oz)
# A crater takes two thirds of the time so, and the module 70 KB more.
take_part(firma_warm "geometry/exact_[a-z_]*|carve/[a-z_]*|solid/[a-z_]*|index/[a-z_]*" -O2)
