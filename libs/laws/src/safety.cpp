// SPDX-License-Identifier: Apache-2.0
// Closed air and energy, by where the vehicles really were and what they really had.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "by_hand.hpp"
#include "checks.hpp"
#include "energy_left.hpp"
#include "radio_limits.hpp"
#include "skein/world/segment.hpp"

namespace skein::laws {

namespace {

// How deep it is in a volume [m]; 0 or less outside. Level: the distance to the nearest edge.
double depth_in(const world::Volume& volume, const world::Vector3& at) {
  if (at.z() <= volume.floor || at.z() >= volume.ceiling) return 0;
  const world::Vector2 here = at.head<2>();
  if (!world::contains(volume.polygon, here)) return 0;
  double edge = kNever;
  for (std::size_t i = 0; i < volume.polygon.size(); ++i) {
    const world::Vector2& next = volume.polygon[(i + 1) % volume.polygon.size()];
    edge = std::min(edge, world::to_segment(here, volume.polygon[i], next));
  }
  return std::min({edge, at.z() - volume.floor, volume.ceiling - at.z()});
}

/// In how many seconds it is out of a volume that was closed around it, at the latest.
double time_to_leave(const Uav& uav, double depth) {
  constexpr double kReaction = 25;  // [s] to plan, to stop what it did, to turn
  const world::VehicleModel& model = uav.spec->model;
  const double turn = model.hovers ? 0 : 2 * 3.2 * model.orbit_radius / model.cruise_speed;
  return kReaction + turn + 2 * depth / (0.5 * model.cruise_speed);
}

struct Stay {
  double from = 0, until = 0, deepest = 0;
  bool stood = false;  ///< in there, before it set out, or at a degree that is not judged
};

/// For how much of that time a fault lets it begin no flight [s].
double kept_from_flying(const History& history, const Uav& uav, double from, double until) {
  double total = 0;
  for (const scenario::AbortSpec& fault : history.scenario->faults.aborts) {
    if (fault.uav != uav.name() || fault.type != "goto") continue;
    const double begin = std::max(from, fault.at.to_seconds());
    total += std::max(0.0, std::min(until, (fault.at + fault.lasts).to_seconds()) - begin);
  }
  return total;
}

/// In how many seconds one turns away from air that is closed across its way [s].
double time_to_turn_away(const scenario::Scenario& scenario) {
  constexpr double kTurns = 12;
  const bool asks = scenario.separation && scenario.separation->merge;
  return kTurns + (scenario.planning ? scenario.planning->takes_most.to_seconds() : 0) +
         (asks ? airtime_of_words_on_air(scenario.radio) : 0);
}

// One that cannot hover climbs in circles over its pad: once off the ground it has no other way.
bool climbed_then(const Uav& uav, double at, double closed) {
  return !uav.spec->model.hovers &&
         std::any_of(uav.activities.begin(), uav.activities.end(), [&](const Activity& one) {
           return one.type == "takeoff" && one.from <= closed && at <= one.until;
         });
}

constexpr std::string_view kMetTheGround = "the vehicle met the ground";  // the simulator's words

bool is_on_its_own(int degree) { return degree >= 4; }
// Degree 1 included: the decision node hears what its vehicle says at any degree.
bool is_in_a_hand(int degree) { return degree < 4; }

/// How much further than its plan knows the wind carries one that cannot hover in half a turn,
/// while a fault slows it and until it has turned [m].
double blown_further(const History& history, const Uav& uav, double at) {
  const world::VehicleModel& model = uav.spec->model;
  if (model.hovers) return 0;
  const double turn = std::numbers::pi * model.min_turn_radius / model.cruise_speed;  // [s] half
  double further = 0;
  for (const scenario::SlowSpec& fault : history.scenario->faults.slows) {
    const double from = fault.at.to_seconds();
    const double until = (fault.at + fault.lasts).to_seconds() + 2 * turn * fault.factor;
    if (fault.uav != uav.name() || at < from || at > until) continue;
    further = std::max(further, history.scenario->world.wind.speed * turn * (fault.factor - 1));
  }
  return further;
}

// Times in a volume, at a degree that is judged. Who waits beside one may be blown in by as much as
// it wavers.
std::vector<Stay> stays_in(const History& history, const Uav& uav, const Closing& closing,
                           bool (*is_judged)(int degree)) {
  const double wavers = 1 + world::tracking_spread(uav.spec->model);  // [m]
  std::vector<Stay> stays;
  bool inside = false, stood = false;
  for (const Sample& sample : uav.samples) {
    const bool may_be_there = !uav.is_out(sample) || !is_judged(uav.degree(sample.at));
    const bool was_standing =
        std::exchange(stood, may_be_there && depth_in(closing.volume, sample.position) > 0);
    const bool closed = sample.at >= closing.known && sample.at < closing.opened &&
                        sample.at < closing.volume.when.until.to_seconds();
    const double depth = closed && uav.is_out(sample) && is_judged(uav.degree(sample.at)) &&
                                 !out_of_control(uav, sample.at)
                             ? depth_in(closing.volume, sample.position)
                             : 0;
    if (depth < wavers + blown_further(history, uav, sample.at)) {
      inside = false;
      continue;
    }
    if (!inside) stays.push_back({sample.at, sample.at, 0, was_standing});
    inside = true;
    stays.back().until = sample.at;
    stays.back().deepest = std::max(stays.back().deepest, depth);
  }
  return stays;
}

}  // namespace

bool out_of_control(const Uav& uav, double at) {
  const bool broken =
      std::any_of(uav.activities.begin(), uav.activities.end(), [&](const auto& one) {
        return one.until <= at && (one.reason == "engine failure" ||
                                   one.reason == "energy used up" || one.reason == kMetTheGround);
      });
  return broken || uav.had_fault("engine", at);
}

std::vector<Violation> flown_into_the_ground(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    for (const Activity& one : uav.activities) {
      const bool planned =
          is_on_its_own(uav.degree(one.from)) && is_on_its_own(uav.degree(one.until));
      if (one.reason != kMetTheGround || !planned || uav.had_fault("engine", one.until)) continue;
      result.push_back({"", one.until, name, 0,
                        one.type + " " + std::to_string(one.task) + " led it into the ground"});
      break;
    }
  }
  return result;
}

