// SPDX-License-Identifier: Apache-2.0
// Output of every functional layer beside its answers: event log records (kinds functional and
// telemetry, docs/journal.md), and the true positions of its vehicles.
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

/// Makes records of kind functional: one for each change of a task, with the request. Of finished
/// tasks except the last kKept only the state is stored.
class FunctionalLines {
 public:
  static constexpr std::size_t kKept = 256;

  /// Notes a request; a repeated request is the same task.
  void note(const std::string& uav, const functional::Request& asked);
  /// The record of a state; absent: already written.
  std::optional<journal::Record> line_of(MissionTime at, const std::string& node,
                                         const std::string& uav, const functional::Status& status);

 private:
  /// A requested task, and the last state written of it.
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
