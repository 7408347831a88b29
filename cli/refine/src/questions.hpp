// SPDX-License-Identifier: Apache-2.0
// The part of a query that is its service's own.
#pragma once

#include "query.hpp"
#include "skein/config/reader.hpp"
#include "terms.hpp"

namespace skein::refine_tool {

/// One service, as query files name it.
struct ServiceReader {
  const char* name;
  /// Reads the service's own keys; those common to all queries are allowed beside them.
  Question (*read)(const config::Reader& reader, const Terms& terms);
};

/// In the order of the documentation.
const std::vector<ServiceReader>& service_readers();

// In ground_questions.cpp: those about areas of ground.
Question read_coverage(const config::Reader& reader, const Terms& terms);
Question read_partition(const config::Reader& reader, const Terms& terms);
Question read_viewshed(const config::Reader& reader, const Terms& terms);
Question read_patrol(const config::Reader& reader, const Terms& terms);
/// The own part of a sweep, for coverage itself and for the stops of a tour.
refiners::CoverageQuery read_sweep(const config::Reader& reader, const Terms& terms,
                                   world::VehicleModel vehicle);

}  // namespace skein::refine_tool
