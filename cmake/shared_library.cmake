# SPDX-License-Identifier: MIT
# Gives a library its public name, firma::NAME, and with FIRMA_SHARED a shared form made of the same objects.
#
# publish_library(TARGET NAME EXPORTS): EXPORTS is a linker script with the symbols that leave the shared library. The
# public name is that of the shared form where BUILD_SHARED_LIBS is on, as in projects that add Firma as a folder. On
# Windows C++ is static alone, as no symbol of it is marked for a DLL; the C API has one.
function(publish_library target name exports)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set(public ${target})
  if(FIRMA_SHARED AND (name STREQUAL "c" OR NOT WIN32))
    add_library(${target}_shared SHARED $<TARGET_OBJECTS:${target}>)
    set_target_properties(${target}_shared PROPERTIES OUTPUT_NAME ${target} EXPORT_NAME ${name} LINKER_LANGUAGE CXX
                          VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_include_directories(${target}_shared INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                               $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    foreach(property INTERFACE_COMPILE_FEATURES INTERFACE_COMPILE_OPTIONS)
      get_target_property(value ${target} ${property})
      if(value)
        set_property(TARGET ${target}_shared PROPERTY ${property} "${value}")
      endif()
    endforeach()
    target_link_libraries(${target}_shared PRIVATE Threads::Threads $<BUILD_INTERFACE:firma_flags>)
    if(UNIX AND NOT APPLE)
      target_link_options(${target}_shared PRIVATE -Wl,--version-script=${exports} -Wl,--no-undefined)
      set_property(TARGET ${target}_shared PROPERTY LINK_DEPENDS ${exports})
    endif()
    if(BUILD_SHARED_LIBS)
      set(public ${target}_shared)
    endif()
  endif()
  add_library(firma::${name} ALIAS ${public})
endfunction()
