# SPDX-License-Identifier: MIT
# Says which compilers there must be, before an older one fails somewhere in the middle. Also for the installed library,
# whose headers need them.
set(FIRMA_LEAST_GNU 11)
set(FIRMA_LEAST_Clang 13)
set(firma_least "${FIRMA_LEAST_${CMAKE_CXX_COMPILER_ID}}")
if((firma_least AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS firma_least) OR CMAKE_CXX_COMPILER_ID STREQUAL "MSVC")
  message(FATAL_ERROR "Firma needs g++ ${FIRMA_LEAST_GNU} or clang ${FIRMA_LEAST_Clang}, or newer; this is ${CMAKE_CXX_COMPILER_ID} "
                      "${CMAKE_CXX_COMPILER_VERSION} (${CMAKE_CXX_COMPILER}). Another one is chosen by -DCMAKE_CXX_COMPILER=..., in an empty build folder.")
endif()
