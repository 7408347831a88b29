// SPDX-License-Identifier: Apache-2.0
#include "patrol/laps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "patrol/ring.hpp"

namespace skein::refiners {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of a lap that goes to what ranks highest, whatever the distance.
constexpr double kTargets = 0.4;
/// Targets that are due may make a lap longer by as much.
constexpr double kStretch = 1.2;
/// What adds nearly no distance counts as adding that part of the mean way per block, lest
/// worthless blocks crowd out others.
constexpr double kLeastAdded = 0.5;
/// About what it takes to look at one block that is left out [ns].
constexpr std::uint32_t kLookedAt = 20;

}  // namespace

LapPlanner::LapPlanner(const LapGround& ground, const LapRule& rule, Deadline& deadline)
    : field_(ground.field),
      blocks_(ground.blocks),
      links_(ground.links),
      deadline_(deadline),
      speed_(ground.speed),
      rule_(rule),
      pitch_(round_length(ground.whole, ground.links) / static_cast<double>(ground.whole.size())),
      most_risk_(*std::max_element(field_.risk.begin(), field_.risk.end())),
      weight_(field_.risk.size()),
      value_(blocks_.size()),
      urgency_(blocks_.size()),
      risk_(blocks_.size()),
      idle_(blocks_.size()),
      lap_(ground.whole),
      next_(2 * blocks_.size(), kNowhere),
      places_(blocks_.size()) {
  std::transform(field_.risk.begin(), field_.risk.end(), weight_.begin(),
                 [&](double risk) { return std::pow(risk, rule.power); });
}

double LapPlanner::wait() const { return std::isfinite(rule_.length) ? rule_.length / speed_ : 0; }

void LapPlanner::rank(const std::vector<double>& last_seen, double now) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    value_[b] = risk_[b] = 0;
    idle_[b] = 0;
    for (const std::uint32_t cell : blocks_[b].cells) {
      const double idle = now - last_seen[cell], at_end = weight_[cell] * (idle + wait());
      value_[b] += at_end * at_end;
      if (field_.risk[cell] * (idle + wait()) <= risk_[b] * (idle_[b] + wait())) continue;
      risk_[b] = field_.risk[cell];
      idle_[b] = idle;
    }
    // Left out now, it is visited about half-way through the next lap.
    urgency_[b] = risk_[b] * (idle_[b] + 1.5 * wait());
  }
}

const std::vector<Visit>& LapPlanner::next(const std::vector<double>& last_seen, double now) {
  if (std::isinf(rule_.length)) return lap_;
  rank(last_seen, now);
  keep(targets());
  fill();
  lap_ = in_order();
  shorten(lap_, links_, deadline_);
  if (last_ != kNowhere)
    lap_ = begun_best(
        lap_, links_,
        {.after = last_, .speed = speed_, .risk = risk_, .idle = idle_, .most_risk = most_risk_});
  last_ = lap_.back();
  return lap_;
}

std::vector<std::size_t> LapPlanner::targets() const {
  std::vector<std::size_t> by_value(blocks_.size());
  std::iota(by_value.begin(), by_value.end(), 0);
  std::sort(by_value.begin(), by_value.end(), [&](std::size_t a, std::size_t b) {
    return value_[a] != value_[b] ? value_[a] > value_[b] : a < b;
  });
  const double room = std::max(1.0, kTargets * rule_.length / pitch_);
  const std::size_t count = std::min(by_value.size(), static_cast<std::size_t>(room));
  by_value.resize(count);
  std::vector<bool> is_target(blocks_.size(), false);
  for (const std::size_t block : by_value) is_target[block] = true;
  add_due(by_value, is_target);
  return by_value;
}

/// Adds the blocks whose risk × idleness would grow beyond that of the most risky block visited
/// once a lap, the worst first; at least the worst of all.
void LapPlanner::add_due(std::vector<std::size_t>& targets, std::vector<bool>& is_target) const {
  std::vector<std::size_t> due;
  std::size_t worst = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (urgency_[b] > urgency_[worst]) worst = b;
    if (!is_target[b] && urgency_[b] > most_risk_ * wait()) due.push_back(b);
  }
  std::sort(due.begin(), due.end(), [&](std::size_t a, std::size_t b) {
    return urgency_[a] != urgency_[b] ? urgency_[a] > urgency_[b] : a < b;
  });
  if (due.empty() && !is_target[worst]) due.push_back(worst);
  targets.insert(targets.end(), due.begin(), due.end());
}

