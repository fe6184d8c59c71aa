# SPDX-License-Identifier: MIT
# What `cmake --install` puts where: libraries, public headers, the command line, and what find_package and pkg-config
# look for. Static and shared libraries stand side by side; firma-config.cmake says which of them a project gets.
include(CMakePackageConfigHelpers)
set(FIRMA_CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/firma)

# No header without its library: firma.h includes read_gltf.h where it is there.
if(NOT TARGET firma_gltf)
  set(no_gltf PATTERN "read_gltf.h" EXCLUDE)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/firma DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" ${no_gltf})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# What of a list of targets there is.
function(targets_there result)
  set(there "")
  foreach(target ${ARGN})
    if(TARGET ${target})
      list(APPEND there ${target})
    endif()
  endforeach()
  set(${result} ${there} PARENT_SCOPE)
endfunction()

foreach(form static shared)
  if(form STREQUAL static)
    targets_there(libraries firma firma_c firma_gltf)
  else()
    targets_there(libraries firma_shared firma_c_shared firma_gltf_shared)
  endif()
  if(libraries)
    install(TARGETS ${libraries} EXPORT firma_${form} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT firma_${form} NAMESPACE firma:: FILE firma-${form}.cmake DESTINATION ${FIRMA_CONFIG_FOLDER})
  endif()
endforeach()
if(TARGET firma_cli)
  install(TARGETS firma_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/firma-config.cmake.in ${PROJECT_BINARY_DIR}/firma-config.cmake
                              INSTALL_DESTINATION ${FIRMA_CONFIG_FOLDER} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/firma-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/firma-config.cmake ${PROJECT_BINARY_DIR}/firma-config-version.cmake
        ${PROJECT_SOURCE_DIR}/cmake/compilers.cmake DESTINATION ${FIRMA_CONFIG_FOLDER})

include(${PROJECT_SOURCE_DIR}/cmake/pkg_config.cmake)
