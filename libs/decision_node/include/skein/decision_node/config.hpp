// SPDX-License-Identifier: Apache-2.0
// What a decision node is told at its start.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/decision_node/contact.hpp"
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

/// What a UAV has to know to merge its ways. Source: spec 6.4.
struct MergingConfig {
  std::vector<std::string> members;  ///< the UAVs, this one too; the same order for all
  world::VehicleModel model;
  world::Wind wind;  ///< as at the start
  std::shared_ptr<const world::Terrain> terrain;
  std::vector<world::Volume> volumes;  ///< no-fly, as at the start; with `knowledge` as believed
  std::string witness = {};  ///< the ground station's name, if it is the third of each pair
};

struct Config {
  std::string uav;
  std::vector<std::string> others = {};  ///< UAVs that it may synchronise with
  int degree = 3;  ///< at the start, 1 to 5; 4 needs `knowledge`, 5 also `team`
  ContactPolicy contact_policy = ContactPolicy::kContinue;
  Duration contact_after = Duration::seconds(60);
  /// It keeps to the ground: it may be on its way without being in the air, and lands nowhere.
  bool drives = false;
  /// Where `kReturn` goes before it lands: x, y, z [m] ENU.
  std::vector<double> home = {0, 0, 50};
  std::optional<Duration> functional_timeout = Duration::seconds(120);
  std::optional<Duration> sync_validity = std::nullopt;  ///< see executive::Config
  std::optional<std::string> background_type;
  /// Null: the scenario has no planning domain, and degree 4 is refused.
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;  ///< as at the start; null only without knowledge
  std::shared_ptr<const interaction::Library> interaction;  ///< null: no joint tasks
  std::optional<team::Config> team = {};                    ///< it is in the roster; absent: none
  std::optional<MergingConfig> merging = {};                ///< absent: ways are flown unasked
  /// How plans are kept consistent in time with others'; absent: they are not.
  std::optional<temporal::Algorithm> consistency = temporal::Algorithm::kDipM;
  Duration horizon = Duration::seconds(15);  ///< commitment, see supervisor::Config
  executive::TaskId first_task{1};           ///< of the supervisor's; below kFirstRoleId
};

}  // namespace skein::decision_node
