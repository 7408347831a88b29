// SPDX-License-Identifier: Apache-2.0
// Which executive has a task of a UAV, and what requests say to one that does not know all tasks.
#pragma once

#include <string>
#include <vector>

#include "skein/ground_station/local_executives.hpp"
#include "skein/ground_station/monitoring.hpp"
#include "transfer_requests.hpp"

namespace skein::ground_station {

/// What the board and the executives at the ground tell together; they must outlive this. Not safe
/// to share between threads.
class TaskPlaces {
 public:
  TaskPlaces(const Monitoring& monitoring, const LocalExecutives& local)
      : monitoring_(monitoring), local_(local) {}

  /// Whether a request for the UAV's executive goes to the one at the ground: it has the task that
  /// the request is about or, if nobody has it, the UAV's degree is 1.
  bool is_at_ground(const SendRequest& request) const;
  /// The request for the executive at the ground or the one on board: a task that was over before a
  /// transfer is unknown to the executive that got the rest.
  Request adapted(const SendRequest& request, bool at_ground) const;
  /// What brings the tasks into an executive of the UAV that has none (requests_to_start()).
  std::vector<Request> starting(const std::string& uav, std::vector<mission::HeldTask> tasks,
                                FirstGiven first = FirstGiven::kUnderWay) const;

 private:
  const Monitoring& monitoring_;
  const LocalExecutives& local_;
};

}  // namespace skein::ground_station
