// SPDX-License-Identifier: Apache-2.0
#include "skein/team_translation/meetings.hpp"

#include "skein/journal/lines/deliberation.hpp"

namespace skein::translation {

journal::Record frontier_told(const Writer& writer, const std::string& node, const std::string& to,
                              const std::string& about, const temporal::Frontier& frontier) {
  return writer.record(journal::lines::Frontier{.uav = node,
                                                .direction = "sent",
                                                .to = to,
                                                .about = about == node ? "" : about,
                                                .meetings = frontier.meetings.size(),
                                                .arcs = frontier.arcs.size()});
}

journal::Record frontier_heard(const Writer& writer, const std::string& node,
                               const std::string& from, const std::string& about) {
  return writer.record(journal::lines::Frontier{
      .uav = node, .direction = "received", .from = from, .about = about == from ? "" : about});
}

wire::PlanFrontier to_wire(const std::string& uav, const temporal::Frontier& frontier) {
  wire::PlanFrontier sample;
  sample.uav = uav;
  for (const temporal::Meeting& one : frontier.meetings)
    sample.meetings.push_back({one.id, one.senders, one.receivers});
  for (const temporal::FrontierArc& arc : frontier.arcs)
    sample.arcs.push_back({arc.from, arc.to, arc.soonest, arc.slowest, arc.latest});
  for (const temporal::FrontierBasis& basis : frontier.bases)
    for (const temporal::EndOf& end : basis.ends)
      sample.bases.push_back({basis.node, end.agent, end.meeting});
  return sample;
}

Read<temporal::Frontier> from_wire(const wire::PlanFrontier& sample) {
  temporal::Frontier frontier;
  for (const wire::SharedMeeting& one : sample.meetings)
    frontier.meetings.push_back({one.id, one.senders, one.receivers});
  for (const wire::FrontierArc& arc : sample.arcs)
    frontier.arcs.push_back({arc.from, arc.to, arc.soonest, arc.slowest, arc.latest});
  for (const wire::FrontierBasis& one : sample.bases) {
    std::vector<temporal::FrontierBasis>& bases = frontier.bases;
    if (bases.empty() || bases.back().node != one.node) bases.push_back({one.node, {}});
    bases.back().ends.push_back({one.agent, one.meeting});
  }
  if (auto fault = temporal::fault_of(frontier))
    return tl::unexpected(wire::Violation{"frontier", std::move(*fault)});
  return frontier;
}

}  // namespace skein::translation
