#pragma once

/// The whole library but the dialects. Each header can be included alone.

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/neighbourhood.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/algorithms/triangles.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/decorator/decorator.h>
#include <halfedge/directed_edges/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/io/bytes.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>
#include <halfedge/mend/mend.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/dual.h>
#include <halfedge/operations/extract.h>
#include <halfedge/operations/operations.h>
#include <halfedge/operations/reorder.h>
#include <halfedge/repair/repair.h>
#include <halfedge/repair/transfer.h>
#include <halfedge/result.h>
#include <halfedge/shapes/shapes.h>
#include <halfedge/validate/validate.h>
