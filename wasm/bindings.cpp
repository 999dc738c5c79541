// The WebAssembly module of the JavaScript package: the functions below, and its memory.
//
// Design. Nothing here is called per item. JavaScript walks a mesh by reading its arrays in place,
// as typed arrays over this memory; `layout` says where they lie. What is called works on a whole
// mesh, so embind's cost of a call doesn't matter, and its conversions are used only for numbers
// and for the few objects that report something.
//
// - A mesh is named by its address, a number. The wrapper (web/src/links.ts) keeps it to itself,
//   calls `destroyMesh` once, and never passes it on after that. No embind class: no garbage
//   collector ever frees the objects of one.
// - Inputs are copied by JavaScript into memory from `allocate`, and freed by it, whatever happens.
// - Arrays are handed over by address; JavaScript copies and frees them. No embind vectors.
// - Errors are objects. Nothing throws in either direction, so nothing leaks on the way.
//
// The types of this module for TypeScript are in web/src/core.d.mts. No algorithm belongs here.

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/halfedge.h>
#include <halfedge/io/parse.h>
#include <halfedge/validate/validate.h>
#include <malloc.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace halfedge;
using emscripten::val;

using Address = std::uintptr_t;

// ---- memory ----------------------------------------------------------------------------------

/// Arrays of the core report a failed allocation, but the strings of an error can't: without
/// exceptions a failing `new` ends the module. So some memory is kept back for them: it is let go
/// when `new` finds none, and while a report is made; and is taken back as soon as there is room.
class Reserve {
 public:
  static bool take_back() {
    if (block_ == nullptr) block_ = std::malloc(kBytes);
    return block_ != nullptr;
  }
  static void let_go() { std::free(std::exchange(block_, nullptr)); }
  static void on_exhaustion() {
    if (block_ == nullptr) std::abort();  // a report larger than the reserve: a bug
    let_go();
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{4} << 20U;
  static inline void* block_ = nullptr;
};

/// While it lives, embind can make strings, for which it allocates without asking for success.
class RoomForReport {
 public:
  RoomForReport() { Reserve::let_go(); }
  ~RoomForReport() { (void)Reserve::take_back(); }
  RoomForReport(const RoomForReport&) = delete;
  RoomForReport& operator=(const RoomForReport&) = delete;
};

Address allocate(std::size_t bytes) {
  if (!Reserve::take_back()) return 0;
  return reinterpret_cast<Address>(std::malloc(bytes > 0 ? bytes : 1));
}

void free_block(Address address) { std::free(reinterpret_cast<void*>(address)); }

std::size_t bytes_in_use() {
  (void)Reserve::take_back();
  return static_cast<std::size_t>(mallinfo().uordblks);
}

template <class T>
std::span<const T> array_at(Address address, std::size_t count) {
  return {reinterpret_cast<const T*>(address), count};
}

using MeshWithoutPrev = BasicMesh<kWithoutPrev>;
/// What an address names. JavaScript chooses the storage at run time, C++ when it is compiled.
using AnyMesh = std::variant<Mesh, MeshWithoutPrev>;

AnyMesh& mesh_at(Address address) { return *reinterpret_cast<AnyMesh*>(address); }

/// Calls `function` with the mesh as what it is.
template <class Function>
auto visit(AnyMesh& mesh, const Function& function) {
  if (auto* whole = std::get_if<Mesh>(&mesh)) return function(*whole);
  return function(*std::get_if<MeshWithoutPrev>(&mesh));
}
template <class Function>
auto visit_mesh(Address address, const Function& function) {
  return visit(mesh_at(address), function);
}

void destroy_mesh(Address address) { std::destroy_at(&mesh_at(address)), free_block(address); }

/// A mesh on its way to JavaScript.
class NewMesh {
 public:
  explicit NewMesh(bool stores_prev) : address_(allocate(sizeof(AnyMesh))) {
    if (address_ == 0) return;
    new (reinterpret_cast<void*>(address_)) AnyMesh;
    if (!stores_prev) mesh_at(address_).emplace<MeshWithoutPrev>();
  }
  NewMesh(const NewMesh&) = delete;
  NewMesh& operator=(const NewMesh&) = delete;
  ~NewMesh() {
    if (address_ != 0) destroy_mesh(address_);
  }
  explicit operator bool() const { return address_ != 0; }
  AnyMesh& operator*() const { return mesh_at(address_); }
  Address release() { return std::exchange(address_, 0); }

