// What the benchmark of the explorer runs in the page. Each function is sent there by itself.

/** Before anything else: notes how long callbacks of frames take, and what goes to the graphics card. */
export function prepare() {
  const request = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.frames = [];
  globalThis.requestAnimationFrame = (callback) =>
    request((now) => {
      const began = performance.now();
      callback(now);
      globalThis.frames.push(performance.now() - began);
    });
  globalThis.uploaded = 0;
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['bufferData', 'bufferSubData']) {
    const upload = prototype[name];
    prototype[name] = function (...args) {
      const [, data] = name === 'bufferData' ? args : args.slice(1);
      const { byteLength = 0, BYTES_PER_ELEMENT = 1 } = data ?? {};
      // The fifth argument is the number of elements, where there is one.
      globalThis.uploaded += args[4] > 0 ? args[4] * BYTES_PER_ELEMENT : byteLength;
      return upload.apply(this, args);
    };
  }
}

/** Notes when a file was chosen, when its mesh had come over, and when the picture was at rest. */
export function watchOpening() {
  const stages = { chosen: 0, decoded: 0, rested: 0 };
  globalThis.stages = stages;
  const stage = document.querySelector('main.stage');
  document.querySelector('[data-file]').addEventListener('change', () => {
    stages.chosen = performance.now();
  });
  // The last progress comes with the mesh; what follows is the page's own work.
  new MutationObserver(() => {
    stages.decoded = performance.now();
  }).observe(document.querySelector('.busy progress'), {
    attributes: true,
    attributeFilter: ['value'],
  });
  new MutationObserver(() => {
    const isReady = document.documentElement.dataset.state === 'ready';
    if (isReady && stage.dataset.mesh === 'large.ply') stages.rested ||= performance.now();
  }).observe(document.documentElement, { attributes: true });
}

/** Moves the pointer over the mesh; returns how long each time took to find what is under it. */
export async function point({ times, pause }) {
  const canvas = document.querySelector('canvas');
  const took = [];
  for (let i = 0; i < times; i++) {
    const place = { clientX: 250 + ((i * 97) % 400), clientY: 250 + ((i * 61) % 300) };
    globalThis.frames.length = 0;
    canvas.dispatchEvent(new PointerEvent('pointermove', { ...place, bubbles: true }));
    await new Promise((done) => setTimeout(done, pause));
    while (globalThis.frames.length === 0) await new Promise((done) => setTimeout(done, 20));
    took.push(globalThis.frames[0]);
  }
  return took;
}

/** Turns the camera by the keyboard; returns how long the callback of each frame took. */
export async function orbit(times) {
  const took = [];
  for (let i = 0; i < times; i++) {
    const key = i % 20 < 10 ? 'ArrowLeft' : 'ArrowRight';
    globalThis.frames.length = 0;
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    while (globalThis.frames.length === 0) await new Promise((done) => setTimeout(done, 20));
    took.push(Math.max(...globalThis.frames));
  }
  return took;
}

/** Flips edges; returns for each how long it took until it was drawn, and the bytes uploaded. */
export async function edit(times) {
  const field = document.querySelector('.goto input');
  const rest = async () => {
    do await new Promise((done) => setTimeout(done, 300));
    while (document.documentElement.dataset.state !== 'ready');
  };
  const measured = [];
  for (let i = 0; i < times; i++) {
    field.value = `e${1000 + 3000 * i}`;
    field.form.requestSubmit();
    await rest();
    globalThis.uploaded = 0;
    globalThis.frames.length = 0;
    const began = performance.now();
    document.querySelector('[data-operation=flipEdge]').click();
    while (globalThis.frames.length === 0) await new Promise((done) => setTimeout(done, 5));
    const took = performance.now() - began;
    await rest();
    measured.push({ took, bytes: globalThis.uploaded });
  }
  return measured;
}
