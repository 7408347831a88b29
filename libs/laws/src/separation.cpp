// SPDX-License-Identifier: Apache-2.0
// UAVs in the air keep apart, by where they really were.
#include "skein/world/separation.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"

namespace skein::laws {

namespace {

constexpr int kParts = 10;  // of the second between two samples

struct Encounter {
  double share = kNever, at = 0;
  world::Vector3 apart = world::Vector3::Zero();
};

// From when they are too near until they are apart again: the nearest of it.
class Watch {
 public:
  Watch(const Uav& first, const Uav& second, std::vector<Violation>& result)
      : first_(first),
        second_(second),
        both_(world::separation_share(first.spec->model) +
              world::separation_share(second.spec->model)),
        result_(result) {}

  void see(double at) {
    const auto one = first_.at(at), other = second_.at(at);
    const bool fly = one && other && one->airborne && other->airborne;
    if (!fly || out_of_control(first_, at) || out_of_control(second_, at)) return end();
    const double share = world::kept_share(both_, one->position, other->position);
    if (share >= 1) return end();
    if (share < nearest_.share) nearest_ = {share, at, one->position - other->position};
  }

  /// Too far to come too near within the second.
  bool far_at(double at) const {
    const auto one = first_.at(at), other = second_.at(at);
    if (!one || !other) return false;
    const double closing = 1.5 * (first_.spec->model.max_speed + second_.spec->model.max_speed);
    return (one->position - other->position).head<2>().norm() > both_.level + closing;
  }

  void end() {
    if (nearest_.share == kNever) return;
    result_.push_back({"", nearest_.at, first_.name(), 0,
                       figure(nearest_.apart.head<2>().norm()) + " m level and " +
                           figure(std::abs(nearest_.apart.z())) + " m in height from " +
                           second_.name() + ", which is to be " + figure(both_.level) + " or " +
                           figure(both_.height)});
    nearest_ = {};
  }

 private:
  const Uav& first_;
  const Uav& second_;
  world::Separation both_;
  std::vector<Violation>& result_;
  Encounter nearest_;
};

}  // namespace

std::vector<Violation> encounters(const History& history) {
  std::vector<Violation> result;
  for (auto a = history.uavs.begin(); a != history.uavs.end(); ++a) {
    for (auto b = std::next(a); b != history.uavs.end(); ++b) {
      Watch watch(a->second, b->second, result);
      for (const Sample& sample : a->second.samples) {
        watch.see(sample.at);
        if (watch.far_at(sample.at)) continue;
        for (int i = 1; i < kParts; ++i) watch.see(sample.at + static_cast<double>(i) / kParts);
      }
      watch.end();
    }
  }
  return result;
}

std::vector<Violation> too_near_in_the_air(const History& history) {
  return history.scenario->separation ? encounters(history) : std::vector<Violation>();
}

std::vector<Violation> too_near(const scenario::Scenario& scenario,
                                const std::vector<journal::Record>& records) {
  std::vector<Violation> all = encounters(history_of(scenario, records));
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.at < b.at; });
  return all;
}

}  // namespace skein::laws
