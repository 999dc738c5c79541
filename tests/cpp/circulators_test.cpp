#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/directed_edges/directed_edges.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/deletion.h>

#include <algorithm>
#include <concepts>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>
#include <version>

#include "support/built.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

// ---- what the types promise ---------------------------------------------------------------------

template <class Range>
constexpr bool kIsForwardRange = std::forward_iterator<typename Range::Iterator>&&
    std::sentinel_for<std::default_sentinel_t, typename Range::Iterator>&&
        std::same_as<decltype(std::declval<const Range&>().begin()), typename Range::Iterator>;

template <class Range>
constexpr bool kCirculates = kIsForwardRange<Range>&&
    std::bidirectional_iterator<decltype(std::declval<Range>().circulator())>;

using M = Mesh;
static_assert(kCirculates<decltype(std::declval<M>().outgoing_cw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().outgoing_ccw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().incoming_cw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().vertex_vertices_ccw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().vertex_edges_cw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().vertex_faces_ccw(Vertex{}))>);
static_assert(kCirculates<decltype(std::declval<M>().face_vertices_ccw(Face{}))>);
static_assert(kCirculates<decltype(std::declval<M>().face_halfedges_cw(Face{}))>);
static_assert(kCirculates<decltype(std::declval<M>().face_edges_ccw(Face{}))>);
static_assert(kCirculates<decltype(std::declval<M>().face_faces_cw(Face{}))>);
static_assert(kCirculates<decltype(std::declval<M>().edge_vertices(Edge{}))>);
static_assert(kCirculates<decltype(std::declval<M>().edge_halfedges(Edge{}))>);
static_assert(kCirculates<decltype(std::declval<M>().edge_faces(Edge{}))>);
static_assert(kCirculates<decltype(std::declval<M>().loop_ccw(Halfedge{}))>);
static_assert(kCirculates<decltype(std::declval<M>().loop_cw(Halfedge{}))>);
static_assert(kIsForwardRange<decltype(std::declval<M>().vertices())>);
static_assert(kIsForwardRange<decltype(std::declval<M>().halfedges())>);
static_assert(kIsForwardRange<decltype(std::declval<M>().edges())>);
static_assert(kIsForwardRange<decltype(std::declval<M>().faces())>);

// Their references are values, which `->` gives a life as long as the expression.
template <class Iterator>
constexpr bool kHasArrow = requires(const Iterator& at) {
  { at->index() } -> std::same_as<Index>;
  { at->valid() } -> std::same_as<bool>;
};
static_assert(kHasArrow<decltype(std::declval<M>().vertices().begin())>);
static_assert(kHasArrow<decltype(std::declval<M>().outgoing_cw(Vertex{}).begin())>);
static_assert(kHasArrow<decltype(std::declval<M>().edge_faces(Edge{}).begin())>);
static_assert(kHasArrow<decltype(std::declval<M>().face_vertices_ccw(Face{}).circulator())>);
static_assert(std::same_as<std::iterator_traits<decltype(M{}.faces().begin())>::reference, Face>);

#if defined(__cpp_lib_ranges)
// Views and borrowed ranges own nothing, and their iterators need no range: so they can be piped
// into std::views as values, and what std::ranges::find gives of a temporary one is an iterator.
template <class Range>
constexpr bool kIsBorrowedView = std::ranges::view<Range>&& std::ranges::borrowed_range<Range>&&
    std::ranges::forward_range<const Range>;
static_assert(kIsBorrowedView<decltype(std::declval<M>().outgoing_ccw(Vertex{}))>);
static_assert(kIsBorrowedView<decltype(std::declval<M>().edge_faces(Edge{}))>);
static_assert(kIsBorrowedView<decltype(std::declval<M>().faces())>);
static_assert(kIsBorrowedView<decltype(std::declval<DirectedEdgesMesh>().vertices())>);
static_assert(kIsBorrowedView<decltype(std::declval<DirectedEdgesMesh>().face_faces_cw(Face{}))>);
#endif

template <class Range>
using ItemOf = std::iter_value_t<typename Range::Iterator>;
static_assert(std::same_as<ItemOf<decltype(std::declval<M>().vertex_faces_cw(Vertex{}))>, Face>);
static_assert(std::same_as<ItemOf<decltype(std::declval<M>().face_edges_cw(Face{}))>, Edge>);

