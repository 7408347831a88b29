// SPDX-License-Identifier: Apache-2.0
// The high-level tasks of a planning domain, with their parameters and the devices that they need;
// and the check of missions against these.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/mission/high_level_task.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::mission {

/// Kind of an argument.
enum class ParameterKind : std::uint8_t {
  kPlace,     ///< a named place, or a location
  kZone,      ///< a named zone
  kPlaces,    ///< a list of named places
  kDuration,  ///< seconds, > 0
  kNumber,    ///< any finite number
  kUavs,      ///< a list of names of UAVs of the team
  kUav,       ///< the name of a UAV of the team
  kDevice,    ///< a device of the vehicle's
  kSyncId,    ///< a whole number > 0, common to the UAVs that synchronise
  kWord,      ///< any name
  kCount
};
/// "place", "zone", "places", "duration", "number", "uavs", "uav", "device", "sync-id", "word".
std::string_view to_text(ParameterKind kind);
std::optional<ParameterKind> parameter_kind_from(std::string_view text);

struct TaskSignature {
  std::string name;
  std::vector<ParameterKind> parameters;
  std::vector<std::string> uses;  ///< each must be served by a device on board: "detection"
  bool operator==(const TaskSignature&) const = default;
};

/// The tasks of a domain. A domain declares them by axioms (docs/comets-domain.md):
///   (:- (high-level-task perform-detection (zone place duration) (detection)) ())
///   (:- (device-serves fire-sensor detection) ())
struct Vocabulary {
  std::map<std::string, TaskSignature, std::less<>> tasks;
  std::multimap<std::string, std::string, std::less<>> serves;  ///< device name → use
};

/// Names that a mission may refer to. `vehicle` may be null: devices are not checked then.
struct Surroundings {
  std::vector<std::string> places, zones, uavs;
  const world::VehicleModel* vehicle = nullptr;
};

/// Every reason why the mission is invalid, in sentences; empty when it is fine: unknown tasks
/// (with the nearest name), wrong number and kind of arguments, unknown places, zones, UAVs and
/// devices (with the nearest name; upper and lower case differ), goals given twice, goals and
/// missions numbered 0, no tasks, no device that serves a use, time constraints that contradict
/// each other or have passed at `now`, figures that are not finite. Any mission may be given,
/// however odd. Cost: linear in the mission, and in the names known for each name of it.
std::vector<std::string> problems_of(const UnitMission& mission, const Vocabulary& vocabulary,
                                     const Surroundings& surroundings, MissionTime now);

}  // namespace skein::mission
