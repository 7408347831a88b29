// SPDX-License-Identifier: Apache-2.0
// `skein refine`: one question to a refiner, its answer as text, JSON and picture.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/partition.hpp"
#include "skein/world/world.hpp"

namespace skein::refine_tool {

struct RefineOptions {
  std::string query;              ///< file; "-": standard input
  std::string example;            ///< service whose example is printed instead
  std::string svg;                ///< picture to write; empty: none
  std::string out;                ///< ways, areas and places to write (.geojson, .kml, .wkt)
  bool json = false;              ///< the answer as JSON
  bool colour = false;            ///< in the text
  std::optional<double> seconds;  ///< time budget, before that of the query
  bool no_budget = false;         ///< none, whatever the query says; else patrols have one
  std::optional<std::uint64_t> seed;
  /// Seconds from any origin that never go back, of the processor as a rule; the time budget is
  /// kept by it.
  std::function<double()> now;
  /// What a part takes as it is flown, over this world (refiners::FlownSweep): balanced partitions
  /// are divided by it; absent: by coverage.
  std::function<std::optional<double>(const refiners::Member&, double altitude,
                                      const world::Polygon& part,
                                      const std::shared_ptr<const world::World>&)>
      flown;
};

/// Names of the services, in the order of the documentation.
std::vector<std::string> service_names();

/// Returns an exit code: 0 there is a solution, 1 there is none, 2 wrong input, 3 a file
/// cannot be written, 4 the budget ended first. Never throws.
int run_refine(const RefineOptions& options, std::istream& in, std::ostream& out,
               std::ostream& err);

}  // namespace skein::refine_tool
