// SPDX-License-Identifier: Apache-2.0
// Waiting places of the partners of a synchronisation: each partner computes all of them, with the
// same result and without communication.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "refinery/views.hpp"

namespace skein::supervisor {

class MeetingPlaces {
 public:
  MeetingPlaces(TimedAir& air, Views& views) : air_(air), views_(views) {}
  MeetingPlaces(const MeetingPlaces&) = delete;
  MeetingPlaces& operator=(const MeetingPlaces&) = delete;

  struct Devices {
    std::string own;                 ///< the device that this UAV looks with
    std::vector<std::string> order;  ///< partners look with the first that they have and that sees
  };
  struct Gathering {
    Spot own;
    std::vector<Spot> others;  ///< of partners for which a place was found, in the order of `names`
  };
  /// The waiting places for a meeting at `place`. `names`: all UAVs that meet, including this one,
  /// in an order common to all.
  ///
  /// A place in the air itself is left free for UAVs with other tasks there: the partners wait
  /// around it, each in a direction by its rank, so far apart that their circles and tracking
  /// errors do not overlap; or above each other if there is no room for that. At a place on the
  /// ground, each UAV in turn gets the best viewpoint for which the earlier ones leave room.
  /// Partners have their own vehicle models (Knowledge::partners), with all devices working. Cost:
  /// a viewpoint and an airspace for each UAV.
  Answer<Gathering> at(const world::Vector3& place, const std::vector<std::string>& names,
                       const Devices& devices, const Departure& when);

 private:
  /// One of the UAVs, with its own air and views; `room`: distance that others keep from it [m].
  struct Party {
    TimedAir& air;
    Views& views;
    double room;
  };
  struct Stranger {
    explicit Stranger(TimedAir theirs) : air(std::move(theirs)) {}
    TimedAir air;
    Views views{air};
  };
  Party party(const std::string& name);
  bool is_me(const std::string& name) const;
  Answer<Spot> around(const world::Vector3& place, const Party& one, std::size_t rank,
                      const std::vector<Spot>& before, double distance);
  Answer<Spot> beside(const world::Vector3& place, const Party& one,
                      const std::vector<std::string>& devices, const std::vector<Spot>& before,
                      const Departure& when);

  TimedAir& air_;
  Views& views_;
  std::map<std::string, std::unique_ptr<Stranger>> others_;
};

}  // namespace skein::supervisor
