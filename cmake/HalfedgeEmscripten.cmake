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

# A page waits for every byte, so only the files that all of a mesh passes through are compiled for
# speed, and the others for size. Each entry is a regular expression.
set(halfedge_fast_files
  "algorithms/(adjacency|topology)"                        # rows of all rings, loops, components
  "attributes/attributes?"                                 # columns follow each operation
  "build/(connect|fans|strict)"                            # every build
  "connectivity/array"                                     # all arrays grow here
  "directed_edges/(connect|fans)"                          # every build
  "io/(obj|off|off_binary|ply|stl)"                        # every file that is read
  "io/(text_scanner|copy_numbers)"                         # and what reads its words and numbers
  "io/(bytes_reader|live_mesh|number_writer|stl_writer)"   # what workers and files are given
  "operations/append" "operations/dual" "making_bindings"  # whole meshes
  "repair/(arrange|match|orient|weld)"                     # every build from a soup
  "validate/check_.*"                                      # every validation
)

# Compiles all files but those for size: by -Oz, which inlines what gets smaller by it, such as
# circulators. Alone it makes emcc inline nothing, and circulators ten times slower.
function(halfedge_trade_speed_for_size)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    return()
  endif()
  list(JOIN halfedge_fast_files "|" fast)
  foreach(source IN LISTS ARGN)
    if(source MATCHES "\\.cpp$" AND NOT source MATCHES "/(halfedge|wasm)/(${fast})\\.cpp$")
      set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS "-Oz;-finline-functions")
    endif()
  endforeach()
endfunction()
