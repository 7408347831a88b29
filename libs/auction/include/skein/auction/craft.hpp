// SPDX-License-Identifier: Apache-2.0
// The bidder's interface to its own vehicle and plan.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// A flight between two places of a plan.
struct Leg {
  double seconds = 0;
  double cost = 0;    ///< in the unit of the team's sum of costs, e.g. metres
  double energy = 0;  ///< [J]
};

/// A leg that does not exist: longer than any deadline.
inline constexpr Leg kNoWay{1e12, 1e12, 0};

/// A place of a member's plan: the place of a task, the start, or the end of the plan.
class Stopover {
 public:
  static constexpr Stopover begin() { return Stopover(kBegin); }
  static constexpr Stopover end() { return Stopover(kEnd); }
  static constexpr Stopover of(TaskNumber task) { return Stopover(task.value()); }
  constexpr bool is_begin() const { return code_ == kBegin; }
  constexpr bool is_end() const { return code_ == kEnd; }
  constexpr auto operator<=>(const Stopover&) const = default;  ///< for keys
  constexpr TaskNumber task() const { return TaskNumber(static_cast<std::uint32_t>(code_)); }

 private:
  static constexpr std::uint64_t kBegin = 1ULL << 32;
  static constexpr std::uint64_t kEnd = kBegin + 1;
  constexpr explicit Stopover(std::uint64_t code) : code_(code) {}
  std::uint64_t code_;
};

/// The bidder's own vehicle and plan, for evaluation only: every function is const and has no side
/// effect. A decision node implements it with operator 1 (insertion) in evaluation mode. Source:
/// spec 6.2, 6.3.
class Craft {
 public:
  virtual ~Craft() = default;
  virtual Abilities abilities() const = 0;
  /// When the vehicle has finished its current commitments [s from the origin of the sale].
  virtual double free_from() const { return 0; }
  /// The energy available for a plan [J].
  virtual double energy() const { return std::numeric_limits<double>::infinity(); }
  /// The flight between two places; none: there is no way.
  virtual std::optional<Leg> leg(Stopover from, Stopover to) const = 0;
  /// The energy of the task itself, without the flight to it [J].
  virtual double energy_of(const Task&) const { return 0; }
  /// Why this vehicle could not do the task even with nothing else to do; none: it could.
  virtual std::optional<std::string> objection(const Task&) const { return std::nullopt; }
};

}  // namespace skein::auction
