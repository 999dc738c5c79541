# cmake -DBUILD_DIR=<build of halfedge> -DSOURCE_DIR=<this folder> -DCOMPILER=<c++> -P run.cmake
#
# Installs the library into a folder of its own, then configures, builds and runs the project beside
# this file against what was installed.

set(work "${BUILD_DIR}/find_package")
set(prefix "${work}/prefix")

function(step)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${work}")
step("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
step("${CMAKE_COMMAND}" -G Ninja -S "${SOURCE_DIR}" -B "${work}/build"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_BUILD_TYPE=Release)
step("${CMAKE_COMMAND}" --build "${work}/build")
step("${work}/build/consumer")
