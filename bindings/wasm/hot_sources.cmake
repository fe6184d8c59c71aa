# SPDX-License-Identifier: MIT
# Casts and cuts are compiled for speed, the rest of the module for size.
# Capsules and hulls are not: for speed they were 20 KB more.
take_part(firma_other_shapes "cast/(capsule[a-z_]*|cast_capsule_polygon|cast_hull_polygon|hull[a-z_]*|make_hull_hit)" -Oz)
take_part(firma_hot "cast/[a-z_]*|geometry/(closest_point|polygon_shape|texture|triangulate_convex)|world/(cast_world|lane_sweep|sweep_lanes)" -O3)
# Of the folders that follow, what no cut runs (checking, comparing and measuring solids, making cutters), and what few cuts
# spend time in: pieces that come loose and come to rest, matter, solids as cutters, and what a profile of craters in rooms
# shows with less than 0.25% of the time.
take_part(firma_cold "carve/(arrange_cut|change_points|check_crossing|check_shells|clip_sheets|column_prism|connected_pieces|cut_job|cut_opening|cut_solid|cut_volume|cutter_from_level|cutter_limits|cutter_pairs|cutter_solid|cutter_topology|edge_parts|exact_ray|face_groups|find_loose|find_pockets|gather|group_loops|held_behind|judge_rules|label|make_chunk|make_crater|make_cutter|matter_shares|mend_mesh|mesh_polygons|nearest_facet|order_cuts|overlay_operands|place_cutter|place_solid|point_within|polygon_reaches|pose_turn|reaches_into|resting_solid|sheet_labels|sheet_overlay|side_of_cutter|side_of_solid|snap_solid|split_matter|tile_faces|touch_polygon|trim_cutter|trim_polygons|wall_hole|wall_section|write_reproduction)|solid/(anchors|boundary|bounds_of|change_solid|check_boundary|check_loops|edge_key|edit_blocks|face_store|find_neighbour|first_seen|hash_points|lay_out_faces|make_facets|matter_pieces|measure_boundary|merge_facets|moment_sum|near_facets|own_face|part_of_solid|plane_chain|same_boundary|shells|solid|solid_face)|index/(box_tree|join_nodes|rounded_box|statistics|unshared_nodes|wide_node|widen_bins)|geometry/exact_shift" -Oz)
# What a step of bodies spends its time in. Players are not: for speed they took no less, as it goes into their casts.
set(FIRMA_MOVED "body/(cast_set|contact_solver|mover|pair_contacts|path_crossings|sweep_bodies|world_contacts)")
# A crater takes two thirds of the time so, and the module 70 KB more.
take_part(firma_warm "geometry/exact_[a-z_]*|carve/[a-z_]*|solid/[a-z_]*|index/[a-z_]*|${FIRMA_MOVED}" -O2)
