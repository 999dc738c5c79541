/** What is to be called when a signal aborts: by one listener, as Node warns of a leak from eleven on. */
const calls = new WeakMap<AbortSignal, Set<() => void>>();

/** Calls `call` when `signal` aborts, unless what this returns was called before. */
export function onAbort(signal: AbortSignal, call: () => void): () => void {
  const waiting = calls.get(signal) ?? new Set();
  if (waiting.size === 0) {
    calls.set(signal, waiting);
    signal.addEventListener('abort', callAll);
  }
  waiting.add(call);
  return () => {
    if (!waiting.delete(call) || waiting.size > 0) return;
    calls.delete(signal);
    signal.removeEventListener('abort', callAll);
  };
}

function callAll(this: AbortSignal): void {
  for (const call of calls.get(this) ?? []) call();
}
