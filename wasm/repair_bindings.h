#pragma once

#include <halfedge/repair/repair.h>

#include "bindings.h"

namespace halfedge::bindings {

/// Adds what a repair has done to a result. The arrays are JavaScript's to free.
inline void add_repair(val& result, RepairReport& report) {
  static_assert(sizeof(FaceVerdict) == 8, "two words: the face; whether it is kept, and the codes");
  val problems = val::array();
  for (const Error& problem : report.problems) problems.call<void>("push", to_problem(problem));
  val counts = val::array();
  for (const std::size_t count : report.counts) counts.call<void>("push", count);
  result.set("repairs", problems);  // `problems` are those of a failure
  result.set("counts", counts);
  result.set("summary", report.summary);
  result.set("verdicts", hand_over(report.verdicts));
  result.set("vertexMap", hand_over(report.vertex_map));
  result.set("vertexOrigin", hand_over(report.vertex_origin));
  result.set("faceMap", hand_over(report.face_map));
}

}  // namespace halfedge::bindings
