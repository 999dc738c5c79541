// The script behind `npm run mutate` finds the statements and conditions of C++ as we write it.

import { applied, findMutants } from '../../scripts/mutate/find.mjs';

const source = `#include <x>
namespace a {
template <class Mesh>
[[nodiscard]] Result<void> check(const Mesh& mesh, Edge e) {  // if (no) return;
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  if constexpr (StoresPrev<Mesh>) mesh.prev(h);
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (mesh.is_boundary(side)) {
      return refusal("code", "a sentence; with a semicolon", {.edges = {e.index()}});
    }
  }
  each([&](Halfedge g) {
    mesh.link(g, h);
  });
  const Face f = is_left ? mesh.face(h) : Face{};
  while (f == g) ++count;
  return count < 3 && f.valid();
}
struct Options {
  bool keep = false;
};
}  // namespace a
`;

const found = findMutants(source).map(({ kind, line, text }) => `${line} ${kind}: ${text}`);

test('each statement and condition is found once, in order', () => {
  expect(found).toEqual([
    '5 delete-refusal: if (Result<void> live = check_live(mesh, e); !live) return live;',
    '5 negate: if (Result<void> live = check_live(mesh, e); !live) return live;',
    '7 delete: mesh.prev(h);',
    '9 negate: if (mesh.is_boundary(side)) {',
    '9 delete-refusal: if (mesh.is_boundary(side)) {',
    '13 delete: each([&](Halfedge g) {',
    '14 delete: mesh.link(g, h);',
    '16 negate: const Face f = is_left ? mesh.face(h) : Face{};',
    '17 negate: while (f == g) ++count;',
    '17 delete: ++count;',
    '18 negate-return: return count < 3 && f.valid();',
  ]);
});

test('a mutant differs in its statement only', () => {
  const texts = findMutants(source).map((mutant) => applied(source, mutant));
  const lines = (text: string) => text.split('\n');
  const changed = (text: string) =>
    lines(text)
      .find((line) => !lines(source).includes(line))
      ?.trim();
  expect(texts.map(changed)).toEqual([
    ';',
    'if (Result<void> live = check_live(mesh, e);!(!live)) return live;',
    'if constexpr (StoresPrev<Mesh>) ;',
    'if (!(mesh.is_boundary(side))) {',
    'if (false) {',
    ';',
    ';',
    'const Face f = is_left  == false ? mesh.face(h) : Face{};',
    'while (!(f == g)) ++count;',
    'while (f == g) ;',
    'return !(count < 3 && f.valid());',
  ]);
});
