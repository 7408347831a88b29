// SPDX-License-Identifier: Apache-2.0
#include "play_virtual.hpp"

#include <algorithm>
#include <functional>

#include "skein/assembly/assembly.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/run_tool/interrupt_guard.hpp"

namespace skein::run_tool {

namespace {

Played::End end_of(node::VirtualOutcome::End end) {
  switch (end) {
    case node::VirtualOutcome::End::kFinished:
      return Played::End::kFinished;
    case node::VirtualOutcome::End::kTimeLimit:
      return Played::End::kTimeLimit;
    case node::VirtualOutcome::End::kStopped:
      return Played::End::kInterrupted;
    case node::VirtualOutcome::End::kNothingLeftToDo:
      break;
  }
  return Played::End::kIdle;
}

journal::Record mission_line(MissionTime at, const char* state) {
  return journal::record_of(at, "runner", journal::lines::Mission{state});
}

}  // namespace

Played play_virtual(const scenario::Scenario& scenario, Progress& progress) {
  const InterruptGuard guard;
  const assembly::NodeMaker make_node(scenario);
  Played played;
  played.records.push_back(mission_line(MissionTime(), "started"));
  const auto journal = [&](const journal::Record& record) {
    played.records.push_back(record);
    progress.see(record);
  };
  const auto keep_going = [&](MissionTime now) {
    progress.show(now);
    return !InterruptGuard::interrupted();
  };
  const node::VirtualOutcome outcome =
      node::run_virtual(make_node.roster(), std::cref(make_node),
                        assembly::virtual_config(scenario), journal, keep_going);
  played.end = end_of(outcome.end);
  if (played.end == Played::End::kTimeLimit) {
    played.records.push_back(mission_line(outcome.at, "time-limit"));
  }
  // A physics step's effects carry the instant of the step, which may be just before the call's.
  std::stable_sort(played.records.begin(), played.records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return played;
}

}  // namespace skein::run_tool
