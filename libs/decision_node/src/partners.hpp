// SPDX-License-Identifier: Apache-2.0
// Which partners are silent, and for which of them nobody waits any more.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "skein/decision_node/messages.hpp"
#include "skein/foundation/time.hpp"

namespace skein::decision_node {

/// What waited for partners and is begun again within this goes on with its wait.
inline constexpr Duration kPlannedAgain = Duration::milliseconds(20'000);

/// A partner that is out of reach is silent. Whoever waits for a silent partner waits for its
/// lease, counted from the beginning of the silence or of the wait, whichever is later; then the
/// partner is given up: nobody here waits for it any more until it is heard again. One that an
/// operator declares lost is given up at once. A value. Source: spec 6.3, 7.3.
class Partners {
 public:
  explicit Partners(Duration lease) : lease_(lease) {}

  /// To be called first; nobody has been heard yet.
  void start(MissionTime now) { born_ = ground_silent_since_ = now; }
  /// Nothing was heard until now, as after a restart: who was silent is so from now on.
  void resume(MissionTime now);
  void contact(const Contact& contact, MissionTime now);
  void declare_lost(const std::string& uav) { lost_.insert(uav); }
  void declare_found(const std::string& uav) { lost_.erase(uav); }

  /// Since when a UAV is out of reach; absent: it is in reach.
  std::optional<MissionTime> silent_since(const std::string& uav) const;
  bool is_declared_lost(const std::string& uav) const { return lost_.contains(uav); }
  /// Why whoever has waited since `waits` waits for this UAV no longer: "no contact with 'heliv'
  /// since 312 s", "'heliv' is declared lost"; absent: it goes on waiting.
  std::optional<std::string> given_up(const std::string& uav, MissionTime waits, MissionTime now);
  /// When it will be so if the UAV stays silent; absent: the UAV is in reach.
  std::optional<MissionTime> gives_up_at(const std::string& uav, MissionTime waits) const;
  /// The same for a UAV whose words come by way of the ground station: not before that has been
  /// silent for the lease too; absent: one of them is in reach.
  std::optional<MissionTime> gives_up_past_ground_at(const std::string& uav,
                                                     MissionTime waits) const;
  Duration lease() const { return lease_; }
  /// "no contact with 'heliv' since 312 s", of who was never heard "since 0 s, when this node
  /// began". Precondition: it is silent.
  std::string silence_of(const std::string& uav) const;

 private:
  Duration lease_;
  MissionTime born_;
  bool hears_ground_ = false;
  MissionTime ground_silent_since_;                                 ///< unless it is heard
  std::map<std::string, std::optional<MissionTime>> silent_since_;  ///< UAVs with known contact
  std::set<std::string> given_up_;                                  ///< their lease is over
  std::set<std::string> lost_;  ///< declared lost, and not heard of anew since
};

}  // namespace skein::decision_node
