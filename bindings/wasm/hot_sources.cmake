# SPDX-License-Identifier: MIT
# Casts and cuts are compiled for speed, the rest of the module for size.
file(GLOB FIRMA_HOT_SOURCES CONFIGURE_DEPENDS src/cast/*.cpp src/geometry/*.cpp src/world/cast_world.cpp src/world/near_world.cpp)
list(FILTER FIRMA_HOT_SOURCES EXCLUDE REGEX "/(check_polygon|clip_ears|polygons_cross|mesh_shells|around_edge|triangulate|exact_[a-z]*)\\.cpp$")
set_source_files_properties(${FIRMA_HOT_SOURCES} PROPERTIES COMPILE_OPTIONS -O3)
# A crater takes two thirds of the time so, and the module 70 KB more.
file(GLOB FIRMA_WARM_SOURCES CONFIGURE_DEPENDS src/geometry/exact_*.cpp src/carve/*.cpp src/solid/*.cpp src/index/*.cpp)
set_source_files_properties(${FIRMA_WARM_SOURCES} PROPERTIES COMPILE_OPTIONS -O2)

# For all of it: linked as one program, which makes it smaller; a small sort instead of libc++'s; and instructions that
# every engine with SIMD has.
target_compile_options(firma PUBLIC $<BUILD_INTERFACE:-flto;-mbulk-memory;-mnontrapping-fptoint;-msign-ext>
                                    "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${PROJECT_SOURCE_DIR}/bindings/wasm/small_sort.h>>")
target_link_options(firma PUBLIC $<BUILD_INTERFACE:-flto>)
