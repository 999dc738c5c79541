# Compiler options of our own targets. Nothing here reaches those who link the library.

# Warnings for `target`; errors with HALFEDGE_WERROR.
function(halfedge_set_warnings target)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 $<$<BOOL:${HALFEDGE_WERROR}>:/WX>)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion $<$<BOOL:${HALFEDGE_WERROR}>:-Werror>)
  # g++ 12 sees overlapping copies in `"text" + std::string` (gcc.gnu.org/PR105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
endfunction()

# The core and the bindings are compiled without exceptions; tests and benchmarks are not.
function(halfedge_forbid_exceptions target)
  if(MSVC)
    target_compile_definitions(${target} PRIVATE _HAS_EXCEPTIONS=0)
  else()
    target_compile_options(${target} PRIVATE -fno-exceptions)
  endif()
endfunction()

# Compiles the files of each folder of `target` as one: they share the headers, which take most of
# the time. So the names in their anonymous namespaces have to differ, within a folder.
function(halfedge_unite_folders target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
  endforeach()
endfunction()

# Sanitizers go on every target of the build, the C++ library's containers included.
if(HALFEDGE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# libFuzzer learns from `target` which inputs reach new places. Without a fuzz target it does
# nothing but count: tests link the same library.
function(halfedge_instrument_for_fuzzing target)
  if(NOT (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND HALFEDGE_SANITIZE))
    message(FATAL_ERROR "Fuzz targets need clang and HALFEDGE_SANITIZE: use the preset asan.")
  endif()
  target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
endfunction()
