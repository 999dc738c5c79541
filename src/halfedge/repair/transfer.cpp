#include <halfedge/repair/transfer.h>

#include <algorithm>
#include <cstring>

namespace halfedge {

namespace {

/// Whether each item is the one that it was.
bool is_identity(std::span<const Index> origin) {
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (origin[i] != i) return false;
  }
  return true;
}

}  // namespace

bool Transfer::fill(Attribute& to, SoupAttribute& from) {
  std::span<const Index> origin;
  switch (from.item) {
    case SoupItem::kVertex:
      if (report_ != nullptr) origin = report_->vertex_origin.span();
      break;
    case SoupItem::kFace:
      if (report_ != nullptr && faces_.empty() && !find_faces()) return false;
      origin = faces_.span();
      break;
    case SoupItem::kCorner:
      if (corners_.empty() && !find_corners()) return false;
      origin = corners_.span();
      break;
  }
  const std::span<std::byte> bytes = to.bytes();
  if (from.rows.empty() && from.values.size() == bytes.size() && is_identity(origin) &&
      from.item != SoupItem::kCorner) {
    to.adopt(std::move(from.values));
    return true;
  }
  const std::size_t stride = to.stride();
  const std::size_t rows = from.values.size() / stride;
  for (std::size_t item = 0; item < to.slots(); ++item) {
    Index row = origin.empty() ? Index(item) : origin[item];
    if (row != kNone && !from.rows.empty()) row = row < from.rows.size() ? from.rows[row] : kNone;
    if (row >= rows) continue;
    std::memcpy(&bytes[stride * item], &from.values[stride * row], stride);
  }
  return true;
}

bool Transfer::find_faces() {
  if (!faces_.resize(links_.face_halfedge.size(), kNone)) return false;
  for (Index f = 0; f < report_->face_map.size(); ++f) {
    if (report_->face_map[f] != kNone) faces_[report_->face_map[f]] = f;
  }
  return true;
}

bool Transfer::find_corners() {
  if (!corners_.resize(links_.next.size(), kNone)) return false;
  // A face that the report says nothing of is as it was, from its first corner on.
  const FaceVerdict* touched = report_ == nullptr ? nullptr : report_->verdicts.begin();
  const FaceVerdict* const end = report_ == nullptr ? nullptr : report_->verdicts.end();
  std::size_t begin = 0;
  for (Index f = 0; f < soup_.face_count(); ++f) {
    const std::size_t size = soup_.sizes.empty() ? 3 : soup_.sizes[f];
    const Index face = report_ == nullptr ? f : report_->face_map[f];
    const bool is_touched = touched != end && touched->face == f;
    if (is_touched) ++touched;
    if (face != kNone) {
      Index h = links_.face_halfedge[face];
      if (is_touched) {
        if (!match(h, begin, size)) return false;
      } else {
        for (std::size_t corner = begin; corner < begin + size; ++corner, h = links_.next[h]) {
          corners_[h] = Index(corner);
        }
      }
    }
    begin += size;
  }
  // Where a hole may be filled: what the next face around the vertex has there.
  for (std::size_t h = 0; h < links_.face.size(); ++h) {
    if (links_.face[h] == kNone) corners_[h] = corners_[links_.next[h] ^ 1U];
  }
  return true;
}

/// A face that was touched runs as in the soup or the other way round, from the first corner on
/// that is left, and some corners may be missing.
bool Transfer::match(Index halfedge, std::size_t begin, std::size_t size) {
  loop_.clear();
  Index h = halfedge;
  do {
    if (!loop_.push_back(h)) return false;
    h = links_.next[h];
  } while (h != halfedge);
  if (follow(begin, size)) return true;
  std::reverse(loop_.begin() + 1, loop_.end());
  if (follow(begin, size)) return true;
  for (const Index unknown : loop_) corners_[unknown] = kNone;
  return true;
}

/// Gives each halfedge the next corner of the soup that has its vertex, copies and welded ones
/// included. Whether there are such corners.
bool Transfer::follow(std::size_t begin, std::size_t size) {
  const auto place = [this](Index input_vertex) { return report_->vertex_map[input_vertex]; };
  const std::size_t end = begin + size;
  std::size_t corner = begin;
  for (const Index h : loop_) {
    const Index wanted = place(report_->vertex_origin[links_.to_vertex[h]]);
    while (corner < end && place(soup_.corners[corner]) != wanted) ++corner;
    if (corner == end) return false;
    corners_[h] = Index(corner++);
  }
  return true;
}

}  // namespace halfedge
