// The classes of `halfedge/three` as components: made once, updated after edits, freed at the end.

import { useThree } from '@react-three/fiber';
import { MeshGeometry, squaredDistanceToSegment } from 'halfedge/three';
import { useEffect, useLayoutEffect, useMemo } from 'react';
import { DoubleSide } from 'three';

/** The surface of a mesh. `onPick` gets the edge that is nearest to a click, or undefined beside the mesh. */
export function Surface({ mesh, version, color, onPick }) {
  const geometry = useMemo(() => new MeshGeometry(mesh, { normals: 'flat' }), [mesh]);
  useUpdates(geometry, version);
  const pick = ({ delta, faceIndex, object, point }) => {
    if (delta > 4) return; // that was dragged
    onPick(nearestEdge(mesh, geometry.face(faceIndex), object.worldToLocal(point.clone())));
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: it is an object of three.js, no element of the page
    <mesh geometry={geometry} onClick={pick}>
      <meshStandardMaterial color={color} roughness={0.9} side={DoubleSide} />
    </mesh>
  );
}

/**
 * One of the helpers: `kind` is its class. It is made anew when `options` is another object, so keep that.
 */
export function Helper({ kind: Kind, mesh, version, options }) {
  const helper = useMemo(() => new Kind(mesh, options), [Kind, mesh, options]);
  useUpdates(helper, version);
  return <primitive object={helper} />;
}

function useUpdates(thing, version) {
  const invalidate = useThree((state) => state.invalidate);
  // biome-ignore lint/correctness/useExhaustiveDependencies: of the mesh, its version is all that React can see
  useLayoutEffect(() => {
    thing.update();
    invalidate();
  }, [thing, version, invalidate]);
  useEffect(() => () => thing.dispose(), [thing]);
}

function nearestEdge(mesh, face, { x, y, z }) {
  const distance = (e) => {
    const ends = [...mesh.edgeVertices(e)].flatMap((v) => [...mesh.position(v)]);
    return squaredDistanceToSegment([x, y, z, ...ends], 0, 3, 6);
  };
  return [...mesh.faceEdges(face)].reduce((a, b) => (distance(b) < distance(a) ? b : a));
}
