# SPDX-License-Identifier: MIT
# Casts and cuts are compiled for speed, the rest of the module for size.
take_part(firma_hot "cast/[a-z_]*|geometry/(closest_point|polygon_shape|texture|triangulate_convex)|world/(cast|near)_world" -O3)
# A crater takes two thirds of the time so, and the module 70 KB more.
take_part(firma_warm "geometry/exact_[a-z_]*|carve/[a-z_]*|solid/[a-z_]*|index/[a-z_]*" -O2)
