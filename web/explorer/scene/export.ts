import type { Stage } from 'halfedge/scene';
import {
  Color,
  GreaterDepth,
  type Object3D,
  type Points,
  type ShaderMaterial,
  Vector3,
} from 'three';
import type { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';

/** A part of the canvas, in CSS pixels. */
export interface Frame {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A label as the page shows it. */
interface Tag extends Frame {
  readonly text: string;
  /** How wide the text is in the font of the page, which others may not have. */
  readonly textWidth: number;
  readonly color: string;
  readonly background: string;
  readonly border: string;
  readonly borderWidth: number;
  /** Of the corners. */
  readonly radius: number;
  readonly fontSize: number;
  readonly fontWeight: string;
  readonly fontFamily: string;
  /** The colour around the letters of a label without a background. */
  readonly halo: string | null;
  readonly opacity: number;
}

/** The picture as pixels, two to the CSS pixel, labels included. */
export async function pngOf(stage: Stage, frame: Frame, host: HTMLElement): Promise<Blob> {
  const canvas = stage.capture(frame);
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  context.scale(canvas.width / frame.width, canvas.height / frame.height);
  for (const tag of tagsIn(host, frame).reverse()) paint(context, tag);
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('The browser made no PNG of the picture: it may be too large.');
  return blob;
}

/**
 * The picture as SVG: the surface as an image, over it arrows and lines as paths, discs as circles and
 * labels as text. What the surface hides is left out, or faint where the page shows it faintly.
 */
export function svgOf(
  stage: Stage,
  frame: Frame,
  host: HTMLElement,
  hides: (point: Vector3) => boolean,
): Blob {
  const drawn = overlays(stage.scene, stage.camera.layers.mask);
  const surface = stage.capture(frame, new Set(drawn)).toDataURL('image/png');
  const { width, height } = frame;
  const pen = new Pen(stage, frame, hides);
  const parts = drawn.map((object) =>
    isLines(object) ? pen.lines(object) : pen.discs(object as Points),
  );
  const svg = [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">`,
    `<image href="${surface}" width="${width}" height="${height}"/>`,
    '<g fill="none" stroke-linecap="round">',
    ...parts,
    '</g>',
    ...tagsIn(host, frame).reverse().map(textOf),
    '</svg>',
  ];
  return new Blob([svg.filter(Boolean).join('\n')], { type: 'image/svg+xml' });
}

function isLines(object: Object3D): object is LineSegments2 {
  return 'isLineSegments2' in object;
}

/** The fat lines and the discs that are drawn, in the order in which they are. */
function overlays(scene: Object3D, layers: number): Object3D[] {
  const found: Object3D[] = [];
  scene.traverseVisible((object) => {
    const isOverlay = isLines(object) || 'isPoints' in object;
    if (isOverlay && object.layers.mask & layers) found.push(object);
  });
  return found.sort((a, b) => a.renderOrder - b.renderOrder);
}

/** Draws what is in the scene as it appears on the canvas. */
class Pen {
  readonly #stage: Stage;
  readonly #frame: Frame;
  readonly #hides: (point: Vector3) => boolean;
  readonly #from = new Vector3();
  readonly #to = new Vector3();
  readonly #middle = new Vector3();
  readonly #color = new Color();

  constructor(stage: Stage, frame: Frame, hides: (point: Vector3) => boolean) {
    this.#stage = stage;
    this.#frame = frame;
    this.#hides = hides;
  }

  lines({ geometry, material }: LineSegments2): string {
    const { instanceStart, instanceEnd, instanceColorStart: colors } = geometry.attributes;
    const hidden = material.depthFunc === GreaterDepth;
    const isOnTop = !material.depthTest;
    const paths = new Map<string, string[]>();
    for (let i = 0; i < geometry.instanceCount; i++) {
      const from = this.#from.fromBufferAttribute(instanceStart, i);
      const to = this.#to.fromBufferAttribute(instanceEnd, i);
      const middle = this.#middle.lerpVectors(from, to, 0.5);
      const segment = this.#segment(from, to);
      if (!segment || (!isOnTop && this.#hides(middle) !== hidden)) continue;
      if (material.vertexColors) {
        this.#color.setRGB(colors.getX(i), colors.getY(i), colors.getZ(i));
      } else {
        this.#color.copy(material.color);
      }
      const stroke = `#${this.#color.getHexString()}`;
      const path = paths.get(stroke) ?? [];
      paths.set(stroke, path);
      path.push(segment);
    }
    const opacity = material.transparent && material.opacity < 1 ? material.opacity : null;
    const looks = `stroke-width="${material.linewidth}"${opacity === null ? '' : ` opacity="${opacity}"`}`;
    return [...paths]
      .map(([stroke, path]) => `<path stroke="${stroke}" ${looks} d="${path.join('')}"/>`)
      .join('\n');
  }

  discs({ geometry, material }: Points): string {
    const { position, tint, size } = geometry.attributes;
    const { uniforms, depthFunc } = material as ShaderMaterial;
    const rim = `#${this.#color.fromArray(uniforms.rim.value).getHexString()}`;
    const circles: string[] = [];
    for (let i = 0; i < geometry.drawRange.count && i < position.count; i++) {
      const point = this.#from.fromBufferAttribute(position, i);
      if (this.#hides(point) !== (depthFunc === GreaterDepth)) continue;
      const { x, y, z } = this.#place(point);
      if (z > 1) continue;
      const fill = `#${this.#color.setRGB(tint.getX(i), tint.getY(i), tint.getZ(i)).getHexString()}`;
      const r = (size.getX(i) - 1.75) / 2;
      const opacity = uniforms.opacity.value;
      circles.push(
        `<circle cx="${short(x)}" cy="${short(y)}" r="${r}" fill="${fill}" stroke="${rim}" stroke-width="1.75" opacity="${opacity}"/>`,
      );
    }
    return circles.join('\n');
  }

  #segment(from: Vector3, to: Vector3): string | null {
    const a = { ...this.#place(from) };
    const b = this.#place(to);
    const { width, height } = this.#frame;
    if (a.z > 1 || b.z > 1) return null;
    if (Math.max(a.x, b.x) < 0 || Math.min(a.x, b.x) > width) return null;
    if (Math.max(a.y, b.y) < 0 || Math.min(a.y, b.y) > height) return null;
    return `M${short(a.x)} ${short(a.y)}L${short(b.x)} ${short(b.y)}`;
  }

  #place(point: Vector3): { x: number; y: number; z: number } {
    const { x, y, z } = this.#stage.project(point, new Vector3());
    return { x: x - this.#frame.x, y: y - this.#frame.y, z };
  }
}

/** The width of the halo, which lies half under the letters; as in label-styles.ts. */
const HALO_PX = 4;

const short = (x: number) => Number(x.toFixed(1));

/** The labels that are in sight, the most important first. */
function tagsIn(host: HTMLElement, frame: Frame): Tag[] {
  const origin = host.getBoundingClientRect();
  const range = document.createRange();
  const tags = [...host.querySelectorAll<HTMLElement>('.tag:not(.away):not([hidden])')];
  return tags.map((tag) => {
    const { left, top, width, height } = tag.getBoundingClientRect();
    const style = getComputedStyle(tag);
    range.selectNodeContents(tag);
    return {
      text: tag.textContent ?? '',
      textWidth: range.getBoundingClientRect().width,
      x: left - origin.left - frame.x,
      y: top - origin.top - frame.y,
      width,
      height,
      color: style.color,
      background: style.backgroundColor,
      border: style.borderTopColor,
      borderWidth: Number.parseFloat(style.borderTopWidth) || 0,
      radius: Math.min(Number.parseFloat(style.borderTopLeftRadius) || 0, height / 2),
      fontSize: Number.parseFloat(style.fontSize),
      fontWeight: style.fontWeight,
      fontFamily: style.fontFamily.replaceAll('"', "'"),
      halo: tag.classList.contains('index') ? style.webkitTextStrokeColor : null,
      opacity: Number(style.opacity),
    };
  });
}

function paint(context: CanvasRenderingContext2D, tag: Tag): void {
  const { x, y, width, height, borderWidth, radius } = tag;
  context.globalAlpha = tag.opacity;
  context.beginPath();
  const inset = borderWidth / 2;
  context.roundRect(x + inset, y + inset, width - borderWidth, height - borderWidth, radius);
  context.fillStyle = tag.background;
  if (tag.halo === null) context.fill();
  if (borderWidth > 0) {
    context.lineWidth = borderWidth;
    context.strokeStyle = tag.border;
    context.stroke();
  }
  context.fillStyle = tag.color;
  context.font = `${tag.fontWeight} ${tag.fontSize}px ${tag.fontFamily}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  if (tag.halo !== null) {
    context.strokeStyle = tag.halo;
    context.lineWidth = HALO_PX;
    context.lineJoin = 'round';
    context.strokeText(tag.text, x + width / 2, y + height / 2 + 0.5);
  }
  context.fillText(tag.text, x + width / 2, y + height / 2 + 0.5);
  context.globalAlpha = 1;
}

function textOf(tag: Tag): string {
  const { x, y, width, height, borderWidth, radius } = tag;
  const text = tag.text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  const font = `font-family="${tag.fontFamily}" font-size="${tag.fontSize}" font-weight="${tag.fontWeight}"`;
  const middle = y + height / 2 + 0.35 * tag.fontSize;
  const place = `x="${short(x + width / 2)}" y="${short(middle)}" text-anchor="middle" fill="${tag.color}" textLength="${short(tag.textWidth)}" lengthAdjust="spacingAndGlyphs"`;
  if (tag.halo !== null) {
    const halo = `stroke="${tag.halo}" stroke-width="${HALO_PX}" stroke-linejoin="round" paint-order="stroke"`;
    return `<text ${place} ${halo} ${font}>${text}</text>`;
  }
  const box = `x="${short(x + borderWidth / 2)}" y="${short(y + borderWidth / 2)}" width="${short(width - borderWidth)}" height="${short(height - borderWidth)}" rx="${short(radius)}"`;
  const stroke = borderWidth > 0 ? ` stroke="${tag.border}" stroke-width="${borderWidth}"` : '';
  return `<g opacity="${tag.opacity}"><rect ${box} fill="${tag.background}"${stroke}/><text ${place} ${font}>${text}</text></g>`;
}
