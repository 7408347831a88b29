// SPDX-License-Identifier: Apache-2.0
#include "flyable/lengthened.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::refiners {
namespace {

constexpr double kWholeCircle = 2 * std::numbers::pi;  // [rad]
/// So near is the length that is asked for met [m], and so often halved at most.
constexpr double kNear = 0.05;
constexpr int kHalvings = 24;
/// Less than that is a chord too short to be steered [rad].
constexpr double kLeastTurn = 0.1;

Pose turned_round(const Pose& pose) { return {pose.at, pose.heading + std::numbers::pi}; }

void append(LevelWay& way, const LevelWay& more) {
  way.insert(way.end(), more.begin() + (way.empty() ? 0 : 1), more.end());
}

/// One pose to another by a place between them, with turns there.
class TurnedCurve {
 public:
  TurnedCurve(const Pose& from, const Pose& to, double radius, const AddedTurn& turn,
              double tolerance)
      : from_(from), to_(to), radius_(radius), turn_(turn), tolerance_(tolerance) {
    const auto curve = DubinsCurve::shortest(from, to, radius);
    place_ = curve.at(turn.place * curve.length());
    if (turn.place <= 0) return;
    const auto before = DubinsCurve::shortest(from, place_, radius);
    before_ = before.sampled(tolerance);
    length_before_ = before.sampled_length(tolerance);
  }

  LevelWay at_least(double least) const {
    const double missing = least - length(0);
    if (missing <= 0) return with(0, 0);
    const double round =
        DubinsCurve::circle(place_, radius_, turn_.left).sampled_length(tolerance_);
    const int whole = static_cast<int>(missing / round);
    double low = 0, high = kWholeCircle;
    for (int i = 0; i < kHalvings && length(high) + whole * round > least + kNear; ++i) {
      const double angle = (low + high) / 2;
      (length(angle) + whole * round >= least ? high : low) = angle;
    }
    return high < kWholeCircle ? with(whole, std::max(high, kLeastTurn)) : with(whole + 1, 0);
  }

 private:
  /// With a part of a circle, by its angle.
  double length(double angle) const {
    const auto part = DubinsCurve::arc(place_, radius_, turn_.left, angle);
    const auto after = DubinsCurve::shortest(part.at(part.length()), to_, radius_);
    return length_before_ + part.sampled_length(tolerance_) + after.sampled_length(tolerance_);
  }

  LevelWay with(int circles, double angle) const {
    LevelWay way = before_;
    const auto circle = DubinsCurve::circle(place_, radius_, turn_.left);
    for (int i = 0; i < circles; ++i) append(way, circle.sampled(tolerance_));
    const auto part = DubinsCurve::arc(place_, radius_, turn_.left, angle);
    if (angle > 0) append(way, part.sampled(tolerance_));
    append(way, DubinsCurve::shortest(part.at(part.length()), to_, radius_).sampled(tolerance_));
    return way;
  }

  Pose from_, to_;
  double radius_;
  AddedTurn turn_;
  double tolerance_;
  Pose place_;
  LevelWay before_;
  double length_before_ = 0;
};

}  // namespace

double length_of(const LevelWay& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

LevelWay without_doubles(const LevelWay& way, double same) {
  LevelWay kept = {way.front()};
  for (std::size_t i = 1; i + 1 < way.size(); ++i)
    if ((way[i] - kept.back()).norm() > same) kept.push_back(way[i]);
  while (kept.size() > 1 && (kept.back() - way.back()).norm() <= same) kept.pop_back();
  if (way.back() != kept.back()) kept.push_back(way.back());
  return kept;
}

LevelWay lengthened(const Pose& from, const Pose& to, double radius, const AddedTurn& turn,
                    double least, double tolerance) {
  if (!turn.at_the_end) return TurnedCurve(from, to, radius, turn, tolerance).at_least(least);
  const AddedTurn back{1 - turn.place, !turn.left, false};
  LevelWay way =
      TurnedCurve(turned_round(to), turned_round(from), radius, back, tolerance).at_least(least);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace skein::refiners
