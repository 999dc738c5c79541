#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/inlining.h>

#include <cassert>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace halfedge {

/// A vector of indices, whose special members are compiled once: they would be inlined at hundreds
/// of places at which something is refused.
class IndexList : public std::vector<Index> {
 public:
  HALFEDGE_COLD IndexList();
  HALFEDGE_COLD IndexList(std::initializer_list<Index> items);
  HALFEDGE_COLD IndexList(std::vector<Index> items);
  HALFEDGE_COLD IndexList(std::span<const Index> items);
  HALFEDGE_COLD IndexList(const IndexList& other);
  HALFEDGE_COLD IndexList(IndexList&& other) noexcept;
  HALFEDGE_COLD IndexList& operator=(const IndexList& other);
  HALFEDGE_COLD IndexList& operator=(IndexList&& other) noexcept;
  HALFEDGE_COLD ~IndexList();
};

/// The items that show why something failed: the duplicate edge, the faces that share it. Indices
/// are those of the input (for a build) or of the mesh (for an operation).
struct Witness {
  IndexList vertices = {};
  IndexList halfedges = {};
  IndexList edges = {};
  IndexList faces = {};

  friend bool operator==(const Witness&, const Witness&) = default;
};

/// Why something was refused: a stable code in kebab-case for programs ("edge-with-many-faces"),
/// which is never freed; one sentence for people that names the item, its value and what was
/// expected; and the witness.
struct Error {
  HALFEDGE_COLD Error();
  HALFEDGE_COLD Error(std::string_view code, std::string message, Witness witness = {});
  HALFEDGE_COLD Error(const Error& other);
  HALFEDGE_COLD Error(Error&& other) noexcept;
  HALFEDGE_COLD Error& operator=(const Error& other);
  HALFEDGE_COLD Error& operator=(Error&& other) noexcept;
  HALFEDGE_COLD ~Error();

  std::string_view code;
  std::string message;
  Witness witness;
};

/// out-of-memory: "There is not enough memory for the dual."
[[nodiscard]] HALFEDGE_COLD Error no_memory_for(std::string_view what);

/// An error on its way to whom it concerns, or none: one pointer, since what each call returns must
/// cost next to nothing where all goes well, which is the rule.
class Failure {
 public:
  Failure() = default;
  Failure(std::string_view code, std::string&& message, Witness&& witness);
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

template <class A, class B>
inline constexpr bool kAreHandlesOfTwoKinds = false;
template <class OneTag, class OtherTag>
inline constexpr bool kAreHandlesOfTwoKinds<Handle<OneTag>, Handle<OtherTag>> =
    !std::is_same_v<OneTag, OtherTag>;

/// A value, or the error that explains why there is none. Failure caused by data is a value in the
/// core, which is built without exceptions; the JavaScript wrapper throws it in one place.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Failure failure) : failure_(std::move(failure)) {}
  Result(Error&& error) : failure_(std::move(error)) {}
  Result(const Error& error) : failure_(error) {}
  /// The error of another result, so that `return can;` passes it on, without a copy. Where both
  /// would have handles, of a vertex and of a face, one is hardly meant for the other: that doesn't
  /// compile, and its error is passed on by `failure()`. pre: !failed.ok()
  template <class Other>
  requires(!kAreHandlesOfTwoKinds<T, Other>) Result(Result<Other>&& failed)
      : failure_(std::move(failed).failure()) {
    assert(!ok());
  }

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
  /// Not a reference, so that `for (const Item& item : make().value())` goes over something that
  /// lives.
  [[nodiscard]] T value() && {
    assert(ok());
    return std::move(value_);
  }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const& { return failure_.error(); }
  /// Not a reference, as with `value`. pre: !ok()
  [[nodiscard]] Error error() && { return failure_.error(); }
  /// The error, if there is one, without a copy.
  [[nodiscard]] Failure failure() && { return std::move(failure_); }

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
  /// Whether another one has a value, or its error, without a copy.
  template <class Other>
  Result(Result<Other>&& other) : failure_(std::move(other).failure()) {}

  [[nodiscard]] bool ok() const { return !failure_.happened(); }
  explicit operator bool() const { return ok(); }

  /// pre: !ok()
  [[nodiscard]] const Error& error() const& { return failure_.error(); }
  [[nodiscard]] Error error() && { return failure_.error(); }
  /// The error, if there is one, without a copy.
  [[nodiscard]] Failure failure() && { return std::move(failure_); }

 private:
  Failure failure_;
};

}  // namespace halfedge
