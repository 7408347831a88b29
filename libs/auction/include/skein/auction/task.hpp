// SPDX-License-Identifier: Apache-2.0
// Tasks on sale, with their requirements, time windows and precedences.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/id.hpp"
#include "skein/foundation/result.hpp"

namespace skein::auction {

using TaskNumber = Id<struct TaskNumberTag>;
using MemberNumber = Id<struct MemberNumberTag>;

/// A set of abilities and sensors, one bit each; the caller assigns bits to names.
using Abilities = std::uint64_t;

/// An approximate place, only used to tell which tasks lie near each other. [m]
struct Place {
  double x = 0;
  double y = 0;
  bool operator==(const Place&) const = default;
};

/// What the winner of a task has to do. Opaque to the auction, which only carries it.
struct Work {
  Work() = default;
  Work(const Work&) = default;
  Work& operator=(const Work&) = default;
  virtual ~Work() = default;
};

/// A task on sale. Times are seconds from the origin of the sale. Source: spec 6.3; T VII.2.2.
struct Task {
  TaskNumber number;
  double duration = 0;              ///< [s], with all members working at once
  Abilities needs = 0;              ///< required of the members together
  Abilities needs_each = 0;         ///< required of every member
  std::uint32_t least_members = 1;  ///< more than one: a joint task, sold to a whole group or not
  double earliest = 0;              ///< must not begin before [s]
  double deadline = std::numeric_limits<double>::infinity();  ///< must have ended by [s]
  Place at;
  std::optional<MemberNumber> pinned{};  ///< by the operator: must be one of its members
  std::set<MemberNumber> forbidden{};    ///< by the operator: must not be its members
  bool repeatable = false;  ///< may be done twice, so it is sold again when its owner is silent
  std::shared_ptr<const Work> work{};
};

/// Bounds on the time from the end of one task to the beginning of another [s]. The way to the
/// other is part of it.
struct Delay {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  bool operator==(const Delay&) const = default;
  /// Whether it says more than that the one ends before the other begins.
  bool bounds() const { return least > 0 || bounds_above(); }
  bool bounds_above() const { return most < std::numeric_limits<double>::infinity(); }
};

/// `first` must end before `then` begins, within the bounds of the delay.
struct Precedence {
  TaskNumber first;
  TaskNumber then;
  Delay delay{};
  bool operator==(const Precedence&) const = default;
};

/// The tasks of one sale: a mission, or the remaining tasks of several.
struct Lot {
  std::vector<Task> tasks;
  std::vector<Precedence> precedences;
};

/// Tasks whose constraints contradict each other, whichever members do them.
struct Contradiction {
  std::vector<TaskNumber>
      chain;  ///< each precedes the next; in a cycle the first and last are the same
  std::string why;
};

/// All errors of a lot that do not depend on the members: duplicate task numbers, precedences of
/// unknown tasks, members both pinned and forbidden, cycles of precedences, chains that cannot end
/// by a deadline; if there is none of these, one circle of bounds that contradict each other, if
/// delays have a greatest. Empty: none. Cost: O((tasks + precedences) log); tasks × precedences
/// with such delays.
std::vector<Contradiction> contradictions(const Lot& lot);

}  // namespace skein::auction
