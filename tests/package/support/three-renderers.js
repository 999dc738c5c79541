// A page that draws the same with each renderer of three.js, for webgpu.test.ts.

import { HalfedgeMesh, init } from 'halfedge';
import * as helpers from 'halfedge/three';
import { webgpuLines } from 'halfedge/three/webgpu';
import * as THREE from 'three';
import { RenderTarget, WebGPURenderer } from 'three/webgpu';

/** Rows of pixels that WebGPU hands out without a gap are multiples of 64 long. */
const [WIDTH, HEIGHT] = [384, 288];

await init();

const renderers = new Map();

/** One renderer for each name and kind of depths. */
async function rendererOf(name, depths) {
  const key = `${name} ${depths}`;
  if (!renderers.has(key)) {
    const options = { antialias: false, [depths]: true };
    const renderer =
      name === 'WebGLRenderer'
        ? new THREE.WebGLRenderer(options)
        : new WebGPURenderer({ ...options, forceWebGL: name === 'WebGLBackend' });
    renderer.setSize(WIDTH, HEIGHT, false);
    await renderer.init?.();
    if ((renderer.backend?.constructor.name ?? 'WebGLRenderer') !== name) {
      throw new Error(`${name} is not to be had here.`);
    }
    renderers.set(key, renderer);
  }
  return renderers.get(key);
}

/** The pixels of a scene, from the top: four bytes each. */
async function picture(renderer, scene, camera) {
  const isWebGPU = renderer.backend?.isWebGPUBackend === true;
  const Target = renderer.backend === undefined ? THREE.WebGLRenderTarget : RenderTarget;
  const target = new Target(WIDTH, HEIGHT);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const place = [target, 0, 0, WIDTH, HEIGHT];
  const given = new Uint8Array(4 * WIDTH * HEIGHT);
  const read = await renderer.readRenderTargetPixelsAsync(
    ...place,
    ...(renderer.backend === undefined ? [given] : []),
  );
  renderer.setRenderTarget(null);
  target.dispose();
  if (isWebGPU) return read.slice();
  const flipped = new Uint8Array(read.length);
  for (let y = 0; y < HEIGHT; y++) {
    const row = read.subarray(4 * WIDTH * y, 4 * WIDTH * (y + 1));
    flipped.set(row, 4 * WIDTH * (HEIGHT - 1 - y));
  }
  return flipped;
}

/** Where cameras are, unless they are beside it all. */
const PLACES = { above: [0, 0, 3], within: [0.4, 0.3, 0.5] };

function cameraOf(kind) {
  const camera =
    kind === 'orthographic'
      ? new THREE.OrthographicCamera(-2, 2, 1.5, -1.5, 0.1, 20)
      : new THREE.PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(...(PLACES[kind] ?? [2, 1.6, 3]));
  camera.lookAt(0, 0, 0);
  return camera;
}

const MESHES = {
  /** An open box whose sides are not plane. */
  box() {
    const mesh = HalfedgeMesh.cube({ size: 1.6 });
    mesh.deleteFace(0);
    mesh.positions[1] += 0.3;
    mesh.positions[14] -= 0.4;
    return mesh;
  },
  /** Quads that are not plane: of all of them the front is seen from above. */
  hills(size = 4) {
    const mesh = HalfedgeMesh.grid(size, size, { width: 1.8, height: 1.8 });
    for (let v = 0; v < mesh.vertexCount; v++) mesh.positions[3 * v + 2] += 0.02 * ((v * v) % 3);
    return mesh;
  },
};

const HELPERS = {
  HalfedgesHelper: (mesh, lines) => new helpers.HalfedgesHelper(mesh, { lines, linewidth: 3 }),
  BoundaryLoopsHelper: (mesh, lines) => new helpers.BoundaryLoopsHelper(mesh, { lines }),
  CirculatorHelper: (mesh, lines) =>
    new helpers.CirculatorHelper(mesh, 'vertexVertices', 6, { lines, linewidth: 6 }),
  ProblemsHelper(mesh, lines) {
    const problems = ['vertex', 'face', 'halfedge'].map((kind) => ({ kind, index: 3 }));
    return new helpers.ProblemsHelper(mesh, { lines, problems });
  },
};

