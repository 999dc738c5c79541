// The files of the mesh collection, against what its README says of them and against a second
// reader that is as plain as can be.

#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/data_files.h"
#include "support/text_file.h"

namespace halfedge {
namespace {

using test::Parsed;

struct Counts {
  std::size_t vertices;
  std::size_t faces;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& counts) {
    return out << counts.vertices << " vertices, " << counts.faces << " faces";
  }
};

/// The columns V and F of the tables in the README, by file name.
std::map<std::string, Counts> read_table() {
  std::map<std::string, Counts> table;
  std::ifstream readme(test::data_folder() / "README.md");
  for (std::string line; std::getline(readme, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    if (cells.size() < 8 || cells[4].find_first_of("0123456789") == std::string::npos) continue;
    std::istringstream name(cells[1]);
    std::string file;
    name >> file;
    table[file] = {std::strtoul(cells[4].c_str(), nullptr, 10),
                   std::strtoul(cells[6].c_str(), nullptr, 10)};
  }
  return table;
}

/// Where we differ from the README's reader, which is tolerant: it drops wrong faces, and reads on.
const std::map<std::string, Counts> kOtherCounts = {
    {"Box_cr_line_ends.ply", {24, 8}},  // the lines of its header end with CR
    {"delim_test.ply", {24, 8}},        // the same
    {"malformed2.obj", {8, 6}},  // `f` alone is a face of degree 0, for the builder to refuse
    {"whitespace.off", {8, 6}},  // blanks before the header word, and the counts glued to it
};
const std::map<std::string, std::string> kErrors = {
    {"OutOfMemory.off", "truncated"},
    {"assimp_empty.ply", "unknown-format"},
    {"box_UTF16BE.obj", "not-text"},
    {"fuzz_crash.ply", "parse-error"},
    {"invalid-relative-texture-index.obj", "index-out-of-range"},
    {"invalid_truncated.off", "parse-error"},
    {"issue-140-zero-face-idx.obj", "index-out-of-range"},
    {"malformed.obj", "index-out-of-range"},
    {"number_formats.obj", "parse-error"},  // 3.1+e2
    {"syn_nul_bytes.obj", "not-text"},
    {"syn_obj_index_0.obj", "index-out-of-range"},
    {"syn_obj_index_big.obj", "index-out-of-range"},
    {"syn_obj_index_overflow.obj", "index-out-of-range"},
    {"syn_obj_neg_too_far.obj", "index-out-of-range"},
    {"syn_off_index_huge.off", "index-out-of-range"},
    {"syn_off_index_negative.off", "index-out-of-range"},
    {"syn_off_truncated_mid_vertex.off", "truncated"},
    {"syn_off_vertex_count_wrong.off", "truncated"},
    {"syn_ply_count_huge.ply", "truncated"},
    {"syn_ply_index_oob.ply", "index-out-of-range"},
    {"syn_ply_list_len_huge.ply", "truncated"},
    {"syn_ply_no_xyz.ply", "parse-error"},
    {"syn_ply_truncated_binary.ply", "truncated"},
    {"syn_random.ply", "parse-error"},
    {"syn_stl_count_too_large.stl", "truncated"},
    {"syn_stl_header_only.stl", "truncated"},
    {"syn_zero_bytes.stl", "unknown-format"},
};

/// Lines without comments, whatever they end with, joined where a backslash says so.
std::vector<std::string> lines_of(const std::string& text) {
  std::string unix_text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    unix_text += text[i] == '\r' ? '\n' : text[i];
  }
  std::vector<std::string> lines;
  std::istringstream in(unix_text);
  for (std::string line; std::getline(in, line);) {
    for (std::string more; line.ends_with('\\') && std::getline(in, more);) {
      line.back() = ' ';
      line += more;
    }
    const std::size_t comment = line.find('#');
    const bool number = comment != std::string::npos && comment > 0 && line[comment - 1] == '.';
    lines.push_back(number ? line : line.substr(0, comment));
  }
  return lines;
}

float to_float(const std::string& number) {
  if (number.find("1.#INF") != std::string::npos) return number[0] == '-' ? -INFINITY : INFINITY;
  if (number.find("1.#IND") != std::string::npos) return NAN;
  return std::strtof(number.c_str(), nullptr);
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  constexpr const char* kBlanks = " \t";
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

Parsed plain_obj(const std::string& text) {
  Parsed file;
  for (const std::string& line : lines_of(text)) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    if (words[0] == "v") {
      for (std::size_t i = 1; i <= 3; ++i) file.positions.push_back(to_float(words.at(i)));
    } else if (words[0] == "f") {
      file.faces.emplace_back();
      for (std::size_t i = 1; i < words.size(); ++i) {
        const long index = std::strtol(words[i].c_str(), nullptr, 10);
        const auto so_far = static_cast<long>(file.positions.size() / 3);
        file.faces.back().push_back(static_cast<Index>(index < 0 ? so_far + index : index - 1));
      }
    }
  }
  return file;
}

/// Numbers wherever the line breaks are (one of the files breaks a face), but for the rest of a
/// line behind a face: its colour.
Parsed plain_off(const std::string& text) {
  std::string numbers;
  for (const std::string& line : lines_of(text.substr(text.find("OFF") + 3))) {
    if (!line.empty()) numbers += line + "\n";
  }
  std::istringstream in(numbers);
  std::string word;
  std::string rest;
  Parsed file;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  in >> vertices >> faces;
  std::getline(in, rest);
  for (std::size_t i = 0; i < 3 * vertices && in >> word; ++i) {
    file.positions.push_back(to_float(word));
  }
  for (std::size_t i = 0; i < faces; ++i) {
    std::size_t degree = 0;
    in >> degree;
    file.faces.emplace_back(degree);
    for (Index& vertex : file.faces.back()) in >> vertex;
    std::getline(in, rest);
  }
  return file;
}

void expect_equal(const Parsed& ours, const Parsed& plain) {
  EXPECT_EQ(ours.faces, plain.faces);
  ASSERT_EQ(ours.positions.size(), plain.positions.size());
  for (std::size_t i = 0; i < plain.positions.size(); ++i) {
    if (std::isnan(plain.positions[i])) {
      ASSERT_TRUE(std::isnan(ours.positions[i])) << i;
    } else {
      ASSERT_EQ(ours.positions[i], plain.positions[i]) << i;
    }
  }
}

Format format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (extension == ".obj") return Format::kObj;
  if (extension == ".off") return Format::kOff;
  return extension == ".ply" ? Format::kPly : Format::kStl;
}

