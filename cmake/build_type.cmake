# SPDX-License-Identifier: MIT
# Optimises where nobody said how to build: the project itself as Release; within a project that sets no build type,
# this library alone (FIRMA_FLAGS_OF_NO_TYPE).
get_property(firma_many_types GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(PROJECT_IS_TOP_LEVEL AND NOT firma_many_types AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "How to build: Release, RelWithDebInfo, Debug, MinSizeRel" FORCE)
endif()
set(FIRMA_FLAGS_OF_NO_TYPE "$<$<NOT:$<BOOL:$<CONFIG>>>:-O3;-DNDEBUG>")