template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
};
static_assert(Comparable<Vertex, Vertex> && !Comparable<Vertex, Face>);
static_assert(!Comparable<Halfedge, Edge> && !Comparable<Vertex, Index>);
static_assert(!std::is_convertible_v<Index, Vertex> && !std::is_convertible_v<Vertex, Index>);
static_assert(!std::is_convertible_v<Vertex, bool>);
static_assert(sizeof(Halfedge) == sizeof(Index) && std::is_trivially_copyable_v<Halfedge>);
static_assert(!Vertex{}.valid() && Vertex(0).valid() && Vertex(1) < Vertex(2));

// ---- helpers --------------------------------------------------------------------------------

template <class Range>
auto collect(const Range& range) {
  std::vector<ItemOf<Range>> items;
  for (const auto item : range) items.push_back(item);
  return items;
}

template <class Item>
std::vector<Item> reversed(std::vector<Item> items) {
  std::reverse(items.begin(), items.end());
  return items;
}

// "5>6 1>0*": halfedges by their ends, * for those without a face.
std::string text(const Mesh& mesh, const std::vector<Halfedge>& halfedges) {
  std::string text;
  for (const Halfedge h : halfedges) {
    text += (text.empty() ? "" : " ") + std::to_string(mesh.from_vertex(h).index()) + ">" +
            std::to_string(mesh.to_vertex(h).index()) + (mesh.is_boundary(h) ? "*" : "");
  }
  return text;
}
template <class Item>
std::string text(const Mesh&, const std::vector<Item>& items) {
  std::string text;
  for (const Item item : items) text += (text.empty() ? "" : " ") + std::to_string(item.index());
  return text;
}

std::vector<Shape> many_shapes() {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 20; ++seed) shapes.push_back(random_polygons(seed));
  return shapes;
}

// ---- order ----------------------------------------------------------------------------------

TEST(Circulators, FollowTheTableOfTheFourByFourGrid) {
  const Mesh mesh = built(quad_grid(3, 3));
  const auto shown = [&](const auto& range) { return text(mesh, collect(range)); };
  EXPECT_EQ(shown(mesh.outgoing_cw(Vertex(5))), "5>6 5>1 5>4 5>9");
  EXPECT_EQ(shown(mesh.outgoing_ccw(Vertex(5))), "5>9 5>4 5>1 5>6");
  EXPECT_EQ(shown(mesh.outgoing_cw(Vertex(1))), "1>0* 1>5 1>2");
  EXPECT_EQ(shown(mesh.outgoing_ccw(Vertex(1))), "1>2 1>5 1>0*");
  EXPECT_EQ(shown(mesh.incoming_cw(Vertex(1))), "0>1 5>1 2>1*");
  EXPECT_EQ(shown(mesh.incoming_ccw(Vertex(1))), "2>1* 5>1 0>1");
  EXPECT_EQ(shown(mesh.vertex_vertices_cw(Vertex(1))), "0 5 2");
  EXPECT_EQ(shown(mesh.vertex_vertices_ccw(Vertex(1))), "2 5 0");
  EXPECT_EQ(shown(mesh.vertex_faces_cw(Vertex(1))), "0 1");
  EXPECT_EQ(shown(mesh.vertex_faces_ccw(Vertex(1))), "1 0");
  EXPECT_EQ(shown(mesh.face_faces_ccw(Face(0))), "1 3");
  EXPECT_EQ(shown(mesh.face_faces_ccw(Face(4))), "3 1 5 7");
  EXPECT_EQ(shown(mesh.face_vertices_ccw(Face(4))), "5 6 10 9");
  EXPECT_EQ(shown(mesh.face_halfedges_ccw(Face(4))), "9>5 5>6 6>10 10>9");
}

