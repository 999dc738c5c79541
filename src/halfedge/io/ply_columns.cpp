#include <halfedge/io/ply_columns.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge::io {
namespace {

/// Properties that make one attribute, under the names that programs give them.
struct Group {
  const char* name;
  std::string_view properties[4];
  std::size_t fewest;  // of them
};

constexpr Group kGroups[] = {
    {"normal", {"nx", "ny", "nz"}, 3},
    {"color", {"red", "green", "blue", "alpha"}, 3},
    {"color", {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}, 3},
    {"uv", {"s", "t"}, 2},
    {"uv", {"u", "v"}, 2},
    {"uv", {"texture_u", "texture_v"}, 2},
};

Scalar scalar_of(PlyType type) {
  if (type == PlyType::kFloat32) return Scalar::kFloat32;
  if (type == PlyType::kFloat64 || is_long(type)) return Scalar::kFloat64;
  return static_cast<Scalar>(static_cast<int>(type) + 2);  // behind the two
}

OnSplit policy_of(std::string_view name, PlyType type) {
  if (name == "normal" && !is_integer(type)) return OnSplit::kNormalize;
  // The mean of two labels is no label.
  return is_integer(type) && name != "color" ? OnSplit::kCopy : OnSplit::kInterpolate;
}

/// Looking for names takes time in proportion to their number.
constexpr std::size_t kMostColumns = 256;

bool is_named(std::span<const SoupAttribute> columns, SoupItem item, std::string_view name) {
  return std::any_of(columns.begin(), columns.end(), [&](const SoupAttribute& column) {
    return column.item == item && column.name == name;
  });
}

template <class Range, class T>
bool contains(const Range& range, const T& value) {
  return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

class ColumnChooser {
 public:
  ColumnChooser(const PlyElement& element, SoupItem item, std::span<const PlyProperty* const> taken,
                std::vector<SoupAttribute>& columns)
      : element_(element),
        item_(item),
        taken_(taken),
        columns_(columns),
        targets_(element.properties.size()) {}

  [[nodiscard]] std::vector<PlyTarget> choose() {
    for (std::size_t i = 0; i < targets_.size() && columns_.size() < kMostColumns; ++i) {
      if (!is_free(i)) continue;
      const std::string_view name = element_.properties[i].name;
      if (!add_group(i) && !add_components(i)) (void)add(name, std::span(&i, 1));
    }
    return std::move(targets_);
  }

 private:
  [[nodiscard]] bool is_free(std::size_t i) const {
    const PlyProperty& property = element_.properties[i];
    return !property.length_type && targets_[i].column == PlyTarget::kNowhere &&
           std::find(taken_.begin(), taken_.end(), &property) == taken_.end();
  }

  /// The group of this property, in whatever order they come, with as many of its parts as there
  /// are.
  [[nodiscard]] bool add_group(std::size_t member) {
    const PlyProperty& property = element_.properties[member];
    for (const Group& group : kGroups) {
      if (!contains(group.properties, property.name)) continue;
      if (item_ == SoupItem::kFace && std::string_view(group.name) == "uv") continue;
      std::vector<std::size_t> parts;
      for (const std::string_view name : group.properties) {
        const PlyProperty* const found = name.empty() ? nullptr : element_.find(name);
        if (found == nullptr) break;
        const auto i = static_cast<std::size_t>(found - element_.properties.data());
        if (!is_free(i) || found->type != property.type) break;
        parts.push_back(i);
      }
      // An alpha of another type than the rest is none.
      if (parts.size() >= group.fewest && contains(parts, member)) return add(group.name, parts);
    }
    return false;
  }

  /// weight[0], weight[1] and so on, in a row, as the writer names components.
  [[nodiscard]] bool add_components(std::size_t first) {
    std::string_view stem = element_.properties[first].name;
    if (!stem.ends_with("[0]") || stem.size() == 3) return false;
    stem.remove_suffix(3);
    std::vector<std::size_t> parts;
    for (std::size_t i = first; i < targets_.size(); ++i) {
      const PlyProperty& property = element_.properties[i];
      const std::string name = sentence::of("{}[{}]", stem, parts.size());
      if (!is_free(i) || property.name != name || parts.size() == Attribute::kMaxComponents ||
          property.type != element_.properties[first].type) {
        break;
      }
      parts.push_back(i);
    }
    return add(stem, parts);
  }

  [[nodiscard]] bool add(std::string_view name, std::span<const std::size_t> parts) {
    if (is_named(columns_, item_, name)) return false;
    const PlyType type = element_.properties[parts[0]].type;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      targets_[parts[k]] = {columns_.size(), k * size_of(type)};
    }
    SoupAttribute& column = columns_.emplace_back();
    column.name = name;
    column.item = item_;
    column.type = scalar_of(type);
    column.components = static_cast<Index>(parts.size());
    column.on_split = policy_of(name, type);
    return true;
  }

  const PlyElement& element_;
  SoupItem item_;
  std::span<const PlyProperty* const> taken_;
  std::vector<SoupAttribute>& columns_;
  std::vector<PlyTarget> targets_;
};

/// Or the nearest integer that the type holds; false if that is another one.
/// pre: an integer type
bool store_integer(std::int64_t value, PlyType type, std::byte* to) {
  const std::size_t bits = 8 * size_of(type);
  const bool is_signed =
      type == PlyType::kInt8 || type == PlyType::kInt16 || type == PlyType::kInt32;
  const std::int64_t most = (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
  const std::int64_t held = std::clamp(value, is_signed ? -most - 1 : 0, most);
  const auto word = static_cast<std::uint32_t>(held);
  const auto half = static_cast<std::uint16_t>(held);
  const auto byte = static_cast<std::uint8_t>(held);
  if (bits == 32) std::memcpy(to, &word, sizeof(word));
  if (bits == 16) std::memcpy(to, &half, sizeof(half));
  if (bits == 8) std::memcpy(to, &byte, sizeof(byte));
  return held == value;
}

}  // namespace

std::vector<PlyTarget> choose_columns(const PlyElement& element, SoupItem item,
                                      std::span<const PlyProperty* const> taken,
                                      std::vector<SoupAttribute>& columns) {
  return ColumnChooser(element, item, taken, columns).choose();
}

bool PlyColumns::begin(const PlyElement& element, SoupItem item,
                       std::span<const PlyProperty* const> taken, bool keeps) {
  targets_.assign(element.properties.size(), {});
  if (keeps) {
    targets_ = choose_columns(element, item, taken, columns_);
    choose_lists(element, item, taken);
  }
  note_unread(element, taken);
  if (!keeps) return true;
  const auto rows = static_cast<std::size_t>(element.count);
  bool has_room = true;
  for (SoupAttribute& column : columns_) {
    if (column.item != item) continue;
    has_room = column.values.resize(rows * column.stride(), std::byte{}) && has_room;
  }
  return has_room;
}

/// How many components a list has, and whether it can be an attribute, is known when its rows have
/// been read.
void PlyColumns::choose_lists(const PlyElement& element, SoupItem item,
                              std::span<const PlyProperty* const> taken) {
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    if (!property.length_type || columns_.size() + lists_.size() >= kMostColumns ||
        std::find(taken.begin(), taken.end(), &property) != taken.end() ||
        is_named(columns_, item, property.name) || is_named(lists_, item, property.name)) {
      continue;
    }
    targets_[k].column = lists_.size();
    SoupAttribute& column = lists_.emplace_back();
    column.name = property.name;
    column.item = item;
    column.type = scalar_of(property.type);
    column.components = 0;
    column.on_split = policy_of(property.name, property.type);
  }
}

