// SPDX-License-Identifier: Apache-2.0
#include "patrol/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "patrol/cycle.hpp"
#include "patrol/ring.hpp"
#include "patrol/walk_search.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Rules are tried over as many rounds over everything.
constexpr double kTrialRounds = 11;
/// Lengths of the laps tried, as parts of a round over everything.
constexpr std::array<double, 6> kLapParts = {0.7, 0.58, 0.5, 0.43, 0.36, 0.28};
constexpr std::array<double, 2> kPowers = {0.6, 0.85};
/// How many rules are flown over the whole time, of those that come near everything in turn.
constexpr std::size_t kFlownWhole = 4;
constexpr double kHopeless = 1.75;
/// Circles over a zone that is seen from one point: their radius, as parts of the footprint.
constexpr double kWidestRound = 0.25, kLeastRound = 0.01;
/// How often the cycles tried have everything before some of it is left out.
constexpr std::array<std::size_t, 2> kTimes = {2, 3};
/// How walks over a lattice are annealed one after the other until one meets the goals. Peaks of a
/// few places each need heat and patience; what is hot is to have less room, or it grows for ever.
struct Annealing {
  double warmth;               ///< the temperature at first, in parts of what the goals allow
  double cooled;               ///< the last one, in parts of the first
  std::uint64_t times;         ///< as many changes as one needs without
  double worst_part;           ///< of what the goal of the worst allows
  std::size_t visits_a_place;  ///< at most
  bool looks_elsewhere;        ///< at gaps that a change makes longer elsewhere
};
constexpr std::array<Annealing, 6> kAnnealings = {{{6e-4, 1.0 / 75, 1, 1, 4, false},
                                                   {2e-3, 1.0 / 75, 1, 1, 4, false},
                                                   {4e-3, 1.0 / 200, 4, 0.97, 3, false},
                                                   {4e-3, 1.0 / 200, 2, 1, 4, true},
                                                   {4e-3, 1.0 / 200, 8, 0.97, 3, true},
                                                   {4e-3, 1.0 / 200, 16, 0.97, 3, true}}};
/// What is found is looked no further for when the goals are met by so much: a lawn mower may do a
/// little better than everything in turn, which they are measured by.
constexpr double kSurelyMet = 0.99;
/// Cycles of which one part in so many is reserve: a visit counts from the middle of its piece.
constexpr double kWorstMargin = 0.95;
/// Rounds over no more blocks are searched for whatever the risk.
constexpr std::size_t kFewBlocks = 64;
/// Laps planned one by one take long over more blocks, and are made shorter from no more visits a
/// block than that.
constexpr std::size_t kMostForLaps = 400, kMostTimes = 5;
/// What the worst risk × idleness and the mean idleness are worth against each other, as parts of
/// what everything in turn gives: the worst can be brought down further.
constexpr double kWorstShare = 0.6, kMeanShare = 0.92;

/// About what it takes to visit a piece of a lane [ns].
constexpr std::uint32_t kVisit = 5000;
/// Parts of a patrol are told after as many visits, and then after twice as many each time.
constexpr std::size_t kFirstPart = 64;

/// Flies laps for a time.
class LapFlight {
 public:
  LapFlight(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task)
      : ground_(ground),
        task_(task),
        deadline_(sight.deadline()),
        log_(ground.field, sight, task.duration / 3),
        footprint_(sight.footprint()) {
    way_.push_back(task.start);
  }

  /// False when the countdown ended it before its time. `take`, if any, is told of parts.
  bool fly(const LapRule& rule, Countdown& countdown, const TakePatrol* take = nullptr) {
    LapPlanner planner(ground_, rule, deadline_);
    std::size_t visits = 0, next_part = kFirstPart;
    while (log_.now() < task_.duration) {
      // Everything in turn begins with what is nearest to the start.
      const double began = log_.now();
      std::vector<Visit> lap = planner.next(log_.last_seen(), log_.now());
      laps_.push_back(lap);
      if (way_.size() == 1) begin_near(lap);
      for (const Visit visit : lap) {
        if (!countdown.step() || deadline_.passed_after(kVisit)) return false;
        go_to(visit);
        if (take != nullptr && ++visits == next_part) {
          (*take)({way_, false});
          next_part *= 2;
        }
        if (log_.now() >= task_.duration) break;
      }
      if (log_.now() <= began && !pass_time(countdown)) return !is_over(countdown);
    }
    return true;
  }

  /// Flies a closed track again and again, from the nearest of its points that the start leads
  /// straight to. False: there is none, or the time was up before.
  bool fly_track(std::vector<Vector2> track, const PatrolSpace& space, Countdown& countdown) {
    const auto first = nearest_open(track, space);
    if (first == track.end()) return false;
    std::rotate(track.begin(), first, track.end());
    while (log_.now() < task_.duration)
      for (const Vector2& point : track) {
        if (!countdown.step() || deadline_.passed_after(kVisit)) return false;
        way_.push_back(point);
        take_note(way_.size() - 1);
        if (log_.now() >= task_.duration) break;
      }
    return true;
  }

