// SPDX-License-Identifier: Apache-2.0
// A goal reported achieved was done: perceptions, ways, takeoffs and landings, waits.
#include <algorithm>
#include <cmath>
#include <set>

#include "checks.hpp"
#include "skein/mission/duration_range.hpp"
#include "skein/world/vehicle_model.hpp"
#include "statement.hpp"

namespace skein::laws {

namespace {

constexpr double kStep = 0.5;       ///< [s] how finely truth is looked at
constexpr double kNearby = 3;       ///< [m] a device aimed so near a place is aimed at it
constexpr double kAlarmMoves = 20;  ///< [m] where it is becomes clearer while it is looked at
constexpr double kHeard = 12;       ///< [s] in which a plan follows an object that moves
constexpr double kSightAbove = 1;   ///< [m] over the ground: what lies there is seen
constexpr double kApart = 100;      ///< [m] as far from their place in the air partners that hover
constexpr double kMoment = 3;       ///< [s] between what is done and its report

/// What a perception was to look at, for how long.
struct WantedLook {
  std::optional<world::Vector3> place;  ///< none: whatever is there
  double seconds = 0;
  double apart = 0;  ///< [m] beside a place in the air, so that partners do not meet there
  double moves = 0;  ///< [m] the place itself may have been thought to be so far off
  /// Of an object that is followed: it is wherever the UAV heard last that it was.
  const mission::Argument* followed = nullptr;
};

/// Where it may take an object to be then, if these are its relays: as was said until some time
/// before it was last in reach, or since.
std::vector<world::Vector3> places_heard(const History& history, const Uav& uav,
                                         const std::set<std::string>& relays,
                                         const mission::Argument& object, double at) {
  const double heard = history.joint.last_reached("ground", uav.name(), relays, at);
  std::vector<world::Vector3> places;
  if (const auto before = history.place(object, heard - kHeard)) places.push_back(*before);
  for (const ObjectTold& one : history.objects_told)
    if (mission::Argument(one.name) == object && heard - kHeard < one.told && one.told <= heard)
      places.push_back(one.position);
  return places;
}

/// Where it may take an object to be then, or a place that it was told of. A relay that died may
/// have passed words on, or not.
std::vector<world::Vector3> places_heard(const History& history, const Uav& uav,
                                         const mission::Argument& object, double at) {
  if (history.was_told_of(uav, object)) return history.places(uav, object, at - kHeard, at);
  const auto& named = history.scenario->radio.relays;
  const std::set<std::string> all(named.begin(), named.end());
  std::set<std::string> living = all;
  std::erase_if(living, [&](const std::string& one) { return history.dead.contains(one); });
  std::vector<world::Vector3> places = places_heard(history, uav, all, object, at);
  if (living.size() == all.size()) return places;
  const auto more = places_heard(history, uav, living, object, at);
  places.insert(places.end(), more.begin(), more.end());
  return places;
}

bool circles(const Uav& uav) { return !uav.spec->model.hovers; }

// In place for a place in the air; who keeps to the ground is below it.
bool is_there(const History& history, const Uav& uav, const Sample& sample,
              const world::Vector3& place, double apart) {
  const double near = wander(history, uav) + apart;
  const world::Vector3 off = sample.position - place;
  const bool high = uav.spec->model.ground || std::abs(off.z()) <= near;
  return high && off.head<2>().norm() <= near;
}

// For a place on the ground: within range, in the field of the device, nothing between.
bool is_seen(const History& history, const Uav& uav, const Activity& look, const Sample& sample,
             const world::Vector3& place, double moves) {
  const world::SensorModel* sensor = world::find_sensor(uav.spec->model, look.device);
  if (sensor == nullptr) return false;
  const double ground = history.terrain.elevation(place.x(), place.y());
  const world::Vector3 seen(place.x(), place.y(), std::max(place.z(), ground) + kSightAbove);
  const world::Vector3 eye = world::eye_of(uav.spec->model, sample.position);
  const world::Vector3 line = seen - eye;
  const auto in_field = [&](const world::Vector3& axis, double off) {
    const double angle = std::acos(std::clamp(axis.dot(line.normalized()), -1.0, 1.0));
    return angle <= sensor->aperture + std::asin(std::min(1.0, off / line.norm()));
  };
  if (line.norm() > sensor->range + wander(history, uav) + moves) return false;
  if (!history.terrain.line_of_sight(eye, seen, -kSightAbove)) return false;
  if (sensor->gimballed && look.target) {
    const double off = (look.target->head<2>() - place.head<2>()).norm();
    return off <= kNearby || (off <= kNearby + moves &&
                              in_field((*look.target - eye).normalized(), wander(history, uav)));
  }
  return in_field(world::direction_of(sample.heading, sensor->boresight_pitch),
                  wander(history, uav) + moves);
}

bool moves_at(const Uav& uav, double at) {
  return std::any_of(uav.activities.begin(), uav.activities.end(), [&](const Activity& one) {
    return one.moves() && one.from <= at && at < one.until;
  });
}

double seconds_looked(const History& history, const Uav& uav, const Goal& goal,
                      const WantedLook& wanted) {
  double seconds = 0;
  for (const Activity* look : uav.activities_of(goal.id)) {
    if (!look->looks()) continue;
    for (double t = look->from; t < std::min(look->until, history.end); t += kStep) {
      const auto sample = uav.at(t);
      if (!sample || moves_at(uav, t)) continue;
      const auto serves = [&](const world::Vector3& place) {
        return history.in_the_air(place)
                   ? is_there(history, uav, *sample, place, wanted.apart)
                   : is_seen(history, uav, *look, *sample, place, wanted.moves);
      };
      bool right = !wanted.place || (wanted.followed == nullptr && serves(*wanted.place));
      if (wanted.followed != nullptr) {
        const auto places = places_heard(history, uav, *wanted.followed, t);
        right = std::any_of(places.begin(), places.end(), serves);
      }
      if (right) seconds += std::min(kStep, look->until - t);
    }
  }
  return seconds;
}

// How far from their place in the air partners may be: beside the circles of one that cannot
// hover.
double apart_from(const History& history, const mission::HighLevelTask& meeting) {
  double circle = 0;
  for (const std::size_t list : {1U, 2U}) {
    for (const std::string& name : names_of(meeting.arguments[list])) {
      const auto partner = history.uavs.find(name);
      if (partner != history.uavs.end() && circles(partner->second))
        circle = std::max(circle, 2 * partner->second.spec->model.orbit_radius);
    }
  }
  return kApart + circle;
}

// The look that a perception of this name comes down to; nothing for other tasks.
std::optional<WantedLook> look_of(const History& history, const Uav& uav,
                                  const mission::HighLevelTask& task, double at) {
  const auto look = [&](std::size_t place, std::size_t seconds) -> std::optional<WantedLook> {
    if (task.arguments.size() <= std::max(place, seconds)) return std::nullopt;
    const mission::Argument& named = task.arguments[place];
    const auto where = history.places(uav, named, at, at);
    const auto long_for = number_of(task.arguments[seconds]);
    if (where.empty() || !long_for) return std::nullopt;
    const bool followed = history.is_followed(named) || history.was_told_of(uav, named);
    const bool moves = followed || history.is_alarm(named);
    return WantedLook{where.back(), *long_for, 0, moves ? kAlarmMoves : 0,
                      followed ? &named : nullptr};
  };
  if (task.name == "perceive" || task.name == "general-combined-goto-and-takeshot" ||
      task.name == "perform-monitoring") {
    return look(0, 1);
  }
  if (task.name == "general-combined-goto-and-synchro-and-takeshot") {
    auto together = look(3, 4);
    if (together) together->apart = apart_from(history, task);
    return together;
  }
  if (task.name == "takeshot-while-waiting" && !task.arguments.empty()) {
    return WantedLook{std::nullopt, number_of(task.arguments[0]).value_or(0), 0, 0, nullptr};
  }
  return std::nullopt;
}

}  // namespace

std::string figure(double number) {
  std::string text = std::to_string(std::round(number * 10) / 10);
  return text.substr(0, text.find('.') + 2);
}

double wander(const History& history, const Uav& uav) {
  const world::VehicleModel& model = uav.spec->model;
  const world::Wind& wind = history.scenario->world.wind;
  const double drift = model.wind_drift * (wind.speed + 2 * wind.gusts);
  const double tracking = 2 * (3 * world::tracking_spread(model) + drift + 1);
  return circles(uav) ? tracking + 2 * model.orbit_radius : tracking;
}

void for_achieved(const History& history,
                  const std::function<void(const Uav&, const Goal&, double)>& check) {
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    for (const auto& [id, goal] : uav.goals) {
      if (const auto at = goal.when("achieved")) check(uav, goal, *at);
    }
  }
}