/// Says which properties of an element nobody reads, and which change their type.
void PlyColumns::note_unread(const PlyElement& element, std::span<const PlyProperty* const> taken) {
  std::vector<bool> unread(element.properties.size());
  std::vector<bool> changed(element.properties.size());
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const bool is_kept = targets_[k].column != PlyTarget::kNowhere;
    unread[k] = !is_kept && std::find(taken.begin(), taken.end(), &property) == taken.end();
    changed[k] = is_kept && is_long(property.type);
  }
  if (element.count == 0) return;
  if (const std::string names = element.name_of(unread); !names.empty()) {
    notes_.push_back("ignored " + names);
  }
  if (const std::string names = element.name_of(changed); !names.empty()) {
    notes_.push_back("read " + names + ", integers of 64 bits, as doubles");
  }
}

// Without rows there is nothing to keep, and nothing to say.
void PlyColumns::end(const PlyElement& element) {
  for (SoupAttribute& column : lists_) {
    if (column.components == kUneven) {
      notes_.push_back("ignored the list " + quoted(column.name) + " of " + quoted(element.name) +
                       ": expected 1 to " + std::to_string(Attribute::kMaxComponents) +
                       " numbers, as many in each row");
    } else if (column.components > 0) {
      columns_.push_back(std::move(column));
    }
  }
  lists_.clear();
}

std::size_t PlyColumns::add(SoupAttribute column) {
  columns_.push_back(std::move(column));
  return columns_.size() - 1;
}

bool is_texture_list(const PlyProperty& property) {
  return property.length_type && property.name == "texcoord" && !is_integer(property.type);
}

SoupAttribute texture_column(const PlyProperty& property) {
  SoupAttribute column;
  column.name = "uv";
  column.item = SoupItem::kCorner;
  column.type = scalar_of(property.type);
  column.components = 2;
  return column;
}

bool read_number(TextScanner& text, PlyType type, std::byte* value, std::size_t& altered) {
  text.skip_blanks();
  if (type == PlyType::kFloat32) {
    float single = 0;
    if (!text.read_float(single)) return false;
    std::memcpy(value, &single, sizeof(single));
    return true;
  }
  const char* const start = text.position();
  std::int64_t integer = 0;
  const bool is_short = is_integer(type) && !is_long(type);
  if (is_short && text.read_integer(integer) && text.at_token_end()) {
    altered += store_integer(integer, type, value) ? 0U : 1U;
    return true;
  }
  text.move_to(start);
  double number = 0;
  if (!text.read_double(number)) return false;
  if (is_short) {  // 255.0
    constexpr double kFarOut = 0x1p40;
    const double whole =
        std::isnan(number) ? 0 : std::clamp(std::nearbyint(number), -kFarOut, kFarOut);
    const bool fits = store_integer(static_cast<std::int64_t>(whole), type, value);
    altered += fits && whole == number ? 0U : 1U;
  } else {
    std::memcpy(value, &number, sizeof(number));
  }
  return true;
}

}  // namespace halfedge::io