std::vector<Violation> in_closed_air(const History& history) {
  const double no_choice = time_to_turn_away(*history.scenario);
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    for (const Closing& closing : uav.closings) {
      std::optional<double> leaves_since;
      for (const Stay& stay : stays_in(history, uav, closing, is_on_its_own)) {
        const auto kept = [&](double from, double until) {
          return kept_from_flying(history, uav, from, until);
        };
        // On its way out, in circles say, it may come through it again.
        const double to_leave = time_to_leave(uav, stay.deepest);
        const bool leaves =
            leaves_since && stay.from <= *leaves_since + to_leave + kept(*leaves_since, stay.from);
        const bool caught = stay.stood || leaves || climbed_then(uav, stay.from, closing.known) ||
                            stay.from <= closing.known + no_choice + kept(closing.known, stay.from);
        if (!leaves) leaves_since = stay.from;
        const double allowed = caught ? to_leave + kept(stay.from, stay.until) : 0;
        const bool short_enough = caught && stay.until - stay.from <= allowed;
        if (short_enough || was_left_by_hand(history, uav, stay.from)) continue;
        const std::string where =
            "'" + closing.volume.name + "', closed since " + figure(closing.known) + " s";
        result.push_back(
            {"", stay.from, name, 0,
             (caught ? "stays " + figure(stay.until - stay.from) + " s in " + where + ", " +
                           figure(allowed) + " s would do"
                     : (uav.spec->model.ground ? "drives " : "flies ") + figure(stay.deepest) +
                           " m into " + where + ", for " + figure(stay.until - stay.from) + " s")});
        break;  // on waiting circles it would come again and again
      }
    }
  }
  return result;
}

namespace {

// Once in a flight and for each volume is enough.
bool was_told_of(const Uav& uav, const world::Volume& volume, double by) {
  return std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& one) {
    return one.at <= by && one.text.find("(volume '" + volume.name + "')") != std::string::npos;
  });
}

}  // namespace

std::vector<Violation> closed_air_untold(const History& history) {
  constexpr double kSoon = 10;  // [s] from when it is in there until it says so
  std::vector<Violation> result;
  if (!history.scenario->planning) return result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    for (const Closing& closing : uav.closings) {
      for (const Stay& stay : stays_in(history, uav, closing, is_in_a_hand)) {
        if (stay.until - stay.from < kSoon || was_told_of(uav, closing.volume, stay.from + kSoon))
          continue;
        result.push_back({"", stay.from, name, 0,
                          "is " + figure(stay.until - stay.from) + " s in '" + closing.volume.name +
                              "', closed since " + figure(closing.known) +
                              " s, in an operator's hand, and says nothing"});
      }
    }
  }
  return result;
}

namespace {

// It was told to land while there was energy, and is told again and again, and does not do it.
bool refuses_to_land(const Uav& uav, double at) {
  constexpr double kTriedAgain = 90;  // [s]
  return std::any_of(uav.activities.begin(), uav.activities.end(), [at](const Activity& one) {
    return one.type == "land" && one.reason == "aborted by the functional layer" &&
           one.until < at && one.until >= at - kTriedAgain;
  });
}

}  // namespace

namespace {

// Below degree 4 somebody else has it in hand, who has to know. Without a planning domain nobody on
// board knows what it takes.
bool was_warned(const History& history, const Uav& uav, double at) {
  if (uav.degree(at) >= 4) return false;
  return !history.scenario->planning ||
         std::any_of(uav.words.begin(), uav.words.end(), [at](const Word& one) {
           return one.at <= at && one.text.find("no longer than to come home") != std::string::npos;
         });
}

}  // namespace

std::vector<Violation> energy_short(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    const double reserve = uav.spec->model.energy.reserve;
    bool told = false, excused = false, was_judged = false, could_land = true;
    double before = 1;
    for (const Sample& sample : uav.samples) {
      const bool judged =
          uav.is_out(sample) && uav.degree(sample.at) >= 4 && !out_of_control(uav, sample.at);
      const bool sudden = before - sample.energy > 0.01 || (judged && !was_judged);
      before = sample.energy;
      was_judged = judged;
      if (!uav.is_out(sample)) excused = false;
      if (!judged) continue;
      const bool above = sample.energy >= reserve;
      if (sudden && lacks_energy_to_land(history, uav, sample)) excused = true;
      if (above) could_land = !refuses_to_land(uav, sample.at);
      if (!above && !could_land) excused = true;
      if (told || excused || sample.energy >= reserve - 0.002) continue;
      told = true;
      result.push_back({"", sample.at, name, 0,
                        (sample.airborne ? "in the air with " : "drives with ") +
                            figure(100 * sample.energy) + " % of its energy, reserve " +
                            figure(100 * reserve) + " %"});
    }
    for (const Activity& one : uav.activities) {
      if (one.reason != "energy used up" || excused || was_warned(history, uav, one.until))
        continue;
      result.push_back(
          {"", one.until, name, uav.goal_of_task(one.task),
           (uav.spec->model.ground ? "stops" : "falls") + std::string(": energy used up")});
    }
  }
  return result;
}

}  // namespace skein::laws
