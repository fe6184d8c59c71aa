# SPDX-License-Identifier: MIT
# Parts of the library that are compiled with options of their own. As options of sources these would keep the sources from
# being compiled as one with others of their folder.

# take_part(NAME SOURCES OPTIONS): moves sources of the list FIRMA_SOURCES, those whose path from src/ on a pattern matches,
# to a part.
function(take_part name pattern)
  set(sources ${FIRMA_SOURCES})
  list(FILTER sources INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/src/(${pattern})\\.cpp$")
  list(REMOVE_ITEM FIRMA_SOURCES ${sources})
  set(FIRMA_SOURCES ${FIRMA_SOURCES} PARENT_SCOPE)
  add_library(${name} OBJECT ${sources})
  unite_folders(${name})
  # All that the library is compiled with, however it comes to it.
  target_include_directories(${name} PRIVATE $<TARGET_PROPERTY:firma,INCLUDE_DIRECTORIES>)
  target_compile_definitions(${name} PRIVATE $<TARGET_PROPERTY:firma,COMPILE_DEFINITIONS>)
  target_compile_options(${name} PRIVATE $<TARGET_PROPERTY:firma,COMPILE_OPTIONS> ${ARGN})
  set(FIRMA_PARTS ${FIRMA_PARTS} ${name} PARENT_SCOPE)
endfunction()

# Once there is the library.
function(join_parts)
  foreach(part ${FIRMA_PARTS})
    target_sources(firma PRIVATE $<TARGET_OBJECTS:${part}>)
  endforeach()
endfunction()
