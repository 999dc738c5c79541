#pragma once

#include <halfedge/connectivity/handle.h>

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace halfedge {

/// The items that show why something failed: the duplicate edge, the faces that share it. Indices
/// are those of the input (for a build) or of the mesh (for an operation).
struct Witness {
  std::vector<Index> vertices = {};
  std::vector<Index> halfedges = {};
  std::vector<Index> edges = {};
  std::vector<Index> faces = {};

  friend bool operator==(const Witness&, const Witness&) = default;
};

/// Why something was refused: a stable code in kebab-case for programs ("edge-with-three-faces"),
/// one sentence for people that names the item, its value and what was expected, and the witness.
struct Error {
  std::string code;
  std::string message;
  Witness witness = {};
};

/// A value, or the error that explains why there is none. Failure caused by data is a value in the
/// core, which is built without exceptions; the JavaScript wrapper throws it in one place.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// pre: ok()
  [[nodiscard]] T& value() & {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&state_));
  }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// Success, or the error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace halfedge
