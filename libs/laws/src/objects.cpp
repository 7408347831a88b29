// SPDX-License-Identifier: Apache-2.0
// Objects are where it is said that they were, and fires only grow.
#include <algorithm>

#include "checks.hpp"

namespace skein::laws {

double ObjectState::distance_to(const world::Vector2& point) const {
  if (front) return front->distance_to(point);
  return std::max(0.0, (point - position).norm() - radius);
}

namespace {

/// Of what is said of an object: false detections near it drag it away, by less than this
/// [standard deviations].
constexpr double kDragged = 6;
/// Truth is told once a second [m].
constexpr double kMeanwhile = 5;
constexpr double kRoundedTo = 0.001;  // of instants [s]

/// As it was told last until then; null: it was not.
const ObjectState* state_at(const std::vector<ObjectState>& states, double at) {
  const auto later = std::upper_bound(states.begin(), states.end(), at + kRoundedTo,
                                      [](double t, const auto& one) { return t < one.at; });
  return later == states.begin() ? nullptr : &*std::prev(later);
}

}  // namespace

// Of whatever kind: sensors take one for another.
std::vector<Violation> objects_elsewhere(const History& history) {
  std::vector<Violation> result;
  for (const ObjectTold& told : history.objects_told) {
    double nearest = kNever;
    for (const auto& [name, states] : history.objects) {
      const ObjectState* state = state_at(states, told.seen);
      if (state == nullptr || !state->active) continue;
      nearest = std::min(nearest, state->distance_to(told.position.head<2>()));
    }
    if (nearest <= kDragged * told.spread + kMeanwhile) continue;
    const std::string what =
        "'" + told.name + "' is said to have been seen at " + figure(told.seen) + " s ";
    result.push_back({"", told.told, "", 0,
                      nearest == kNever
                          ? what + "when there was nothing anywhere"
                          : what + "where nothing was within " + figure(nearest) + " m"});
  }
  return result;
}

std::vector<Violation> fires_that_shrink(const History& history) {
  constexpr double kRounding = 0.01;  // of the log [m]
  std::vector<Violation> result;
  for (const auto& [name, states] : history.objects) {
    for (std::size_t i = 1; i < states.size(); ++i) {
      const auto &before = states[i - 1], &now = states[i];
      if (!before.front || !now.front || !before.active || !now.active) continue;
      const auto points = before.front->outline(16);
      const bool left = std::any_of(points.begin(), points.end(), [&](const auto& point) {
        return now.front->distance_to(point) > kRounding;
      });
      if (left)
        result.push_back(
            {"", now.at, "", 0,
             "fire '" + name + "' no longer covers where it was at " + figure(before.at) + " s"});
    }
  }
  return result;
}

}  // namespace skein::laws
