// SPDX-License-Identifier: Apache-2.0
// Progress of an interrupted high-level task, so that only the rest is planned.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::mission {

/// Belongs to the high-level task and outlives its plans: its next plan starts from this progress.
/// States what was observed, not what was planned. Source: T IV.4.2 (SCD-2, SCD-6).
struct Progress {
  /// A device perceived from a place for a time, while its companion motion ran.
  struct Look {
    std::string device;
    world::Vector3 at = world::Vector3::Zero();  ///< [m] ENU, place that the vehicle was sent to
    Duration lasted;
    bool operator==(const Look&) const = default;
  };
  /// The rest of a way along which a device perceived, from the last way-point reached.
  struct Rest {
    std::string device;
    std::vector<world::Vector3> way;  ///< [m] ENU; empty: all of it was flown
    bool operator==(const Rest&) const = default;
  };

  std::vector<world::Vector3> reached;   ///< where its motions ended [m] ENU, in order
  std::vector<Look> looks;               ///< in order
  Duration waited;                       ///< in place, with or without a device
  std::set<std::uint64_t> synchronised;  ///< ids of synchronisations that are done
  std::optional<Rest> rest;              ///< of the last way with a perception along it
  bool operator==(const Progress&) const = default;

  bool none() const { return *this == Progress{}; }
  Duration looked() const;  ///< all looks together
};

/// For people: "perceived 290 s, 3 places reached, synchronised 551"; empty when nothing was done.
std::string to_text(const Progress& progress);

}  // namespace skein::mission
