// SPDX-License-Identifier: Apache-2.0
// What a bidder asks about its own vehicle.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// A flight between two places of a plan.
struct Leg {
  double seconds = 0;
  double cost = 0;    ///< what a sum of costs adds up: metres, or what else the team agreed on
  double energy = 0;  ///< [J]
};

/// Stands for a way that does not exist: longer than any deadline.
inline constexpr Leg kNoWay{1e12, 1e12, 0};

/// A place of a member's plan: a task's, where it begins, or where it ends.
class Stopover {
 public:
  static constexpr Stopover begin() { return Stopover(kBegin); }
  static constexpr Stopover end() { return Stopover(kEnd); }
  static constexpr Stopover of(TaskNumber task) { return Stopover(task.value()); }
  constexpr bool is_begin() const { return code_ == kBegin; }
  constexpr bool is_end() const { return code_ == kEnd; }
  constexpr TaskNumber task() const { return TaskNumber(static_cast<std::uint32_t>(code_)); }

 private:
  static constexpr std::uint64_t kBegin = 1ULL << 32;
  static constexpr std::uint64_t kEnd = kBegin + 1;
  constexpr explicit Stopover(std::uint64_t code) : code_(code) {}
  std::uint64_t code_;
};

/// The bidder's own vehicle and plan, asked in evaluation only: every function is const and leaves
/// nothing behind. A decision node answers with operator 1 in evaluation mode. Source:
/// spec 6.2, 6.3.
class Craft {
 public:
  virtual ~Craft() = default;
  virtual Abilities abilities() const = 0;
  /// When it is free of what it does already [s from the origin of the sale].
  virtual double free_from() const { return 0; }
  /// What a plan may take [J].
  virtual double energy() const { return std::numeric_limits<double>::infinity(); }
  /// None: there is no way.
  virtual std::optional<Leg> leg(Stopover from, Stopover to) const = 0;
  /// What the task itself takes [J].
  virtual double energy_of(const Task&) const { return 0; }
  /// Why this vehicle would not do the task even if it were alone in the world; none: it would.
  virtual std::optional<std::string> objection(const Task&) const { return std::nullopt; }
};

}  // namespace skein::auction
