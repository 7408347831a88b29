// SPDX-License-Identifier: Apache-2.0
// The functions `best-view` and `relay-position` of roles: places by the refiners that satisfy
// spatial constraints.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "skein/interaction/placed_constraint.hpp"
#include "skein/interaction/valid_position.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {

/// Common inputs of both functions.
struct RolePlaceQuery {
  world::VehicleModel vehicle;
  Position from{};              ///< position of the UAV [m, ENU]
  double clearance = 20;        ///< least height over the ground [m]
  MissionTime at;               ///< volumes that are closed at some time from then on count
  std::vector<ActiveScm> scms;  ///< constraints that the place must satisfy
  ScmLimits limits;
};

/// Views that one vehicle searched for in vain over one terrain. A refusal holds until something on
/// which it depends changes; where the vehicle is does not count. Holds the last few. A value.
class RefusedViews {
 public:
  /// What a refusal depends on.
  struct Search {
    std::string device;
    Position target{};
    double clearance = 0;                       ///< [m]
    std::vector<world::Volume> closed;          ///< at some time from then on
    std::vector<PlacedConstraint> constraints;  ///< of the SCMs
    bool operator==(const Search&) const = default;
  };
  /// Why it was refused; absent: not known.
  std::optional<Failure> why(const Search& search) const;
  void refused(Search search, const Failure& why);

 private:
  std::deque<std::pair<Search, Failure>> known_;
};

/// The viewpoint refiner's best place to perceive a target with a device of the vehicle, among the
/// places where the SCMs hold. What is known as refused is not searched for again; what no budget
/// cut short becomes known. Errors: those of the refiner; an SCM refers to an unknown place.
Result<Position, Failure> best_view(const RolePlaceQuery& query, const std::string& device,
                                    const Position& target, const Observer& observer,
                                    const refiners::Setting& setting,
                                    RefusedViews* known = nullptr);

/// A place with radio links to both ends, with a margin of at least `least_margin` [dB], over the
/// real terrain and in line of sight if the radio needs it, where the SCMs hold; the nearest to the
/// relay refiner's best place. Errors: no such place was found; an SCM refers to an unknown place.
Result<Position, Failure> relay_position(const RolePlaceQuery& query, const Position& one,
                                         const Position& other, double least_margin,
                                         const Observer& observer,
                                         const refiners::Setting& setting);

}  // namespace skein::interaction
