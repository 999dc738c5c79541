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
