// SPDX-License-Identifier: Apache-2.0
// What is sold: tasks with their needs, windows and orders.
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

/// Abilities and sensors, one bit each; who calls numbers their names.
using Abilities = std::uint64_t;

/// A place that everybody knows, only to tell which tasks lie near each other. [m]
struct Place {
  double x = 0;
  double y = 0;
  bool operator==(const Place&) const = default;
};

/// What a task comes down to for whoever does it: opaque to the market, which passes it on.
struct Work {
  Work() = default;
  Work(const Work&) = default;
  Work& operator=(const Work&) = default;
  virtual ~Work() = default;
};

/// A task on sale. Times are seconds from the origin of the sale. Source: spec 6.3; T VII.2.2.
struct Task {
  TaskNumber number;
  double duration = 0;              ///< [s], of all its members together
  Abilities needs = 0;              ///< that its members have between them
  Abilities needs_each = 0;         ///< that each of its members has
  std::uint32_t least_members = 1;  ///< more than one: a joint task, all of them or none
  double earliest = 0;              ///< is not begun before [s]
  double deadline = std::numeric_limits<double>::infinity();  ///< has ended by then [s]
  Place at;
  std::optional<MemberNumber> pinned{};  ///< by the operator: is one of its members
  std::set<MemberNumber> forbidden{};    ///< by the operator: are none of them
  bool repeatable = false;  ///< may be done twice: is not waited for when its owner is silent
  std::shared_ptr<const Work> work{};
};

/// `first` ends before `then` begins.
struct Precedence {
  TaskNumber first;
  TaskNumber then;
  bool operator==(const Precedence&) const = default;
};

/// What is sold together: a mission, or what is left of several.
struct Lot {
  std::vector<Task> tasks;
  std::vector<Precedence> precedences;
};

/// Tasks that contradict each other whoever does them.
struct Contradiction {
  std::vector<TaskNumber>
      chain;  ///< each before the next; of a circle, first and last are the same
  std::string why;
};

/// Everything wrong with a lot by itself: numbers given twice, precedences of unknown tasks,
/// members that are pinned and forbidden, circles of precedences, chains that cannot end by a
/// deadline. Empty: nothing. Cost: tasks plus precedences, by a logarithm.
std::vector<Contradiction> contradictions(const Lot& lot);

}  // namespace skein::auction
