#pragma once

#include <halfedge/connectivity/handle.h>

// Having lines of memory on their way to the cache before they are needed.

namespace halfedge {

/// Whether there is an instruction for it, with which a loop can ask for what it needs some rounds
/// later, and goes on. WebAssembly has none. A loop can be run in blocks there, and each word that
/// a block needs touched first: these loads don't depend on each other, so that many of them miss
/// the cache at a time, where the loop itself would wait for one after the other.
#if defined(__GNUC__) && !defined(__wasm__)
inline constexpr bool kCanPrefetch = true;
#else
inline constexpr bool kCanPrefetch = false;
#endif

/// Asks for the line of a word that will be written. The address need not be one of an array.
/// Always inlined: g++ takes a function that only prefetches for one without effect and drops it.
[[gnu::always_inline]] inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address, 1);
#endif
}

/// Loads a word, for nothing but that its line is in the cache then.
[[gnu::always_inline]] inline void touch(const Index* word) {
  (void)*static_cast<const volatile Index*>(word);
}

}  // namespace halfedge
