# Finds fast_float, which reads decimal numbers for the file readers (the standard library of the
# compilers we support has no std::from_chars for floating point), and sets
# HALFEDGE_FAST_FLOAT_INCLUDE_DIR, a folder with fast_float/fast_float.h in it.
#
# Order: HALFEDGE_FAST_FLOAT_DIR (-D, or in the environment), the system's headers, a download of the pinned release.

set(HALFEDGE_FAST_FLOAT_DIR "$ENV{HALFEDGE_FAST_FLOAT_DIR}" CACHE PATH "A folder with fast_float/fast_float.h in it")
set(HALFEDGE_FAST_FLOAT_VERSION v3.9.0)

if(HALFEDGE_FAST_FLOAT_DIR)
  if(NOT EXISTS "${HALFEDGE_FAST_FLOAT_DIR}/fast_float/fast_float.h")
    message(FATAL_ERROR "HALFEDGE_FAST_FLOAT_DIR is ${HALFEDGE_FAST_FLOAT_DIR}, "
      "expected a folder with fast_float/fast_float.h in it.")
  endif()
  set(fast_float_source "${HALFEDGE_FAST_FLOAT_DIR}")
else()
  # NO_CMAKE_FIND_ROOT_PATH: a header-only library of the host serves Emscripten as well.
  find_path(HALFEDGE_FAST_FLOAT_SYSTEM_DIR fast_float/fast_float.h
    PATHS /usr/include /usr/local/include /opt/homebrew/include
    NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(HALFEDGE_FAST_FLOAT_SYSTEM_DIR)
  if(HALFEDGE_FAST_FLOAT_SYSTEM_DIR)
    set(fast_float_source "${HALFEDGE_FAST_FLOAT_SYSTEM_DIR}")
  else()
    find_package(Git QUIET)
    if(NOT Git_FOUND)
      message(FATAL_ERROR "There is neither fast_float here, nor Git to download it: install one of them, "
        "or name a folder with fast_float/fast_float.h in it by HALFEDGE_FAST_FLOAT_DIR.")
    endif()
    message(STATUS "fast_float is not installed: downloading ${HALFEDGE_FAST_FLOAT_VERSION}")
    include(FetchContent)
    FetchContent_Declare(fast_float
      GIT_REPOSITORY https://github.com/fastfloat/fast_float.git
      GIT_TAG ${HALFEDGE_FAST_FLOAT_VERSION}
      GIT_SHALLOW ON)
    FetchContent_GetProperties(fast_float)
    if(NOT fast_float_POPULATED)
      FetchContent_Populate(fast_float)
    endif()
    set(fast_float_source "${fast_float_SOURCE_DIR}/include")
  endif()
endif()

# Copied, so that the compiler sees fast_float alone and not its neighbours: a cross compiler that
# is shown the host's /usr/include takes the host's C headers for its own.
set(HALFEDGE_FAST_FLOAT_INCLUDE_DIR "${CMAKE_CURRENT_BINARY_DIR}/fast_float_include")
file(COPY "${fast_float_source}/fast_float" DESTINATION "${HALFEDGE_FAST_FLOAT_INCLUDE_DIR}")
