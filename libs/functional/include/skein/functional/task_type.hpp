// SPDX-License-Identifier: Apache-2.0
// What a type of elementary tasks asks of the vehicle.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skein::functional {

enum class Motion : std::uint8_t {
  kNone,   ///< it does not care what the vehicle does
  kKeeps,  ///< the vehicle is to stay where it is
  kMoves,
};

enum class Leaves : std::uint8_t { kAsItWas, kInTheAir, kOnTheGround };

enum class CarriedOutBy : std::uint8_t {
  kFunctionalLayer,
  kExecutive,    ///< by synchronisation messages
  kInteraction,  ///< with other UAVs, by the supervisor
};

enum class Ending : std::uint8_t {
  kByItself,  ///< nature, or its parameters, say when
  kByOrder,   ///< whoever gives the next orders
  kByStop,    ///< another task that its stop names
};

/// Declared in data (task_types.hpp). Source: spec 2.1, 2.5, 3.3; T III.1.1.
struct TaskType {
  std::string name;
  std::optional<std::vector<std::string>> parameters;  ///< names that it takes; absent: any
  Motion motion = Motion::kNone;
  Leaves leaves = Leaves::kAsItWas;  ///< where the vehicle is when it has ended
  std::vector<std::string> devices;  ///< parameters that name a device, its own while active
  bool radio = false;
  CarriedOutBy by = CarriedOutBy::kFunctionalLayer;
  std::vector<Ending> ends;

  /// Nothing else may move the vehicle while it is active.
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
