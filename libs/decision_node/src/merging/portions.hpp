// SPDX-License-Identifier: Apache-2.0
// A sweep in portions, of which only the next has air.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "merging/airways.hpp"

namespace skein::decision_node {

/// One motion to its executive, several flights to the vehicle, each from where the one before
/// ends: the way of a sweep, cut at its way-points. A value. Source: spec 6.4 ("a portion of
/// trajectory"); docs/decisions/0068-sweeps-in-portions.md.
class Portions {
 public:
  /// Nothing: it is better flown as one, since it is short, or comes back nearer than `width` [m]
  /// to where it was, and what it would leave behind it would wait for again. `from`: where it
  /// begins. Cost: O(way-points²).
  static std::optional<Portions> of(const functional::Request& flight,
                                    const elementary::GotoTask& task, const world::Vector3& from,
                                    double width);

  /// Of the whole, as its executive knows it.
  functional::TaskId task() const { return next_.id; }
  /// The portion to be flown next, past `by`, under the number of the whole. Precondition: one is
  /// left.
  functional::Request next(const std::optional<world::Vector3>& by = {}) const;
  /// That one is flown from now on.
  void take() { ++taken_; }
  bool is_last_taken() const { return taken_ == parts_.size(); }
  /// So little of the portion that is flown is left [m] that the next is asked for.
  bool is_near_end(double left) const;

  /// Of those that it is flown by, the number under which the vehicle flies now.
  std::optional<functional::TaskId> flown = {};
  bool running = false;              ///< its executive knows that it flies
  std::optional<Airway> ahead = {};  ///< the next portion; has its air
  bool stopped = false;              ///< nothing is flown after this portion

 private:
  functional::Request next_;
  double speed_ = 0;
  std::vector<std::vector<world::Vector3>> parts_;
  std::size_t taken_ = 0;
};

}  // namespace skein::decision_node
