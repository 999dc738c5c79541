import { Canvas } from '@react-three/fiber';
import {
  BoundaryLoopsHelper,
  fromBufferGeometry,
  HalfedgesHelper,
  ProblemsHelper,
} from 'halfedge/three';
import { useMemo, useState } from 'react';
import { IcosahedronGeometry } from 'three';
import { Controls } from './Controls.jsx';
import { Helper, Surface } from './Halfedges.jsx';
import { useDark } from './useDark.js';
import { useMesh } from './useMesh.js';

const EDITS = {
  Flip: (mesh, e) => mesh.flipEdge(e),
  Split: (mesh, e) => mesh.splitEdge(e),
  Collapse: (mesh, e) => mesh.collapse(mesh.edgeHalfedge(e)),
  Delete: (mesh, e) => mesh.deleteEdge(e),
};

/** The length of a pixel at the ball, which says how large arrows are. */
const PIXEL = 0.005;

const LIGHT = {
  surface: '#dfe5ee',
  arrows: { color: '#2485f7', boundaryColor: '#6c1f04', linewidth: 1.5, pixel: PIXEL },
  boundary: { color: '#6c1f04' },
  picked: '#046a53',
  refusal: '#e01297',
};
const DARK = {
  surface: '#4a5566',
  arrows: { color: '#87a6fb', boundaryColor: '#fe342e', linewidth: 1.5, pixel: PIXEL },
  boundary: { color: '#fe342e' },
  picked: '#58fecb',
  refusal: '#fed218',
};

/** A geometry of three.js, as a mesh that can be edited. */
function ball() {
  const { mesh } = fromBufferGeometry(new IcosahedronGeometry(1, 1));
  mesh.history.enabled = true;
  mesh.generations.enabled = true; // so that we notice when the edge that was picked is gone
  return mesh;
}

export function App() {
  const { mesh, version, refusal, edit } = useMesh(ball);
  const [reference, pick] = useState();
  const picked = reference && mesh.generations.isCurrent(reference) ? reference.index : undefined;
  const colors = useDark() ? DARK : LIGHT;
  const lit = useMemo(() => {
    const problems = picked === undefined ? [] : [{ kind: 'edge', index: picked }];
    return { problems, color: colors.picked };
  }, [picked, colors]);
  const witness = useMemo(() => {
    const problems = refusal ? [refusal] : [];
    return { problems, color: colors.refusal, linewidth: 5, pixel: PIXEL };
  }, [refusal, colors]);
  const shown = { mesh, version };

  return (
    <>
      <main>
        <h1>A ball of triangles</h1>
        <p>Drag to turn it, and click an edge to pick it.</p>
        <p id="counts">
          {mesh.vertexCount} vertices, {mesh.edgeCount} edges, {mesh.faceCount} faces
        </p>
        <p id="picked">{picked === undefined ? 'No edge is picked.' : describe(mesh, picked)}</p>
        <div className="buttons">
          {Object.entries(EDITS).map(([name, change]) => (
            <button
              key={name}
              type="button"
              disabled={picked === undefined}
              onClick={() => edit(() => change(mesh, picked))}
            >
              {name}
            </button>
          ))}
          <button
            type="button"
            disabled={!mesh.history.canUndo}
            onClick={() => edit(() => mesh.history.undo())}
          >
            Undo
          </button>
        </div>
        <p id="refusal" role="status">
          {refusal?.message}
        </p>
      </main>
      <Canvas
        aria-label="The mesh, its halfedges as arrows"
        camera={{ position: [0.9, 0.9, 3.6] }}
        flat
        frameloop="demand"
        onPointerMissed={() => pick(undefined)}
      >
        <hemisphereLight args={[0xffffff, 0x9aa3b0, 1.6]} />
        <directionalLight position={[-2, 3, 4]} intensity={2} />
        <Surface
          {...shown}
          color={colors.surface}
          onPick={(e) => pick(mesh.generations.reference('edge', e))}
        />
        <Helper {...shown} kind={HalfedgesHelper} options={colors.arrows} />
        <Helper {...shown} kind={BoundaryLoopsHelper} options={colors.boundary} />
        <Helper {...shown} kind={ProblemsHelper} options={lit} />
        <Helper {...shown} kind={ProblemsHelper} options={witness} />
        <Controls />
      </Canvas>
    </>
  );
}

function describe(mesh, e) {
  const [a, b] = mesh.edgeVertices(e);
  const faces = [...mesh.edgeFaces(e)];
  const where =
    faces.length === 2
      ? `between faces ${faces.join(' and ')}`
      : `on the boundary, at face ${faces}`;
  return `Edge ${e} joins vertices ${a} and ${b}, ${where}.`;
}