std::vector<Violation> perceptions_not_done(const History& history) {
  constexpr double kPart = 0.95;
  constexpr double kSlack = 3;  // [s]
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const auto wanted = look_of(history, uav, goal.task, at);
    if (!wanted) return;
    const double seconds = seconds_looked(history, uav, goal, *wanted);
    if (seconds >= kPart * wanted->seconds - kSlack) return;
    result.push_back({"", at, uav.name(), goal.id,
                      mission::to_text(goal.task) +
                          " is achieved: it looked from the right place for " + figure(seconds) +
                          " of " + figure(wanted->seconds) + " s"});
  });
  return result;
}

namespace {

// How long it was asked to look at the most, of what counts seconds; nothing of other tasks.
std::optional<double> seconds_asked(const mission::HighLevelTask& task) {
  const std::size_t at = task.name == "perform-detection" ? 2 : 1;
  const bool counts = task.name == "perceive" || task.name == "perform-detection" ||
                      task.name == "general-combined-goto-and-takeshot";
  if (!counts || task.arguments.size() <= at) return std::nullopt;
  if (const auto range = mission::duration_range_of(task.arguments[at])) return range->most;
  return number_of(task.arguments[at]);
}

}  // namespace

std::vector<Violation> done_twice(const History& history) {
  constexpr double kPart = 1.25;
  constexpr double kOfAPiece = 30;  // [s] a pattern is not cut to the second
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const auto asked = seconds_asked(goal.task);
    if (!asked || !uav.deliberates(goal.received(), at)) return;
    // A functional layer that has lost its memory is asked for the whole look again.
    const std::string& layer = uav.spec->functional;
    if (history.was_killed(layer.empty() ? "sim" : layer)) return;
    // A pattern is flown to its end, however slowly.
    if (goal.task.name == "perform-detection" && uav.had_fault("slow", at)) return;
    double seconds = 0, waited = 0;
    int pieces = 0;
    for (const Activity* look : uav.activities_of(goal.id)) {
      if (!look->looks() || look->until <= look->from) continue;
      const double until = std::min(look->until, at);
      seconds += until - look->from;
      waited += seconds_waited_for_air(history, uav.name(), look->from, until);
      ++pieces;
    }
    // Between two portions of a pattern the device stays on.
    const double most = kPart * *asked + pieces * kOfAPiece + waited;
    if (pieces < 2 || seconds <= most) return;
    // The device is on while a patrol comes to its zone; nothing is done again there.
    seconds = seconds_detected(history, uav, goal).value_or(seconds);
    if (seconds <= most) return;
    result.push_back({"", at, uav.name(), goal.id,
                      mission::to_text(goal.task) + " is achieved: it looked for " +
                          figure(seconds) + " of " + figure(*asked) + " s in " +
                          std::to_string(pieces) + " pieces: what was done was done again"});
  });
  return result;
}

