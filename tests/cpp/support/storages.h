#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/storage.h>

namespace halfedge::test {

template <Storage kStored>
struct StorageOf {
  static constexpr Storage kStorage = kStored;
};

/// All sixteen ways to leave links out, for typed tests: prev, face, face_halfedge,
/// vertex_halfedge.
using AllStorages = testing::Types<
    StorageOf<Storage{true, true, true, true}>, StorageOf<Storage{true, true, true, false}>,
    StorageOf<Storage{true, true, false, true}>, StorageOf<Storage{true, true, false, false}>,
    StorageOf<Storage{true, false, true, true}>, StorageOf<Storage{true, false, true, false}>,
    StorageOf<Storage{true, false, false, true}>, StorageOf<Storage{true, false, false, false}>,
    StorageOf<Storage{false, true, true, true}>, StorageOf<Storage{false, true, true, false}>,
    StorageOf<Storage{false, true, false, true}>, StorageOf<Storage{false, true, false, false}>,
    StorageOf<Storage{false, false, true, true}>, StorageOf<Storage{false, false, true, false}>,
    StorageOf<Storage{false, false, false, true}>, StorageOf<Storage{false, false, false, false}>>;

}  // namespace halfedge::test
