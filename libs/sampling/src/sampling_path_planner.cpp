// SPDX-License-Identifier: Apache-2.0
#include "skein/sampling/sampling_path_planner.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "free_air.hpp"
#include "path_query_checks.hpp"
#include "shortcuts.hpp"
#include "skein/refiners/flyable.hpp"
#include "tree_search.hpp"

namespace skein::sampling {
namespace {

using refiners::Budget;
using refiners::Countdown;
using refiners::FlyableQuery;
using refiners::Outcome;
using refiners::Path;
using refiners::PathQuery;
using refiners::Refined;
using refiners::Refusal;
using refiners::RefusalKind;
using refiners::Setting;
using refiners::Way;
using world::Vector3;

/// Of the chords of arcs [m].
constexpr double kTolerance = 0.5;
/// What is kept beside the body while searching, so that rounding never makes a way touch [m].
constexpr double kHair = 1e-3;
/// A vehicle that cannot hover may need more room than the shortest way has: after that many ways
/// that could not be made flyable, each with half a turn radius more around, it is refused.
constexpr int kMostWays = 4;

/// One query on its way to an answer.
class Search {
 public:
  Search(const PathQuery& query, const Setting& setting, const SamplingOptions& options,
         MissionTime until)
      : query_(query),
        setting_(setting),
        options_(options),
        air_(query, setting.world, until, setting.budget),
        random_(setting.seed, "sampling path planner") {}

  Outcome<Path> run() {
    if (!air_.is_whole()) return tl::unexpected(out_of_time("before the search"));
    if (auto refusal = air_.refusal_at(query_.from, "from")) return tl::unexpected(*refusal);
    if (auto refusal = air_.refusal_at(query_.to, "to")) return tl::unexpected(*refusal);
    std::optional<Refusal> last;
    for (int i = 0; i < (query_.vehicle.hovers ? 1 : kMostWays); ++i) {
      const double room = query_.vehicle.min_turn_radius * i / 2;
      const auto way = corners_with(room);
      if (!way) {
        if (!last) last = none_found();
        break;
      }
      const auto flown = flyable(*way);
      if (flown) return answer(*flown);
      last = is_late() ? out_of_time("making the way flyable") : flown.error();
    }
    return tl::unexpected(*last);
  }

 private:
  bool is_late() const { return setting_.budget.expired(); }

  static Refusal out_of_time(const std::string& when) {
    return {RefusalKind::kBudgetExhausted, "", "the time was up " + when};
  }

  /// Samples for a first way: as many as the budget has, if it has a bound.
  std::uint64_t first_samples() const {
    constexpr auto kUnbounded = std::numeric_limits<std::uint64_t>::max();
    const Budget& budget = setting_.budget;
    return budget.time_is_up || budget.steps != kUnbounded ? kUnbounded : options_.first_samples;
  }

  bool is_over() const { return cut_short_ || used_ >= setting_.budget.steps; }

  /// A share of the budget; what is used of it counts.
  template <class Find>
  std::optional<Way> within_budget(std::uint64_t samples, const Find& find) {
    if (is_over()) return std::nullopt;
    const Budget share{setting_.budget.time_is_up,
                       std::min(samples, setting_.budget.steps - used_)};
    Countdown countdown(share, 1);
    auto way = find(countdown);
    used_ += std::min(countdown.steps(), share.steps);
    cut_short_ = cut_short_ || countdown.cut_short();
    return way;
  }

  SearchSpace space_with(double room) const {
    SearchSpace space;
    space.low = air_.low();
    space.high = air_.high();
    space.from = query_.from;
    space.to = query_.to;
    space.any_point = [this](Random& random) { return air_.any_point(random); };
    space.is_free = [this, room](const Vector3& point) {
      return at_an_end(point) || air_.is_free(point, kHair + room);
    };
    space.is_free_between = [this, room](const Vector3& a, const Vector3& b) {
      return air_.is_free(a, b, at_an_end(a) || at_an_end(b) ? 0 : kHair + room);
    };
    return space;
  }
  bool at_an_end(const Vector3& point) const { return point == query_.from || point == query_.to; }

