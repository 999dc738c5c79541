#include <halfedge/attributes/attributes.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace halfedge {

namespace {

Error bad(std::string sentence) { return {"bad-attribute", std::move(sentence)}; }

std::string quoted(ItemKind kind, std::string_view name) {
  return sentence::of("{} attribute \"{}\"", name_of(kind), name);
}

}  // namespace

Result<Attribute*> Attributes::add(ItemKind kind, std::string_view name,
                                   const AttributeOptions& options, Index slots) {
  if (kind == ItemKind::kMesh) return bad("A mesh has attributes of its items, not of itself.");
  if (name.empty() && !options.is_generation) {
    return bad("The name of an attribute is empty, expected a word.");
  }
  if (options.is_generation && (!name.empty() || options.type != Scalar::kUint32 ||
                                options.components != 1 || !options.default_value.empty())) {
    return bad("Generations are one uint32 without a name, as enable_generations adds them.");
  }
  if (options.components < 1 || options.components > Attribute::kMaxComponents) {
    return bad(sentence::of("The {} would have {} components, expected 1 to {}.",
                            quoted(kind, name), options.components, Attribute::kMaxComponents));
  }
  if (!options.default_value.empty() && options.default_value.size() != options.components) {
    return bad(sentence::of("The default of the {} has {} numbers, expected {}.",
                            quoted(kind, name), options.default_value.size(), options.components));
  }
  if (find(kind, name) != nullptr) {
    return Error{"attribute-exists", sentence::of("There is a {} already.", quoted(kind, name))};
  }
  std::unique_ptr<Attribute> column(new (std::nothrow)
                                        Attribute(std::string(name), kind, options, serials_++));
  if (column == nullptr || column->serial() >= Journal::kMostColumns || !column->has_default() ||
      !column->reserve(slots)) {
    return Error{"out-of-memory",
                 sentence::of("There is not enough memory for the {}.", quoted(kind, name))};
  }
  column->resize(slots);
  ++count_;
  return columns_[std::size_t(kind)].emplace_back(std::move(column)).get();
}

const Attribute* Attributes::find(ItemKind kind, std::string_view name) const {
  for (const Column& column : of(kind)) {
    if (column->name() == name) return column.get();
  }
  return nullptr;
}

Attribute* Attributes::find(ItemKind kind, std::string_view name) {
  return const_cast<Attribute*>(std::as_const(*this).find(kind, name));
}

bool Attributes::remove(ItemKind kind, std::string_view name) {
  std::vector<Column>& columns = columns_[std::size_t(kind)];
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column->name() == name; });
  if (found == columns.end()) return false;
  columns.erase(found);  // `name` may be its own, and is gone then
  --count_;
  return true;
}

bool Attributes::reserve_columns(ItemKind kind, std::size_t slots) {
  for (Column& column : of(kind)) {
    if (!column->reserve(slots)) return false;
  }
  return true;
}

void Attributes::resize_columns(ItemKind kind, Index slots, Journal* journal) {
  for (Column& column : of(kind)) {
    const Index old = column->slots();
    column->resize(slots);
    if (!column->is_generation() || slots <= old) continue;
    // Undo may have taken away other items from these slots, now or while there was history.
    ++generations_;
    for (Index item = old; item < slots; ++item) column->set(item, 0, generations_, journal);
  }
}

Attributes& Attributes::operator=(Attributes&& other) noexcept {
  if (this == &other) return *this;
  columns_ = std::exchange(other.columns_, {});
  count_ = std::exchange(other.count_, 0);
  serials_ = other.serials_;
  const bool had_generations = generations_ > 0;
  generations_ = std::max(generations_, other.generations_);
  if (had_generations) end_all_generations();
  return *this;
}

bool Attributes::assign(const Attributes& other) {
  if (this == &other) return true;
  drop_all();
  serials_ = other.serials_;
  const bool had_generations = generations_ > 0;
  generations_ = std::max(generations_, other.generations_);
  for (std::size_t kind = 0; kind < columns_.size(); ++kind) {
    for (const Column& from : other.columns_[kind]) {
      const AttributeOptions options{.type = from->type(),
                                     .components = from->components(),
                                     .on_split = from->on_split(),
                                     .is_generation = from->is_generation()};
      std::unique_ptr<Attribute> column(
          new (std::nothrow) Attribute(from->name(), from->kind(), options, from->serial()));
      if (column == nullptr || !column->assign(*from)) {
        drop_all();
        return false;
      }
      columns_[kind].emplace_back(std::move(column));
      ++count_;
    }
  }
  if (had_generations) end_all_generations();
  return true;
}

