// SPDX-License-Identifier: Apache-2.0
// Shares adjusted until all finish together.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "partition/balance_flown.hpp"
#include "partition/track.hpp"

namespace skein::refiners::partition {
namespace {

/// The most promising of them, which are balanced.
constexpr std::size_t kFollowed = 6;
/// Divisions tried for each: more do not help, lanes come one at a time.
constexpr std::size_t kRounds = 12;
/// What the last to end gives away at once, as a fraction of its area, and the ways tried then.
constexpr std::array<double, 5> kSteps = {0.1, 0.05, 0.03, 0.015, 0.007};
constexpr std::size_t kPolished = 24;
/// Less is better: the end first, but no great spread for a small gain.
double cost_of(const Trial& trial) {
  return trial.latest * (1 + 0.3 * std::max(0.0, trial.spread - 0.04));
}

/// Precondition: there are some.
Division& nearest(std::vector<Division>& ways, const Division& to) {
  return *std::min_element(ways.begin(), ways.end(), [&](const Division& a, const Division& b) {
    return unlikeness(a, to) < unlikeness(b, to);
  });
}

/// When all would end if they went on as they did, with the shares that suit that.
double promise(const std::vector<Ability>& abilities, double whole) {
  const auto areas = fair_areas(abilities, whole);
  if (!areas) return std::numeric_limits<double>::infinity();
  double latest = 0;
  for (std::size_t i = 0; i < areas->size(); ++i)
    latest = std::max(latest, abilities[i].ready + (*areas)[i] / abilities[i].rate);
  return latest;
}

class Balancer {
 public:
  explicit Balancer(Planner& planner) : planner_(planner), limits_(planner.abilities()) {}

  std::optional<Trial> run(std::optional<Refusal>& refusal) {
    auto tracks = begin(refusal);
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const Track& a, const Track& b) { return a.promise < b.promise; });
    if (tracks.size() > kFollowed) tracks.resize(kFollowed);
    for (Track& track : tracks) follow(track);
    if (best_) polish();
    if (!best_ || !planner_.flies()) return best_;
    return balance_flown(planner_, std::move(*best_), std::move(tracks), std::move(planned_));
  }

 private:
  std::vector<Track> begin(std::optional<Refusal>& refusal) {
    std::vector<Track> tracks;
    const auto areas = fair_areas(limits_, planner_.whole());
    if (!areas) return tracks;
    const auto plain = planner_.plan(*areas);
    if (plain && planner_.has_energy(*plain)) {
      best_ = *plain;
      latest_allowed_ = plain->latest;
    }
    for (Division& division : planner_.divide(*areas, kWays)) {
      if (planner_.finished()) break;
      auto trial = planner_.plan(*areas, std::move(division));
      if (trial) {
        Track track{trial->division, limits_};
        take(*trial, track.abilities);
        track.promise = promise(track.abilities, planner_.whole());
        tracks.push_back(std::move(track));
      } else if (!refusal) {
        refusal = trial.error();
      }
    }
    return tracks;
  }

  void follow(Track& track) {
    for (std::size_t round = 0; round < kRounds && !planner_.finished(); ++round) {
      const auto areas = fair_areas(track.abilities, planner_.whole());
      if (!areas) return;
      auto ways = planner_.divide(*areas, kWays);
      if (ways.empty()) return;
      const auto trial = planner_.plan(*areas, std::move(nearest(ways, track.last)));
      if (!trial) return;
      track.last = trial->division;
      take(*trial, track.abilities);
      if (trial->spread <= kFineSpread) return;
    }
  }

  /// Lanes come one at a time, so what was learnt overshoots: the last to end gives some area away,
  /// less and less, as long as that helps.
  void polish() {
    for (const double step : kSteps) {
      for (std::size_t again = 0; again < kRounds && !planner_.finished(); ++again) {
        const Trial before = *best_;
        if (before.spread <= kFineSpread) return;
        std::vector<double> areas = before.areas;
        const auto last =
            std::max_element(before.sweeps.begin(), before.sweeps.end(),
                             [](const auto& a, const auto& b) { return a.cost < b.cost; });
        const auto giver = static_cast<std::size_t>(last - before.sweeps.begin());
        const double given = step * areas[giver], rest = planner_.whole() - areas[giver];
        for (std::size_t i = 0; i < areas.size(); ++i)
          areas[i] += i == giver ? -given : given * areas[i] / rest;
        if (!try_all(areas)) break;
      }
    }
  }

  /// True when one of the ways to divide is better than the best so far.
  bool try_all(const std::vector<double>& areas) {
    bool better = false;
    for (Division& division : planner_.divide(areas, kPolished)) {
      if (planner_.finished()) break;
      const auto trial = planner_.plan(areas, std::move(division));
      if (trial) keep(*trial);
      if (!trial || !is_better(*trial)) continue;
      best_ = *trial;
      better = true;
    }
    return better;
  }

  void take(const Trial& trial, std::vector<Ability>& abilities) {
    planner_.learn_rates(trial, abilities);
    planner_.learn_limits(trial, abilities);
    if (is_better(trial)) best_ = trial;
    keep(trial);
  }

  void keep(const Trial& trial) {
    if (planner_.flies() && planner_.has_energy(trial)) planned_.push_back(trial);
  }

  /// Balance must not make the end later than proportion does.
  bool is_better(const Trial& trial) const {
    return planner_.has_energy(trial) && trial.latest <= latest_allowed_ &&
           (!best_ || cost_of(trial) < cost_of(*best_));
  }

  Planner& planner_;
  std::vector<Ability> limits_;
  double latest_allowed_ = std::numeric_limits<double>::infinity();
  std::size_t flights_ = 0;  ///< that may still be flown
  double best_cost_ = 0;     ///< of the best that was flown
  std::optional<Trial> best_;
  std::vector<Trial> planned_;  ///< all that has energy, where it will be flown in thought
};

}  // namespace

std::optional<Trial> balance(Planner& planner, std::optional<Refusal>& refusal) {
  return Balancer(planner).run(refusal);
}

}  // namespace skein::refiners::partition