const surfaceOf = (geometry, options) =>
  new THREE.Mesh(
    geometry,
    new THREE.MeshBasicMaterial({ color: 0xdddddd, side: THREE.DoubleSide, ...options }),
  );

function sceneOf(...objects) {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xffffff);
  return scene.add(...objects);
}

const linesFor = (name) => (name === 'WebGLRenderer' ? undefined : webgpuLines);

/** A helper upon its mesh, or without a surface. */
async function drawHelper(name, { helper, mesh, camera, depths, surface = true }) {
  const shown = MESHES[mesh]();
  const lines = HELPERS[helper](shown, linesFor(name));
  const object = surface ? surfaceOf(new helpers.MeshGeometry(shown)) : new THREE.Group();
  const scene = sceneOf(object.add(lines));
  return picture(await rendererOf(name, depths), scene, cameraOf(camera));
}

const isInk = (pixels, i) => {
  const [r, g, b] = pixels.subarray(i, i + 3);
  return Math.max(r, g, b) - Math.min(r, g, b) > 20;
};

/** How many pixels of each picture are coloured, and how many of the two are different. */
function compare(one, other) {
  let [ink, otherInk, differ] = [0, 0, 0];
  for (let i = 0; i < one.length; i += 4) {
    if (isInk(one, i)) ink += 1;
    if (isInk(other, i)) otherInk += 1;
    if ([0, 1, 2].some((k) => Math.abs(one[i + k] - other[i + k]) > 20)) differ += 1;
  }
  return { ink, otherInk, differ };
}

/** Puts a picture into the page, for those who look at it. */
function show(pixels) {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: WIDTH, height: HEIGHT });
  const data = new ImageData(new Uint8ClampedArray(pixels), WIDTH, HEIGHT);
  canvas.getContext('2d').putImageData(data, 0, 0);
  document.body.append(canvas);
}

/** What a helper looks like with a renderer, beside WebGLRenderer. */
async function likeWebGL(name, options) {
  const [expected, found] = [
    await drawHelper('WebGLRenderer', options),
    await drawHelper(name, options),
  ];
  show(expected);
  show(found);
  return compare(expected, found);
}

/** What a helper looks like without a surface, beside one upon it. */
async function uponSurface(name, options) {
  const [alone, upon] = [
    await drawHelper(name, { ...options, surface: false }),
    await drawHelper(name, options),
  ];
  show(upon);
  return compare(alone, upon);
}

/** Bytes that went into buffers of vertices and of indices that were there already. */
const sent = { bytes: 0 };

const { bufferSubData } = WebGL2RenderingContext.prototype;
const uniforms = WebGL2RenderingContext.UNIFORM_BUFFER;
WebGL2RenderingContext.prototype.bufferSubData = function (target, at, data, from, length) {
  if (target !== uniforms)
    sent.bytes += (length || data.length - (from ?? 0)) * data.BYTES_PER_ELEMENT;
  return bufferSubData.call(this, target, at, data, from, length);
};
const { writeBuffer } = GPUQueue.prototype;
GPUQueue.prototype.writeBuffer = function (buffer, at, data, from, length) {
  if (buffer.usage & (GPUBufferUsage.VERTEX | GPUBufferUsage.INDEX)) {
    sent.bytes += (length ?? data.length - (from ?? 0)) * data.BYTES_PER_ELEMENT;
  }
  return writeBuffer.call(this, buffer, at, data, from, length);
};

function coloured(mesh) {
  mesh.attributes.add('vertex', 'color', { type: 'uint8', components: 3 });
  const colors = mesh.attributes.get('vertex', 'color');
  for (let i = 0; i < colors.length; i++) colors[i] = (37 * i) % 256;
  return mesh;
}