TEST(Circulators, AroundAVertexShowWhatLeavesItFromTheAnchorClockwiseAndBack) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    for (const Vertex v : mesh.vertices()) {
      std::vector<Halfedge> outgoing;
      std::vector<Halfedge> incoming;
      std::vector<Vertex> vertices;
      std::vector<Edge> edges;
      std::vector<Face> faces;
      const Halfedge anchor = mesh.vertex_halfedge(v);
      for (Halfedge h = anchor; h.valid();) {
        outgoing.push_back(h);
        incoming.push_back(mesh.opposite(h));
        vertices.push_back(mesh.to_vertex(h));
        edges.push_back(mesh.edge(h));
        if (!mesh.is_boundary(h)) faces.push_back(mesh.face(h));
        h = mesh.next(mesh.opposite(h));
        if (h == anchor) break;
      }
      EXPECT_EQ(collect(mesh.outgoing_cw(v)), outgoing);
      EXPECT_EQ(collect(mesh.outgoing_ccw(v)), reversed(outgoing));
      EXPECT_EQ(collect(mesh.incoming_cw(v)), incoming);
      EXPECT_EQ(collect(mesh.incoming_ccw(v)), reversed(incoming));
      EXPECT_EQ(collect(mesh.vertex_vertices_cw(v)), vertices);
      EXPECT_EQ(collect(mesh.vertex_vertices_ccw(v)), reversed(vertices));
      EXPECT_EQ(collect(mesh.vertex_edges_cw(v)), edges);
      EXPECT_EQ(collect(mesh.vertex_edges_ccw(v)), reversed(edges));
      EXPECT_EQ(collect(mesh.vertex_faces_cw(v)), faces);
      EXPECT_EQ(collect(mesh.vertex_faces_ccw(v)), reversed(faces));
      EXPECT_EQ(mesh.valence(v), outgoing.size());
    }
  }
}

TEST(Circulators, AroundAFaceShowItsCornersInTheOrderOfTheInputAndBack) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    for (const Face f : mesh.faces()) {
      std::vector<Vertex> vertices;
      for (const Index v : shape.faces[f.index()]) vertices.push_back(Vertex(v));
      std::vector<Halfedge> halfedges;
      std::vector<Edge> edges;
      std::vector<Face> faces;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vertex before = vertices[(i + vertices.size() - 1) % vertices.size()];
        Halfedge h = mesh.find_halfedge(before, vertices[i]);
        halfedges.push_back(h);
        edges.push_back(mesh.edge(h));
        const Face neighbour = mesh.face(mesh.opposite(h));
        if (neighbour.valid()) faces.push_back(neighbour);
      }
      EXPECT_EQ(collect(mesh.face_vertices_ccw(f)), vertices);
      EXPECT_EQ(collect(mesh.face_vertices_cw(f)), reversed(vertices));
      EXPECT_EQ(collect(mesh.face_halfedges_ccw(f)), halfedges);
      EXPECT_EQ(collect(mesh.face_halfedges_cw(f)), reversed(halfedges));
      EXPECT_EQ(collect(mesh.face_edges_ccw(f)), edges);
      EXPECT_EQ(collect(mesh.face_edges_cw(f)), reversed(edges));
      EXPECT_EQ(collect(mesh.face_faces_ccw(f)), faces);
      EXPECT_EQ(collect(mesh.face_faces_cw(f)), reversed(faces));
      EXPECT_EQ(mesh.degree(f), vertices.size());
    }
  }
}

TEST(Circulators, RepeatANeighbourThatIsSharedAcrossSeveralEdges) {
  const Mesh mesh = built(pillow());
  EXPECT_EQ(collect(mesh.face_faces_ccw(Face(0))), std::vector<Face>(3, Face(1)));
}

TEST(Circulators, OfAnEdgeShowSideZeroFirst) {
  const Mesh mesh = built(triangle());
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e, 0);
    const Halfedge o = mesh.edge_halfedge(e, 1);
    EXPECT_EQ(collect(mesh.edge_halfedges(e)), (std::vector<Halfedge>{h, o}));
    EXPECT_EQ(collect(mesh.edge_vertices(e)),
              (std::vector<Vertex>{mesh.to_vertex(h), mesh.to_vertex(o)}));
    EXPECT_EQ(collect(mesh.edge_faces(e)), std::vector<Face>{Face(0)});
  }
  const Mesh closed = built(pillow());
  for (const Edge e : closed.edges()) {
    EXPECT_EQ(collect(closed.edge_faces(e)),
              (std::vector<Face>{closed.face(closed.edge_halfedge(e, 0)),
                                 closed.face(closed.edge_halfedge(e, 1))}));
  }
}

TEST(Circulators, OfALoopBeginAtTheHalfedgeInBothDirections) {
  const Mesh mesh = built(quad_grid(3, 3));
  for (const Halfedge h : mesh.halfedges()) {
    std::vector<Halfedge> loop = {h};
    for (Halfedge n = mesh.next(h); n != h; n = mesh.next(n)) loop.push_back(n);
    EXPECT_EQ(collect(mesh.loop_ccw(h)), loop);
    std::reverse(loop.begin() + 1, loop.end());
    EXPECT_EQ(collect(mesh.loop_cw(h)), loop);
    EXPECT_EQ(loop.size(), mesh.is_boundary(h) ? 12U : 4U);
  }
}