class DataFiles : public testing::TestWithParam<const char*> {};

TEST_P(DataFiles, ReadAsTheReadmeSaysOrEndInTheRightError) {
  HALFEDGE_NEEDS_DATA();
  const std::map<std::string, Counts> table = read_table();
  const auto files = test::data_files(GetParam(), {".obj", ".off", ".ply", ".stl"});
  EXPECT_FALSE(files.empty());
  for (const auto& path : files) {
    const std::string name = path.filename().string();
    SCOPED_TRACE(name);
    const Format format = format_of(path);
    const std::string text = test::read_file(path);
    const auto result = parse(test::bytes_of(text), format);
    if (const auto error = kErrors.find(name); error != kErrors.end()) {
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().code, error->second);
      continue;
    }
    ASSERT_TRUE(result) << result.error().message;
    const Parsed file = test::flatten(result);
    if (format == Format::kObj) expect_equal(file, plain_obj(text));
    if (format == Format::kOff && !result.value().binary) expect_equal(file, plain_off(text));
    const auto other = kOtherCounts.find(name);
    if (other != kOtherCounts.end() || table.contains(name)) {
      EXPECT_EQ((Counts{file.positions.size() / 3, file.faces.size()}),
                other != kOtherCounts.end() ? other->second : table.at(name));
    }
  }
}

// Whatever else there is: an error that says so, and never a soup.
TEST_P(DataFiles, OfOtherFormatsAreRefused) {
  HALFEDGE_NEEDS_DATA();
  for (const auto& path : test::data_files(GetParam(), {".gltf", ".glb", ".bin"})) {
    SCOPED_TRACE(path.filename().string());
    const std::string text = test::read_file(path);
    const auto result = parse(test::bytes_of(text));
    ASSERT_FALSE(result);
    EXPECT_TRUE(
        (std::set<std::string_view>{"unsupported-format", "unknown-format", "not-text"}.contains(
            result.error().code)))
        << result.error().code << ": " << result.error().message;
  }
}

// The same mesh in several forms, byte order by byte order and element order by element order.
TEST(DataFormats, AgreeOnTheSameMesh) {
  HALFEDGE_NEEDS_DATA();
  const auto read = [](const char* name) {
    return test::flatten(
        parse(test::bytes_of(test::read_file(test::data_folder() / "good" / name))));
  };
  const Parsed shelf = read("platonic_shelf_ascii.ply");
  EXPECT_EQ(shelf.error, "");
  EXPECT_EQ(read("platonic_shelf_binary_le.ply").faces, shelf.faces);
  EXPECT_EQ(read("platonic_shelf_big_endian.ply").faces, shelf.faces);
  EXPECT_EQ(read("platonic_shelf_big_endian.ply").positions,
            read("platonic_shelf_binary_le.ply").positions);
  EXPECT_EQ(read("stl_box_ascii.stl").faces, read("stl_box_binary.stl").faces);
  EXPECT_EQ(read("stl_box_ascii.stl").positions, read("stl_box_binary.stl").positions);
  EXPECT_EQ(read("icosahedron_ascii.stl").faces, read("icosahedron_binary.stl").faces);
}

INSTANTIATE_TEST_SUITE_P(Collection, DataFiles, testing::Values("good", "nasty"),
                         [](const auto& folder) { return std::string(folder.param); });

}  // namespace
}  // namespace halfedge
