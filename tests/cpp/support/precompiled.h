#pragma once

// What the common tests are compiled with before they are read: see halfedge_precompile.

#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/attribute_file.h"
#include "support/canonical.h"
#include "support/collapsing.h"
#include "support/complexes.h"
#include "support/copies.h"
#include "support/data_files.h"
#include "support/face_lists.h"
#include "support/invariants.h"
#include "support/matching.h"
#include "support/mending.h"
#include "support/operations.h"
#include "support/polygon_lists.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/renumbered.h"
#include "support/repairing.h"
#include "support/same_but_prev.h"
#include "support/shapes.h"
#include "support/storages.h"
#include "support/sweep.h"
#include "support/text_file.h"
#include "support/whole_soup.h"
