// SPDX-License-Identifier: Apache-2.0
// Types of elementary tasks: their demands on the vehicle.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skein::functional {

enum class Motion : std::uint8_t {
  kNone,   ///< independent of the vehicle's motion
  kKeeps,  ///< the vehicle has to hold its position
  kMoves,  ///< the task moves the vehicle
};

/// The condition of the vehicle after the task has ended.
enum class Leaves : std::uint8_t { kAsItWas, kInTheAir, kOnTheGround };

enum class CarriedOutBy : std::uint8_t {
  kFunctionalLayer,
  kExecutive,    ///< with synchronisation messages
  kInteraction,  ///< joint tasks: with other UAVs, through the supervisor
};

/// What ends a task of a type.
enum class Ending : std::uint8_t {
  kByItself,  ///< its nature, or its parameters
  kByOrder,   ///< an order from outside
  kByStop,    ///< another task, which its stop condition names
};

/// A type of elementary tasks, declared as data (task_types.hpp). Source: spec 2.1, 2.5, 3.3;
/// T III.1.1.
struct TaskType {
  std::string name;
  std::optional<std::vector<std::string>> parameters;  ///< allowed names; absent: any
  Motion motion = Motion::kNone;
  Leaves leaves = Leaves::kAsItWas;
  std::vector<std::string> devices;  ///< parameters that name a device, which the task then owns
  bool radio = false;
  CarriedOutBy by = CarriedOutBy::kFunctionalLayer;
  std::vector<Ending> ends;

  /// Whether no other task may move the vehicle while this one is active.
  bool holds_vehicle() const { return motion != Motion::kNone; }
  bool synchronises() const { return by == CarriedOutBy::kExecutive; }
  bool is_joint() const { return by == CarriedOutBy::kInteraction; }
  bool can_end(Ending how) const { return std::find(ends.begin(), ends.end(), how) != ends.end(); }
  bool takes(const std::string& parameter) const {
    return !parameters ||
           std::find(parameters->begin(), parameters->end(), parameter) != parameters->end();
  }
  bool operator==(const TaskType&) const = default;
};

}  // namespace skein::functional