  /// The straight way, or the shortest that was found.
  std::optional<Way> corners_with(double room) {
    const SearchSpace space = space_with(room);
    if (room == 0 && space.is_free_between(query_.from, query_.to))
      return Way{query_.from, query_.to};
    const auto first = within_budget(first_samples(), [&](Countdown& countdown) {
      return first_way(space, random_, countdown);
    });
    if (!first) return std::nullopt;
    const auto over = [this] { return is_late(); };
    const auto is_free = [&](const Vector3& a, const Vector3& b) {
      return !is_late() && space.is_free_between(a, b);
    };
    Way best = shortened(*first, is_free, over, random_);
    const auto shorter = within_budget(options_.shortening_samples, [&](Countdown& countdown) {
      return shorter_way(space, refiners::length_of(best), random_, countdown);
    });
    if (!shorter) return best;
    Way other = shortened(*shorter, is_free, over, random_);
    return refiners::length_of(other) < refiners::length_of(best) ? other : best;
  }

  Result<Way, Refusal> flyable(const Way& corners) const {
    FlyableQuery query;
    query.corners = corners;
    query.heading_from = query_.heading_from;
    query.heading_to = query_.heading_to;
    query.speed = query_.speed;
    query.tolerance = kTolerance;
    const double off_chord = query_.vehicle.hovers ? 0 : kTolerance;
    query.is_free = [this, off_chord](const Vector3& a, const Vector3& b) {
      return air_.is_free(a, b, off_chord);
    };
    query.shortest = true;
    query.time_is_up = setting_.budget.time_is_up;
    return refiners::make_flyable(query, query_.vehicle);
  }

  Refusal none_found() const {
    return {RefusalKind::kBudgetExhausted, "",
            "no way was found with " + std::to_string(used_) + " samples" +
                (cut_short_ ? ", until the time was up" : "") +
                "; that does not prove that there is none"};
  }

  Outcome<Path> answer(const Way& way) const {
    const auto flight =
        refiners::estimate_flight(way, query_.vehicle, setting_.world.wind, query_.speed);
    if (flight.duration.expected == Duration::max())
      return refiners::refuse(RefusalKind::kBeyondVehicle, "",
                              "the wind is as fast as the vehicle");
    const double usable = 1 - query_.vehicle.energy.reserve;
    if (!(flight.energy <= usable))
      return refiners::refuse(RefusalKind::kBeyondVehicle, "to",
                              "the way takes more energy than the vehicle holds but its reserve");
    Refined<Path> refined;
    refined.task = {way, flight.length, 0, flight.energy};
    refined.cost = flight.length;
    refined.duration = flight.duration;
    refined.effort = {used_, cut_short_};
    return refined;
  }

  const PathQuery& query_;
  const Setting& setting_;
  const SamplingOptions& options_;
  FreeAir air_;
  Random random_;
  std::uint64_t used_ = 0;
  bool cut_short_ = false;
};

bool some_come_later(const std::vector<world::Volume>& volumes, MissionTime depart) {
  return std::any_of(volumes.begin(), volumes.end(),
                     [&](const world::Volume& volume) { return volume.when.from > depart; });
}

/// Until when volumes count at first: they all do, where none comes only after the departure.
MissionTime first_horizon(const PathQuery& query, const Setting& setting) {
  if (!some_come_later(setting.world.volumes, query.depart) &&
      !some_come_later(query.reserved, query.depart))
    return MissionTime::max();
  const auto straight = refiners::estimate_flight({query.from, query.to}, query.vehicle,
                                                  setting.world.wind, query.speed);
  return query.depart + straight.duration.most + straight.duration.most;
}

}  // namespace

/// A flight that takes longer than was reckoned with may meet volumes that come later: then anew,
/// with these.
Outcome<Path> SamplingPathPlanner::plan(const PathQuery& query, const Setting& setting) const {
  if (auto refusal = check_query(query, setting.world)) return tl::unexpected(*std::move(refusal));
  Setting rest = setting;
  MissionTime until = first_horizon(query, setting);
  for (int round = 0;; ++round) {
    auto outcome = Search(query, rest, options_, until).run();
    if (!outcome || until == MissionTime::max()) return outcome;
    const Duration most = outcome->duration.most;
    if (query.depart + most < until) return outcome;
    until = round == 0 ? query.depart + most + most : MissionTime::max();
    rest.budget.steps -= std::min(rest.budget.steps, outcome->effort.steps);
  }
}

}  // namespace skein::sampling