  PatrolFigures figures() const { return log_.figures(); }
  std::vector<Vector2> take_way() { return std::move(way_); }

  /// The last laps, as few as visit everything; empty: all of them do not.
  std::vector<Visit> last_laps() const {
    std::vector<bool> visited(ground_.blocks.size(), false);
    std::size_t missing = visited.size();
    auto lap = laps_.rbegin();
    if (lap != laps_.rend()) ++lap;  // which may have been cut off
    for (; lap != laps_.rend() && missing > 0; ++lap)
      for (const Visit visit : *lap)
        if (!visited[visit / 2]) visited[visit / 2] = true, --missing;
    std::vector<Visit> all;
    if (missing > 0) return all;
    for (auto first = lap.base(); first + 1 != laps_.end(); ++first)
      all.insert(all.end(), first->begin(), first->end());
    return all;
  }

 private:
  void begin_near(std::vector<Visit>& lap) const {
    const auto nearest = std::min_element(lap.begin(), lap.end(), [&](Visit a, Visit b) {
      return cost_from_start(a) < cost_from_start(b);
    });
    if (cost_from_start(*nearest) < kInfinity)
      std::rotate(lap.begin(), nearest, lap.end());
    else
      lap.insert(lap.begin(), nearest_of_all());
  }

  std::vector<Vector2>::iterator nearest_open(std::vector<Vector2>& track,
                                              const PatrolSpace& space) const {
    auto nearest = track.end();
    for (auto point = track.begin(); point != track.end(); ++point)
      if ((nearest == track.end() ||
           (*point - task_.start).norm() < (*nearest - task_.start).norm()) &&
          space.is_open(task_.start, *point))
        nearest = point;
    return nearest;
  }

  double cost_from_start(Visit visit) const {
    return ground_.links.cost_from(task_.start, task_.heading, visit);
  }

  Visit nearest_of_all() const {
    Visit nearest = 0;
    for (Visit visit = 1; visit < 2 * ground_.blocks.size(); ++visit)
      if (cost_from_start(visit) < cost_from_start(nearest)) nearest = visit;
    return nearest;
  }

  void go_to(Visit visit) {
    const std::size_t from = way_.size();
    if (from == 1)
      ground_.links.append_way_from(task_.start, task_.heading, visit, way_);
    else
      ground_.links.append_way(last_, visit, way_);
    ground_.links.append_track(visit, way_);
    last_ = visit;
    take_note(from);
  }

  /// Of the way from that point on.
  void take_note(std::size_t from) {
    for (std::size_t i = from; i < way_.size(); ++i)
      log_.fly(way_[i - 1], way_[i], log_.now() + (way_[i] - way_[i - 1]).norm() / task_.speed);
  }

  /// Laps that take no time, over one point from which all is seen: circles beside it, to the end
  /// of the patrol. False: there is no room for any, or no more to plan.
  bool pass_time(Countdown& countdown) {
    const std::vector<Vector2> round =
        ground_.links.small_round(way_.back(), kWidestRound * footprint_, kLeastRound * footprint_);
    if (round.empty()) return false;
    while (log_.now() < task_.duration && countdown.step() && !deadline_.passed_after(kVisit)) {
      const std::size_t from = way_.size();
      way_.insert(way_.end(), round.begin() + 1, round.end());
      take_note(from);
    }
    return !is_over(countdown);
  }

  bool is_over(const Countdown& countdown) const { return countdown.over() || deadline_.is_over(); }

  LapGround ground_;
  const PatrolTask& task_;
  Deadline& deadline_;
  IdlenessLog log_;
  double footprint_;
  std::vector<Vector2> way_;
  std::vector<std::vector<Visit>> laps_;
  Visit last_ = 0;
};

/// The greater of two shares of what everything in turn gives; what leaves cells unseen is worst.
double badness(const PatrolFigures& figures, const PatrolFigures& in_turn) {
  if (figures.unseen > in_turn.unseen) return kInfinity;
  return std::max(figures.worst_risk_idleness / (kWorstShare * in_turn.worst_risk_idleness),
                  figures.mean_idleness / (kMeanShare * in_turn.mean_idleness));
}

/// The most promising rules by trials over the first part of the time, the best first.
std::vector<LapRule> promising_rules(const LapGround& ground, const PatrolSight& sight,
                                     PatrolTask task, Countdown& countdown) {
  const double round = round_length(ground.whole, ground.links);
  task.duration = std::min(task.duration, kTrialRounds * round / ground.speed);
  std::vector<LapRule> rules;
  LapFlight reference(ground, sight, task);
  if (!reference.fly({.length = kInfinity}, countdown)) return rules;
  std::vector<std::pair<double, std::size_t>> ranking;
  for (const double power : kPowers)
    for (const double part : kLapParts) {
      const LapRule rule{.length = part * round, .power = power};
      LapFlight flight(ground, sight, task);
      if (!flight.fly(rule, countdown)) return {};
      ranking.emplace_back(badness(flight.figures(), reference.figures()), rules.size());
      rules.push_back(rule);
    }
  std::sort(ranking.begin(), ranking.end());
  std::vector<LapRule> best;
  for (const auto& [bad, rule] : ranking)
    if (best.size() < kFlownWhole && bad < kHopeless) best.push_back(rules[rule]);
  return best;
}

