#include <valgrind/callgrind.h>

#include <cstdio>
#include <vector>

#include "loops.h"
#include "memory.h"
#include "meshes.h"

// Runs each loop once, to be counted by callgrind, which is told to write its counts after each
// under the name of the loop. Prints the compiler, then a line for each loop: whose it is, name,
// yardstick and number of faces; with tabs between, which Valgrind's own lines don't have. See
// scripts/guard.mjs.

namespace {

void count(const char* whose, const std::vector<Loop>& loops) {
  for (const Loop& loop : loops) {
    if (loop.prepare) loop.prepare();
    const std::string title = std::string(whose) + ": " + loop.name;
    CALLGRIND_START_INSTRUMENTATION;  // from here on, with an empty cache
    CALLGRIND_ZERO_STATS;
    loop.run();
    CALLGRIND_DUMP_STATS_AT(title.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
    std::printf("%s\t%s\t%s\t%zu\n", whose, loop.name.c_str(), loop.yardstick.c_str(), loop.faces);
  }
}

}  // namespace

int main() {
  keep_one_heap();
#ifdef __clang__
  std::printf("compiler\tclang++ %d\n", __clang_major__);
#else
  std::printf("compiler\tg++ %d\n", __GNUC__);
#endif
  const TriangleMesh natural = sphere(5);
  const TriangleMesh random = shuffled(natural, 1);
  count("flat", flat_loops(natural, random));
  count("halfedge", guarded_loops(natural, random));
  return 0;
}
