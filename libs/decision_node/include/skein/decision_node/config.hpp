// SPDX-License-Identifier: Apache-2.0
// Configuration of a decision node.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/decision_node/contact.hpp"
#include "skein/decision_node/other_uavs.hpp"
#include "skein/executive/executive.hpp"
#include "skein/interaction/model.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/team/roster.hpp"
#include "skein/temporal/algorithm.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/wind.hpp"

namespace skein::decision_node {

/// Configuration of plan merging. Source: spec 6.4.
struct MergingConfig {
  std::vector<std::string> members;  ///< all UAVs that merge, this one too; the same order for all
  world::VehicleModel model;
  world::Wind wind;  ///< as at the start
  std::shared_ptr<const world::Terrain> terrain;
  std::vector<world::Volume> volumes;  ///< no-fly volumes at the start; `knowledge` updates them
  std::string witness = {};  ///< name of the ground station if it is the witness, else empty
};

struct Config {
  std::string uav;
  OtherUavs others = {};  ///< UAVs that this one may synchronise with
  int degree = 3;         ///< initial degree, 1 to 5; 4 needs `knowledge`, 5 also `team`
  ContactPolicy contact_policy = ContactPolicy::kContinue;
  Duration contact_after = Duration::seconds(60);
  /// A ground vehicle: it moves without being airborne, and never takes off or lands.
  bool drives = false;
  /// Where ContactPolicy::kReturn flies to before landing: x, y, z [m] ENU.
  std::vector<double> home = {0, 0, 50};
  std::optional<Duration> functional_timeout = Duration::seconds(120);
  std::optional<Duration> sync_validity = std::nullopt;  ///< see executive::Config
  std::optional<std::string> background_type;
  /// Null: the scenario has no planning domain; degree 4 is refused.
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;  ///< at the start; null only without `knowledge`
  std::shared_ptr<const interaction::Library> interaction;  ///< null: no joint tasks
  std::optional<team::Config> team = {};      ///< roster that includes this UAV; absent: no team
  std::optional<MergingConfig> merging = {};  ///< absent: ways are flown without reservations
  /// Algorithm of temporal consistency with the plans of others; absent: none.
  std::optional<temporal::Algorithm> consistency = temporal::Algorithm::kDipM;
  /// Silence after which a partner of a synchronisation or joint task is not waited for any more.
  Duration partner_lease = Duration::seconds(600);
  Duration horizon = Duration::seconds(15);  ///< of commitment, see supervisor::Config
  executive::TaskId first_task{1};  ///< first id of the supervisor's tasks; below kFirstRoleId
};

}  // namespace skein::decision_node
