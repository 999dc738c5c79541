#pragma once

#include <halfedge/io/parse.h>
#include <halfedge/result.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

namespace halfedge::test {

/// The folder of test meshes, which are not part of the project: ../shared/data beside it, or what
/// HALFEDGE_DATA says. It may be absent.
inline std::filesystem::path data_folder() {
  const char* elsewhere = std::getenv("HALFEDGE_DATA");
  return elsewhere != nullptr ? elsewhere : HALFEDGE_DATA_DIR;
}

/// All files in a sub-folder ("good", "nasty") whose extension is one of these, in any case,
/// sorted.
inline std::vector<std::filesystem::path> data_files(const std::string& folder,
                                                     const std::vector<std::string>& extensions) {
  std::vector<std::filesystem::path> files;
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / folder, absent)) {
    std::string extension = entry.path().extension().string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::filesystem::file_size(path), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

/// What a file holds, if our readers know its format.
inline Result<ParsedFile> parse_file(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  return parse({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace halfedge::test

/// Ends the test, saying so, where the test meshes are absent.
#define HALFEDGE_NEEDS_DATA()                                             \
  if (!std::filesystem::exists(halfedge::test::data_folder())) {          \
    GTEST_SKIP() << "no test meshes at " << halfedge::test::data_folder() \
                 << ": set HALFEDGE_DATA to their folder";                \
  }
