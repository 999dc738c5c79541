import { HalfedgeError } from 'halfedge';
import { useCallback, useState } from 'react';

/**
 * A halfedge mesh as state of a component. The mesh is one object that changes in place, so what shows it
 * takes `version` beside it, and looks again when that is another.
 *
 * @param make makes the mesh, once
 * @returns the mesh, its version, the HalfedgeError if the last edit was refused, and `edit(operation)`, which calls it
 */
export function useMesh(make) {
  const [mesh] = useState(make);
  const [state, setState] = useState({ version: mesh.version, refusal: undefined });
  const edit = useCallback(
    (operation) => {
      let refusal;
      try {
        operation();
      } catch (error) {
        if (!(error instanceof HalfedgeError)) throw error;
        refusal = error;
      }
      setState({ version: mesh.version, refusal });
    },
    [mesh],
  );
  return { mesh, ...state, edit };
}
