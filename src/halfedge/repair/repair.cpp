#include <halfedge/build/connect.h>
#include <halfedge/build/diagnose.h>
#include <halfedge/build/strict.h>
#include <halfedge/repair/repair.h>
#include <halfedge/repair/soup.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace halfedge {

namespace {

using repair::Faces;
using repair::Log;
using repair::Surface;
using repair::Vertices;
using sentence::count_of;

bool sizes_add_up(const Polygons& polygons) {
  const std::size_t corners = polygons.corners.size();
  std::uint64_t sum = polygons.sizes.empty() ? corners - corners % 3 : 0;
  for (const Index size : polygons.sizes) sum += size;
  return polygons.positions.size() % 3 == 0 && polygons.vertex_count() <= kMaxSlots &&
         corners <= kMaxSlots && polygons.face_count() <= kMaxSlots && sum == corners;
}

// One repair, from the input to the links of the mesh.
class Repair {
 public:
  Repair(Mesh& mesh, const Polygons& input, const RepairOptions& options, RepairReport& report)
      : mesh_(mesh), input_(input), options_(options), report_(report), log_(report) {}

  [[nodiscard]] bool cancelled() const { return cancelled_; }

  [[nodiscard]] ConnectResult run() {
    if (!go_on(Stage::kBuild, 0)) return ConnectResult::kOutOfMemory;
    if (!options_.weld) {
      const ConnectResult result = take_as_it_is();
      if (result != ConnectResult::kNotManifold) return result;
    }
    if (!log_.begin(input_.face_count()) ||
        !repair::weld(input_.positions, options_.weld, vertices_))
      return ConnectResult::kOutOfMemory;
    if (!repair::clean(input_, vertices_, log_, faces_)) return ConnectResult::kOutOfMemory;
    report_welded();

    // As a rule that is all. Only if the faces make no manifold, all of them are looked into.
    if (!write_sizes() || !number_vertices()) return ConnectResult::kOutOfMemory;
    ConnectResult result = connect_now();
    if (result == ConnectResult::kNotManifold) {
      if (!mend() || !write_sizes() || !number_vertices()) return ConnectResult::kOutOfMemory;
      result = connect_now();
      assert(result != ConnectResult::kNotManifold);
    }
    if (result != ConnectResult::kDone) return result;
    report_isolated();
    return write_maps() && log_.finish(options_, copies_.size()) ? ConnectResult::kDone
                                                                 : ConnectResult::kOutOfMemory;
  }

 private:
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size() + copies_.size(); }
  // The vertex of the input whose position a vertex has.
  [[nodiscard]] Index origin(Index v) const {
    return vertices_.origin[v < vertices_.size() ? v : copies_[v - vertices_.size()]];
  }

  // Most input needs no repair: this is the strict builder, without its reasons.
  [[nodiscard]] ConnectResult take_as_it_is() {
    if (!can_be_connected(input_)) return ConnectResult::kNotManifold;
    ConnectResult result = connect<true>(input_, mesh_.mutable_links());
    if (result == ConnectResult::kDone) {
      result = copy_positions(input_.positions, mesh_.mutable_positions());
    }
    if (result != ConnectResult::kDone) return result;
    const Array<Index>& anchors = mesh_.links().vertex_halfedge;
    isolated_ = std::size_t(std::count(anchors.begin(), anchors.end(), kNone));
    if (isolated_ > 0 && options_.drop_isolated) return ConnectResult::kNotManifold;
    std::vector<Index> first;
    for (Index v = 0; v < anchors.size() && first.size() < std::min(isolated_, kWitnesses); ++v) {
      if (anchors[v] == kNone) first.push_back(v);
    }
    report_isolated(first);
    const bool fits = fill_with_identity(report_.vertex_map, input_.vertex_count()) &&
                      fill_with_identity(report_.vertex_origin, input_.vertex_count()) &&
                      fill_with_identity(report_.face_map, input_.face_count()) &&
                      log_.finish(options_, 0);
    return fits ? ConnectResult::kDone : ConnectResult::kOutOfMemory;
  }
  [[nodiscard]] static bool fill_with_identity(Array<Index>& map, std::size_t size) {
    if (!map.recreate(size)) return false;
    for (Index i = 0; i < size; ++i) map[i] = i;
    return true;
  }