/// Nowhere more risk than elsewhere, so that nothing is gained by seeing some cells more often than
/// others; of few blocks everything in turn may still be a clumsy round.
bool is_best_in_turn(const LapGround& ground) {
  const auto [least, most] =
      std::minmax_element(ground.field.risk.begin(), ground.field.risk.end());
  return *least == *most && ground.blocks.size() > kFewBlocks;
}

/// Flies one after the other and takes what is better than all before.
class PatrolTrials {
 public:
  PatrolTrials(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
               Countdown& countdown, const TakePatrol& take)
      : ground_(ground), sight_(sight), task_(task), countdown_(countdown), take_(take) {}

  void run() {
    LapFlight in_turn(ground_, sight_, task_);
    const bool complete = in_turn.fly({.length = kInfinity}, countdown_,
                                      sight_.deadline().is_set() ? &take_ : nullptr);
    in_turn_ = in_turn.figures();
    take_({in_turn.take_way(), complete});
    if (!complete || ground_.blocks.size() < 4) return;
    if (is_best_in_turn(ground_)) return;
    least_ = badness(in_turn_, in_turn_);
    for (const std::size_t times : kTimes)
      if (!fly_cycle(weighted_cycle(ground_, goal(1), times, time()))) return;
    if (least_ <= kSurelyMet || fly_walks()) return;
    if (ground_.blocks.size() <= kMostForLaps && !is_over()) fly_laps();
  }

 private:
  CycleTime time() const { return {countdown_, sight_.deadline()}; }
  bool is_over() const { return countdown_.over() || sight_.deadline().is_over(); }

  CycleGoal goal(double part) const {
    return {kMeanShare * in_turn_.mean_idleness,
            kWorstMargin * kWorstShare * part * in_turn_.worst_risk_idleness};
  }

  /// False: the time is up.
  bool fly_cycle(const std::vector<Visit>& cycle) {
    LapFlight flight({ground_.field, ground_.blocks, ground_.links, cycle, ground_.speed}, sight_,
                     task_);
    if (!flight.fly({.length = kInfinity}, countdown_)) return false;
    take_if_better(flight);
    return true;
  }

  void take_if_better(LapFlight& flight) {
    const double bad = badness(flight.figures(), in_turn_);
    if (bad >= least_) return;
    least_ = bad;
    take_({flight.take_way(), true});
  }

  /// Walks over a lattice, which turn wherever it is worth it, until one meets the goals. False:
  /// there is no such lattice.
  bool fly_walks() {
    if (ground_.walked == nullptr) return false;
    const auto graph = make_walk_graph(ground_.field, *ground_.walked, sight_);
    if (!graph) return false;
    const bool reachable = least_mean_of_walks(*graph) < goal(1).mean_idleness * ground_.speed;
    std::uint64_t seed = task_.seed;
    for (const Annealing& annealing : kAnnealings) {
      if (annealing.times > 1 && !reachable) return true;
      const Cooling cooling{.from = annealing.warmth,
                            .to = annealing.warmth * annealing.cooled,
                            .changes_a_place = annealing.times * Cooling{}.changes_a_place,
                            .visits_a_place = annealing.visits_a_place,
                            .looks_elsewhere = annealing.looks_elsewhere,
                            .seed = annealing.times > 1 ? ++seed : seed};
      const Walk walk =
          annealed_walk(*graph, goal(annealing.worst_part), ground_.speed, cooling, time());
      if (walk.empty()) return true;
      LapFlight flight(ground_, sight_, task_);
      if (!flight.fly_track(track_of(*graph, walk), *ground_.walked, countdown_)) return false;
      take_if_better(flight);
      if (least_ <= kSurelyMet) return true;
    }
    return true;
  }

  /// Laps planned one by one, and what their last ones can be made.
  void fly_laps() {
    for (const LapRule& rule : promising_rules(ground_, sight_, task_, countdown_)) {
      LapFlight flight(ground_, sight_, task_);
      if (!flight.fly(rule, countdown_)) return;
      const std::vector<Visit> last = flight.last_laps();
      take_if_better(flight);
      if (last.empty() || last.size() > kMostTimes * ground_.blocks.size()) continue;
      const CycleGoal wanted = goal(std::max(1.0, least_));
      if (!fly_cycle(improved_cycle(ground_, wanted, last, time()))) return;
    }
  }

  const LapGround& ground_;
  const PatrolSight& sight_;
  const PatrolTask& task_;
  Countdown& countdown_;
  const TakePatrol& take_;
  PatrolFigures in_turn_;
  double least_ = kInfinity;
};

}  // namespace

void fly_in_turn(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take) {
  LapFlight flight(ground, sight, task);
  const bool complete =
      flight.fly({.length = kInfinity}, countdown, sight.deadline().is_set() ? &take : nullptr);
  take({flight.take_way(), complete});
}

void plan_patrol(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take) {
  PatrolTrials(ground, sight, task, countdown, take).run();
}

}  // namespace skein::refiners
