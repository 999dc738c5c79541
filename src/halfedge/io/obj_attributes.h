#pragma once

#include <halfedge/build/soup_attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/text_scanner.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace halfedge::io {

/// What programs write for faces without a material.
inline constexpr std::string_view kNoMaterial = "(null)";

/// Collects what an OBJ file says beside positions and faces. What reads false has run out of
/// memory; text that is none of what it should be is passed over.
class ObjAttributes {
 public:
  /// The references of a corner, as written; 0 for none.
  struct Corner {
    std::int64_t texture = 0;
    std::int64_t normal = 0;
  };
  enum class Name : std::uint8_t { kGroup, kObject, kMaterial };

  [[nodiscard]] bool read_texture(TextScanner& text) { return read_row(text, 2, textures_); }
  [[nodiscard]] bool read_normal(TextScanner& text) { return read_row(text, 3, normals_); }
  /// Of the vertex of this index: three numbers, or four with alpha. A single one is a weight,
  /// which is counted.
  [[nodiscard]] bool read_color(TextScanner& text, std::size_t vertex);
  [[nodiscard]] bool add_corner(std::size_t corner, const Corner& references);
  /// The rest of the line names the faces from this one on.
  [[nodiscard]] bool read_name(TextScanner& text, Name kind, std::size_t face);
  /// The number of the group, or off, of the faces from this one on.
  [[nodiscard]] bool read_smoothing(TextScanner& text, std::size_t face);
  void read_library(TextScanner& text);

  /// Makes columns and tables of names of all that.
  [[nodiscard]] bool finish(std::size_t vertices, std::size_t faces, ParsedFile& file);

 private:
  /// Values, and which of them a corner has.
  struct Table {
    Array<float> values;
    Array<Index> rows;  // by corner
  };
  struct Run {
    std::size_t first_face;
    Index id;
  };
  struct Names {
    std::map<std::string_view, Index> ids;
    std::vector<std::string_view> in_order;
    Array<Run> runs;
    bool is_cut = false;  // there were too many
  };

  [[nodiscard]] bool read_row(TextScanner& text, std::size_t width, Table& table);
  [[nodiscard]] bool refer(Table& table, std::size_t width, std::size_t corner,
                           std::int64_t reference);
  [[nodiscard]] bool widen_colors();
  [[nodiscard]] bool finish_table(Table& table, const char* name, Index width, ParsedFile& file);
  [[nodiscard]] bool finish_colors(std::size_t vertices, ParsedFile& file);
  [[nodiscard]] static bool finish_names(Names& names, const char* name, std::size_t faces,
                                         ParsedFile& file);
  [[nodiscard]] bool finish_smoothing(std::size_t faces, ParsedFile& file);
  void note_losses(ParsedFile& file) const;

  Table textures_;
  Table normals_;
  Array<float> colors_;
  std::size_t color_width_ = 0;
  std::array<Names, 3> names_;
  std::vector<std::string> libraries_;
  Array<Run> smoothing_;        // the ids are the numbers of groups
  bool is_smooth_ = false;      // one of them isn't 0
  std::size_t unknown_ = 0;     // references to what the file doesn't have
  std::size_t malformed_ = 0;   // texture coordinates and normals that aren't numbers alone
  std::size_t extra_ = 0;       // vertices with something else behind their positions
  std::size_t depths_ = 0;      // third texture coordinates that aren't 0
  std::size_t weights_ = 0;     // of vertices, that aren't 1
  std::size_t strange_ = 0;     // numbers of smoothing groups that are none
  std::size_t unused_[2] = {};  // texture coordinates and normals to which no corner refers
};

}  // namespace halfedge::io
