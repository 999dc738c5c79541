// Meshes and polygons out of files, and files out of meshes. See the design in bindings.cpp.

#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>
#include <halfedge/repair/transfer.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "repair_bindings.h"

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

val strings_of(const std::vector<std::string>& strings) {
  val list = val::array();
  for (const std::string& text : strings) list.call<void>("push", text);
  return list;
}

val names_of(const ParsedFile& file) {
  val names = val::object();
  for (const SoupNames& table : file.names) {
    val list = val::array();
    for (const std::string& name : table.names) {
      list.call<void>("push", letters_of(name));
    }
    names.set(table.attribute, list);
  }
  return names;
}

/// What the user says the format is: a value of Format, or -1.
std::optional<Format> claim(int format) {
  return format < 0 ? std::nullopt : std::optional(static_cast<Format>(format));
}

bool tell(void* callback, Stage stage, double fraction) {
  return (*static_cast<const val*>(callback))(static_cast<int>(stage), fraction).as<bool>();
}

Error was_cancelled() { return {"cancelled", "The build was cancelled."}; }

/// `callback` is null, or a function that gets a stage and a fraction, and must not throw; false
/// cancels.
val parse_file(Address address, std::size_t count, int claimed, bool repair, bool attributes,
               bool stores_prev, val callback) {
  const Progress progress{callback.isNull() ? nullptr : &tell, &callback};
  const std::span<const std::uint8_t> bytes = array_at<std::uint8_t>(address, count);
  Result<ParsedFile> file =
      parse(bytes, claim(claimed),
            {.attributes = attributes, .for_repair = repair, .progress = progress});
  if (!file) return failure(file.error());
  const Format format = file.value().format;
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  BuildReport strict;
  RepairReport repaired;
  std::vector<Error>& problems = repair ? repaired.problems : strict.problems;
  const Polygons polygons = file.value().soup.view();
  if (!repair && !progress(Stage::kBuild, 0)) return failure(was_cancelled());
  const bool is_built = repair ? build_from_soup(*mesh, polygons, {.progress = progress}, repaired)
                               : build_from_polygons(*mesh, polygons, strict);
  Result<void> has_attributes;
  if (is_built) {
    has_attributes =
        add_attributes(*mesh, polygons, repair ? &repaired : nullptr, file.value().attributes);
  }
  file.value().soup = {};
  if (!has_attributes) return failure(has_attributes.error());
  add_places(problems, bytes, format);
  if (!is_built) return failure(problems, repair ? problems.size() : strict.problem_count);
  if (!progress(Stage::kBuild, 1)) return failure(was_cancelled());
  const RoomForReport room;
  val result = success("mesh", val(mesh.release()));
  result.set("format", static_cast<int>(format));
  result.set("notes", strings_of(file.value().notes));
  result.set("names", names_of(file.value()));
  if (repair) add_repair(result, repaired);
  return result;
}

/// Tables of names, each ended by NUL: the name of the attribute and the names, each ended by LF.
std::vector<SoupNames> names_in(std::string_view text) {
  std::vector<SoupNames> tables;
  bool is_new = true;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\n' && text[at] != '\0') continue;
    const std::string_view word = text.substr(begin, at - begin);
    begin = at + 1;
    if (text[at] == '\0') {
      is_new = true;
    } else if (is_new) {
      tables.push_back({std::string(word), {}});
      is_new = false;
    } else {
      tables.back().names.emplace_back(word);
    }
  }
  return tables;
}

/// `item` and `type` are values of SoupItem and Scalar; `values` are counted in bytes.
val columns_of(std::vector<SoupAttribute>& columns) {
  val list = val::array();
  for (SoupAttribute& column : columns) {
    val item = val::object();
    item.set("name", letters_of(column.name));
    item.set("item", static_cast<int>(column.item));
    item.set("type", static_cast<int>(column.type));
    item.set("components", column.components);
    item.set("values", hand_over(column.values));
    item.set("rows", hand_over(column.rows));
    list.call<void>("push", item);
  }
  return list;
}

/// The faces of a file as they stand there, whatever they are. `sizes` has none if all are
/// triangles.
val parse_soup(Address address, std::size_t count, int claimed, bool welds, bool attributes) {
  Result<ParsedFile> file = parse(array_at<std::uint8_t>(address, count), claim(claimed),
                                  {.attributes = attributes, .for_repair = true, .weld = welds});
  if (!file) return failure(file.error());
  const RoomForReport room;
  PolygonSoup& soup = file.value().soup;
  val result = success("positions", hand_over(soup.positions));
  result.set("sizes", hand_over(soup.sizes));
  result.set("corners", hand_over(soup.corners));
  result.set("attributes", columns_of(file.value().attributes));
  result.set("names", names_of(file.value()));
  result.set("format", static_cast<int>(file.value().format));
  result.set("notes", strings_of(file.value().notes));
  return result;
}

/// `format` and `encoding` are values of Format and Encoding; `names` is text as names_in() reads
/// it. Notes are looked for if somebody wants them.
val write_file(Address mesh, int format, int encoding, bool attributes, bool with_notes,
               Address names, std::size_t name_count) {
  const std::vector<SoupNames> tables =
      names_in({reinterpret_cast<const char*>(names), name_count});
  std::vector<std::string> notes;
  WriteOptions options;
  options.attributes = attributes;
  if (with_notes) options.notes = &notes;
  options.names = tables;
  options.encoding = static_cast<Encoding>(encoding);
  Result<Array<std::uint8_t>> bytes = write(mesh_at(mesh), static_cast<Format>(format), options);
  if (!bytes) return failure(bytes.error());
  const RoomForReport room;
  val result = success("bytes", hand_over(bytes.value()));
  result.set("notes", strings_of(notes));
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge_files) {
  using emscripten::function;

  function("parse", &parse_file);
  function("parseSoup", &parse_soup);
  function("write", &write_file);
}