namespace {

// The least distance from a place in a time; a place on the ground is flown over.
double least_distance(const History& history, const Uav& uav, const world::Vector3& place,
                      double from, double until) {
  double least = kNever;
  for (double t = from; t <= until; t += kStep) {
    const auto sample = uav.at(t);
    const bool drives = uav.spec->model.ground.has_value();
    if (!sample || (!sample->airborne && !drives)) continue;
    const world::Vector3 off = sample->position - place;
    least =
        std::min(least, history.in_the_air(place) && !drives ? off.norm() : off.head<2>().norm());
  }
  return least;
}

double begin_of(const Goal& goal) { return goal.received(); }

std::vector<mission::Argument> places_of(const mission::HighLevelTask& task) {
  std::vector<mission::Argument> places;
  if (task.arguments.empty()) return places;
  if (task.name == "general-gotoxyz") places.push_back(task.arguments[0]);
  if (task.name == "perform-tour") {
    for (const std::string& name : names_of(task.arguments[0])) places.emplace_back(name);
  }
  return places;
}

// What keeps to the ground lands nowhere: it comes home.
std::optional<std::string> not_at_home(const History& history, const Uav& uav, double at) {
  const auto sample = uav.at(std::min(at, history.end));
  if (!sample) return std::nullopt;
  const double off = (sample->position.head<2>() - uav.spec->start).norm();
  if (off <= 1.8 * wander(history, uav)) return std::nullopt;
  return "it is " + figure(off) + " m from home";
}

std::optional<std::string> not_as_said(const History& history, const Uav& uav, const Goal& goal,
                                       double at) {
  const bool takeoff = goal.task.name == "general-takeoff";
  if (!takeoff && goal.task.name != "general-land") return std::nullopt;
  if (uav.spec->model.ground) return not_at_home(history, uav, at);
  for (double t = at - kMoment; t <= at + kMoment; t += kStep) {
    const auto sample = uav.at(std::min(t, history.end));
    if (!sample || sample->airborne == takeoff) return std::nullopt;
  }
  // It may fly on at once, before the next sample: the simulator's word for the task counts, of
  // whichever goal it was (a second landing has no task of its own).
  for (const Activity& one : uav.activities) {
    const bool did = one.type == (takeoff ? "takeoff" : "land") && one.end == "ended";
    if (did && std::abs(one.until - at) <= kMoment) return std::nullopt;
  }
  return takeoff ? "it stands on the ground" : "it is in the air";
}

}  // namespace