TEST(Circulators, BeginAtAnExplicitStartInBothDirections) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    for (const Halfedge start : mesh.halfedges()) {
      const Vertex v = mesh.from_vertex(start);
      std::vector<Halfedge> cw = collect(mesh.outgoing_cw(v));
      std::rotate(cw.begin(), std::find(cw.begin(), cw.end(), start), cw.end());
      std::vector<Halfedge> ccw = reversed(cw);
      std::rotate(ccw.begin(), ccw.end() - 1, ccw.end());
      EXPECT_EQ(collect(mesh.outgoing_cw(v, start)), cw);
      EXPECT_EQ(collect(mesh.outgoing_ccw(v, start)), ccw);
      EXPECT_EQ(collect(mesh.incoming_ccw(v, start))[0], mesh.opposite(start));
      EXPECT_EQ(collect(mesh.incoming_cw(v, start))[0], mesh.opposite(start));
      EXPECT_EQ(collect(mesh.vertex_vertices_cw(v, start))[0], mesh.to_vertex(start));
      EXPECT_EQ(collect(mesh.vertex_vertices_ccw(v, start))[0], mesh.to_vertex(start));
      EXPECT_EQ(collect(mesh.vertex_edges_cw(v, start))[0], mesh.edge(start));
      EXPECT_EQ(collect(mesh.vertex_edges_ccw(v, start))[0], mesh.edge(start));
      if (mesh.is_boundary(start)) continue;
      EXPECT_EQ(collect(mesh.vertex_faces_cw(v, start))[0], mesh.face(start));
      EXPECT_EQ(collect(mesh.vertex_faces_ccw(v, start))[0], mesh.face(start));
      const Face f = mesh.face(start);
      EXPECT_EQ(collect(mesh.face_halfedges_ccw(f, start)), collect(mesh.loop_ccw(start)));
      EXPECT_EQ(collect(mesh.face_halfedges_cw(f, start)), collect(mesh.loop_cw(start)));
      EXPECT_EQ(collect(mesh.face_vertices_ccw(f, start))[0], mesh.to_vertex(start));
      EXPECT_EQ(collect(mesh.face_vertices_cw(f, start))[0], mesh.to_vertex(start));
      EXPECT_EQ(collect(mesh.face_edges_ccw(f, start))[0], mesh.edge(start));
      EXPECT_EQ(collect(mesh.face_edges_cw(f, start))[0], mesh.edge(start));
      const Face neighbour = mesh.face(mesh.opposite(start));
      if (!neighbour.valid()) continue;
      EXPECT_EQ(collect(mesh.face_faces_ccw(f, start))[0], neighbour);
      EXPECT_EQ(collect(mesh.face_faces_cw(f, start))[0], neighbour);
    }
  }
}

TEST(Circulators, SkipMissingFacesAtAnExplicitStart) {
  const Mesh mesh = built(quad_grid(3, 3));
  const Halfedge boundary = mesh.vertex_halfedge(Vertex(1));  // 1>0*
  EXPECT_EQ(text(mesh, collect(mesh.vertex_faces_cw(Vertex(1), boundary))), "0 1");
  EXPECT_EQ(text(mesh, collect(mesh.vertex_faces_ccw(Vertex(1), boundary))), "1 0");
  const Halfedge bottom = mesh.find_halfedge(Vertex(0), Vertex(1));
  EXPECT_EQ(text(mesh, collect(mesh.face_faces_ccw(Face(0), bottom))), "1 3");
  EXPECT_EQ(text(mesh, collect(mesh.face_faces_cw(Face(0), bottom))), "3 1");
}

