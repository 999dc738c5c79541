import { HalfedgeMesh, init } from 'halfedge';
import { type ExerciseTask, taskNamed } from 'halfedge/exercise/judge';
import { attempt } from '../../dist/exercise/judge/attempt.js';
import { compile, type Program } from '../../dist/exercise/judge/program.js';
import { failureOf } from './support/exercises.js';

beforeAll(() => init());

/** A walk of do … while around a vertex, from pieces. */
const around = (name: string, take: string, step: string, first = 'mesh.vertexHalfedge(v)') =>
  `function ${name}(mesh, v) {
  const ring = [];
  const first = ${first};
  if (first === NONE) return ring;
  let h = first;
  do {
    ${take};
    ${step};
  } while (h !== first);
  return ring;
}`;

const TAKE = 'ring.push(mesh.toVertex(h))';
const CCW = 'h = mesh.opposite(mesh.prev(h))';

describe('A typical mistake', () => {
  test.each<[why: string, task: string, code: string, expected: string, words: RegExp]>([
    [
      'walking around the face',
      'vertex-vertices',
      around('vertexVertices', TAKE, 'h = mesh.next(h)'),
      'walks-face',
      /^It walks around f\d+, not around v0\. On the tetrahedron, vertexVertices\(mesh, v0\): it gave v\d, v\d, v\d; expected/,
    ],
    [
      'turning around the other end',
      'vertex-vertices',
      around('vertexVertices', TAKE, 'h = mesh.opposite(mesh.next(h))'),
      'turns-elsewhere',
      /^It turns around v\d, not around v0\./,
    ],
    [
      'taking the vertex itself',
      'vertex-vertices',
      around('vertexVertices', 'ring.push(mesh.fromVertex(h))', CCW),
      'takes-centre',
      /^It takes v0 itself, 3 times\./,
    ],
    [
      'giving halfedges back',
      'vertex-vertices',
      around('vertexVertices', 'ring.push(h)', CCW),
      'returns-halfedges',
      /gives back the halfedges that leave the vertex; vertices were asked\..*mesh\.toVertex\(h\)/,
    ],
    [
      'missing the last one',
      'vertex-vertices',
      `function vertexVertices(mesh, v) {
        const ring = [];
        const first = mesh.vertexHalfedge(v);
        for (let h = first; mesh.opposite(mesh.prev(h)) !== first; h = mesh.opposite(mesh.prev(h))) {
          ring.push(mesh.toVertex(h));
        }
        return ring;
      }`,
      'misses-last',
      /^It misses one: v\d\. .* A loop that looks ahead stops before it has taken the last/,
    ],
    [
      'missing the first one',
      'vertex-vertices',
      `function vertexVertices(mesh, v) {
        const ring = [];
        const first = mesh.vertexHalfedge(v);
        for (let h = mesh.opposite(mesh.prev(first)); h !== first; h = mesh.opposite(mesh.prev(h))) {
          ring.push(mesh.toVertex(h));
        }
        return ring;
      }`,
      'misses-first',
      /^It misses the first: v\d\./,
    ],
    [
      'taking the start twice',
      'vertex-vertices',
      `function vertexVertices(mesh, v) {
        const first = mesh.vertexHalfedge(v);
        const ring = [mesh.toVertex(first)];
        let h = first;
        do {
          h = mesh.opposite(mesh.prev(h));
          ring.push(mesh.toVertex(h));
        } while (h !== first);
        return ring;
      }`,
      'start-twice',
      /^It takes v\d twice: at the start, and again at the end\./,
    ],
    [
      'going round twice',
      'vertex-vertices',
      around('vertexVertices', TAKE, CCW).replace(
        'return ring;\n}',
        'return [...ring, ...ring];\n}',
      ),
      'several-laps',
      /^It goes round 2 times\./,
    ],
    [
      'taking each one twice in one lap',
      'vertex-vertices',
      around('vertexVertices', `${TAKE}; ring.push(mesh.toVertex(h))`, CCW),
      'repeats',
      /^It takes v\d twice\./,
    ],
    [
      'looking before leaving',
      'vertex-vertices',
      `function vertexVertices(mesh, v) {
        const ring = [];
        const first = mesh.vertexHalfedge(v);
        let h = first;
        while (h !== first) { ${TAKE}; ${CCW}; }
        return ring;
      }`,
      'empty',
      /^Its list is empty\./,
    ],
    [
      'forgetting an isolated vertex',
      'vertex-vertices',
      around('vertexVertices', TAKE, CCW).replace('if (first === NONE) return ring;', ''),
      'reads-null-halfedge',
      /^Line 7: it asks for toVertex\(−1\), and −1 is no item\. On the sheet with a lonely vertex, .*v5 is isolated/,
    ],
    [
      'stopping where there is no face',
      'vertex-vertices',
      `function vertexVertices(mesh, v) {
        const ring = [];
        const first = mesh.vertexHalfedge(v);
        if (first === NONE) return ring;
        let h = first;
        do {
          ${TAKE};
          ${CCW};
        } while (h !== first && mesh.face(h) !== NONE);
        return ring;
      }`,
      'stops-at-boundary',
      /^It stops at the boundary\. On the bow tie, /,
    ],
    [
      'never comparing with the start',
      'vertex-vertices',
      around('vertexVertices', TAKE, 'h = mesh.next(h)').replace('h !== first', 'h !== v'),
      'endless',
      /^The loop in line 6 does not end\./,
    ],
    [
      'never coming back to the start',
      'vertex-vertices',
      around('vertexVertices', TAKE, CCW, 'mesh.vertexHalfedge(v)').replace(
        'let h = first;',
        'let h = mesh.next(first);',
      ),
      'endless',
      /^The loop in line 6 does not end\..*and never comes back to h\d+, where it began/,
    ],
    [
      'looping without a walk',
      'valence',
      'function valence(mesh, v) {\n  let n = 0;\n  while (true) n += 1;\n}',
      'endless',
      /^The loop in line 3 does not end\..*asks the mesh for no next halfedge/,
    ],
    [
      'calling itself without end',
      'valence',
      'function valence(mesh, v) {\n  return 1 + valence(mesh, v);\n}',
      'endless-recursion',
      /^Line 2: the function calls itself without end\./,
    ],
    [
      'taking the face 0 for none',
      'vertex-faces',
      around('vertexFaces', 'if (mesh.face(h)) ring.push(mesh.face(h))', CCW),
      'zero-is-false',
      /^It leaves out f0, which it has been given\..* 0 counts as false: compare with NONE\.$/,
    ],
    [
      'taking only indices above 0',
      'vertex-vertices',
      around('vertexVertices', 'if (mesh.toVertex(h) > 0) ring.push(mesh.toVertex(h))', CCW),
      'zero-is-false',
      /^It leaves out v0, which it has been given\. .*, as in if \(mesh\.toVertex\(h\)\)\?/,
    ],
    [
      'taking the halfedge 0 for none',
      'valence',
      taskNamed('valence').solution.replace('first === NONE', '!(first > 0)'),
      'numbering',
      /wrong with others\. It gives back 0; expected 3\. .* vertexHalfedge gave h0\. h0 is one like any other, but 0 counts as false/,
    ],
    [
      'taking the face 0 for the boundary',
      'is-boundary-vertex',
      taskNamed('is-boundary-vertex').solution.replace('mesh.face(h) === NONE', '!mesh.face(h)'),
      'wrong-true',
      /^It says true of v\d; expected false\..* Every halfedge that leaves it has a face\. face gave f0\. /,
    ],
    [
      'making the list outside of the function',
      'vertex-vertices',
      `const ring = [];\n${around('vertexVertices', TAKE, CCW).replace('const ring = [];', '')}`,
      'keeps-list',
      /^Its list still holds what the call before put into it: (v\d(, )?){3}\. On the tetrahedron, /,
    ],
    [
      'counting outside of the function',
      'valence',
      `let count = 0;\n${taskNamed('valence').solution.replace('let count = 0;', '')}`,
      'keeps-count',
      /^It goes on counting from 3, where the call before ended\. On the tetrahedron, .*: it gave 6; expected 3\./,
    ],
    [
      'counting on from mesh to mesh',
      'count-boundary-loops',
      `let loops = 0;\n${taskNamed('count-boundary-loops').solution.replace('let loops = 0;', '')}`,
      'keeps-count',
      /^It goes on counting from 1, where the call before ended\. On the ring, /,
    ],
    [
      'counting around the other end',
      'valence',
      taskNamed('valence').solution.replace(
        'mesh.next(mesh.opposite(h))',
        'mesh.opposite(mesh.next(h))',
      ),
      'turns-elsewhere',
      /^It turns around v11, not around v12\. On the cone, .* opposite\(next\(h\)\) turns around the vertex that h leads to\./,
    ],
    [
      'turning around a corner in place of walking around the face',
      'face-vertices',
      around('faceVertices', TAKE, 'h = mesh.opposite(mesh.next(h))', 'mesh.faceHalfedge(v)'),
      'turns-elsewhere',
      /^It turns around v\d, not around the face\. .* next alone stays in it\.$/,
    ],
    [
      'making texts of indices',
      'vertex-vertices',
      around('vertexVertices', 'ring.push(String(mesh.toVertex(h)))', CCW),
      'not-an-item',
      /^The 1st in its list is the text “\d”, which is no vertex\. .*: it gave “\d”, “\d”, “\d”; expected v\d, v\d, v\d\. Items are numbers, and this is a text\./,
    ],
    [
      'going through a range by for … in',
      'count-boundary-loops',
      'function countBoundaryLoops(mesh) {\n  let count = 0;\n  for (const h in mesh.halfedges())\n    if (mesh.face(h) === NONE) count++;\n  return count;\n}',
      'throws',
      /^Line 3: for … in gives names, and not the items: write for … of\. /,
    ],
    [
      'going through a Set by for … in',
      'vertex-vertices',
      `${around('ringOf', 'ring.push(h)', CCW)}\nfunction vertexVertices(mesh, v) {\n  const ring = [];\n  for (const h in 0, new Set(ringOf(mesh, v))) { ring.push(mesh.toVertex(h)); }\n  return ring;\n}`,
      'throws',
      /^Line 14: for … in gives names, and not the items: write for … of\. /,
    ],
    [
      'going through a list by for … in',
      'vertex-vertices',
      `${around('ringOf', 'ring.push(h)', CCW)}\nfunction vertexVertices(mesh, v) {\n  const ring = [];\n  for (const h in ringOf(mesh, v)) ring.push(mesh.toVertex(h));\n  return ring;\n}`,
      'asks-for-nothing',
      /^Line 14: it asks for toVertex\(“0”\)\. .* Items are numbers, and this is a text\. Does it come from for … in\? That gives names, .* for … of gives the items\.$/,
    ],
    [
      'a generator that goes on and on',
      'vertex-vertices',
      'function* vertexVertices(mesh, v) {\n  let h = mesh.vertexHalfedge(v);\n  while (true) {\n    yield mesh.toVertex(h);\n    h = mesh.next(mesh.opposite(h));\n  }\n}',
      'endless',
      /^The loop in line 3 does not end\./,
    ],
    [
      'an async function',
      'valence',
      'async function valence(mesh, v) { return 3; }',
      'wrong-type',
      /^It gives back a promise; expected a number\. .* leave the words async and await out\.$/,
    ],
    [
      'an async generator',
      'face-vertices',
      'async function* faceVertices(mesh, f) { yield 3; }',
      'wrong-type',
      /^It gives back an async generator; expected a list\. .* leave the words async and await out\.$/,
    ],
    [
      'going to and fro in place of back',
      'previous',
      'function previous(mesh, h) {\n  let before = mesh.next(h);\n  while (mesh.next(before) !== h) before = mesh.opposite(before);\n  return before;\n}',
      'endless',
      /never comes back to h0, where it began/,
    ],
    [
      'giving nothing back',
      'vertex-vertices',
      around('vertexVertices', TAKE, CCW).replace('return ring;\n}', '}'),
      'returns-nothing',
      /^It gives back undefined\./,
    ],
    [
      'giving a number for a list',
      'vertex-vertices',
      'function vertexVertices(mesh, v) { return 3; }',
      'wrong-type',
      /^It gives back the number 3; expected a list\./,
    ],
    [
      'pushing what has no value',
      'vertex-vertices',
      around('vertexVertices', 'ring.push(h.vertex)', CCW),
      'not-an-item',
      /^The 1st in its list is undefined, which is no vertex\./,
    ],
    [
      'taking the null face',
      'vertex-faces',
      around('vertexFaces', 'ring.push(mesh.face(h))', CCW),
      'null-face',
      /^It takes −1 for a face\. On the sheet, /,
    ],
    [
      'asking the null face',
      'vertex-faces',
      around('vertexFaces', 'mesh.faceHalfedge(mesh.face(h)); ring.push(mesh.face(h))', CCW),
      'throws',
      /^Line 7: mesh\.faceHalfedge is not to be used in this exercise: the mesh has vertexHalfedge, /,
    ],
    [
      'going the wrong way round',
      'one-ring',
      `${around('oneRing', TAKE, 'h = mesh.next(mesh.opposite(h))')}`,
      'wrong-way',
      /^It goes the wrong way round: clockwise\. On the tetrahedron, oneRing\(mesh, v0, 'ccw'\)/,
    ],
    [
      'starting elsewhere',
      'one-ring',
      `function oneRing(mesh, v, direction) {
        const ring = [];
        const first = mesh.vertexHalfedge(v);
        if (first === NONE) return ring;
        let h = first;
        do {
          h = direction === 'ccw' ? mesh.opposite(mesh.prev(h)) : mesh.next(mesh.opposite(h));
          ring.push(mesh.toVertex(h));
        } while (h !== first);
        return ring;
      }`,
      'starts-elsewhere',
      /^It starts at v\d; expected v\d as the first\..* \(The circulators of the library step first /,
    ],
    [
      'going along prev',
      'face-vertices',
      around('faceVertices', TAKE, 'h = mesh.prev(h)', 'mesh.faceHalfedge(v)'),
      'wrong-way',
      /^It goes the wrong way round: clockwise\./,
    ],
    [
      'leaving the face',
      'face-vertices',
      around('faceVertices', TAKE, 'h = mesh.next(mesh.opposite(h))', 'mesh.faceHalfedge(v)'),
      'walks-vertex',
      /^It turns around v\d, not around the face\./,
    ],
    [
      'taking the index of the face for that of a halfedge',
      'face-vertices',
      around('faceVertices', TAKE, 'h = mesh.next(h)', 'v'),
      'walks-face',
      /^It walks around f\d, not around f\d\. On the tetrahedron, .*mesh\.faceHalfedge\(f\)/,
    ],
    [
      'taking every face for a triangle',
      'face-vertices',
      `function faceVertices(mesh, f) {
        const h = mesh.faceHalfedge(f);
        return [h, mesh.next(h), mesh.prev(h)].map((it) => mesh.toVertex(it));
      }`,
      'misses-last',
      /^It misses one: v\d\. On the prism, .* There are 4 to be found here\.$/,
    ],
    [
      'going to the other side of the boundary',
      'boundary-loop',
      `function boundaryLoop(mesh, h) {
        const loop = [];
        let at = mesh.opposite(h);
        do { loop.push(at); at = mesh.next(at); } while (at !== mesh.opposite(h));
        return loop;
      }`,
      'walks-face',
      /^It walks around f\d, on the other side of the edge\. On the sheet, /,
    ],
    [
      'walking against next',
      'boundary-loop',
      `function boundaryLoop(mesh, h) {
        const loop = [];
        let at = h;
        do { loop.push(at); at = mesh.prev(at); } while (at !== h);
        return loop;
      }`,
      'wrong-way',
      /^It goes the wrong way round: against next\./,
    ],
    [
      'counting faces for edges',
      'valence',
      around('valence', 'if (mesh.face(h) !== NONE) ring.push(h)', CCW).replaceAll(
        'return ring',
        'return ring.length',
      ),
      'counts-faces',
      /^That is the number of faces around it\. On the sheet, valence\(mesh, v\d\): it gave 1; expected 2\./,
    ],
    [
      'counting around the face',
      'valence',
      around('valence', 'ring.push(h)', 'h = mesh.next(h)').replaceAll(
        'return ring',
        'return ring.length',
      ),
      'walks-face',
      /^That is the number of halfedges around a face\. On the prism, /,
    ],
    [
      'counting one too many',
      'valence',
      around('valence', 'ring.push(h)', CCW).replace(
        'return ring;\n}',
        'return ring.length + 1;\n}',
      ),
      'one-too-many',
      /^It counts one too many\./,
    ],
    [
      'giving NONE where nothing meets the vertex',
      'valence',
      around('valence', 'ring.push(h)', CCW)
        .replace('return ring;\n}', 'return ring.length;\n}')
        .replace('return ring;', 'return NONE;'),
      'one-too-few',
      /^It counts one too few\. On the sheet with a lonely vertex, .* Nothing meets it: mesh\.vertexHalfedge is NONE\.$/,
    ],
    [
      'adding to undefined',
      'valence',
      'function valence(mesh, v) { let n; return n + 1; }',
      'not-a-number',
      /^It gives back NaN/,
    ],
    [
      'seeing no boundary',
      'is-boundary-vertex',
      'function isBoundaryVertex(mesh, v) { return false; }',
      'wrong-false',
      /^It says false of v\d; expected true\. On the sheet, .* h\d+ leaves it and has no face\./,
    ],
    [
      'taking three steps',
      'previous',
      'function previous(mesh, h) { return mesh.next(mesh.next(h)); }',
      'wrong-item',
      /which is next\(next\(h\d+\)\): right in triangles only; expected h\d+\. On the prism, /,
    ],
    [
      'using what is not there',
      'previous',
      'function previous(mesh, h) { return mesh.prev(h); }',
      'throws',
      /^Line 1: mesh\.prev is not to be used in this exercise: the mesh has next, opposite, toVertex, face here\./,
    ],
    [
      'inventing a name',
      'previous',
      'function previous(mesh, h) {\n  return mesh.before(h);\n}',
      'throws',
      /^Line 2: mesh\.before does not exist/,
    ],
    [
      'throwing what has no text',
      'previous',
      'function previous(mesh, h) { throw Object.create(null); }',
      'throws',
      /^The code stops with an error: Something was thrown that has no text\./,
    ],
    [
      'waiting outside of a function',
      'previous',
      'function previous(mesh, h) {}\nawait 3;',
      'syntax',
      /^Line 2, column 1: Nothing can be waited for outside of a function\./,
    ],
    [
      'asking for undefined',
      'previous',
      'function previous(mesh, h) {\n  let at;\n  return mesh.next(at);\n}',
      'asks-for-nothing',
      /^Line 3: it asks for next\(undefined\)\./,
    ],
    [
      'a mistake after asking for a list',
      'count-boundary-loops',
      'function countBoundaryLoops(mesh) {\n  const all = mesh.halfedges();\n  return all.map((h) => h).length;\n}',
      'throws',
      /^Line 3: all\.map is not a function\. On the tetrahedron, countBoundaryLoops\(mesh\)\.$/,
    ],
    [
      'counting halfedges for loops',
      'count-boundary-loops',
      taskNamed('count-boundary-loops').starter,
      'counts-halfedges',
      /^That is the number of boundary halfedges\. On the sheet, countBoundaryLoops\(mesh\): it gave 9; expected 1\./,
    ],
    [
      'counting one loop at most',
      'count-boundary-loops',
      'function countBoundaryLoops(mesh) { return [...mesh.halfedges()].some((h) => mesh.face(h) < 0) ? 1 : 0; }',
      'yes-or-no',
      /^It has more than one\. On the ring, /,
    ],
    [
      'taking halfedges for edges',
      'euler-characteristic',
      taskNamed('euler-characteristic').starter,
      'counts-halfedges',
      /^It takes each halfedge for an edge/,
    ],
    [
      'believing in two',
      'euler-characteristic',
      'const eulerCharacteristic = () => 2;',
      'two',
      /^It is 2 for a sphere only.* On the torus, /,
    ],
    [
      'changing nothing',
      'flip-edge',
      taskNamed('flip-edge').starter,
      'nothing-changed',
      /^All links are what they were before\. On the cone, flipEdge\(links, e1\): expected \(v.*links\.next\[h\] = …/,
    ],
    [
      'flipping twice',
      'flip-edge',
      `${taskNamed('flip-edge').solution.replace('flipEdge', 'flip')}
      function flipEdge(links, e) { flip(links, e); flip(links, e); }`,
      'nothing-changed',
      /^The links are sound, but the faces are what they were before\./,
    ],
    [
      'taking arrays for functions',
      'flip-edge',
      taskNamed('flip-edge').starter.replace('next[h]', 'next(h)'),
      'throws',
      /^Line 5: next is not a function\..*: next\[h\], not next\(h\)\.$/,
    ],
    [
      'taking a value of a mesh for a function',
      'valence',
      'function valence(mesh, v) {\n  return mesh.vertexHalfedge(v)();\n}',
      'throws',
      /is not a function\. On the \w+, valence\(mesh, v\d+\)\.$/,
    ],
    [
      'taking an edge for a halfedge',
      'flip-edge',
      taskNamed('flip-edge').solution.replace('h = 2 * e', 'h = e'),
      'next-prev-mismatch',
      /toVertex of h0, h1 has to stay: the halfedges of e1 are h2 and h3, which is 2 \* e and 2 \* e \+ 1\. 1 more does not fit\.$/,
    ],
    [
      'forgetting the faces',
      'flip-edge',
      taskNamed('flip-edge').solution.replace('face[x] = face[y] = face[z] = f;', ''),
      'face-mismatch',
      // Not all that it has changed is listed, and that is said.
      /it gave (\w+\[\d+\]: \d+ → \d+, ){8}… \(15\)\. .*was face set for those that changed sides\? 3 more do not fit\.$/,
    ],
    [
      'following links that were changed',
      'flip-edge',
      `function flipEdge({ next }, e) {
        let h = 2 * e;
        next[h] = h;
        while (next[h] !== h + 1) h = next[h];
      }`,
      'endless',
      /^The loop in line 4 does not end\..* What changes from turn to turn\? A walk along links that were changed/,
    ],
    [
      'asking a while whether it is back before it has left',
      'face-vertices',
      `function faceVertices(mesh, f) {
        const list = [];
        const first = mesh.faceHalfedge(f);
        for (let h = first; h !== first; h = mesh.next(h)) list.push(mesh.toVertex(h));
        return list;
      }`,
      'empty',
      /expected v2, v1, v0\. A walk of do … while takes its first vertex .* Or was 0 taken for none\? faceHalfedge gave h0\. h0 is one like any other/,
    ],
    [
      'forgetting prev',
      'flip-edge',
      taskNamed('flip-edge').solution.replace('prev[y] = x;', ''),
      'next-prev-mismatch',
      /^The next of halfedge \d+ is halfedge \d+, whose prev is halfedge \d+\..*Whenever next\[a\] = b is set/,
    ],
    [
      'forgetting the vertices',
      'flip-edge',
      taskNamed('flip-edge').solution.replace('toVertex[h] = d;', ''),
      'to-from-mismatch',
      /leads to vertex \d+, but its next, halfedge \d+, leaves vertex \d+/,
    ],
    [
      'forgetting the anchors',
      'flip-edge',
      taskNamed('flip-edge').solution.replace(/if \(vertexHalfedge.*\n/g, ''),
      'anchor-elsewhere',
      /vertexHalfedge has to leave its vertex/,
    ],
    [
      'a mistake of syntax',
      'valence',
      'function valence(mesh, v) {\n  let n = ;\n}',
      'syntax',
      /^Line 2, column 11: Unexpected token\./,
    ],
    [
      'a fence of Markdown before the code',
      'valence',
      '\n```js\nfunction valence(mesh, v) {}\n```\n',
      'syntax',
      /^Line 2, column 1: This marks code in Markdown, and is none\. Leave the lines with ``` out\.$/,
    ],
    [
      'a fence of Markdown after the code',
      'valence',
      'function valence(mesh, v) {}\n```\n',
      'syntax',
      /^Line 2, column 1: This marks code in Markdown/,
    ],
    [
      'a quote of print',
      'valence',
      'function valence(mesh, v) {\n  return “2”;\n}',
      'syntax',
      /^Line 2, column 10: Unexpected character '“'\. Code has plain characters: quotes are ' or "/,
    ],
    [
      'a character that is not seen',
      'valence',
      'function valence(mesh, v) {\n  \u200breturn 2;\n}',
      'syntax',
      /^Line 2, column 3: Unexpected character U\+200B, which can’t be seen\. It came along with what was pasted: /,
    ],
    ...[
      '(mesh: Mesh, v) {}',
      '(mesh, v: number) {}',
      '(mesh, v): number {}',
      '() { let n: number; }',
    ].map((rest): [string, string, string, string, RegExp] => [
      `a type in ${rest}`,
      'valence',
      `function valence${rest}`,
      'syntax',
      /Unexpected token\. It may be a type, which TypeScript has: leave the colon and the type out\.$/,
    ]),
    [
      'a colon that is of no type',
      'valence',
      'function valence(mesh, v) {\n  while (v):\n}',
      'syntax',
      /Unexpected token\. The code can’t be read from there on/,
    ],
    [
      'another name',
      'valence',
      'function degree() {}',
      'no-function',
      /^The code has no function valence\. It has degree\./,
    ],
    [
      'a mistake outside',
      'valence',
      'const a = 1;\nmissing();\nfunction valence() {}',
      'throws',
      /^Line 2: missing is not defined\. It happens outside of valence/,
    ],
    [
      'an import',
      'valence',
      "import 'halfedge';\n",
      'syntax',
      /Import and export have no place here\. The mesh is given to the function/,
    ],
    [
      'an export',
      'valence',
      'export function valence(mesh, v) {}\n',
      'syntax',
      /^Line 1, column 1: Import and export have no place here\. Leave the word out: /,
    ],
  ])('%s, in %s, is told as such', (_why, task, code, expected, words) => {
    const failure = failureOf(task, code);
    expect([failure.code, failure.message]).toEqual([expected, expect.stringMatching(words)]);
  });

  test('that only the tidy numbers let pass is found, and told as such', () => {
    const sheet: ExerciseTask = { ...taskNamed('is-boundary-vertex'), meshes: ['sheet'] };
    const failure = failureOf(sheet, 'function isBoundaryVertex(mesh, v) { return v !== 4; }');
    expect(failure.code).toBe('numbering');
    expect(failure.message).toMatch(
      /^It is right as long as the numbers are tidy, and wrong with others\. It says \w+ of v\d; expected \w+\. On the sheet, shuffled, /,
    );
  });

  test('says “have” of several halfedges', () => {
    const bowTie: ExerciseTask = { ...taskNamed('is-boundary-vertex'), meshes: ['bow-tie'] };
    const code = 'function isBoundaryVertex(mesh, v) { return mesh.toVertex(0) < 0; }';
    const pinched: ExerciseTask = {
      ...bowTie,
      *asks(mesh) {
        for (const index of mesh.vertices()) {
          if (!mesh.isManifoldVertex(index)) yield [{ kind: 'vertex', index }];
        }
      },
    };
    expect(failureOf(pinched, code).hint).toMatch(/^h\d+ and h\d+ leave it and have no face\.$/);
  });

  test('names the line also in a loop without braces, and where lines have other code', () => {
    const code = 'function valence(mesh, v) {\n\n  for (const a of [1])\n    for (;;)\n      v;\n}';
    expect(failureOf('valence', code).line).toBe(4);
    const throwing = 'function valence(mesh, v) {\n  for (;;)\n    null.x;\n}';
    expect(failureOf('valence', throwing).line).toBe(3);
  });

  test('that the task knows has no hint but the task’s own', () => {
    const two = 'function eulerCharacteristic(mesh) { return 2; }';
    expect(failureOf('euler-characteristic', two)).toMatchObject({ code: 'two', hint: '' });
    const degree: ExerciseTask = {
      ...taskNamed('valence'),
      meshes: ['prism'],
      mistakes: [{ code: 'three', answer: () => 3, says: 'Not every vertex is like that.' }],
      reference: () => 4,
    };
    const three = 'function valence(mesh, v) { return 3; }';
    expect(failureOf(degree, three)).toMatchObject({ code: 'three', hint: '' });
  });

  test('is told without what is true of the previous halfedge only, and NONE by its name', () => {
    const across: ExerciseTask = {
      ...taskNamed('previous'),
      meshes: ['sheet'],
      answer: { kind: 'item', of: 'face' },
      reference: (mesh, h) => mesh.face((h as { index: number }).index),
      *asks(mesh) {
        for (const index of mesh.halfedges()) {
          if (mesh.isBoundaryHalfedge(index)) yield [{ kind: 'halfedge', index }];
        }
      },
    };
    const code = 'function previous(mesh, h) { return mesh.face(mesh.opposite(h)); }';
    const { title, expected, hint, marks } = failureOf(across, code);
    expect(title).toMatch(/^It gives back f\d; expected NONE\.$/);
    expect([expected, hint, marks]).toEqual(['NONE', '', []]);
  });

  test('shows where the walk went, and what it missed', () => {
    const code = around('vertexVertices', TAKE, 'h = mesh.next(h)');
    const { steps, marks, item } = failureOf('vertex-vertices', code);
    expect(item).toBe('v0');
    expect(steps.map(({ item: { kind } }) => kind)).toEqual(['vertex', 'vertex', 'vertex']);
    expect(marks).toHaveLength(1);
  });

  test.each([
    ['sent away', 'structuredClone(links.next, { transfer: [links.next.buffer] })'],
    ['replaced by what nobody can send', 'links.next = () => 0'],
  ])('tells of links that were %s, also from a worker', (_how, code) => {
    const program = `function flipEdge(links) { ${code}; }`;
    expect(failureOf('flip-edge', program)).toMatchObject({ code: 'links-replaced' });
    const mesh = HalfedgeMesh.tetrahedron();
    const call = compile(program, 'flipEdge') as Program;
    const outcome = attempt(call, taskNamed('flip-edge'), mesh as never, [0]);
    expect(() => structuredClone(outcome)).not.toThrow();
    mesh.dispose();
  });

  test('does not let one call change what the next one gets', () => {
    const code = 'function valence(mesh, v) { mesh.next = () => 0; return 3; }';
    expect(failureOf('valence', code).message).toMatch(/^Line 1: mesh\.next can't be set/);
  });
});

test.each([
  ['a list', '[3, 1, 2]', '“0”, “1”, “2”'],
  ['an object', '{ a: 3, b: 1 }', '“a”, “b”'],
  ['a typed array', 'new Int32Array(2)', '“0”, “1”'],
  ['a text', "'ab'", '“0”, “1”'],
  ['nothing', 'null', 'nothing'],
])('Programs may go through the names in %s', (_, source, names) => {
  const code = `function vertexVertices() { const all = []; for (const name in ${source}) all.push(name); return all; }`;
  expect(failureOf('vertex-vertices', code)?.got).toBe(names);
});
