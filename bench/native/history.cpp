#include "history.h"

#include <string>
#include <vector>

#include "edits.h"
#include "measure.h"
#include "table.h"

void compare_history(const std::string& label, const TriangleMesh& input) {
  EditedMesh mesh(input);
  for (const Edit& edit : edits()) {
    const auto run = [&] { mesh.run(edit); };
    const std::vector<std::string> names{std::string(edit.name) + "/off",
                                         std::string(edit.name) + "/on"};
    print_row(label + " | " + edit.name, names,
              measure({{names[0], run, [&] { mesh.prepare(edit, false); }},
                       {names[1], run, [&] { mesh.prepare(edit, true); }}}));
  }
}