TEST(Circulators, AreEmptyAtAnIsolatedVertex) {
  const Mesh mesh = built(with_isolated_vertices());
  const Vertex v(3);
  const auto expect_empty = [](const auto& range) {
    EXPECT_TRUE(range.empty());
    EXPECT_TRUE(range.begin() == range.end());
    EXPECT_FALSE(range.circulator().valid());
    EXPECT_EQ(collect(range).size(), 0U);
  };
  expect_empty(mesh.outgoing_cw(v));
  expect_empty(mesh.outgoing_ccw(v));
  expect_empty(mesh.incoming_cw(v));
  expect_empty(mesh.incoming_ccw(v));
  expect_empty(mesh.vertex_vertices_cw(v));
  expect_empty(mesh.vertex_vertices_ccw(v));
  expect_empty(mesh.vertex_edges_cw(v));
  expect_empty(mesh.vertex_edges_ccw(v));
  expect_empty(mesh.vertex_faces_cw(v));
  expect_empty(mesh.vertex_faces_ccw(v));
}

TEST(Circulators, AreEmptyWhereNoSideHasAFace) {
  const Mesh mesh = built(triangle());
  EXPECT_TRUE(mesh.face_faces_ccw(Face(0)).empty());
  EXPECT_TRUE(mesh.face_faces_cw(Face(0)).empty());
  EXPECT_FALSE(mesh.face_faces_ccw(Face(0)).circulator().valid());
}

// ---- the two forms --------------------------------------------------------------------------

// The endless form goes round and round in the order of the range, and back.
template <class Range>
void expect_endless(const Range& range) {
  const auto lap = collect(range);
  auto at = range.circulator();
  ASSERT_EQ(at.valid(), !lap.empty());
  if (lap.empty()) return;
  const auto start = at;
  for (int round = 0; round < 3; ++round) {
    for (const auto item : lap) {
      EXPECT_EQ(*at, item);
      const auto before = at++;
      EXPECT_EQ(*before, item);
      EXPECT_EQ(--at, before);
      EXPECT_EQ(*at, item);
      ++at;
    }
    EXPECT_EQ(at, start);
  }
  for (int round = 0; round < 2; ++round) {
    for (auto item = lap.rbegin(); item != lap.rend(); ++item) {
      const auto after = at--;
      EXPECT_EQ(*at, *item);
      EXPECT_EQ(++at, after);
      --at;
    }
  }
  EXPECT_EQ(at.halfedge(), start.halfedge());
}

TEST(Circulators, AreEndlessAndBidirectional) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    for (const Vertex v : mesh.vertices()) {
      expect_endless(mesh.outgoing_cw(v));
      expect_endless(mesh.outgoing_ccw(v));
      expect_endless(mesh.incoming_ccw(v));
      expect_endless(mesh.vertex_vertices_cw(v));
      expect_endless(mesh.vertex_edges_ccw(v));
      expect_endless(mesh.vertex_faces_cw(v));
      expect_endless(mesh.vertex_faces_ccw(v));
    }
    for (const Face f : mesh.faces()) {
      expect_endless(mesh.face_halfedges_ccw(f));
      expect_endless(mesh.face_vertices_cw(f));
      expect_endless(mesh.face_edges_ccw(f));
      expect_endless(mesh.face_faces_ccw(f));
      expect_endless(mesh.face_faces_cw(f));
    }
    for (const Edge e : mesh.edges()) {
      expect_endless(mesh.edge_halfedges(e));
      expect_endless(mesh.edge_vertices(e));
      expect_endless(mesh.edge_faces(e));
    }
  }
}

TEST(Circulators, ShowTheSameByAnArrow) {
  const Mesh mesh = built(quad_grid(3, 3));
  const auto ring = mesh.vertex_vertices_ccw(Vertex(5));
  for (auto at = ring.begin(); at != ring.end(); ++at) EXPECT_EQ(at->index(), (*at).index());
  const auto faces = mesh.vertex_faces_cw(Vertex(5)).circulator();
  EXPECT_EQ(faces->index(), (*faces).index());
  EXPECT_EQ(std::make_reverse_iterator(faces)->index(), std::prev(faces)->index());
  for (auto at = mesh.faces().begin(); at != mesh.faces().end(); ++at) EXPECT_TRUE(at->valid());
}

TEST(Circulators, StepBackByTheOlderFunctionsToo) {
  const Mesh mesh = built(quad_grid(3, 3));
  const auto at = mesh.vertex_faces_ccw(Vertex(5)).circulator();
  EXPECT_TRUE(std::prev(std::next(at)) == at);
  auto last = at;
  --last;
  EXPECT_TRUE(std::prev(at) == last);
  EXPECT_EQ(*std::make_reverse_iterator(at), *last);
}

