// SPDX-License-Identifier: Apache-2.0
// Known state of a run at an instant.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "skein/journal/record.hpp"

namespace skein::series_tool {

/// Not known yet.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct UavState {
  std::array<double, 3> position{kUnknown, kUnknown, kUnknown};  ///< [m] ENU
  std::array<double, 3> velocity{kUnknown, kUnknown, kUnknown};  ///< [m/s] ENU
  double heading = kUnknown, energy = kUnknown, airborne = kUnknown, degree = kUnknown;
  double revision = kUnknown, decisions = 0, reachable = kUnknown;
  std::set<std::int64_t> running;  ///< ids of running tasks
  std::set<std::int64_t> open;     ///< ids of high-level tasks without a final state
};

/// Takes the records of a run in the order of time.
class State {
 public:
  void see(const journal::Record& record);

  /// State of a UAV; all unknown if it has no records yet.
  const UavState& uav(const std::string& name) const;
  /// Truth of the radio from one node to another: 1 up, 0 down.
  double link(const std::string& from, const std::string& to) const;
  double alarms() const { return static_cast<double>(alarms_.size()); }
  double messages() const { return messages_; }

 private:
  void see_uav(const journal::Record& record, UavState& uav);

  std::map<std::string, UavState> uavs_;
  std::map<std::pair<std::string, std::string>, double> links_;
  std::set<std::int64_t> alarms_;  ///< raised or confirmed, not infirmed
  double messages_ = 0;            ///< event samples sent so far
};

/// Distance of two UAVs [m]; unknown if either position is.
double distance(const UavState& a, const UavState& b);

}  // namespace skein::series_tool
