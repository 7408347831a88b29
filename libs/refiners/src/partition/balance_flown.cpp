// SPDX-License-Identifier: Apache-2.0
#include "partition/balance_flown.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace skein::refiners::partition {
namespace {

/// Sweeps flown in thought, for each member; and as long as all are that far apart.
constexpr std::size_t kFlights = 40, kFlightsIfWide = 160;
constexpr double kWideSpread = 0.03;
/// How often divisions are planned anew for them.
constexpr std::size_t kPlannings = 12;
/// Of the ways that are most like one that was found.
constexpr std::size_t kNearby = 3;
constexpr double kGolden = 0.6180339887498949;  // multiples lie in no rows

/// Parts are alike whose middles are so near to each other, in swaths, and whose areas differ by so
/// little of them.
constexpr double kNear = 0.1, kAlike = 0.01;

/// Of what is flown the last to end is not all: what is flown in the end differs a little again.
double cost_flown(double latest, double earliest) {
  return latest + 2 * std::max(0.0, latest - earliest - kFineSpread * latest);
}

double lanes_of(const Trial& trial, std::size_t member) {
  return static_cast<double>(trial.sweeps[member].task.lanes.size());
}

/// A part that was flown in thought.
struct FlownPart {
  world::Vector2 middle;
  double area = 0;   ///< [m²]
  double lanes = 0;  ///< that coverage has
  double more = 0;   ///< seconds that it took beyond those of coverage
};

/// How long a part takes jumps with its lanes, and where they would leave gaps one more is flown
/// than coverage has. So what coverage plans is flown, the most promising first; then, with shares
/// that suit what was flown, ways like those that were found.
class FlownBalancer {
 public:
  FlownBalancer(Planner& planner, Trial best, std::vector<Track> tracks, std::vector<Trial> planned)
      : planner_(planner),
        best_(std::move(best)),
        tracks_(std::move(tracks)),
        planned_(std::move(planned)),
        flown_(best_.sweeps.size()) {}

  Trial run() {
    Track found{best_.division, planner_.abilities()};
    planner_.learn_rates(best_, found.abilities);
    tracks_.insert(tracks_.begin(), std::move(found));
    if (!fly(best_, tracks_.front())) return best_;
    std::vector<Track> as_planned = tracks_;
    for (std::size_t round = 1; round <= kPlannings && wants_more(); ++round) {
      fly_promising();
      for (Track& track : as_planned) plan_nearby(track, round);
    }
    for (std::size_t round = 1; round <= kFlightsIfWide && wants_more(); ++round)
      for (Track& track : tracks_) fly_nearby(track, round);
    return best_;
  }

 private:
  bool wants_more() const {
    const std::size_t most = best_.spread > kWideSpread ? kFlightsIfWide : kFlights;
    return flights_ < most * flown_.size() && best_.spread > kFineSpread && planner_.flies();
  }

  /// Of all that was planned, as long as it may be better than the best if no gaps are left.
  void fly_promising() {
    const auto less = [&](const Trial& a, const Trial& b) { return hoped(a) < hoped(b); };
    while (wants_more() && !planned_.empty()) {
      const auto next = std::min_element(planned_.begin(), planned_.end(), less);
      if (hoped(*next) >= best_cost_) break;
      Trial trial = std::move(*next);
      *next = std::move(planned_.back());
      planned_.pop_back();
      fly(std::move(trial), tracks_.front());
    }
    planned_.clear();
  }

  /// What it costs to fly if parts take no more than those like them did, or where none is, lanes
  /// no more than they were once seen to.
  double hoped(const Trial& trial) const {
    double latest = 0, earliest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < trial.sweeps.size(); ++i) {
      const double end = trial.sweeps[i].cost + more_of(trial, i);
      latest = std::max(latest, end);
      earliest = std::min(earliest, end);
    }
    return cost_flown(latest, earliest);
  }

  FlownPart part_of(const Trial& trial, std::size_t member) const {
    const world::Polygon& part = trial.division.parts[member];
    return {middle_of(part), world::area(part), lanes_of(trial, member), 0};
  }