  // Makes the faces a manifold: afterwards faces_ has those that are left, over all the vertices.
  [[nodiscard]] bool mend() {
    mesh_.clear();
    Surface surface;
    repair::Crowds crowds;
    Array<Index> vertex_of;
    return go_on(Stage::kRepair, 0) && repair::arrange(input_, vertices_, faces_, surface) &&
           go_on(Stage::kRepair, 0.2) && repair::match(surface, faces_, log_, crowds) &&
           go_on(Stage::kRepair, 0.5) && repair::orient(surface, faces_, log_) &&
           go_on(Stage::kRepair, 0.7) && repair::match_crowds(surface, crowds) &&
           repair::split_vertices(surface, crowds, faces_, log_, vertex_of, copies_) &&
           take_back(surface, vertex_of) && go_on(Stage::kRepair, 1);
  }
  // False if whoever follows the progress cancels. The steps end then as for want of memory.
  [[nodiscard]] bool go_on(Stage stage, double fraction) {
    cancelled_ = !options_.progress(stage, fraction);
    return !cancelled_;
  }

  // Copies the surface to faces_, in the order of the input and with the corners they start at.
  [[nodiscard]] bool take_back(const Surface& surface, const Array<Index>& vertex_of) {
    Array<Index> place;
    if (!place.resize(faces_.size(), kNone)) return false;
    for (Index f = 0; f < surface.faces.size(); ++f) place[surface.faces.source[f]] = f;
    Index kept = 0;
    Index corners = 0;
    for (Index f = 0; f < faces_.size(); ++f) {
      if (place[f] == kNone) continue;
      const Index begin = surface.faces.first[place[f]];
      const Index end = surface.faces.first[place[f] + 1];
      std::copy(vertex_of.begin() + begin, vertex_of.begin() + end,
                faces_.corners.begin() + corners);
      if (surface.flipped[place[f]]) {
        std::reverse(faces_.corners.begin() + corners + 1,
                     faces_.corners.begin() + corners + (end - begin));
      }
      faces_.source[kept] = faces_.source[f];
      faces_.first[kept++] = corners;
      corners += end - begin;
    }
    faces_.first[kept] = corners;
    // No more than there were: these can't fail.
    (void)faces_.first.resize(kept + std::size_t{1});
    (void)faces_.source.resize(kept);
    (void)faces_.corners.resize(corners);
    return true;
  }

  // None, if all are triangles.
  [[nodiscard]] bool write_sizes() {
    sizes_.clear();
    if (faces_.corners.size() == 3 * faces_.size() && input_.sizes.empty()) return true;
    if (!sizes_.recreate(faces_.size())) return false;
    for (Index f = 0; f < faces_.size(); ++f) sizes_[f] = faces_.first[f + 1] - faces_.first[f];
    return true;
  }

  // The vertices of the mesh: all, or those with faces.
  [[nodiscard]] bool number_vertices() {
    if (!number_.resize(vertex_count())) return false;
    std::fill(number_.begin(), number_.end(), kNone);
    for (const Index v : faces_.corners) number_[v] = 0;
    isolated_ = std::size_t(std::count(number_.begin(), number_.end(), kNone));
    Index count = 0;
    for (Index& number : number_) {
      if (number == 0 || !options_.drop_isolated) number = count++;
    }
    Array<float>& positions = mesh_.mutable_positions();
    if (!positions.recreate(3 * std::size_t{count})) return false;
    for (Index v = 0; v < number_.size(); ++v) {
      if (number_[v] == kNone) continue;
      const float* p = &input_.positions[3 * std::size_t{origin(v)}];
      std::copy(p, p + 3, &positions[3 * std::size_t{number_[v]}]);
    }
    return true;
  }

  [[nodiscard]] ConnectResult connect_now() {
    const bool renumbered = options_.drop_isolated && isolated_ > 0;
    Array<Index> corners;
    if (renumbered) {
      if (!corners.recreate(faces_.corners.size())) return ConnectResult::kOutOfMemory;
      for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = number_[faces_.corners[c]];
    }
    const Polygons polygons{mesh_.positions(), sizes_.span(),
                            renumbered ? corners.span() : faces_.corners.span()};
    return connect<true>(polygons, mesh_.mutable_links());
  }

  // ---- the report

  void report_welded() {
    if (!options_.weld) return;
    std::size_t welded = 0;
    std::vector<Index> first;
    for (Index v = 0; v < vertices_.of_input.size(); ++v) {
      const Index own = vertices_.of_input[v];
      if (own == kNone || vertices_.origin[own] == v) continue;
      if (++welded <= kWitnesses) first.push_back(v);
    }
    if (welded == 0) return;
    log_.add(RepairCode::kCoincidentPosition, [&] {
      return Error{{},
                   sentence::of("{}{} welded to another {}: {}.", count_of(welded, "vertex"),
                                welded == 1 ? " was" : " were", where(), sentence::list_of(first)),
                   {.vertices = first}};
    });
    log_.add_more(RepairCode::kCoincidentPosition, welded - 1);
  }
  [[nodiscard]] std::string where() const {
    if (*options_.weld == 0) return "at the same position";
    return sentence::of("closer than {}", sentence::number(*options_.weld));
  }

