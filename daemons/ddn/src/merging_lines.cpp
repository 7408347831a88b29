// SPDX-License-Identifier: Apache-2.0
#include "merging_lines.hpp"

#include "skein/journal/lines/deliberation.hpp"

#include "skein/foundation/joined.hpp"

namespace skein::ddn {

namespace {

/// x, y, x, y, radius, floor, ceiling of each.
std::vector<double> flat(const merging::Volumes& air) {
  std::vector<double> numbers;
  for (const merging::Volume& one : air) {
    for (const double number :
         {one.from.x(), one.from.y(), one.to.x(), one.to.y(), one.radius, one.floor, one.ceiling})
      numbers.push_back(journal::rounded(number));
  }
  return numbers;
}

}  // namespace

journal::Record line_of(const translation::Writer& writer, const decision_node::AirNoted& noted) {
  journal::lines::Air line{.uav = writer.node,
                           .task = noted.task.value(),
                           .type = noted.type,
                           .state = noted.state,
                           .waited = noted.waited.to_seconds(),
                           .for_ = joined(noted.waits_for, "; ")};
  (noted.state == "waits" ? line.wants : line.air) = flat(noted.air);
  if (noted.raised > 0) line.raised = noted.raised;
  return writer.record(std::move(line));
}

}  // namespace skein::ddn
