# SPDX-License-Identifier: MIT
# Files for pkg-config: firma.pc, firma_c.pc, firma_gltf.pc. They find the headers and libraries from where they lie
# themselves, so that an installed tree can be moved. A linker takes the shared library where there is one; what the
# static ones need besides is in Libs where there are no others, else in Libs.private (pkg-config --static).
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE folder)
cmake_path(APPEND folder pkgconfig)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${folder} OUTPUT_VARIABLE FIRMA_PC_PREFIX)

# write_pc(NAME DESCRIPTION REQUIRES LIBRARIES SHARED STATIC_ONLY): LIBRARIES are linked always.
function(write_pc FIRMA_PC_NAME FIRMA_PC_DESCRIPTION FIRMA_PC_REQUIRES FIRMA_PC_LIBRARIES shared private)
  if(TARGET ${shared})
    set(FIRMA_PC_PRIVATE "${private}")
  else()
    string(APPEND FIRMA_PC_LIBRARIES " ${private}")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/firma.pc.in ${PROJECT_BINARY_DIR}/${FIRMA_PC_NAME}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${FIRMA_PC_NAME}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

set(FIRMA_PC_FLAGS "-ffp-contract=off")
if(WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # see the library's options
  string(APPEND FIRMA_PC_FLAGS " -fno-ipa-ra")
endif()
set(runtime "-lstdc++ -lm")
if(CMAKE_THREAD_LIBS_INIT)
  string(APPEND runtime " ${CMAKE_THREAD_LIBS_INIT}")
endif()
write_pc(firma "Collision detection in polygon worlds that can be carved" "" "-lfirma" firma_shared "${runtime}")
if(TARGET firma_c)
  write_pc(firma_c "Collision detection in polygon worlds that can be carved: the C API" "" "-lfirma_c" firma_c_shared "-lfirma ${runtime}")
endif()
if(TARGET firma_gltf AND TARGET firma_shared)
  write_pc(firma_gltf "glTF for Firma" "firma" "" firma_gltf_shared "-lfirma_gltf")
elseif(TARGET firma_gltf)
  write_pc(firma_gltf "glTF for Firma" "firma" "-lfirma_gltf" firma_gltf_shared "")
endif()
