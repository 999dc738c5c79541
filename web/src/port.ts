// The end of a connection that is in a worker: the same for browsers and Node.

/** This end of the connection. */
export interface Port<Request, Reply> {
  post(reply: Reply, transfer: object[]): void;
  listen(listener: (request: Request) => void): void;
}

/** In a browser the global object, in Node one of its modules: not imported, as a bundler would follow. */
export function openPort<Request, Reply>(): Port<Request, Reply> {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  const { parentPort } = (threads ?? {}) as { parentPort?: NodePort<Request, Reply> };
  if (parentPort) {
    return {
      post: (reply, transfer) => parentPort.postMessage(reply, transfer),
      listen: (listener) => parentPort.on('message', listener),
    };
  }
  const scope = globalThis as unknown as WebScope<Request, Reply>;
  return {
    post: (reply, transfer) => scope.postMessage(reply, transfer),
    listen: (listener) => scope.addEventListener('message', ({ data }) => listener(data)),
  };
}

interface NodePort<Request, Reply> {
  postMessage(reply: Reply, transfer: object[]): void;
  on(type: 'message', listener: (request: Request) => void): void;
}
interface WebScope<Request, Reply> {
  postMessage(reply: Reply, transfer: object[]): void;
  addEventListener(type: 'message', listener: (event: { data: Request }) => void): void;
}
