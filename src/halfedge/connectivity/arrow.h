#pragma once

namespace halfedge {

/// What `->` of an iterator gives that makes its handles when they are asked for: one that lives as
/// long as the expression, also where the iterator doesn't, as in std::reverse_iterator.
template <class Handle>
class Arrow {
 public:
  explicit Arrow(Handle handle) : handle_(handle) {}
  const Handle* operator->() const { return &handle_; }

 private:
  Handle handle_;
};

}  // namespace halfedge