  void report_isolated() {
    std::vector<Index> first;
    for (Index v = 0; v < vertex_count() && first.size() < std::min(isolated_, kWitnesses); ++v) {
      if (is_isolated(v)) first.push_back(origin(v));
    }
    report_isolated(first);
  }
  void report_isolated(const std::vector<Index>& first) {
    if (isolated_ == 0) return;
    log_.add(RepairCode::kIsolatedVertex, [&] {
      return Error{{},
                   sentence::of("{}{} no faces{}: {}.", count_of(isolated_, "vertex"),
                                isolated_ == 1 ? " has" : " have",
                                !options_.drop_isolated ? ""
                                : isolated_ == 1        ? ", and was left out"
                                                        : ", and were left out",
                                sentence::list_of(first)),
                   {.vertices = first}};
    });
    log_.add_more(RepairCode::kIsolatedVertex, isolated_ - 1);
  }
  [[nodiscard]] bool is_isolated(Index v) const {
    return options_.drop_isolated ? number_[v] == kNone
                                  : mesh_.links().vertex_halfedge[number_[v]] == kNone;
  }

  [[nodiscard]] bool write_maps() {
    if (!report_.vertex_map.resize(input_.vertex_count(), kNone) ||
        !report_.vertex_origin.recreate(mesh_.vertex_slots()) ||
        !report_.face_map.resize(input_.face_count(), kNone)) {
      return false;
    }
    for (std::size_t v = 0; v < input_.vertex_count(); ++v) {
      const Index own = vertices_.of_input[v];
      if (own != kNone) report_.vertex_map[v] = number_[own];
    }
    for (Index v = 0; v < number_.size(); ++v) {
      if (number_[v] != kNone) report_.vertex_origin[number_[v]] = origin(v);
    }
    for (Index f = 0; f < faces_.size(); ++f) report_.face_map[faces_.source[f]] = f;
    return true;
  }

  static constexpr std::size_t kWitnesses = 100;

  Mesh& mesh_;
  const Polygons& input_;
  const RepairOptions& options_;
  RepairReport& report_;
  Log log_;
  Vertices vertices_;
  Array<Index> copies_;  // what vertices beyond those are copies of
  Faces faces_;
  Array<Index> sizes_;
  Array<Index> number_;  // by vertex: that of the mesh, or kNone
  std::size_t isolated_ = 0;
  bool cancelled_ = false;
};

bool fail(RepairReport& report, const char* code, std::string message) {
  report = {};
  report.problems.emplace_back(code, std::move(message));
  return false;
}

}  // namespace

bool build_from_soup(Mesh& mesh, const Polygons& polygons, const RepairOptions& options,
                     RepairReport& report) {
  report = {};
  mesh.clear();
  if (!sizes_add_up(polygons)) {
    BuildReport reasons;
    diagnose(polygons, reasons);
    report.problems = std::move(reasons.problems);
    assert(!report.problems.empty());
    return false;
  }
  if (options.weld && !(*options.weld >= 0 && std::isfinite(*options.weld))) {
    return fail(report, "bad-tolerance",
                sentence::of("The tolerance of welding is {}; expected a finite number from 0.",
                             sentence::number(*options.weld)));
  }
  Repair repair(mesh, polygons, options, report);
  ConnectResult result = repair.run();
  if (result == ConnectResult::kDone && !mesh.fit_attributes()) {
    result = ConnectResult::kOutOfMemory;
  }
  if (result == ConnectResult::kDone) return true;
  mesh.clear();
  if (repair.cancelled()) return fail(report, "cancelled", "The repair was cancelled.");
  switch (result) {
    case ConnectResult::kDone:
    case ConnectResult::kNotManifold:
      return fail(report, "not-manifold", "The repaired faces make no manifold, which is a bug.");
    case ConnectResult::kTooLarge:
      return fail(
          report, "too-large",
          sentence::of(
              "A mesh of these faces needs more than the {} halfedges that a mesh can have.",
              kMaxSlots));
    case ConnectResult::kOutOfMemory:
      return fail(report, "out-of-memory",
                  sentence::of("There is not enough memory for repairing a mesh of {} and {}.",
                               count_of(polygons.vertex_count(), "vertex"),
                               count_of(polygons.face_count(), "face")));
  }
  return false;
}

}  // namespace halfedge
