// SPDX-License-Identifier: Apache-2.0
// A query with everything that its file refers to.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/refiners/coverage.hpp"
#include "skein/refiners/evaluate.hpp"
#include "skein/refiners/partition.hpp"
#include "skein/refiners/path.hpp"
#include "skein/refiners/patrol.hpp"
#include "skein/refiners/relay.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/viewpoint.hpp"
#include "skein/refiners/viewshed.hpp"
#include "skein/world/world.hpp"

namespace skein::refine_tool {

/// A stop of a tour that is an area to be swept; its gates are the ends of possible sweeps.
struct AreaStop {
  std::size_t stop = 0;  ///< index into the stops of the tour
  refiners::CoverageQuery coverage;
};

/// A tour with the areas whose gates are still to be found.
struct TourWithAreas {
  refiners::TourQuery tour;
  std::vector<AreaStop> areas;
};

using Question =
    std::variant<refiners::PathQuery, TourWithAreas, refiners::CoverageQuery,
                 refiners::PartitionQuery, refiners::PatrolQuery, refiners::ViewpointQuery,
                 refiners::ViewshedQuery, refiners::RelayQuery, refiners::EvaluateQuery,
                 refiners::InsertionQuery>;

enum class Planner : std::uint8_t { kVoxels, kSampling };

struct Query {
  std::string service;
  world::World world;
  Question question;
  Planner planner = Planner::kVoxels;
  std::uint64_t seed = 1;
  std::optional<double> seconds;
  std::optional<std::uint64_t> steps;
  bool no_budget = false;   ///< it says that it wants none
  bool by_default = false;  ///< `seconds` are those of a query that says nothing
  /// What was done to the query so that it could be asked, in sentences.
  std::vector<std::string> notes = {};
};

}  // namespace skein::refine_tool
