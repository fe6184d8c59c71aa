# SPDX-License-Identifier: MIT
# The two libraries of headers that Firma is compiled with: fast_float and Boost. Users of the built library need
# neither.
#
# Each is linked to from a private folder when cross compiling, so that nothing else of the folder it lies in, often
# /usr/include, comes along.
add_library(firma_header_libraries INTERFACE)

function(find_header_library folder header package)
  string(TOUPPER FIRMA_${folder}_INCLUDE_DIR variable)
  find_path(${variable} ${header} HINTS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH
            DOC "The folder with ${header}")
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

find_header_library(fast_float fast_float/fast_float.h libfast-float-dev)
find_header_library(boost boost/multiprecision/cpp_int.hpp libboost-dev)
