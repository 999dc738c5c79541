#pragma once

#include <halfedge/io/parse.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "meshes.h"

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// A scanned mesh of 70 k faces of all valences, from the folder of test meshes, or the mesh of
/// another file; where that is absent, a sphere of 82 k, all of valence 6, which is kinder to
/// branch prediction.
inline NamedMesh base_mesh(std::string path = {}) {
  if (path.empty()) {
    const char* folder = std::getenv("HALFEDGE_DATA");
    path = std::string(folder != nullptr ? folder : HALFEDGE_DATA_DIR) + "/good/bunny_pmp.off";
  }
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> text((std::istreambuf_iterator<char>(file)),
                               std::istreambuf_iterator<char>());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  halfedge::Result<halfedge::ParsedFile> parsed = halfedge::parse({bytes, text.size()});
  if (!parsed) return {"a subdivided sphere (no " + path + ")", sphere(6)};
  const halfedge::PolygonSoup& soup = parsed.value().soup;
  return {
      "a scanned bunny, subdivided",
      {{soup.positions.begin(), soup.positions.end()}, {soup.corners.begin(), soup.corners.end()}}};
}
