// SPDX-License-Identifier: Apache-2.0
// Where the partners of a synchronisation wait for each other: each reckons the places of all of
// them, alike and without asking.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "refinery/views.hpp"

namespace skein::supervisor {

class Meetings {
 public:
  Meetings(TimedAir& air, Views& views) : air_(air), views_(views) {}
  Meetings(const Meetings&) = delete;
  Meetings& operator=(const Meetings&) = delete;

  struct Devices {
    std::string own;                 ///< what this UAV looks with
    std::vector<std::string> order;  ///< others look with the first that is theirs and sees
  };
  struct Gathering {
    Spot own;
    std::vector<Spot> others;  ///< those that find a place, in the order of the names
  };
  /// Of all who meet, this UAV among them, in the order that all of them have.
  ///
  /// A place in the air is left free, for whoever comes there with another task: they wait around
  /// it, each in a direction by its rank, so far from it and from each other that nobody's circles
  /// and what he wavers meet another's, or over each other where there is no room for that. A place
  /// on the ground is looked at by each from the best side that those before leave room for. Each
  /// is taken for what it is (Knowledge::partners), with all its devices working. Cost: a viewpoint
  /// and an airspace for each.
  Answer<Gathering> at(const world::Vector3& place, const std::vector<std::string>& names,
                       const Devices& devices, const Departure& when);

 private:
  /// One of them, and how it sees air and places.
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
