# SPDX-License-Identifier: MIT
# Where there are tests: less optimised is what is itself no part of what they test or measure, which compiles in two thirds
# of the time so (g++), or in one third (clang with sanitizers). The library is optimised as users have it.
function(compile_quickly target)
  if(FIRMA_BUILD_TESTS AND FIRMA_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  elseif(FIRMA_BUILD_TESTS)
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()
