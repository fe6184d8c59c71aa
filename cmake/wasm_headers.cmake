# SPDX-License-Identifier: MIT
# Header-only libraries that a cross compiler does not find: links to them in a private folder, so that nothing else of
# /usr/include comes along.
set(FIRMA_WASM_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${FIRMA_WASM_HEADERS})
foreach(library fast_float boost)
  file(CREATE_LINK /usr/include/${library} ${FIRMA_WASM_HEADERS}/${library} SYMBOLIC)
endforeach()
target_include_directories(firma SYSTEM PRIVATE ${FIRMA_WASM_HEADERS})
# Boost names a class that C++17 took out of the standard library.
target_compile_definitions(firma PRIVATE _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)
