// SPDX-License-Identifier: Apache-2.0
// One member's view of an area divided among the members of a joint task: its own part, the
// remainders of its own and of the others' parts, and what has no owner any more.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "skein/negotiation/terms.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/supervisor/area_sweep.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// The name of a row that is an area to share.
inline constexpr const char* kArea = "area";

/// The input of planning a sweep.
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

  /// Whether the area was divided at least once.
  bool agreed() const { return round_ > 0; }
  /// How often.
  int divisions() const { return round_; }
  /// A result of area-sharing under these parameters: adds each part to the remainder of its
  /// member; of those whose remainders were shared anew, in their stead. What had no owner has one
  /// then, as far as it was shared: somebody may have been lost since the session was opened.
  void agree(const interaction::Rows& result, const interaction::Rows& parameters = {});
  /// Adds all of `areas` to this member's own part.
  void take(const std::vector<world::Polygon>& areas);
  /// A partner is lost: its remainder, as last told or agreed, has no owner any more.
  void lose(const std::string& uav);
  /// A partner goes on without this member: its remainder stays its own, though it was lost here.
  void leave_to(const std::string& uav);
  /// What that partner, which goes on without this member, told of its remainder and of what it
  /// took of this member's: what others have of its own part is theirs. Whether there was some.
  bool yield_to(const std::string& uav, const interaction::Rows& left);
  /// The remainders of lost partners.
  std::vector<world::Polygon> nobodys() const;
  /// A partner's remainder. Ignored if it was told before the latest division. Before the first
  /// one, it is of a partner that has taken this member in.
  void told(const std::string& uav, const interaction::Rows& left);
  /// Whether this member comes to partners that have shared the area.
  bool comes_later() const { return !there_.empty(); }
  /// The parameters of the next session, without the number of divisions: what nobody has; and, if
  /// somebody comes to those who have shared the area, all that these have left.
  interaction::Rows to_share() const;
  /// A member holds a role from now on that held none: all share anew what they have left once it
  /// asks them to.
  void take_in(const std::string& uav) { newcomers_.insert(uav); }

  /// This member's remainder, and what it took of lost partners, for all; empty before the first
  /// division.
  interaction::Rows left() const;
  /// Area of this member's remainder [m²].
  double area_left() const;

  /// This member's capacity beside its remainder, or with it where that is to be shared anew.
  /// Refused: no device, no way, no energy; its remainder is not as the session has it.
  Result<interaction::Rows, Failure> offer(const interaction::Terms& terms,
                                           const SweepSetting& setting) const;
  /// The way over this member's remainder, from its position, but for what lies in closed air and
  /// half a swath around it; empty: nothing remains. Flights reported from then on reduce the
  /// remainder. Refused: none of it can be swept now.
  Result<refiners::Way, supervisor::NoSweep> set_out(const SweepSetting& setting);
  /// The vehicle flew straight from its last position to `to`, seeing `reach` [m] to each side.
  void fly(const world::Vector3& to, double reach);
  /// The vehicle has flown all of the way. What lay in closed air is left.
  void flown();

 private:
  /// The lanes over a convex piece, and how many of their points are passed.
  struct Piece {
    world::Polygon area;
    refiners::Way lanes = {};
    std::size_t passed = 0;
    double reach = 0;  ///< to each side of a lane [m]
    world::Polygon left() const;
  };
  std::vector<world::Polygon> own_left() const;
  /// Why what a session shares is not what there is; empty: it is.
  std::string outdated(const interaction::Terms& terms) const;
  /// To this member's own part.
  void add(world::Polygon area);

  std::string self_;
  int round_ = 0;
  std::vector<Piece> own_;
  std::map<std::string, std::vector<world::Polygon>> others_;
  std::map<std::string, std::vector<world::Polygon>> lost_;   ///< by the partner that had them
  std::map<std::string, std::vector<world::Polygon>> taken_;  ///< by the partner that had them
  /// What others said to have, and to have taken of this member's, by who said it.
  std::map<std::string, std::vector<world::Polygon>> kept_by_, taken_by_;
  std::map<std::string, interaction::Rows> there_;  ///< before the first division: told by partners
  std::set<std::string> newcomers_;                 ///< who were taken in, and have no part yet
  std::vector<world::Vector3> at_;                  ///< the last position; empty: unknown
};

}  // namespace skein::decision_node
