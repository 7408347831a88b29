// SPDX-License-Identifier: Apache-2.0
// Runs of a few lines.
#pragma once

#include <string>
#include <vector>

#include "skein/recording/run.hpp"

namespace skein::compare_tool {

using journal::Record;

inline Record line(double at, const std::string& node, const std::string& kind) {
  return {MissionTime::seconds(at), node, kind};
}

inline Record task(double at, const std::string& state) {
  return line(at, "marvin", "task")
      .with("uav", "marvin")
      .with("task", 104)
      .with("type", "goto")
      .with("state", state);
}

inline Record goal(double at, const std::string& state) {
  return line(at, "marvin", "goal")
      .with("uav", "marvin")
      .with("goal", 7)
      .with("statement", "map Z")
      .with("state", state);
}

inline Record finished(double at) {
  return line(at, "ground", "mission").with("state", "finished");
}

inline recording::Run run_of(std::vector<Record> records) {
  recording::Run run;
  run.folder = "out/x";
  run.info.scenario = "search";
  for (const Record& record : records) run.events += journal::to_json(record) + "\n";
  run.records = std::move(records);
  return run;
}

}  // namespace skein::compare_tool
