// SPDX-License-Identifier: Apache-2.0
#include "merging_lines.hpp"

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
  journal::Record line(writer.at, writer.node, "air");
  line.with("uav", writer.node)
      .with("task", noted.task.value())
      .with("type", noted.type)
      .with("state", noted.state)
      .with("waited", noted.waited.to_seconds());
  if (!noted.waits_for.empty()) line.with("for", joined(noted.waits_for, "; "));
  if (noted.raised > 0) line.with("raised", noted.raised);
  if (!noted.air.empty()) line.with("air", flat(noted.air));
  return line;
}

}  // namespace skein::ddn
