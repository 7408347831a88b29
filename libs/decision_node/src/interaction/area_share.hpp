// SPDX-License-Identifier: Apache-2.0
// An area that is shared among the members of a joint task, as one of them has it: its own part,
// what is left of it, what is left of others', and what is nobody's any more.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// What a sweep is planned with.
struct SweepSetting {
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  MissionTime now;
  world::VehicleState state;
  std::string device;
};

class AreaShare {
 public:
  explicit AreaShare(std::string self) : self_(std::move(self)) {}

  /// It was shared at least once.
  bool agreed() const { return round_ > 0; }
  /// A result of area-sharing: each part is added to what its member has left.
  void agree(const interaction::Rows& result);
  /// All of these are its own.
  void take(const std::vector<world::Polygon>& areas);
  /// What it had left is nobody's, as it told last or as it was agreed.
  void lose(const std::string& uav);
  const std::vector<world::Polygon>& nobodys() const { return nobodys_; }
  /// A partner tells what it has left; what it told before the area was shared again counts not.
  void told(const std::string& uav, const interaction::Rows& left);

  /// To tell partners; empty before it is agreed.
  interaction::Rows left() const;
  /// Its own [m²].
  double area_left() const;

  /// What it can do beside what it has left. Refused: no device, no way, no energy.
  Result<interaction::Rows, Failure> offer(const SweepSetting& setting) const;
  /// The way over all that is left of its own, from where it is; empty: nothing is left. From then
  /// on what is flown of it counts.
  Result<refiners::Way, Failure> set_out(const SweepSetting& setting);
  /// It flew there from where it was last.
  void fly(const world::Vector3& to, double reach);
  /// It flew all of the way.
  void flown();

 private:
  /// Lanes over a convex piece, of which so many points are passed.
  struct Piece {
    world::Polygon area;
    refiners::Way lanes = {};
    std::size_t passed = 0;
    double reach = 0;  ///< to each side of a lane [m]
    world::Polygon left() const;
  };
  std::vector<world::Polygon> own_left() const;

  std::string self_;
  int round_ = 0;
  std::vector<Piece> own_;
  std::map<std::string, std::vector<world::Polygon>> others_;
  std::vector<world::Polygon> nobodys_;
  std::vector<world::Vector3> at_;  ///< where it was last, if that is known
};

/// The part of a convex polygon in which `lowest` <= its distance along `normal` <= `highest`.
world::Polygon between(const world::Polygon& polygon, const world::Vector2& normal, double lowest,
                       double highest);

}  // namespace skein::decision_node