  double more_of(const Trial& trial, std::size_t member) const {
    const FlownPart part = part_of(trial, member);
    double nearest = kNear * planner_.query().members[member].swath;
    double least = std::numeric_limits<double>::infinity();
    std::optional<double> alike;
    for (const FlownPart& other : flown_[member]) {
      least = std::min(least, other.more / other.lanes);
      const double off = (other.middle - part.middle).norm();
      const bool is_like = other.lanes == part.lanes &&
                           std::abs(other.area - part.area) < kAlike * part.area && off < nearest;
      if (!is_like) continue;
      nearest = off;
      alike = other.more;
    }
    return alike.value_or(flown_[member].empty() ? 0 : least * part.lanes);
  }

  /// Ways like one that was found, the cuts turned a little otherwise each round.
  std::vector<Division> nearby(const Track& track, const std::vector<double>& areas,
                               std::size_t round, std::size_t most) const {
    const double between = std::fmod(0.5 + kGolden * static_cast<double>(round), 1);
    auto ways = planner_.divide(areas, kWays, between);
    std::stable_sort(ways.begin(), ways.end(), [&](const Division& a, const Division& b) {
      return unlikeness(a, track.last) < unlikeness(b, track.last);
    });
    if (ways.size() > most) ways.resize(most);
    return ways;
  }

  void plan_nearby(Track& track, std::size_t round) {
    const auto areas = fair_areas(track.abilities, planner_.whole());
    if (!areas) return;
    for (Division& division : nearby(track, *areas, round, kNearby)) {
      auto trial = planner_.plan(*areas, std::move(division));
      if (!trial || !planner_.has_energy(*trial)) continue;
      planner_.learn_rates(*trial, track.abilities);
      planned_.push_back(std::move(*trial));
    }
  }

  /// With the shares that suit what was flown of it.
  void fly_nearby(Track& track, std::size_t round) {
    const auto areas = wants_more() ? fair_areas(track.abilities, planner_.whole()) : std::nullopt;
    if (!areas) return;
    // Where those were in vain, others.
    const bool in_vain = flights_ >= kFlights * flown_.size();
    auto ways = nearby(track, *areas, round, in_vain ? kWays : kNearby);
    if (ways.empty()) return;
    auto trial = planner_.plan(*areas, std::move(ways[round % ways.size()]));
    if (trial && planner_.has_energy(*trial)) fly(std::move(*trial), track);
  }

  /// One sweep after the other, as long as it may be better than the best; then it is that. False:
  /// what is flown is not known.
  bool fly(Trial trial, Track& track) {
    double latest = 0, earliest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < trial.sweeps.size(); ++i) {
      ++flights_;
      const double planned = trial.sweeps[i].cost;
      if (!planner_.fly(trial, i)) return false;
      flown_[i].push_back(part_of(trial, i));
      flown_[i].back().more = trial.sweeps[i].cost - planned;
      learn(trial, i, track);
      latest = std::max(latest, trial.sweeps[i].cost);
      earliest = std::min(earliest, trial.sweeps[i].cost);
      if (best_.flown && cost_flown(latest, earliest) >= best_cost_) return true;
    }
    track.flown = true;
    judge(trial);
    trial.flown = true;
    best_cost_ = cost_flown(latest, earliest);
    best_ = std::move(trial);
    return true;
  }

  /// Half of what was known before counts on: a part may have taken a lane more than the next one.
  void learn(const Trial& trial, std::size_t member, Track& track) const {
    Ability& ability = track.abilities[member];
    const double before = ability.rate;
    planner_.learn_rate(trial, member, ability);
    if (track.flown) ability.rate = (before + ability.rate) / 2;
  }

  Planner& planner_;
  Trial best_;
  double best_cost_ = 0;  ///< once it is flown
  std::vector<Track> tracks_;
  std::vector<Trial> planned_;                 ///< not flown yet
  std::vector<std::vector<FlownPart>> flown_;  ///< by each member
  std::size_t flights_ = 0;                    ///< sweeps flown so far
};

}  // namespace

Trial balance_flown(Planner& planner, Trial best, std::vector<Track> tracks,
                    std::vector<Trial> planned) {
  return FlownBalancer(planner, std::move(best), std::move(tracks), std::move(planned)).run();
}

}  // namespace skein::refiners::partition
