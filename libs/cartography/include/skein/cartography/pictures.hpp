// SPDX-License-Identifier: Apache-2.0
// Pictures of what the refiners were asked and what they answered, refusals too.
#pragma once

#include <string>

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

namespace skein::cartography {

// Each gives one self-contained SVG over the part of the world that matters. Points of the query
// that are not finite are left out. Deterministic.

std::string picture(const world::World& world, const refiners::PathQuery& query,
                    const refiners::Outcome<refiners::Path>& outcome);
std::string picture(const world::World& world, const refiners::TourQuery& query,
                    const refiners::Outcome<refiners::Tour>& outcome);
std::string picture(const world::World& world, const refiners::CoverageQuery& query,
                    const refiners::Outcome<refiners::Coverage>& outcome);
std::string picture(const world::World& world, const refiners::PartitionQuery& query,
                    const refiners::Outcome<refiners::Partition>& outcome);
std::string picture(const world::World& world, const refiners::PatrolQuery& query,
                    const refiners::Outcome<refiners::Patrol>& outcome);
std::string picture(const world::World& world, const refiners::ViewpointQuery& query,
                    const refiners::Outcome<refiners::Viewpoints>& outcome);
std::string picture(const world::World& world, const refiners::ViewshedQuery& query,
                    const refiners::Outcome<refiners::Viewshed>& outcome);
std::string picture(const world::World& world, const refiners::RelayQuery& query,
                    const refiners::Outcome<refiners::Relay>& outcome);
std::string picture(const world::World& world, const refiners::EvaluateQuery& query,
                    const refiners::Outcome<refiners::Evaluation>& outcome);
std::string picture(const world::World& world, const refiners::InsertionQuery& query,
                    const refiners::Outcome<refiners::Insertion>& outcome);

}  // namespace skein::cartography
