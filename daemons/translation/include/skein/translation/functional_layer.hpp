// SPDX-License-Identifier: Apache-2.0
// What every functional layer tells beside its answers: lines of the event log (kinds functional
// and telemetry, docs/journal.md), and where its vehicles are.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/byte_book.hpp"
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

/// Lines of kind functional: one for each change of a task, with what was asked for. Of tasks that
/// are over and not the last kKept only the state is kept.
class FunctionalLines {
 public:
  static constexpr std::size_t kKept = 256;

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
    std::optional<functional::TaskState> told;
  };
  using Key = std::pair<std::string, functional::TaskId>;  ///< UAV and task
  Asked& entry(const Key& key);
  void file(const Key& key);

  std::map<Key, Asked> asked_;
  std::deque<Key> over_;                  ///< of those, the oldest first
  std::map<std::string, ByteBook> past_;  ///< 1 + state of each that was let go, by UAV
};

}  // namespace skein::translation