std::vector<Violation> places_not_reached(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const std::string what = mission::to_text(goal.task) + " is achieved: ";
    const auto breach = [&](const std::string& seen) {
      result.push_back({"", at, uav.name(), goal.id, what + seen});
    };
    if (const auto why = not_as_said(history, uav, goal, at)) breach(*why);
    const bool tour = goal.task.name == "perform-tour" || !uav.deliberates(begin_of(goal), at);
    const double from = tour ? begin_of(goal) : std::max(begin_of(goal), at - kMoment);
    for (const mission::Argument& named : places_of(goal.task)) {
      const auto places = history.places(uav, named, tour ? from : at - kHeard, at);
      const auto nearest = [&](const world::Vector3& place) {
        return least_distance(history, uav, place, from, std::min(at + kMoment, history.end));
      };
      const bool reached = std::ranges::any_of(places, [&](const world::Vector3& place) {
        return nearest(place) <= 1.8 * wander(history, uav);
      });
      if (reached || places.empty()) continue;
      const world::Vector3& place = places.front();
      const double least = nearest(place);
      breach(least == kNever
                 ? "it never flew there"
                 : "it came no nearer than " + figure(least) + " m to (" + figure(place.x()) + " " +
                       figure(place.y()) + " " + figure(place.z()) + ")");
    }
  });
  return result;
}

std::vector<Violation> waits_not_done(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    if (goal.task.name != "general-wait" || goal.task.arguments.empty()) return;
    const double wanted = number_of(goal.task.arguments[0]).value_or(0);
    double waited = 0;
    for (const Activity* one : uav.activities_of(goal.id)) {
      if (one->type == "wait") waited += std::min(one->until, history.end) - one->from;
    }
    if (waited >= wanted - kMoment) return;
    result.push_back(
        {"", at, uav.name(), goal.id,
         "general-wait is achieved: it waited " + figure(waited) + " of " + figure(wanted) + " s"});
  });
  return result;
}

}  // namespace skein::laws