/// Makes the ring of the targets: those of the lap before in its order, the others where they add
/// least.
void LapPlanner::keep(const std::vector<std::size_t>& targets) {
  std::vector<bool> is_target(blocks_.size(), false);
  for (const std::size_t block : targets) is_target[block] = true;
  std::erase_if(lap_, [&](Visit visit) { return !is_target[visit / 2]; });
  if (lap_.empty()) lap_ = {static_cast<Visit>(2 * targets.front())};
  std::fill(next_.begin(), next_.end(), kNowhere);
  for (std::size_t i = 0; i < lap_.size(); ++i)
    next_[lap_[i]] = lap_[i + 1 < lap_.size() ? i + 1 : 0];
  length_ = round_length(lap_, links_);
  for (const std::size_t block : targets) {
    if (is_in(block)) continue;
    if (length_ > kStretch * rule_.length) return;
    find_place(block);
    insert(block);
  }
}

void LapPlanner::fill() {
  std::vector<std::size_t> left_out;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (!is_in(b)) {
      find_place(b);
      left_out.push_back(b);
    }
  while (!left_out.empty() &&
         !deadline_.passed_after(kLookedAt * static_cast<std::uint32_t>(left_out.size()))) {
    const std::size_t best = best_of(left_out);
    if (best == left_out.size()) return;
    const std::size_t block = left_out[best];
    left_out[best] = left_out.back();
    left_out.pop_back();
    insert(block);
    update_places(left_out, places_[block]);
  }
}

/// Position in `left_out` of the block worth most for the distance it adds; its size: none fits.
std::size_t LapPlanner::best_of(const std::vector<std::size_t>& left_out) const {
  std::size_t best = left_out.size();
  double best_score = 0;
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    const std::size_t block = left_out[i];
    if (length_ + places_[block].added > rule_.length) continue;
    const double score = value_[block] / std::max(places_[block].added, kLeastAdded * pitch_);
    if (score > best_score ||
        (score == best_score && best < left_out.size() && block < left_out[best])) {
      best_score = score;
      best = i;
    }
  }
  return best;
}

void LapPlanner::update_places(const std::vector<std::size_t>& left_out, const Place& placed) {
  for (const std::size_t other : left_out) {
    if (places_[other].after == placed.after) {
      find_place(other);
      continue;
    }
    for (const Visit from : {placed.after, placed.as}) {
      const Place place = place_between(other, from, next_[from]);
      if (place.added < places_[other].added) places_[other] = place;
    }
  }
}

LapPlanner::Place LapPlanner::place_between(std::size_t block, Visit after, Visit before) const {
  const auto forwards = static_cast<Visit>(2 * block);
  const double gap = next_[after] == after ? 0 : links_.cost(after, before);
  const double there = links_.cost(after, forwards) + links_.cost(forwards, before);
  const double back = links_.cost(after, forwards + 1) + links_.cost(forwards + 1, before);
  const double length = links_.length(forwards) - gap;
  return there <= back ? Place{there + length, after, forwards}
                       : Place{back + length, after, forwards + 1};
}

void LapPlanner::find_place(std::size_t block) {
  Place best{kInfinity, kNowhere, kNowhere};
  Visit at = lap_.front();
  do {
    const Place place = place_between(block, at, next_[at]);
    if (place.added < best.added) best = place;
    at = next_[at];
  } while (at != lap_.front());
  places_[block] = best;
}

void LapPlanner::insert(std::size_t block) {
  const Place& place = places_[block];
  next_[place.as] = next_[place.after];
  next_[place.after] = place.as;
  length_ += place.added;
}

std::vector<Visit> LapPlanner::in_order() const {
  std::vector<Visit> lap;
  Visit at = lap_.front();
  do {
    lap.push_back(at);
    at = next_[at];
  } while (at != lap_.front());
  return lap;
}

}  // namespace skein::refiners
