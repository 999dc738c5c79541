#include "loops.h"

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>
#include <halfedge/mesh.h>
#include <halfedge/repair/repair.h>
#include <halfedge/validate/validate.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "edits.h"
#include "meshes.h"
#include "variant.h"

namespace {

using namespace halfedge;

void require(bool done) {
  if (!done) std::abort();
}

// The sum is not used: this keeps the compiler from leaving its loop out.
void use(std::uint64_t sum) {
  [[maybe_unused]] static volatile std::uint64_t sink;
  sink = sum;
}

// The loops of the benchmark, of ours or of the baseline.
void add_contender(std::vector<Loop>& loops, std::unique_ptr<Contender> (*make)(),
                   const TriangleMesh& input, const std::string& order) {
  const std::shared_ptr<Contender> mesh = make();
  const auto add = [&](const std::string& name, std::function<void()> run,
                       std::function<void()> prepare = {}) {
    loops.push_back(
        {name + order, name + order, input.face_count(), std::move(run), std::move(prepare)});
  };
  mesh->build(input);  // so that the loop finds its memory
  mesh->keep();
  add("build", [mesh, &input] { mesh->build(input); });
  add("circulator", [mesh] { use(std::uint64_t(mesh->circulate())); });
  add("one-ring sum", [mesh] { use(mesh->one_ring_sum()); });
  const auto restore = [mesh] { mesh->restore(); };
  add(
      "sqrt(3) step", [mesh] { mesh->subdivide(); }, restore);
  add(
      "split and collapse", [mesh] { mesh->split_and_collapse(); }, restore);
  add(
      "compaction", [mesh] { mesh->compact(); },
      [mesh] {
        mesh->restore();
        mesh->split_and_collapse();
      });
}

void add_ccw(std::vector<Loop>& loops, const std::shared_ptr<Variant>& mesh,
             const TriangleMesh& input, const std::string& variant) {
  loops.push_back({"one-ring sum, ccw" + variant, "one-ring sum", input.face_count(),
                   [mesh] { use(mesh->one_ring_sum_ccw()); }});
}

// Of a mesh type that the benchmark's loops aren't of.
void add_variant(std::vector<Loop>& loops, const std::shared_ptr<Variant>& mesh,
                 const TriangleMesh& input, const std::string& variant) {
  const auto add = [&](const std::string& name, std::function<void()> run) {
    loops.push_back({name + variant, name, input.face_count(), std::move(run)});
  };
  mesh->build(input);
  add("build", [mesh, &input] { mesh->build(input); });
  add("circulator", [mesh] { use(std::uint64_t(mesh->circulate())); });
  add("one-ring sum", [mesh] { use(mesh->one_ring_sum()); });
  add_ccw(loops, mesh, input, variant);
}

void add_edits(std::vector<Loop>& loops, const TriangleMesh& input) {
  const auto mesh = std::make_shared<EditedMesh>(input);
  for (const Edit& edit : edits()) {
    for (const bool has_history : {false, true}) {
      loops.push_back({std::string(edit.name) + (has_history ? ", with history" : ""),
                       "split and collapse", input.face_count(), [mesh, edit] { mesh->run(edit); },
                       [mesh, edit, has_history] { mesh->prepare(edit, has_history); }});
    }
  }
}

void add_passes(std::vector<Loop>& loops, const TriangleMesh& input) {
  const auto mesh = std::make_shared<Mesh>();
  BuildReport report;
  require(build_from_polygons(*mesh, {input.positions, {}, input.corners}, report));
  const auto rows = std::make_shared<Adjacency>();
  for (const auto& [name, ring] :
       {std::pair("rows of one-rings", Ring::kVertexVertices),
        std::pair("rows of the faces of vertices", Ring::kVertexFaces),
        std::pair("rows of the neighbours of faces", Ring::kFaceFaces)}) {
    loops.push_back({name, "one-ring sum", input.face_count(), [mesh, rows, kind = ring] {
                       require(bool(adjacency(*mesh, kind, Direction::kCcw, *rows)));
                     }});
  }
  loops.push_back(
      {"validate", "circulator", input.face_count(), [mesh] { require(validate(*mesh).empty()); }});
}

void add_files(std::vector<Loop>& loops, const TriangleMesh& input) {
  Mesh mesh;
  BuildReport report;
  require(build_from_polygons(mesh, {input.positions, {}, input.corners}, report));
  struct File {
    const char* name;
    Format format;
    Encoding encoding;
  };
  for (const File& file :
       {File{"binary PLY", Format::kPly, Encoding::kBinary},
        File{"text PLY", Format::kPly, Encoding::kText}, File{"OBJ", Format::kObj, Encoding::kText},
        File{"OFF", Format::kOff, Encoding::kText},
        File{"binary STL", Format::kStl, Encoding::kBinary}}) {
    auto written = write(mesh, file.format, {.encoding = file.encoding});
    require(bool(written));
    const auto bytes = std::make_shared<Array<std::uint8_t>>(std::move(written.value()));
    loops.push_back({std::string("read ") + file.name, "build", input.face_count(),
                     [bytes] { require(bool(parse(bytes->span()))); }});
  }
  const auto target = std::make_shared<Mesh>();
  loops.push_back({"repair, welding", "build", input.face_count(), [target, &input] {
                     RepairReport repaired;
                     const Polygons polygons{input.positions, {}, input.corners};
                     require(build_from_soup(*target, polygons, {.weld = 0.0}, repaired));
                   }});
}

}  // namespace

std::vector<Loop> flat_loops(const TriangleMesh& natural, const TriangleMesh& shuffled) {
  std::vector<Loop> loops;
  add_contender(loops, make_flat, natural, "");
  add_contender(loops, make_flat, shuffled, ", shuffled");
  return loops;
}

std::vector<Loop> guarded_loops(const TriangleMesh& natural, const TriangleMesh& shuffled) {
  static const TriangleMesh hubs = bipyramid(10'000);
  std::vector<Loop> loops;
  add_contender(loops, make_halfedge, natural, "");
  add_contender(loops, make_halfedge, shuffled, ", shuffled");
  const std::shared_ptr<Contender> around_hubs = make_halfedge();
  around_hubs->build(hubs);
  loops.push_back({"build, around two vertices", "build", hubs.face_count(),
                   [around_hubs] { around_hubs->build(hubs); }});
  const auto everything = std::make_shared<VariantOf<Mesh>>();
  everything->build(natural);
  add_ccw(loops, everything, natural, "");
  add_variant(loops, std::make_shared<VariantOf<BasicMesh<kWithoutPrev>>>(), natural,
              ", without prev");
  add_variant(loops, std::make_shared<VariantOf<DirectedEdgesMesh>>(), natural, ", Directed Edges");
  add_edits(loops, natural);
  add_passes(loops, natural);
  add_files(loops, natural);
  return loops;
}
