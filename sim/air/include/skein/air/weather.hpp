// SPDX-License-Identifier: Apache-2.0
// Applies the simulator's link states to the Air.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "skein/air/air.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::air {

/// Conditions on every link in addition to the simulator's: the greater loss holds, delays add up,
/// and a rate replaces the reported capacity (which the nodes themselves keep to as well).
struct Everywhere {
  double loss = 0;
  Duration delay;
  double rate = 0;  ///< [byte/s]; 0: any
};

/// Follows link states once the mission runs; before, all nodes hear each other, as on the apron.
/// Mission time is converted to steady time by the clock's rate.
class Weather {
 public:
  /// `numbers`: of the nodes of the air, in its order.
  Weather(std::vector<std::uint32_t> numbers, Everywhere everywhere, Air& air);

  /// Takes a Clock or a LinkState; other samples are ignored.
  void hear(const wire::Sample& sample);
  bool running() const { return running_; }
  /// Mission time as last heard [ns].
  std::int64_t mission_time() const { return mission_time_; }

 private:
  void apply();
  Condition condition_of(const wire::LinkState& state) const;

  std::vector<std::uint32_t> numbers_;
  Everywhere everywhere_;
  Air& air_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, wire::LinkState> states_;
  bool running_ = false;
  double rate_ = 1;
  std::int64_t mission_time_ = 0;
};

}  // namespace skein::air
