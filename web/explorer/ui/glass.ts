/**
 * Cards are glass where a graphics card draws: it blurs what is behind them. A processor would need longer for that than
 * for the mesh, in each frame, so that cards are opaque there, as they are for who prefers it (styles/tokens.css).
 */
export function chooseGlass(canvas: HTMLCanvasElement): void {
  document.documentElement.dataset.cards = isDrawnByProcessor(canvas) ? 'opaque' : 'glass';
}

/** Whether WebGL draws to this canvas without a graphics card. */
function isDrawnByProcessor(canvas: HTMLCanvasElement): boolean {
  const gl = canvas.getContext('webgl2');
  if (!gl) return false;
  let name: unknown = gl.getParameter(gl.RENDERER);
  // Firefox says it at once, and warns of the extension.
  const behind = name === 'WebKit WebGL' && gl.getExtension('WEBGL_debug_renderer_info');
  if (behind) name = gl.getParameter(behind.UNMASKED_RENDERER_WEBGL);
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(name));
}
