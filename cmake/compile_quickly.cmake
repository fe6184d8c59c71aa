# SPDX-License-Identifier: MIT
# Where there are tests: less optimised is what is itself no part of what they test or measure, and of the library what
# reads, joins and saves levels. It compiles in two thirds of the time so (g++), or in one third (clang with sanitizers).
# compile_quickly(TARGET -O0): not optimised at all, but on Windows, whose objects hold a limited number of sections.
function(compile_quickly target)
  if(FIRMA_BUILD_TESTS AND NOT FIRMA_SANITIZE AND NOT WIN32 AND ARGN)
    target_compile_options(${target} PRIVATE ${ARGN})
  elseif(FIRMA_BUILD_TESTS AND NOT FIRMA_SANITIZE)
    target_compile_options(${target} PRIVATE -O1)
  endif()
  compile_quickly_sanitized(${target})
endfunction()

# What users have is optimised as they have it, but for the sanitizers: there only what takes most of a test's time is.
function(compile_quickly_sanitized target)
  if(FIRMA_BUILD_TESTS AND FIRMA_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# library_first(TARGET LIBRARY...): links these, whole, before the target's own objects. Of an inline function that both
# have, theirs is taken, which is optimised.
function(library_first target)
  if(FIRMA_BUILD_TESTS AND NOT WIN32)
    list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
    list(JOIN files "," files)
    target_link_options(${target} PRIVATE "LINKER:--whole-archive,${files},--no-whole-archive")
  endif()
endfunction()
