#pragma once

// What keeps the compiled code small, WebAssembly's above all. The linker copies functions of other
// files into their callers as well, so that it isn't enough to define one in a source file.

/// Before a function that is large for what its callers gain by having it in line.
#if defined(__GNUC__)
#define HALFEDGE_NOINLINE [[gnu::noinline]]
#else
#define HALFEDGE_NOINLINE
#endif

/// The same where it gains nothing but size: in WebAssembly alone.
#if defined(__wasm__)
#define HALFEDGE_NOINLINE_IN_WASM HALFEDGE_NOINLINE
#else
#define HALFEDGE_NOINLINE_IN_WASM
#endif

/// Before a function that is called seldom, as where something is refused: compiled for size.
#if defined(__GNUC__)
#define HALFEDGE_COLD [[gnu::cold, gnu::noinline]]
#else
#define HALFEDGE_COLD
#endif