/** Edits that change few items, then so many that all buffers have to grow. */
const EDITS = {
  nothing() {},
  poke: (mesh) => mesh.poke(5, 0.2),
  move(mesh) {
    mesh.positions[3 * 80 + 2] += 0.1;
  },
  delete: (mesh) => mesh.deleteFace(70),
  grow(mesh) {
    for (let i = 0; i < 2; i++) for (const f of [...mesh.faces()]) mesh.poke(f, 0.02);
  },
  'move again': (mesh) => EDITS.move(mesh),
  compact(mesh) {
    mesh.deleteFace(3);
    mesh.compact();
  },
};

/**
 * Edits a mesh that is drawn, again and again: how much of each picture is different from one made anew, and how many bytes
 * were sent to the graphics card, beside what the geometry said, and all that there is of the lines.
 */
async function edited(name, normals) {
  const renderer = await rendererOf(name);
  const camera = cameraOf('above');
  const mesh = coloured(MESHES.hills(12));
  const options = { lines: linesFor(name), pixel: 0.003, linewidth: 1 };
  const geometry = new helpers.MeshGeometry(mesh, { normals });
  const arrows = new helpers.HalfedgesHelper(mesh, options);
  const look = { vertexColors: true, color: 0xffffff };
  const surface = surfaceOf(geometry, look);
  const scene = sceneOf(surface, arrows);
  await picture(renderer, scene, camera);
  const steps = {};
  for (const [edit, run] of Object.entries(EDITS)) {
    run(mesh);
    const { bytes } = geometry.update();
    sent.bytes = 0;
    arrows.visible = false;
    await picture(renderer, scene, camera);
    const forSurface = sent.bytes;
    arrows.update();
    arrows.visible = true;
    const found = await picture(renderer, scene, camera);
    const forLines = sent.bytes - forSurface;
    const { instanceStart, instanceColorStart } = arrows.children[0].geometry.attributes;
    const allLines = instanceStart.data.array.byteLength + instanceColorStart.data.array.byteLength;
    const anew = surfaceOf(helpers.toBufferGeometry(mesh, { normals }).geometry, look);
    const fresh = new helpers.HalfedgesHelper(mesh, options);
    const { ink, differ } = compare(await picture(renderer, sceneOf(anew, fresh), camera), found);
    if (edit === 'compact') show(found);
    steps[edit] = { ink, differ, bytes, forSurface, forLines, allLines };
  }
  return steps;
}

/** How many programs there are for a helper, and then for a clone of it and for others. */
async function programs(name) {
  const renderer = await rendererOf(name, 'alpha');
  const helper = HELPERS.HalfedgesHelper(MESHES.box(), webgpuLines);
  await picture(renderer, sceneOf(helper), cameraOf());
  const before = renderer.info.memory.programs;
  const others = Object.values(HELPERS).map((make) => make(MESHES.hills(), webgpuLines));
  await picture(renderer, sceneOf(helper, helper.clone(), ...others), cameraOf('orthographic'));
  return [before, renderer.info.memory.programs];
}

/** What is thrown where a helper has the lines of another renderer, twice; and then a picture of one that hasn't. */
async function withWrongLines(name) {
  const renderer = await rendererOf(name, 'stencil');
  const camera = cameraOf();
  const wrong = name === 'WebGLRenderer' ? webgpuLines : undefined;
  const scene = sceneOf(HELPERS.HalfedgesHelper(MESHES.box(), wrong));
  const thrown = [];
  for (let i = 0; i < 2; i++) {
    try {
      await picture(renderer, scene, camera);
    } catch (error) {
      thrown.push(`${error}`);
    }
  }
  const right = sceneOf(HELPERS.HalfedgesHelper(MESHES.box(), linesFor(name)));
  const pixels = await picture(renderer, right, camera);
  return { thrown, ink: compare(pixels, pixels).ink };
}

Object.assign(window, { likeWebGL, uponSurface, edited, programs, withWrongLines });
document.title = 'ready';
