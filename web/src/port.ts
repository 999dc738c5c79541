// The end of a connection that is in a worker: the same for browsers and Node.

import { nodeModule } from './node-module.js';

/** This end of the connection. */
export interface Port<Request, Reply> {
  post(reply: Reply, transfer: object[]): void;
  listen(listener: (request: Request) => void): void;
}

/** In a browser the global object, in Node the port of one of its modules. */
export function openPort<Request, Reply>(): Port<Request, Reply> {
  const threads = nodeModule('node:worker_threads');
  const parentPort = threads?.parentPort as NodePort<Request, Reply> | null | undefined;
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