TEST(Circulators, KnowTheHalfedgeTheyStandOn) {
  const Mesh mesh = built(quad_grid(3, 3));
  auto at = mesh.vertex_faces_cw(Vertex(1)).circulator();
  EXPECT_EQ(text(mesh, std::vector<Halfedge>{at.halfedge()}), "1>5");  // 1>0* has no face
  ++at;
  EXPECT_EQ(text(mesh, std::vector<Halfedge>{at.halfedge()}), "1>2");
  ++at;
  EXPECT_EQ(text(mesh, std::vector<Halfedge>{at.halfedge()}), "1>5");
  EXPECT_EQ(mesh.incoming_cw(Vertex(1)).begin().halfedge(), mesh.vertex_halfedge(Vertex(1)));
}

TEST(Circulators, AsRangesAreMultiPassAndReflexive) {
  const Mesh mesh = built(quad_grid(3, 3));
  const auto ring = mesh.vertex_vertices_ccw(Vertex(5));
  EXPECT_EQ(collect(ring), collect(ring));
  const auto first = ring.begin();
  auto at = first;
  EXPECT_TRUE(at == at);
  EXPECT_TRUE(at == first);
  const auto before = at++;
  EXPECT_TRUE(before == first);
  EXPECT_FALSE(at == first);
  EXPECT_FALSE(at == ring.end());
  EXPECT_EQ(std::distance(first, first), 0);
  for (int i = 0; i < 3; ++i) ++at;
  EXPECT_TRUE(at == ring.end());
  EXPECT_TRUE(at == at);
}

// clang before 16 can't compile the views of libstdc++, whatever they are of.
#if defined(__cpp_lib_ranges) && (!defined(__clang__) || __clang_major__ >= 16)
TEST(Circulators, AsRangesArePipedIntoViews) {
  const Mesh mesh = built(quad_grid(3, 3));
  // The range itself is gone when the view is used.
  const auto neighbours_beyond = [&mesh](Vertex v, Index least) {
    const auto ring = mesh.outgoing_ccw(v);
    return ring | std::views::transform([&mesh](Halfedge h) { return mesh.to_vertex(h); }) |
           std::views::filter([least](Vertex w) { return w.index() >= least; });
  };
  std::vector<Vertex> found;
  for (const Vertex w : neighbours_beyond(Vertex(5), 5)) found.push_back(w);
  EXPECT_EQ(found, (std::vector<Vertex>{Vertex(9), Vertex(6)}));

  const auto is_boundary = [&mesh](Halfedge h) { return mesh.is_boundary(h); };
  const auto gap = std::ranges::find_if(mesh.outgoing_ccw(Vertex(1)), is_boundary);
  EXPECT_EQ(*gap, mesh.vertex_halfedge(Vertex(1)));
  const auto corner = std::ranges::max_element(
      mesh.vertices(), {}, [&mesh](Vertex v) { return mesh.position(v).x + mesh.position(v).y; });
  EXPECT_EQ(*corner, Vertex(15));
  found.clear();
  for (const Vertex v : mesh.vertices() | std::views::drop(2) | std::views::take(2)) {
    found.push_back(v);
  }
  EXPECT_EQ(found, (std::vector<Vertex>{Vertex(2), Vertex(3)}));
}
#endif

TEST(LiveItems, AreListedInIndexOrderWithoutTheDeleted) {
  Mesh mesh = reference_build(two_components());
  std::vector<Edge> edges;
  for (const Edge e : mesh.face_edges_ccw(Face(4))) edges.push_back(e);
  mesh.release(Face(4));
  for (const Edge e : edges) mesh.release(e);
  for (const Index v : {4U, 6U}) mesh.release(Vertex(v));
  EXPECT_EQ(text(mesh, collect(mesh.vertices())), "0 1 2 3 5");
  EXPECT_EQ(text(mesh, collect(mesh.faces())), "0 1 2 3");
  EXPECT_EQ(text(mesh, collect(mesh.edges())), "0 1 2 3 4 5");
  EXPECT_EQ(collect(mesh.halfedges()).size(), 12U);
  EXPECT_EQ(mesh.vertex_count(), 5U);
  EXPECT_EQ(mesh.vertex_slots(), 7U);
  EXPECT_TRUE(Mesh{}.vertices().empty());
  EXPECT_TRUE(Mesh{}.halfedges().empty());
}

// ---- use after a change ---------------------------------------------------------------------

