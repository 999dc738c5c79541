#pragma once

#include <halfedge/connectivity/handle.h>

#include <cassert>
#include <string>
#include <utility>
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

/// An error on its way to whom it concerns, or none: one pointer, since what each call returns must
/// cost next to nothing where all goes well, which is the rule.
class Failure {
 public:
  Failure() = default;
  Failure(Error&& error);
  Failure(const Error& error);
  Failure(Failure&& other) noexcept : error_(std::exchange(other.error_, nullptr)) {}
  Failure(const Failure& other) : Failure() {
    if (other.error_ != nullptr) *this = Failure(*other.error_);
  }
  Failure& operator=(Failure other) noexcept {
    std::swap(error_, other.error_);
    return *this;
  }
  ~Failure() {
    if (error_ != nullptr) forget(error_);
  }

  [[nodiscard]] bool happened() const { return error_ != nullptr; }
  /// pre: happened()
  [[nodiscard]] const Error& error() const {
    assert(happened());
    return *error_;
  }

 private:
  static void forget(Error* error);

  Error* error_ = nullptr;
};

/// A value, or the error that explains why there is none. Failure caused by data is a value in the
/// core, which is built without exceptions; the JavaScript wrapper throws it in one place.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Failure failure) : failure_(std::move(failure)) {}
  Result(Error&& error) : failure_(std::move(error)) {}
  Result(const Error& error) : failure_(error) {}

  [[nodiscard]] bool ok() const { return !failure_.happened(); }
  explicit operator bool() const { return ok(); }

  /// pre: ok()
  [[nodiscard]] T& value() & {
    assert(ok());
    return value_;
  }
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return value_;
  }
  [[nodiscard]] T&& value() && {
    assert(ok());
    return std::move(value_);
  }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const { return failure_.error(); }

 private:
  T value_ = {};
  Failure failure_;
};

/// Success, or the error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Failure failure) : failure_(std::move(failure)) {}
  Result(Error&& error) : failure_(std::move(error)) {}
  Result(const Error& error) : failure_(error) {}

  [[nodiscard]] bool ok() const { return !failure_.happened(); }
  explicit operator bool() const { return ok(); }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const { return failure_.error(); }

 private:
  Failure failure_;
};

}  // namespace halfedge
