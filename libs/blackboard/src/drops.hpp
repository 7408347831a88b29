// SPDX-License-Identifier: Apache-2.0
// Samples that were refused.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/foundation/tally.hpp"

namespace skein::blackboard {

/// Tells of each sample that is refused, and which are to be logged: of one origin, slot and field,
/// whatever the element of a list, the first, tenth, hundredth and so on.
class Drops {
 public:
  void tell(wire::Slot slot, const wire::SampleHeader& header, const wire::Violation& violation,
            std::vector<Incoming>& out);

 private:
  using Kind = std::tuple<wire::Slot, NodeNumber, std::string>;
  Tally<Kind> times_{256};
};

}  // namespace skein::blackboard
