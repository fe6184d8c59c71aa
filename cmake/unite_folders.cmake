# SPDX-License-Identifier: MIT
# With FIRMA_UNITE the sources of a folder are compiled as one, which takes a third of the time: most of a small file's
# goes into what it includes. So names within a folder are different also where only their own file sees them; between
# folders they are not, so CMAKE_UNITY_BUILD, which knows no folders, means FIRMA_UNITE here.
option(FIRMA_UNITE "Compile the sources of each folder as one: quicker from nothing, slower after a change" ${CMAKE_UNITY_BUILD})
set(CMAKE_UNITY_BUILD OFF)

function(unite_folders target)
  if(NOT FIRMA_UNITE)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    get_filename_component(folder ${path} DIRECTORY)
    get_filename_component(folder ${folder} NAME)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
  # Compiled by itself several times over, for one kind of processor each.
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/world/sweep_lanes.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ takes a source that another includes for a header, whose types might be another's.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
