# SPDX-License-Identifier: MIT
# What runs in every frame is compiled for speed, the rest of the module for size.
file(GLOB FIRMA_HOT_SOURCES CONFIGURE_DEPENDS src/cast/*.cpp src/geometry/*.cpp src/world/cast_world.cpp src/world/near_world.cpp)
list(FILTER FIRMA_HOT_SOURCES EXCLUDE REGEX "/(check_polygon|clip_ears|polygons_cross|mesh_shells|around_edge|triangulate|exact_[a-z]*)\\.cpp$")
set_source_files_properties(${FIRMA_HOT_SOURCES} PROPERTIES COMPILE_OPTIONS -O3)
# The signs that every cut asks for; all else of carving, for which there is no room, is compiled for size too.
file(GLOB FIRMA_WARM_SOURCES CONFIGURE_DEPENDS src/geometry/exact_*.cpp)
list(FILTER FIRMA_WARM_SOURCES EXCLUDE REGEX "/exact_(plane|shift)\\.cpp$")  # made once a face; asked for where a sign is 0
set_source_files_properties(${FIRMA_WARM_SOURCES} PROPERTIES COMPILE_OPTIONS -Os)

# For all of it: linked as one program, which makes it smaller; a small sort instead of libc++'s; and instructions that
# every engine with SIMD has.
target_compile_options(firma PUBLIC $<BUILD_INTERFACE:-flto;-mbulk-memory;-mnontrapping-fptoint;-msign-ext>
                                    "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${PROJECT_SOURCE_DIR}/bindings/wasm/small_sort.h>>")
target_link_options(firma PUBLIC $<BUILD_INTERFACE:-flto>)
