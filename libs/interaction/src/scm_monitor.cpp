// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/scm_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/contract.hpp"

namespace skein::interaction {

namespace {

using Quantity = SpatialConstraint::Quantity;
constexpr double kTurn = 2 * std::numbers::pi;

double distance_between(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// By how much the relation holds; negative if it does not.
double slack_of(const SpatialConstraint& one, double value, double reference) {
  switch (one.relation) {
    case Relation::kLess:
    case Relation::kAtMost:
      return reference - value;
    case Relation::kGreater:
    case Relation::kAtLeast:
      return value - reference;
    case Relation::kEqual:
      break;
  }
  const bool azimuth = one.quantity == Quantity::kAzimuth;
  const double gap = azimuth ? std::remainder(value - reference, kTurn) : value - reference;
  return one.tolerance - std::abs(gap);
}

bool holds_by(Relation relation, double slack) {
  const bool strict = relation == Relation::kLess || relation == Relation::kGreater;
  return strict ? slack > 0 : slack >= 0;
}

}  // namespace

std::optional<double> azimuth_in(const Position& origin, const Position& toward,
                                 const Position& place) {
  const double zero_x = toward[0] - origin[0], zero_y = toward[1] - origin[1];
  const double x = place[0] - origin[0], y = place[1] - origin[1];
  if ((zero_x == 0 && zero_y == 0) || (x == 0 && y == 0)) return std::nullopt;
  const double angle = std::atan2(zero_x * y - zero_y * x, zero_x * x + zero_y * y);
  return angle < 0 ? angle + kTurn : angle;
}

std::optional<double> altitude_in(const Position& origin, const Position& place) {
  const double level = std::hypot(place[0] - origin[0], place[1] - origin[1]);
  const double up = place[2] - origin[2];
  if (level == 0 && up == 0) return std::nullopt;
  return std::atan2(up, level);
}

/// What one update finds.
struct ScmMonitor::Round {
  const Position& own;
  const Observer& observer;
  MissionTime now;
  Duration oldest;
  bool unknown = false;         ///< some place
  bool clear = true;            ///< all that is known holds by the margin
  std::optional<Slack> missed;  ///< by most

  std::optional<Position> position(const std::string& name) const {
    const std::optional<Sighting> seen = observer(name);
    if (!seen || now - seen->at > oldest) return std::nullopt;
    return seen->position;
  }
};

ScmMonitor::ScmMonitor(std::string id, Scm scm, ScmBinding binding, ScmLimits limits)
    : id_(std::move(id)), scm_(std::move(scm)), binding_(std::move(binding)), limits_(limits) {
  for (const Scm::Formal& formal : scm_.parameters) {
    SKEIN_EXPECTS(formal.place ? binding_.places.count(formal.name) > 0
                               : binding_.numbers.count(formal.name) > 0);
  }
}

const std::vector<std::string>& ScmMonitor::names_of(const std::string& place) const {
  return binding_.places.at(place);
}

std::optional<ScmFound> ScmMonitor::update(const Position& own, const Observer& observer,
                                           MissionTime now) {
  using Finding = ScmReport::Finding;
  Round round{own, observer, now, limits_.oldest, false, true, std::nullopt};
  for (std::size_t i = 0; i < scm_.constraints.size(); ++i) measure(i, round);
  Finding found = Finding::kSatisfied;
  if (round.missed) {
    found = Finding::kViolated;
  } else if (round.unknown) {
    found = Finding::kUndetermined;
  } else if (finding_ == Finding::kViolated && !round.clear) {
    found = Finding::kViolated;  // not by the margin yet
  }
  if (found == finding_) return std::nullopt;
  finding_ = found;
  ScmFound change{{id_, found}, std::nullopt};
  if (found == Finding::kViolated) change.why = round.missed->measured;
  return change;
}

// Once for each name of its first place; the other places stand for their first names.
void ScmMonitor::measure(std::size_t index, Round& round) const {
  const SpatialConstraint& one = scm_.constraints[index];
  std::vector<std::string> of;
  for (const std::string& place : one.of) {
    const auto& names = names_of(place);
    of.push_back(names.empty() ? "" : names.front());
  }
  for (const std::string& name : names_of(one.of.front())) {
    of.front() = name;
    measure_one(index, of, round);
  }
}

void ScmMonitor::measure_one(std::size_t index, const std::vector<std::string>& of,
                             Round& round) const {
  const SpatialConstraint& one = scm_.constraints[index];
  const auto value = value_of(one, of, round.own, round);
  const auto reference = reference_of(one, of, round);
  if (!value || !reference) {
    round.unknown = true;
    return;
  }
  Slack slack;
  slack.by = slack_of(one, *value, *reference);
  slack.holds = holds_by(one.relation, slack.by);
  slack.measured = {index, of.front(), one.relation, *value, *reference};
  const double margin = one.quantity == Quantity::kDistance ? limits_.distance : limits_.angle;
  // What is equal within a tolerance cannot hold by more than that.
  const double wanted = one.relation == Relation::kEqual ? std::min(margin, one.tolerance) : margin;
  round.clear = round.clear && slack.by >= wanted;
  if (slack.holds) return;
  if (!round.missed || slack.by < round.missed->by) round.missed = slack;
}

std::optional<double> ScmMonitor::value_of(const SpatialConstraint& one,
                                           const std::vector<std::string>& of, const Position& at,
                                           const Round& round) const {
  const auto first = round.position(of.front());
  if (!first) return std::nullopt;
  if (one.quantity == Quantity::kDistance) return distance_between(at, *first);
  if (one.quantity == Quantity::kAltitude) return altitude_in(*first, at);
  const auto toward = round.position(of[1]);
  if (!toward) return std::nullopt;
  return azimuth_in(*first, *toward, at);
}

std::optional<double> ScmMonitor::reference_of(const SpatialConstraint& one,
                                               const std::vector<std::string>& of,
                                               const Round& round) const {
  if (const auto* term = std::get_if<Term>(&one.than)) {
    if (const double* number = std::get_if<double>(term)) return *number;
    return binding_.numbers.at(std::get<std::string>(*term));
  }
  std::vector<Position> places;
  for (const std::string& place : std::get<std::vector<std::string>>(one.than)) {
    const auto& names = names_of(place);
    const auto seen = names.empty() ? std::nullopt : round.position(names.front());
    if (!seen) return std::nullopt;
    places.push_back(*seen);
  }
  if (one.quantity == Quantity::kDistance) return distance_between(places[0], places[1]);
  return value_of(one, of, places[0], round);
}

}  // namespace skein::interaction
