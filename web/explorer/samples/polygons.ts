/** Vertices and faces as they are written to a file, whatever they make together. */
export interface Polygons {
  readonly positions: number[][];
  readonly faces: number[][];
}

/** A rectangle of `columns` × `rows` cells over (u, v) in the unit square. */
export function sheet(
  columns: number,
  rows: number,
  place: (u: number, v: number) => number[],
): Polygons {
  const positions: number[][] = [];
  const faces: number[][] = [];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      positions.push(place(column / columns, row / rows));
    }
  }
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at = row * (columns + 1) + column;
      faces.push([at, at + 1, at + columns + 2, at + columns + 1]);
    }
  }
  return { positions, faces };
}

/** A closed box. */
export function box(low: readonly number[], high: readonly number[]): Polygons {
  const positions = Array.from({ length: 8 }, (_, i) =>
    [0, 1, 2].map((k) => ((i >> k) & 1 ? high[k] : low[k])),
  );
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return { positions, faces };
}

/** Several in one. */
export function together(...parts: readonly Polygons[]): Polygons {
  const positions: number[][] = [];
  const faces: number[][] = [];
  for (const part of parts) {
    const first = positions.length;
    positions.push(...part.positions);
    faces.push(...part.faces.map((face) => face.map((v) => v + first)));
  }
  return { positions, faces };
}

/** With one vertex for all that are in the same place. */
export function welded({ positions, faces }: Polygons): Polygons {
  const places = new Map<string, number>();
  const kept: number[][] = [];
  const of = positions.map((position) => {
    const key = position.map((x) => (Math.round(x * 1e6) / 1e6 + 0).toString()).join(' ');
    const found = places.get(key) ?? kept.push(position) - 1;
    places.set(key, found);
    return found;
  });
  return { positions: kept, faces: faces.map((face) => face.map((v) => of[v])) };
}

const numbers = (values: readonly number[]) =>
  values.map((x) => String(Number(x.toFixed(6)) + 0)).join(' ');

export function toObj({ positions, faces }: Polygons): string {
  const vertices = positions.map((position) => `v ${numbers(position)}\n`);
  return [...vertices, ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}\n`)].join('');
}

export function toOff({ positions, faces }: Polygons): string {
  const vertices = positions.map((position) => `${numbers(position)}\n`);
  const lines = faces.map((face) => `${face.length} ${face.join(' ')}\n`);
  return [`OFF\n${positions.length} ${faces.length} 0\n`, ...vertices, ...lines].join('');
}

/** Triangles, nine coordinates each, as a binary STL file. */
export function toStl(triangles: Float32Array): Uint8Array {
  const count = triangles.length / 9;
  const data = new DataView(new ArrayBuffer(84 + 50 * count));
  data.setUint32(80, count, true);
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 9; k++)
      data.setFloat32(84 + 50 * i + 12 + 4 * k, triangles[9 * i + k], true);
  }
  return new Uint8Array(data.buffer);
}
