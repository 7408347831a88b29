// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/meetings.hpp"

namespace skein::translation {

wire::PlanFrontier to_wire(const std::string& uav, const temporal::Frontier& frontier) {
  wire::PlanFrontier sample;
  sample.uav = uav;
  for (const temporal::Meeting& one : frontier.meetings)
    sample.meetings.push_back({one.id, one.senders, one.receivers});
  for (const temporal::FrontierArc& arc : frontier.arcs)
    sample.arcs.push_back({arc.from, arc.to, arc.soonest, arc.slowest, arc.latest});
  return sample;
}

Read<temporal::Frontier> from_wire(const wire::PlanFrontier& sample) {
  temporal::Frontier frontier;
  for (const wire::SharedMeeting& one : sample.meetings)
    frontier.meetings.push_back({one.id, one.senders, one.receivers});
  for (const wire::FrontierArc& arc : sample.arcs)
    frontier.arcs.push_back({arc.from, arc.to, arc.soonest, arc.slowest, arc.latest});
  if (auto fault = temporal::fault_of(frontier))
    return tl::unexpected(wire::Violation{"frontier", std::move(*fault)});
  return frontier;
}

}  // namespace skein::translation
