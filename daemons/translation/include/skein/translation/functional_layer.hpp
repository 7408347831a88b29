// SPDX-License-Identifier: Apache-2.0
// What every functional layer tells beside its answers: lines of the event log (kinds functional
// and telemetry, docs/journal.md), and where its vehicles are.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/functional/port.hpp"
#include "skein/journal/line.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::translation {

/// The instance of a truth: wire instances are 32 bits, this is a fixed hash of its name.
std::uint32_t truth_instance(const std::string& name);
wire::Truth truth_of(const std::string& uav, const world::VehicleState& state);

/// A line of kind telemetry.
journal::Record telemetry_line(MissionTime at, const std::string& node, const std::string& uav,
                               const world::VehicleState& state);

/// Lines of kind functional: one for each change of a task, with what was asked for.
class FunctionalLines {
 public:
  /// What is asked for twice is one task.
  void note(const std::string& uav, const functional::Request& asked);
  /// Absent when the state was told before.
  std::optional<journal::Record> line_of(MissionTime at, const std::string& node,
                                         const std::string& uav, const functional::Status& status);

 private:
  /// A task as it was asked for, and what was last told of it.
  struct Asked {
    std::string type;
    std::string device;          ///< of a perception
    std::vector<double> target;  ///< that the device is aimed at [m] ENU
    std::string told;            ///< its last state
  };
  std::map<std::pair<std::string, functional::TaskId>, Asked> asked_;  ///< by UAV and task
};

}  // namespace skein::translation
