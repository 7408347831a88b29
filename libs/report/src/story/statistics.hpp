// SPDX-License-Identifier: Apache-2.0
// The figures of a run.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

struct UavFigures {
  double distance =
      0.0;  ///< [m] length of the track while airborne; of the whole track if never airborne
  double airborne = 0.0;               ///< [s]
  std::optional<double> max_altitude;  ///< [m] ENU, of the whole track
  double max_speed = 0.0;              ///< [m/s]
  std::optional<double> energy_used;   ///< share of the capacity, from first to last sample
  std::size_t tasks = 0;
  std::size_t ended = 0;
  std::size_t aborted = 0;
};

/// The closest that two UAVs came while both were airborne, at the samples of either.
struct Separation {
  double metres = 0.0;
  double t = 0.0;
  std::size_t first = 0;  ///< indices into Chronology::uavs
  std::size_t second = 0;
};

/// What one slot carried from one node to another.
struct ChannelFigures {
  std::size_t sent = 0;
  std::size_t received = 0;
  std::size_t lost = 0;
  std::size_t expired = 0;
  std::vector<double> latencies;  ///< [s], ascending
};

/// Slot, from, to. A record of a loss names no sender: `from` is then the node that wrote it.
using ChannelKey = std::tuple<std::string, std::string, std::string>;

struct Statistics {
  std::vector<UavFigures> uavs;
  std::optional<Separation> separation;
  std::map<ChannelKey, ChannelFigures> channels;
  std::size_t lines = 0;  ///< readable ones
  std::size_t passed = 0;
  std::size_t failed = 0;
  bool ok() const { return failed == 0 && passed > 0; }
};

Statistics measure(const Chronology& chronology, const Journal& journal);

/// The least distance over time between any two airborne UAVs, for each instant of the first
/// track of the pair; series for the profile: (t, metres), in time order.
std::vector<std::pair<double, double>> separation_series(const Chronology& chronology,
                                                         std::size_t samples);

/// The value below which a share of an ascending series lies (nearest rank); 0 for none.
double quantile(const std::vector<double>& ascending, double share);

}  // namespace skein::report
