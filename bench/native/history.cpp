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
    const auto edited = [&] {
      mesh.prepare(edit, true);
      mesh.run(edit);
    };
    const auto undone = [&] {
      edited();
      mesh.undo_all();
    };
    const std::string name = edit.name;
    const std::vector<std::string> names{name + "/off", name + "/on", name + "/undo",
                                         name + "/redo"};
    print_row(label + " | " + name, names,
              measure({{names[0], run, [&] { mesh.prepare(edit, false); }},
                       {names[1], run, [&] { mesh.prepare(edit, true); }},
                       {names[2], [&] { mesh.undo_all(); }, edited},
                       {names[3], [&] { mesh.redo_all(); }, undone}}));
  }
}
