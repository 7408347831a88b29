// SPDX-License-Identifier: Apache-2.0
// The portions of a sweep, which get their air one after the other.
#pragma once

#include <optional>
#include <vector>

#include "merging/airways.hpp"

namespace skein::decision_node {

/// The way of a sweep, cut at way-points. To the executive it is one task; to the vehicle each
/// portion is a flight of its own, from where the one before ends. A value. Source: spec 6.4
/// ("a portion of trajectory"); docs/decisions/0068-sweeps-in-portions.md.
class Portions {
 public:
  /// The portions of a flight that begins at `from`. Nothing where one flight is better: the sweep
  /// is short, or it comes back nearer than `width` [m] to air that it left, and would wait for
  /// that air again. Cost: O(way-points²).
  static std::optional<Portions> of(const functional::Request& flight,
                                    const elementary::GotoTask& task, const world::Vector3& from,
                                    double width);

  /// The task of the executive.
  functional::TaskId task() const { return whole_.id; }
  /// The flight of the next portion under the number of the task, past `by` where that is given.
  /// Precondition: a portion is left.
  functional::Request next(const std::optional<world::Vector3>& by = {}) const;
  /// The next portion is flown from now on.
  void take() { ++taken_; }
  bool is_last_taken() const { return taken_ == parts_.size(); }
  /// True: with `left` [m] of the current portion to fly, it is time to ask for the next one.
  bool is_near_end(double left) const;

  /// Notes that the sweep runs; true: for the first time, with this status of a portion.
  bool begins_to_run(const functional::Status& status);

  std::optional<functional::TaskId> flown = {};  ///< number of the portion that the vehicle flies
  bool running = false;                          ///< the executive was told that the task runs
  std::optional<Airway> ahead = {};              ///< the next portion, once its air is granted
  bool stopped = false;                          ///< the task ends with the current portion

 private:
  functional::Request whole_;
  double speed_ = 0;  ///< [m/s]
  std::vector<std::vector<world::Vector3>> parts_;
  std::size_t taken_ = 0;
};

}  // namespace skein::decision_node
