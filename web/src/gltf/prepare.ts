import { describe } from '../arguments.js';
import { fileError } from './container.js';
import type { GltfDocument, GltfNode, GltfPrimitive } from './document.js';
import { checkCompressed, knownName, MESHOPT } from './meshopt.js';

/** Decoders for compressed geometry. */
export interface GltfDecoders {
  /** three.js's DRACOLoader, for KHR_draco_mesh_compression. */
  readonly dracoLoader?: object | undefined;
  /** A MeshoptDecoder, for EXT_meshopt_compression and KHR_meshopt_compression; three.js's if left out. */
  readonly meshoptDecoder?: object | undefined;
}

const DRACO = 'KHR_draco_mesh_compression';
const INSTANCING = 'EXT_mesh_gpu_instancing';
/** Extensions that have to do with geometry; others that are about looks don't matter here. */
const GEOMETRY = [DRACO, ...MESHOPT, INSTANCING, 'KHR_mesh_quantization'];
const LOOKS =
  /^(KHR|EXT|AGI|MSFT|NV|FB|GOOGLE|MOZ)_(materials?|textures?|lights?|xmp|animation|audio)/;

const LINES_AND_POINTS = 4;

/** three.js warns where there are none, and takes any; nothing reads them. */
const NO_BOUNDS = { min: [0, 0, 0], max: [0, 0, 0] };

/** What is left of a document. */
export interface Prepared {
  readonly document: GltfDocument;
  /** What was left out and a user may want to know, one sentence each. */
  readonly notes: string[];
}

/**
 * Leaves of a document what makes geometry, of the scene that is shown, so that three.js's loader looks
 * for no image.
 */
export function prepare(
  document: GltfDocument,
  decoders: GltfDecoders,
  fileSize: number,
): Prepared {
  checkExtensions(document, decoders);
  const notes = new Notes();
  const meshes = document.meshes.map(({ primitives, name }) => ({
    ...(typeof name === 'string' ? { name } : {}),
    primitives: primitives.flatMap((primitive) => {
      const kept = geometryOf(primitive, decoders, notes);
      if (kept === undefined) return [];
      const { attributes, indices = [], extensions } = kept;
      const read = [...Object.values(attributes), indices].flat();
      if (extensions === undefined) {
        checkFallback(document, primitive);
        checkSizes(document, read, fileSize);
      }
      return [kept];
    }),
  }));
  const nodes = document.nodes.map((node): GltfNode => {
    const { camera, skin, weights, name, extras, extensions = {}, mesh, ...rest } = node;
    if (skin !== undefined) notes.count('skins of nodes');
    // three.js makes no mesh without primitives.
    const kept =
      mesh === undefined || meshes[mesh].primitives.length === 0 ? rest : { ...rest, mesh };
    const instances = extensions[INSTANCING];
    if (instances === undefined) return kept;
    checkSizes(document, Object.values(Object(instances.attributes)), fileSize);
    return { ...kept, extensions: { [INSTANCING]: instances } };
  });
  const isUsed = (name: string) =>
    GEOMETRY.includes(name) && (name !== DRACO || decoders.dracoLoader !== undefined);
  const { asset, accessors, buffers } = document;
  const bufferViews = document.bufferViews.map((view, i) => checkCompressed(view, i, document));
  return {
    document: {
      ...{ asset, bufferViews, buffers, meshes, ...shownScene(document, nodes) },
      accessors: accessors.map((accessor) => ({ ...accessor, ...NO_BOUNDS })),
      extensionsUsed: document.extensionsUsed?.filter(isUsed).map(knownName) ?? [],
      extensionsRequired: document.extensionsRequired?.filter(isUsed).map(knownName) ?? [],
    },
    notes: notes.sentences(),
  };
}

/** The scene of the file; where it has none, all nodes, and where those are missing too, all meshes. */
function shownScene({ scenes, scene = 0, meshes }: GltfDocument, nodes: GltfNode[]) {
  if (scenes.length > 0) return { scene: 0, scenes: [{ nodes: scenes[scene].nodes ?? [] }], nodes };
  const all = nodes.length > 0 ? nodes : meshes.map((_, mesh): GltfNode => ({ mesh }));
  const children = new Set(all.flatMap((node) => node.children ?? []));
  const roots = [...all.keys()].filter((i) => !children.has(i));
  return { scene: 0, scenes: [{ nodes: roots }], nodes: all };
}

/** What a primitive has of triangles, or undefined. */
function geometryOf(
  { attributes, indices, mode = 4, targets, extensions = {} }: GltfPrimitive,
  { dracoLoader }: GltfDecoders,
  notes: Notes,
): GltfPrimitive | undefined {
  if (mode < LINES_AND_POINTS) {
    notes.count(mode === 0 ? 'primitives of points' : 'primitives of lines');
    return undefined;
  }
  if (attributes.POSITION === undefined) {
    notes.count('primitives without positions');
    return undefined;
  }
  if (targets !== undefined) notes.count('morph targets of primitives');
  const kept: [string, number][] = [];
  for (const [semantic, accessor] of Object.entries(attributes)) {
    if (SEMANTICS.includes(semantic)) kept.push([semantic, accessor]);
    else notes.count(`the attribute ${describe(semantic)} of primitives`);
  }
  const compressed = dracoLoader === undefined ? undefined : extensions[DRACO];
  return {
    attributes: Object.fromEntries(kept),
    mode,
    ...(indices === undefined ? {} : { indices }),
    ...(compressed === undefined ? {} : { extensions: { [DRACO]: compressed } }),
  };
}

const SEMANTICS = ['POSITION', 'NORMAL', 'TEXCOORD_0', 'COLOR_0'];

/** What was left out. */
class Notes {
  readonly #counts = new Map<string, number>();

  count(what: string): void {
    this.#counts.set(what, (this.#counts.get(what) ?? 0) + 1);
  }

  sentences(): string[] {
    return [...this.#counts].map(([what, count]) => `Ignored ${what} (${count}).`);
  }
}

function checkExtensions(document: GltfDocument, decoders: GltfDecoders): void {
  const required = document.extensionsRequired ?? [];
  if (required.includes(DRACO) && decoders.dracoLoader === undefined) throw needsDraco();
  const unknown = required.find((name) => !GEOMETRY.includes(name) && !LOOKS.test(name));
  if (unknown === undefined) return;
  throw fileError(
    'unsupported-format',
    `glTF: the file requires the extension ${JSON.stringify(unknown)}, which is not supported.`,
  );
}

const needsDraco = () =>
  fileError(
    'unsupported-format',
    `glTF: the geometry is compressed (${DRACO}): it needs three.js's DRACOLoader as options.dracoLoader.`,
  );

/** Where a file doesn't require the decoder, it should have the geometry uncompressed too; some don't. */
function checkFallback({ accessors }: GltfDocument, primitive: GltfPrimitive): void {
  if (primitive.extensions?.[DRACO] === undefined) return;
  const { bufferView, sparse } = accessors[primitive.attributes.POSITION];
  if (bufferView === undefined && sparse === undefined) throw needsDraco();
}

/** Rows without a buffer are zeros: they cost no bytes in the file, but memory. */
function checkSizes({ accessors }: GltfDocument, read: number[], fileSize: number): void {
  for (const index of read) {
    const { bufferView, count } = accessors[index];
    if (bufferView !== undefined || count <= fileSize) continue;
    throw fileError(
      'too-large',
      `glTF: accessors[${index}] has ${count} rows of zeros, expected no more than the file has bytes.`,
    );
  }
}
