# What every target of the WebAssembly build needs: compile options, and a link that works with
# Debian's Emscripten as well as with an emsdk.

if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_compile_options(-flto)
  add_link_options(-flto)
endif()
add_compile_options(-msimd128)
add_link_options(-msimd128)

# Debian's Emscripten needs two things of the environment when it links. `acorn` lies where only
# Debian's own node looks. And npm puts node_modules/.bin in front of PATH, where a wasm-opt of
# another version would be taken for Emscripten's own, and break the module without a word.
# An emsdk keeps its own PATH.
if(EMSCRIPTEN_ROOT_PATH STREQUAL "/usr/share/emscripten")
  set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK
    "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs PATH=/usr/bin:/bin")
endif()

# A page waits for every byte, so only the files that all of a mesh passes through, or that are called
# for one edit after the other, are compiled for speed, and the others for size.
set(halfedge_fast_files
  # every file that is read, and what reads its words and numbers
  io/obj io/off io/ply io/stl_binary io/stl_text io/text_scanner io/copy_numbers
  # what workers and files are given
  io/bytes_reader io/live_mesh io/number_writer io/stl_writer
  # every build, and every build from a soup
  build/connect build/fans build/match_bucket build/strict directed_edges/connect directed_edges/fans
  repair/arrange repair/match repair/orient repair/weld
  # all arrays grow here, and columns of attributes follow each operation
  connectivity/array attributes/attribute attributes/attributes
  # every edit
  operation_bindings construction_bindings history/journal
  # where edits are refused; all that refuses gets smaller by it, besides
  sentence result refusals
  # whole meshes: rows of all rings, topology, validation, copies, orders
  algorithms/adjacency algorithms/topology algorithms/touch_rings
  algorithms/triangles algorithms/quad
  validate/check_links validate/check_orbits validate/check_polygons validate/check_references
  making_bindings operations/append operations/reorder
)

# A file that was given another name would be compiled for size, and nobody would see why it is slow.
foreach(name IN LISTS halfedge_fast_files)
  if(NOT EXISTS "${PROJECT_SOURCE_DIR}/src/halfedge/${name}.cpp" AND
     NOT EXISTS "${PROJECT_SOURCE_DIR}/wasm/${name}.cpp")
    message(FATAL_ERROR "halfedge_fast_files names ${name}, expected a file of src/halfedge or wasm.")
  endif()
endforeach()

# Compiles all files but those for size: by -Oz, which inlines what gets smaller by it, such as
# circulators. Alone it makes emcc inline nothing, and circulators ten times slower.
function(halfedge_trade_speed_for_size target)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    return()
  endif()
  target_compile_options(${target} PRIVATE -Oz -finline-functions)
  foreach(source IN LISTS ARGN)
    string(REGEX REPLACE ".*/(halfedge|wasm)/|\\.cpp$" "" name "${source}")
    if(source MATCHES "\\.cpp$" AND name IN_LIST halfedge_fast_files)
      # Options of its own keep a file out of those that are compiled as one, too.
      set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS -O3)
    endif()
  endforeach()
endfunction()

# The files for speed and the others, as lists of these names.
function(halfedge_split_off_fast_files fast others)
  foreach(source IN LISTS ARGN)
    string(REGEX REPLACE ".*/(halfedge|wasm)/|\\.cpp$" "" name "${source}")
    if(name IN_LIST halfedge_fast_files)
      list(APPEND fast_sources "${source}")
    else()
      list(APPEND other_sources "${source}")
    endif()
  endforeach()
  set(${fast} ${fast_sources} PARENT_SCOPE)
  set(${others} ${other_sources} PARENT_SCOPE)
endfunction()
