// Where a browser draws that needs a screen, though nobody looks: Xvfb, with WebGL in software.

import { spawn } from 'node:child_process';
import { which } from './run.mjs';

/**
 * Starts one at the first number that is free: what a browser needs in its environment to draw there, and how to stop
 * it. Where there is no Xvfb, browsers draw where they always do.
 *
 * @returns {Promise<{ environment: Record<string, string>, stop: () => void }>}
 */
export async function startDisplay() {
  const xvfb = which('Xvfb');
  if (xvfb === undefined) return { environment: {}, stop() {} };
  const args = ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'];
  const display = spawn(xvfb, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const number = await new Promise((resolve, reject) => {
    display.on('error', reject);
    display.on('close', (status) => reject(new Error(`Xvfb ended (${status}).`)));
    display.stdio[3]?.once('data', (text) => resolve(String(text).trim()));
  });
  return {
    environment: { DISPLAY: `:${number}`, LIBGL_ALWAYS_SOFTWARE: '1' },
    stop: () => display.kill(),
  };
}
