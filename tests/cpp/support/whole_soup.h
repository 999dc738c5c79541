#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/polygons.h>

#include <cstddef>

namespace halfedge::test {

/// That the arrays of a soup fit together, and corners are vertices if they must be.
inline void expect_whole(const PolygonSoup& soup, bool corners_exist) {
  ASSERT_EQ(soup.positions.size() % 3, 0U);
  std::size_t corners = 0;
  for (const Index size : soup.sizes) corners += size;
  if (soup.sizes.empty()) {
    ASSERT_EQ(soup.corners.size() % 3, 0U);
  } else {
    ASSERT_EQ(corners, soup.corners.size());
  }
  if (!corners_exist) return;
  for (const Index v : soup.corners) ASSERT_LT(v, soup.positions.size() / 3);
}

}  // namespace halfedge::test