 private:
  Address address_;
};

// ---- reports ---------------------------------------------------------------------------------

val to_array(const std::vector<Index>& indices) {
  return val(emscripten::typed_memory_view(indices.size(), indices.data())).call<val>("slice");
}

val to_problem(const Error& error) {
  val problem = val::object();
  problem.set("code", error.code);
  problem.set("message", error.message);
  problem.set("vertices", to_array(error.witness.vertices));
  problem.set("halfedges", to_array(error.witness.halfedges));
  problem.set("edges", to_array(error.witness.edges));
  problem.set("faces", to_array(error.witness.faces));
  return problem;
}

/// What a call returns that failed: `problems`, and how many there are, listed or not.
val failure(std::span<const Error> errors, std::size_t count) {
  const RoomForReport room;
  val problems = val::array();
  for (const Error& error : errors) problems.call<void>("push", to_problem(error));
  val result = val::object();
  result.set("problems", problems);
  result.set("problemCount", count);
  return result;
}
val failure(const Error& error) { return failure({&error, 1}, 1); }

val success(const char* name, const val& value) {
  val result = val::object();
  result.set(name, value);
  return result;
}

/// Hands the elements over: the address is JavaScript's to free.
template <class T>
val hand_over(Array<T>& array) {
  val block = val::object();
  block.set("count", array.size());
  block.set("address", reinterpret_cast<Address>(array.release()));
  return block;
}

// ---- meshes ----------------------------------------------------------------------------------

Address create_mesh(bool stores_prev) { return NewMesh(stores_prev).release(); }

Address clone_mesh(Address address) {
  return visit_mesh(address, [](const auto& original) -> Address {
    using AMesh = std::remove_cvref_t<decltype(original)>;
    NewMesh copy(StoresPrev<AMesh>);
    if (!copy || !std::get_if<AMesh>(&*copy)->assign(original)) return 0;
    return copy.release();
  });
}

/// The halfedge that an operation has made; kNone when memory is exhausted.
Index index_of(const Result<Halfedge>& made) { return made.ok() ? made.value().index() : kNone; }

Index make_loop(Address address) {
  return visit_mesh(address, [](auto& mesh) { return index_of(decorator::make_loop(mesh)); });
}
Index make_segment(Address address) {
  return visit_mesh(address, [](auto& mesh) { return index_of(decorator::make_segment(mesh)); });
}

/// The words that `Links.refresh` reads. They are good until the next call.
Address layout(Address address) {
  static std::array<std::uint32_t, 16> words;
  const auto at = [](const auto* data) {
    return static_cast<std::uint32_t>(reinterpret_cast<Address>(data));
  };
  visit_mesh(address, [&]<Storage kStored>(const BasicMesh<kStored>& mesh) {
    const Links& links = mesh.links();
    words = {at(links.next.data()),
             at(links.prev.data()),
             at(links.to_vertex.data()),
             at(links.face.data()),
             at(links.vertex_halfedge.data()),
             at(links.face_halfedge.data()),
             at(mesh.positions().data()),
             mesh.vertex_slots(),
             mesh.halfedge_slots(),
             mesh.face_slots(),
             mesh.vertex_count(),
             mesh.edge_count(),
             mesh.face_count(),
             static_cast<std::uint32_t>(mesh.version()),
             static_cast<std::uint32_t>(mesh.version() >> 32U),
             kStored.prev};
  });
  return reinterpret_cast<Address>(words.data());
}

Error no_room_for_a_mesh() { return {"out-of-memory", "memory is exhausted: no room for a mesh"}; }

bool build_any(AnyMesh& mesh, const Polygons& polygons, BuildReport& report) {
  return visit(mesh, [&](auto& m) { return build_from_polygons(m, polygons, report); });
}

val build(Address positions, std::size_t position_count, Address sizes, std::size_t size_count,
          Address corners, std::size_t corner_count, bool stores_prev) {
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  BuildReport report;
  const Polygons polygons{array_at<float>(positions, position_count),
                          array_at<Index>(sizes, size_count),
                          array_at<Index>(corners, corner_count)};
  if (!build_any(*mesh, polygons, report)) return failure(report.problems, report.problem_count);
  return success("mesh", val(mesh.release()));
}

/// Names the lines of the file on which the faces of each witness start.
void add_lines(std::vector<Error>& problems, std::span<const std::uint8_t> bytes, Format format) {
  std::vector<Index> faces;
  for (const Error& problem : problems) {
    faces.insert(faces.end(), problem.witness.faces.begin(), problem.witness.faces.end());
  }
  if (faces.empty()) return;
  const std::vector<std::size_t> lines = lines_of_faces(bytes, format, faces);
  std::size_t at = 0;
  for (Error& problem : problems) {
    const std::size_t count = problem.witness.faces.size();
    for (std::size_t i = 0; i < count; ++i) {
      problem.message += i == 0 ? (count == 1 ? " (Line " : " (Lines ") : ", ";
      problem.message += std::to_string(lines[at++]);
    }
    if (count > 0) problem.message += ")";
  }
}

/// `claimed` is what the user says the format is: a value of Format, or -1.
val parse_file(Address address, std::size_t count, int claimed, bool stores_prev) {
  const std::span<const std::uint8_t> bytes = array_at<std::uint8_t>(address, count);
  Result<ParsedFile> file =
      parse(bytes, claimed < 0 ? std::nullopt : std::optional(static_cast<Format>(claimed)));
  if (!file) return failure(file.error());
  const Format format = file.value().format;
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  BuildReport report;
  if (!build_any(*mesh, file.value().soup.view(), report)) {
    file.value().soup = {};
    add_lines(report.problems, bytes, format);
    return failure(report.problems, report.problem_count);
  }
  const RoomForReport room;
  val notes = val::array();
  for (const std::string& note : file.value().notes) notes.call<void>("push", note);
  val result = success("mesh", val(mesh.release()));
  result.set("format", static_cast<int>(format));
  result.set("notes", notes);
  return result;
}

// ---- questions about a whole mesh ------------------------------------------------------------

val validate_mesh(Address mesh, int level) {
  const std::vector<Problem> problems =
      visit_mesh(mesh, [&](const auto& m) { return validate(m, level); });
  const RoomForReport room;
  val list = val::array();
  for (const Problem& problem : problems) {
    val item = val::object();
    item.set("code", std::string(problem.code));
    item.set("severity", std::string(name_of(problem.severity)));
    item.set("kind", std::string(name_of(problem.kind)));
    item.set("index", static_cast<std::int32_t>(problem.index));
    item.set("message", problem.message);
    list.call<void>("push", item);
  }
  return list;
}

double euler(Address mesh) {
  return visit_mesh(mesh,
                    [](const auto& m) { return static_cast<double>(euler_characteristic(m)); });
}

val total_genus(Address mesh) {
  const Result<std::int64_t> result = visit_mesh(mesh, [](const auto& m) { return genus(m); });
  if (!result) return failure(result.error());
  return success("genus", val(static_cast<double>(result.value())));
}

val loops(Address mesh) {
  Result<Array<Halfedge>> result =
      visit_mesh(mesh, [](const auto& m) { return boundary_loops(m); });
  if (!result) return failure(result.error());
  return success("halfedges", hand_over(result.value()));
}

val components(Address mesh) {
  Result<Components> result =
      visit_mesh(mesh, [](const auto& m) { return connected_components(m); });
  if (!result) return failure(result.error());
  Components& found = result.value();
  val out = val::object();
  out.set("list", hand_over(found.list));  // vertices, edges, faces, boundary loops
  out.set("ofVertex", hand_over(found.of_vertex));
  out.set("ofFace", hand_over(found.of_face));
  return out;
}

val to_rows(const Result<void>& result, Adjacency& rows) {
  if (!result) return failure(result.error());
  val out = val::object();
  out.set("offsets", hand_over(rows.offsets));
  out.set("items", hand_over(rows.items));
  return out;
}

/// `ring` and `direction` are values of Ring and Direction.
val all_rings(Address mesh, int ring, int direction) {
  Adjacency rows;
  const Result<void> result = visit_mesh(mesh, [&](const auto& m) {
    return adjacency(m, static_cast<Ring>(ring), static_cast<Direction>(direction), rows);
  });
  return to_rows(result, rows);
}

val some_rings(Address mesh, int ring, int direction, Address centres, std::size_t count) {
  Adjacency rows;
  const Result<void> result = visit_mesh(mesh, [&](const auto& m) {
    return adjacency(m, static_cast<Ring>(ring), static_cast<Direction>(direction),
                     array_at<Index>(centres, count), rows);
  });
  return to_rows(result, rows);
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge) {
  using emscripten::function;

  std::set_new_handler(&Reserve::on_exhaustion);
  (void)Reserve::take_back();

  function("allocate", &allocate);
  function("free", &free_block);
  function("bytesInUse", &bytes_in_use);

  function("createMesh", &create_mesh);
  function("cloneMesh", &clone_mesh);
  function("destroyMesh", &destroy_mesh);
  function("layout", &layout);
  function("makeLoop", &make_loop);
  function("makeSegment", &make_segment);
  function("build", &build);
  function("parse", &parse_file);

  function("validate", &validate_mesh);
  function("eulerCharacteristic", &euler);
  function("genus", &total_genus);
  function("boundaryLoops", &loops);
  function("components", &components);
  function("allRings", &all_rings);
  function("someRings", &some_rings);
}
