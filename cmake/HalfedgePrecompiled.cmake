# Precompiled headers, and with clang their code as well.

# Precompiles the given headers for the sources of `target`. Clang also compiles the inline functions and
# the instances of templates that they have, once and optimised, into an object that `target` links: else each source
# would have those that it uses compiled anew.
function(halfedge_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12
     OR APPLE) # whose linker has no --gc-sections
    return()
  endif()
  target_compile_options(${target} PRIVATE -fpch-codegen -Wno-unused-command-line-argument)
  set(precompiled "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.pch")
  # CMake would say -x c++, but it's no text any more.
  set_source_files_properties("${precompiled}" PROPERTIES
    GENERATED ON OBJECT_DEPENDS "${precompiled}" LANGUAGE CXX COMPILE_OPTIONS "-x;none")
  add_library(${target}_headers OBJECT "${precompiled}")
  target_compile_options(${target}_headers PRIVATE
    -O1 -ffunction-sections -fdata-sections -Wno-unused-command-line-argument)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_headers>)
  # Also compiled is what nobody calls, and what that calls may be in no library.
  target_link_options(${target} PRIVATE LINKER:--gc-sections)
endfunction()
