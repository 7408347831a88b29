// SPDX-License-Identifier: Apache-2.0
// Plans from a file, checked against the problems read.
#pragma once

#include <iosfwd>
#include <vector>

#include "library.hpp"
#include "skein/plan_tool/plan.hpp"

namespace skein::plan_tool {

struct Streams {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
};

/// Each plan of options.validate with the problem it names; a file that names none is checked with
/// the only problem chosen.
int validate_plans(Library& library, const std::vector<ChosenProblem>& problems,
                   const PlanOptions& options, const Surroundings& surroundings,
                   const Streams& streams);

}  // namespace skein::plan_tool