TEST(CirculatorsDeathTest, AssertOnUseAfterTheConnectivityChanged) {
  if (!kCheckedCirculators) GTEST_SKIP() << "circulators are checked in debug builds";
  const char* sentence = "circulator was used after the connectivity changed";
  Mesh mesh = built(cube());
  auto range = mesh.vertex_faces_cw(Vertex(0));
  auto iterator = range.begin();
  auto circulator = range.circulator();
  (void)mesh.new_vertex();
  EXPECT_DEATH((void)*iterator, sentence);
  EXPECT_DEATH(++iterator, sentence);
  EXPECT_DEATH((void)*circulator, sentence);
  EXPECT_DEATH(++circulator, sentence);
  EXPECT_DEATH(--circulator, sentence);
  EXPECT_DEATH((void)range.begin(), sentence);
  EXPECT_DEATH((void)range.circulator(), sentence);
  EXPECT_EQ(collect(mesh.vertex_faces_cw(Vertex(0))).size(), 3U);
}

TEST(LiveItemsDeathTest, AssertOnUseAfterThereAreMoreOrFewerSlots) {
  if (!kCheckedCirculators) GTEST_SKIP() << "live items are checked in debug builds";
  const char* sentence = "live items were asked for after there were more or fewer slots";
  Mesh mesh = built(cube());
  const auto range = mesh.vertices();
  auto iterator = range.begin();
  (void)mesh.new_vertex();
  EXPECT_DEATH((void)*iterator, sentence);
  EXPECT_DEATH(++iterator, sentence);
  EXPECT_DEATH((void)range.begin(), sentence);
  // Without the check this would not end.
  EXPECT_DEATH(
      for ([[maybe_unused]] const Vertex v
           : mesh.vertices()) { (void)mesh.new_vertex(); },
      sentence);
  auto last = mesh.vertices().begin();
  mesh.release(Vertex(8));
  EXPECT_EQ(*++last, Vertex(1));
  ASSERT_TRUE(compact(mesh));
  EXPECT_DEATH(++last, sentence);
}

TEST(LiveItems, MayBeDeletedMeanwhile) {
  Mesh mesh = reference_build(two_components());
  for (const Face f : mesh.faces()) ASSERT_TRUE(operations::delete_face(mesh, f));
  EXPECT_EQ(mesh.face_count() + mesh.edge_count() + mesh.vertex_count(), 0U);
}

// HALFEDGE_CHECKED=1 asks for this in release builds, where there is no assert.
TEST(CirculatorsDeathTest, EndTheProgramWhereTheyAreCheckedInAnyBuild) {
  Mesh mesh = built(cube());
  auto iterator = LiveRange<Connectivity, Vertex, true>(mesh).begin();
  const Orbit<Connectivity, walk::RotateCw, view::Self, true> orbit(
      mesh, mesh.vertex_halfedge(Vertex(0)));
  (void)mesh.new_vertex();
  EXPECT_DEATH(++iterator, "");
  EXPECT_DEATH((void)orbit.begin(), "");
}

TEST(CirculatorsDeathTest, AssertThatThereIsSomethingToVisit) {
#if defined(NDEBUG)
  GTEST_SKIP() << "asserts are off in release builds";
#else
  const Mesh mesh = built(with_isolated_vertices());
  auto circulator = mesh.vertex_vertices_cw(Vertex(3)).circulator();
  const char* sentence = "nothing to visit: ask valid";
  EXPECT_DEATH((void)*circulator, sentence);
  EXPECT_DEATH(++circulator, sentence);
  EXPECT_DEATH(--circulator, sentence);
  EXPECT_DEATH((void)*decltype(circulator){}, sentence);
#endif
}

TEST(CirculatorsDeathTest, AssertThatAnExplicitStartBelongsToTheItem) {
#if defined(NDEBUG)
  GTEST_SKIP() << "asserts are off in release builds";
#else
  const Mesh mesh = built(cube());
  const Halfedge elsewhere = mesh.vertex_halfedge(Vertex(6));
  EXPECT_DEATH((void)mesh.outgoing_cw(Vertex(0), elsewhere), "must leave the vertex");
  const Halfedge other = mesh.face_halfedge(Face(1));
  EXPECT_DEATH((void)mesh.face_edges_cw(Face(0), other), "must lie in the face");
#endif
}

}  // namespace
}  // namespace halfedge::test