void Attributes::drop_all() {
  for (std::vector<Column>& columns : columns_) columns.clear();
  count_ = 0;
}

void Attributes::set_defaults(ItemKind kind, Index item, Journal* journal) {
  for (Column& column : of(kind)) {
    if (!column->is_generation()) {
      column->set_default(item, journal);
    } else if (journal != nullptr) {  // undo may have taken away another item from this slot
      column->set(item, 0, ++generations_, journal);
    }
  }
}

void Attributes::change_generation(ItemKind kind, Index item, Journal* journal) {
  for (Column& column : of(kind)) {
    if (column->is_generation()) column->set(item, 0, ++generations_, journal);
  }
}

void Attributes::end_all_generations() {
  ++generations_;
  for (std::vector<Column>& columns : columns_) {
    for (Column& column : columns) {
      if (column->is_generation()) column->set_all(generations_);
    }
  }
}

void Attributes::note_all(Journal& journal) const {
  for (const std::vector<Column>& columns : columns_) {
    for (const Column& column : columns) column->note_all(journal);
  }
}

void Attributes::compact(ItemKind kind, const Array<Index>& map) {
  const std::size_t width = kind == ItemKind::kHalfedge ? 2 : 1;
  for (Column& column : of(kind)) column->compact(map, width);
}

void Attributes::exchange(const Journal::Note& note) {
  for (std::vector<Column>& columns : columns_) {
    for (Column& column : columns) {
      if (column->serial() == note.column) return column->exchange(note);
    }
  }
}

void Attributes::copy_values(ItemKind kind, Index to, Index from, Journal* journal) {
  for (Column& column : of(kind)) column->copy(to, from, journal);
}

void Attributes::blend_values(ItemKind kind, Index to, Index a, Index b, double t,
                              Journal* journal) {
  for (Column& column : of(kind)) {
    Attribute::Sum sum;
    column->add(sum, a, 1 - t);
    column->add(sum, b, t);
    column->store(sum, to, journal);
  }
}

void Attributes::copy_corner_values(Index to, Index from, Journal* journal) {
  for (Column& column : of(ItemKind::kHalfedge)) {
    if (column->belongs_to_corners()) column->copy(to, from, journal);
  }
}

void Attributes::blend_corner_values(Index to, Index a, Index b, double t, Journal* journal) {
  for (Column& column : of(ItemKind::kHalfedge)) {
    if (!column->belongs_to_corners()) continue;
    Attribute::Sum sum;
    column->add(sum, a, 1 - t);
    column->add(sum, b, t);
    column->store(sum, to, journal);
  }
}

void Attributes::swap_corners(Index a, Index b, Journal* journal) {
  for (Column& column : of(ItemKind::kHalfedge)) {
    if (column->belongs_to_corners()) column->swap(a, b, journal);
  }
}

Attributes::CornerMove::CornerMove(Attribute& column, const EdgeCorners (&sides)[2], double t,
                                   Journal* journal)
    : column_(column), sides_(sides), journal_(journal) {
  for (const std::size_t i : {0U, 1U}) {
    if (sides[i].has_face) before_[i] = {column.value(sides[i].from), column.value(sides[i].to)};
  }
  for (const EdgeCorners& side : sides) {
    if (!side.has_face) continue;
    if (t == 1) {  // exactly: a mean would be rounded, or brought to length 1
      column.copy(side.result, side.to, journal);
      continue;
    }
    Attribute::Sum sum;
    column.add(sum, side.from, 1 - t);
    column.add(sum, side.to, t);
    column.store(sum, side.result, journal);
  }
}

void Attributes::CornerMove::operator()(Index corner, EdgeEnd end) const {
  const Attribute::Value value = column_.value(corner);
  for (const std::size_t i : {0U, 1U}) {
    const Attribute::Value& before = end == EdgeEnd::kFrom ? before_[i].from : before_[i].to;
    if (!sides_[i].has_face || value != before) continue;
    return column_.copy(corner, sides_[i].result, journal_);
  }
}

}  // namespace halfedge
