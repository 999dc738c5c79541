#pragma once

// What the files of bindings share: memory, meshes on their way, reports.

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <halfedge/halfedge.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::bindings {

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

inline Address allocate(std::size_t bytes) {
  if (!Reserve::take_back()) return 0;
  return reinterpret_cast<Address>(std::malloc(bytes > 0 ? bytes : 1));
}

inline void free_block(Address address) { std::free(reinterpret_cast<void*>(address)); }

inline std::size_t bytes_in_use() {
  (void)Reserve::take_back();
  return static_cast<std::size_t>(mallinfo().uordblks);
}

template <class T>
std::span<const T> array_at(Address address, std::size_t count) {
  return {reinterpret_cast<const T*>(address), count};
}

/// A letter for each byte of a name: what a file spells in is for JavaScript to find out.
inline val letters_of(const std::string& name) {
  return val(std::basic_string<unsigned char>(name.begin(), name.end()));
}

/// What an address names. JavaScript chooses the storage at run time: one type, compiled once.
using AnyMesh = BasicMesh<kPrevAtRunTime>;

inline AnyMesh& mesh_at(Address address) { return *reinterpret_cast<AnyMesh*>(address); }

inline void destroy_mesh(Address address) {
  std::destroy_at(&mesh_at(address)), free_block(address);
}

/// A mesh on its way to JavaScript.
class NewMesh {
 public:
  explicit NewMesh(bool stores_prev) : address_(allocate(sizeof(AnyMesh))) {
    if (address_ == 0) return;
    new (reinterpret_cast<void*>(address_)) AnyMesh;
    mesh_at(address_).choose_prev(stores_prev);
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

/// The words that `Links` reads: where the arrays of a mesh lie, and how many items there are.
inline std::array<std::uint32_t, 19> layout_words;

/// Writes them anew. They are good until the next call.
inline void write_layout(const AnyMesh& mesh) {
  const auto at = [](const auto* data) {
    return static_cast<std::uint32_t>(reinterpret_cast<Address>(data));
  };
  const auto room = [](std::size_t capacity) { return static_cast<std::uint32_t>(capacity); };
  const Links& links = mesh.links();
  layout_words = {at(links.next.data()),
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
                  mesh.stores_prev(),
                  room(mesh.capacity(ItemKind::kVertex)),
                  room(mesh.capacity(ItemKind::kHalfedge)),
                  room(mesh.capacity(ItemKind::kFace))};
}

// ---- reports ---------------------------------------------------------------------------------

inline val to_array(const std::vector<Index>& indices) {
  return val(emscripten::typed_memory_view(indices.size(), indices.data())).call<val>("slice");
}

inline val to_problem(const Error& error) {
  val problem = val::object();
  problem.set("code", std::string(error.code));
  problem.set("message", error.message);
  problem.set("vertices", to_array(error.witness.vertices));
  problem.set("halfedges", to_array(error.witness.halfedges));
  problem.set("edges", to_array(error.witness.edges));
  problem.set("faces", to_array(error.witness.faces));
  return problem;
}

/// What a call returns that failed: `problems`, and how many there are, listed or not.
inline val failure(std::span<const Error> errors, std::size_t count) {
  const RoomForReport room;
  val problems = val::array();
  for (const Error& error : errors) problems.call<void>("push", to_problem(error));
  val result = val::object();
  result.set("problems", problems);
  result.set("problemCount", count);
  return result;
}
inline val failure(const Error& error) { return failure({&error, 1}, 1); }

inline val success(const char* name, const val& value) {
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

/// What `validate` found.
inline val to_list(std::span<const Problem> problems) {
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

inline Error no_room_for_a_mesh() { return no_memory_for("a mesh"); }

}  // namespace halfedge::bindings
