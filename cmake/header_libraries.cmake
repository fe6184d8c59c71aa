# SPDX-License-Identifier: MIT
# The libraries of headers that Firma is compiled with: fast_float, Boost, and Highway where it is there. Users of the
# built library need none of them.
#
# Each is linked to from a private folder when cross compiling, so that nothing else of the folder it lies in, often
# /usr/include, comes along.
add_library(firma_header_libraries INTERFACE)

# find_headers(FOLDER HEADER): sets FIRMA_FOLDER_INCLUDE_DIR.
function(find_headers folder header)
  string(TOUPPER FIRMA_${folder}_INCLUDE_DIR variable)
  find_path(${variable} ${header} HINTS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH
            DOC "The folder with ${header}")
  set(${variable} ${${variable}} PARENT_SCOPE)
endfunction()

function(add_headers folder header package)
  string(TOUPPER FIRMA_${folder}_INCLUDE_DIR variable)
  if(NOT ${variable})
    message(FATAL_ERROR "Firma needs ${header} to be compiled: Debian's package ${package}, or -D${variable}=the folder it is in")
  endif()
  if(CMAKE_CROSSCOMPILING)
    set(links ${PROJECT_BINARY_DIR}/headers)
    file(MAKE_DIRECTORY ${links})
    file(CREATE_LINK ${${variable}}/${folder} ${links}/${folder} SYMBOLIC)
    target_include_directories(firma_header_libraries SYSTEM INTERFACE ${links})
  else()
    target_include_directories(firma_header_libraries SYSTEM INTERFACE ${${variable}})
  endif()
endfunction()

find_headers(fast_float fast_float/fast_float.h)
add_headers(fast_float fast_float/fast_float.h libfast-float-dev)
find_headers(boost boost/multiprecision/cpp_int.hpp)
add_headers(boost boost/multiprecision/cpp_int.hpp libboost-dev)

# Without Highway casts give the same answers, but take longer (docs/install.md).
set(FIRMA_SIMD AUTO CACHE STRING "Casts test eight triangles at a time: ON (needs Highway's headers), OFF, AUTO (where these are)")
set_property(CACHE FIRMA_SIMD PROPERTY STRINGS AUTO ON OFF)
if(FIRMA_SIMD)
  find_headers(hwy hwy/highway.h)
  if(FIRMA_HWY_INCLUDE_DIR OR NOT FIRMA_SIMD STREQUAL "AUTO")
    add_headers(hwy hwy/highway.h libhwy-dev)
    target_compile_definitions(firma PRIVATE FIRMA_SIMD=1)
  else()
    message(STATUS "Firma: no hwy/highway.h (Debian's package libhwy-dev, or -DFIRMA_HWY_INCLUDE_DIR=the folder it is in), "
                   "so casts test one triangle at a time: the same answers, slower")
  endif()
endif()
