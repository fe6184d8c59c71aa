# SPDX-License-Identifier: MIT
# ccache, where there is one and nothing else was asked for. It is told that a precompiled header does not change what is
# compiled, and that no source asks for the time.
if(PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(FIRMA_CCACHE ccache)
  mark_as_advanced(FIRMA_CCACHE)
  if(FIRMA_CCACHE)
    set(CMAKE_C_COMPILER_LAUNCHER ${FIRMA_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${FIRMA_CCACHE})
  endif()
endif()
