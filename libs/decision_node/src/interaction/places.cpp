// SPDX-License-Identifier: Apache-2.0
#include "interaction/places.hpp"

#include <algorithm>

#include "interaction/role_tasks.hpp"
#include "interaction/sightings.hpp"
#include "path_query.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/interaction/capabilities.hpp"
#include "skein/interaction/describe.hpp"
#include "skein/interaction/placed_constraint.hpp"
#include "skein/interaction/role_fit.hpp"
#include "skein/negotiation/role_places.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/refiners/path.hpp"
#include "skein/supervisor/area_sweep.hpp"

namespace skein::decision_node {

namespace {

using interaction::Position;

constexpr double kClearance = 10;   // [m] over the ground
constexpr double kLeastMargin = 3;  // [dB] of a relay's links
constexpr std::uint64_t kSeed = 1;  // one situation, one place

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(" \t"), to = text.find_last_not_of(" \t");
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

Result<Position, Failure> point_of(const std::string& name, const PlaceQuery& query,
                                   const Outlook& outlook) {
  const auto known = query.scope.find(name);
  if (known == query.scope.end()) return failure("'" + name + "' has no value");
  if (const auto* point = std::get_if<Position>(&known->second)) return *point;
  const auto* place = std::get_if<std::string>(&known->second);
  const auto seen = place == nullptr ? std::nullopt : outlook.observer(*place);
  if (!seen) return failure("nobody knows where '" + (place ? *place : name) + "' is");
  return seen->position;
}

// A point on the ground is heard a little over it.
Position in_the_air(Position at, const world::World& world) {
  constexpr double kAntenna = 2;  // [m]
  at[2] = std::max(at[2], world.terrain.elevation(at[0], at[1]) + kAntenna);
  return at;
}

/// Whether the constraint is about none but places that have a name here.
bool is_about_named(const interaction::SpatialConstraint& one,
                    const interaction::ScmBinding& binding) {
  const auto* others = std::get_if<std::vector<std::string>>(&one.than);
  const auto is_named = [&](const std::string& place) { return !binding.places.at(place).empty(); };
  return std::ranges::all_of(one.of, is_named) &&
         (others == nullptr || std::ranges::all_of(*others, is_named));
}

// Of a place that is not known nothing can be said; what an SCM says of its other places holds.
std::vector<interaction::ActiveScm> known_ones(std::vector<interaction::ActiveScm> scms,
                                               const Outlook& outlook,
                                               const interaction::ScmLimits& limits) {
  const auto is_known = interaction::known_by(outlook.observer, outlook.now, limits);
  for (interaction::ActiveScm& one : scms) {
    for (auto& [formal, names] : one.binding.places)
      std::erase_if(names, [&](const std::string& name) { return !is_known(name); });
    std::erase_if(one.scm.constraints, [&](const interaction::SpatialConstraint& constraint) {
      return !is_about_named(constraint, one.binding);
    });
  }
  std::erase_if(scms, [](const auto& one) { return one.scm.constraints.empty(); });
  return scms;
}

bool is_seen_by_sensors(const interaction::ActiveScm& scm, const Outlook& outlook) {
  for (const auto& [formal, names] : scm.binding.places) {
    for (const std::string& name : names) {
      const auto seen = outlook.observer(name);
      if (seen && seen->by_sensors) return true;
    }
  }
  return false;
}

// A place is one to stay at: what the vehicle wavers, and what a place that sensors follow is
// mistaken by and moves in a while, is to break no constraint. Where a UAV was heard to be last is
// better than nothing, when what it said since was lost.
interaction::ScmLimits limits_of(const std::vector<interaction::ActiveScm>& scms,
                                 const Outlook& outlook) {
  constexpr double kNearest = 20;  // [m] of what is looked at
  constexpr double kSeen = 5;      // [m] of a place that is seen: three deviations of one tracked
  const world::VehicleModel& vehicle = outlook.knowledge.vehicle;
  const world::Wind& wind = outlook.world.wind;
  const bool seen = std::any_of(scms.begin(), scms.end(),
                                [&](const auto& one) { return is_seen_by_sensors(one, outlook); });
  const double wavers =
      (seen ? kSeen : 0) + 1.5 * (2 * world::tracking_spread(vehicle) +
                                  vehicle.wind_drift * (wind.speed + 2 * wind.gusts));
  interaction::ScmLimits limits;
  limits.oldest = limits.oldest_seen;
  limits.distance = std::max(limits.distance, wavers);
  limits.angle = std::max(limits.angle, wavers / kNearest);
  return limits;
}

interaction::RolePlaceQuery role_query(const PlaceQuery& query, const Outlook& outlook) {
  interaction::RolePlaceQuery result;
  result.vehicle = outlook.knowledge.vehicle;
  result.from = query.from;
  result.clearance = kClearance;
  result.at = outlook.now;
  result.limits = limits_of(query.scms, outlook);
  result.scms = known_ones(query.scms, outlook, result.limits);
  return result;
}

/// Near to `from`, where all constraints hold.
Result<Position, Failure> anywhere(const interaction::RolePlaceQuery& query, const Position& from,
                                   const Outlook& outlook) {
  interaction::ValidPositionQuery valid;
  valid.scms = query.scms;
  valid.air = interaction::free_air_of(outlook.world, query.vehicle, query.clearance, query.at);
  if (outlook.free_to_stay) {
    valid.air.holds = [inside = valid.air.holds, &outlook](const Position& at) {
      return inside(at) && outlook.free_to_stay(vector_of(at));
    };
  }
  valid.from = from;
  valid.limits = query.limits;
  valid.seed = kSeed;
  const auto found = valid_position(valid, outlook.observer, outlook.now);
  if (!found) return failure(found.error().why);
  return found->position;
}

}  // namespace

Call call_of(const std::string& initialiser) {
  const auto open = initialiser.find('('), close = initialiser.rfind(')');
  Call call{trimmed(initialiser.substr(0, open)), {}};
  if (open == std::string::npos || close == std::string::npos) return call;
  const std::string inside = initialiser.substr(open + 1, close - open - 1);
  for (std::size_t at = 0; !trimmed(inside).empty() && at <= inside.size();) {
    const std::size_t comma = std::min(inside.find(',', at), inside.size());
    call.arguments.push_back(trimmed(inside.substr(at, comma - at)));
    at = comma + 1;
  }
  return call;
}

std::optional<Argument> text_of(const Call& call, const interaction::Library& library,
                                const Arguments& scope) {
  const auto function = library.functions.find(call.function);
  if (function == library.functions.end() || call.arguments.size() != 1 ||
      function->second.gives != interaction::ParameterType::kText) {
    return std::nullopt;
  }
  const auto value = scope.find(call.arguments.front());
  return value == scope.end() ? std::nullopt : std::optional(value->second);
}

namespace {

// The place nearest to the refiner's best where the SCMs hold by their margins. Where it finds none
// under the SCMs, any that keeps them will do.
Result<Position, Failure> place_beside(const PlaceQuery& query, const Outlook& outlook) {
  const interaction::RolePlaceQuery role = role_query(query, outlook);
  if (query.call.function == "valid-position") return anywhere(role, query.from, outlook);
  if (query.call.arguments.size() != 2) return failure("nobody computes " + query.call.function);
  const auto one = point_of(query.call.arguments[0], query, outlook);
  if (!one) return one;
  const auto other = point_of(query.call.arguments[1], query, outlook);
  if (!other) return other;
  const refiners::Setting setting{outlook.world, {}, kSeed};
  Result<Position, Failure> found = failure("nobody computes " + query.call.function);
  if (query.call.function == "best-view") {
    found = best_view(role, query.device, *one, outlook.observer, setting, outlook.refused);
  } else if (query.call.function == "relay-position") {
    found = relay_position(role, in_the_air(*one, outlook.world), in_the_air(*other, outlook.world),
                           kLeastMargin, outlook.observer, setting);
  } else {
    return found;
  }
  const bool free = found && (!outlook.free_to_stay || outlook.free_to_stay(vector_of(*found)));
  if (role.scms.empty() && (free || !found)) return found;
  const auto valid = anywhere(role, found.value_or(query.from), outlook);
  if (valid || free) return valid ? valid : found;
  return failure("others leave it no air there");
}

}  // namespace

Result<Position, Failure> place_of(const PlaceQuery& query, const Outlook& outlook) {
  const auto beside = place_beside(query, outlook);
  if (beside || !outlook.free_to_stay) return beside;
  Outlook alone = outlook;
  alone.free_to_stay = {};
  return place_beside(query, alone);
}

Result<Position, Failure> aim_of(const Argument& argument, const Outlook& outlook) {
  if (const auto* point = std::get_if<Position>(&argument)) return *point;
  const auto* name = std::get_if<std::string>(&argument);
  const auto seen = name == nullptr ? std::nullopt : outlook.observer(*name);
  if (!seen) return failure("nobody knows where '" + (name ? *name : "it") + "' is");
  Position at = seen->position;
  at[2] = outlook.world.terrain.elevation(at[0], at[1]) + outlook.knowledge.altitude;
  return at;
}

std::string device_of(const interaction::Role& role, const world::VehicleModel& vehicle) {
  for (const interaction::Requirement& one : role.requirements) {
    const auto* device = std::get_if<std::string>(&one.value);
    if (device != nullptr && world::find_sensor(vehicle, *device) != nullptr) return *device;
  }
  return vehicle.sensors.empty() ? "" : vehicle.sensors.front().device;
}

std::vector<interaction::ActiveScm> scms_of(
    const Joint& joint, const std::string& role, const Holders& holders, const std::string& self,
    const std::function<bool(const interaction::ScmInstance&, const std::vector<std::string>&)>&
        counts) {
  std::vector<interaction::ActiveScm> all;
  for (const interaction::ScmInstance& instance : joint.variant->table.scms) {
    for (const interaction::ScmPlace& place : joint.variant->table.places) {
      if (place.id != instance.id || place.role != role) continue;
      if (!counts(instance, place.blocks)) continue;
      all.push_back({instance.id, joint.library->scms.at(instance.scm),
                     binding_of(joint, instance, holders, self)});
    }
  }
  return all;
}

// ---- costs ----

namespace {

constexpr double kThere = 1;  // [m] it is there

/// Goes along the nominal path of a role.
class Walk {
 public:
  Walk(const Joint& joint, const std::string& role, Position from, const Outlook& outlook)
      : joint_(joint),
        role_(joint.library->roles.at(role)),
        outlook_(outlook),
        scope_(arguments_of(joint, role)),
        automaton_(with_times(role_.automaton, numbers_of(scope_))),
        at_(from),
        scms_(scms_of(
            joint, role, {}, outlook.knowledge.uav,
            [&](const auto& instance, const auto&) { return is_about_places(joint, instance); })) {}

  Result<RoleCost, Failure> cost() {
    RoleCost all;
    for (const interaction::NominalStep& step : nominal_path(automaton_)) {
      for (const std::string& local : step.computed) {
        if (auto why = compute(local)) return failure(*why);
      }
      const auto took = cost_of_task(automaton_[*automaton_.find(step.task)]);
      if (!took) return tl::unexpected(took.error());
      all.seconds += took->seconds;
      all.energy += took->energy;
    }
    return all;
  }

 private:
  std::optional<std::string> compute(const std::string& local) {
    for (const interaction::Componel& one : role_.automaton.componels()) {
      if (one.block() == nullptr) continue;
      for (const interaction::LocalParameter& parameter : one.block()->locals) {
        if (parameter.name != local) continue;
        const Call call = call_of(parameter.initialiser);
        if (const auto text = text_of(call, *joint_.library, scope_)) {
          scope_[local] = *text;
          continue;
        }
        const auto place = place_of(
            {call, scope_, at_, device_of(role_, outlook_.knowledge.vehicle), scms_}, outlook_);
        if (!place) return place.error().why;
        scope_[local] = *place;
      }
    }
    return std::nullopt;
  }

  RoleCost staying(double seconds) const {
    return {seconds, drawn(outlook_.knowledge.vehicle.energy.hover_power, seconds)};
  }
  double drawn(double power, double seconds) const {
    const double capacity = outlook_.knowledge.vehicle.energy.capacity;
    return capacity > 0 ? power * seconds / capacity : 0;
  }

  // How it is shared is not known yet: equal parts.
  Result<RoleCost, Failure> cost_of_mapping(const interaction::Task& task) {
    const config::Value* named = task.parameters.find("area");
    const auto zone = named == nullptr ? std::nullopt : zone_of(*named, scope_, outlook_.world);
    if (!zone) return failure("there is no zone that it could map");
    const world::VehicleModel& vehicle = outlook_.knowledge.vehicle;
    const auto swath = supervisor::swath_of(outlook_.knowledge, device_of(role_, vehicle));
    if (!swath) return failure(swath.error());
    const double part = world::area(*zone) / static_cast<double>(joint_.members.size());
    const double seconds = part / (*swath * vehicle.cruise_speed);
    return RoleCost{seconds, drawn(vehicle.energy.cruise_power, seconds)};
  }

  /// Until the time that ends a block around it.
  RoleCost cost_of_following(const interaction::Componel& task) const {
    std::optional<double> shortest;
    for (const interaction::Componel* one = &task; &automaton_[one->parent] != one;) {
      one = &automaton_[one->parent];
      for (const interaction::Clause& clause : one->block()->exit) {
        for (const interaction::Literal& literal : clause) {
          const auto* time = std::get_if<interaction::TimeIs>(&literal.condition);
          if (time == nullptr || !time->passed || literal.negated) continue;
          if (std::holds_alternative<interaction::TimeIs::Epoch>(time->since)) continue;
          const double seconds = std::max(time->after.to_seconds(), 0.0);
          shortest = std::min(shortest.value_or(seconds), seconds);
        }
      }
    }
    return staying(shortest.value_or(0));
  }

  Result<RoleCost, Failure> cost_of_task(const interaction::Componel& componel) {
    const interaction::Task& task = *componel.task();
    if (task.type == kMapArea) return cost_of_mapping(task);
    if (task.type == kFollow) return cost_of_following(componel);
    if (const config::Value* duration = task.parameters.find("duration")) {
      const auto seconds = value_of(*duration, scope_);
      if (seconds && std::holds_alternative<double>(*seconds))
        return staying(std::get<double>(*seconds));
    }
    const config::Value* to = task.parameters.find("to");
    if (to == nullptr) return RoleCost{};
    const auto value = value_of(*to, scope_);
    if (!value) return tl::unexpected(value.error());
    const auto aim = aim_of(*value, outlook_);
    if (!aim) return tl::unexpected(aim.error());
    const auto flight =
        refiners::estimate_flight(way_to(*aim), outlook_.knowledge.vehicle, outlook_.world.wind);
    at_ = *aim;
    return RoleCost{flight.duration.expected.to_seconds(), flight.energy};
  }

  /// As the role's task will be refined; where there is no way from here now, as the crow flies.
  refiners::Way way_to(const Position& aim) const {
    const refiners::Way straight{vector_of(at_), vector_of(aim)};
    if ((straight[1] - straight[0]).norm() < kThere) return straight;
    const auto path =
        refine(path_query(outlook_.knowledge.vehicle, straight[0], straight[1], outlook_.now),
               refiners::Setting{outlook_.world, {}});
    return path ? path->task.way : straight;
  }

  const Joint& joint_;
  const interaction::Role& role_;
  const Outlook& outlook_;
  Arguments scope_;
  interaction::Automaton automaton_;  ///< of the role, with the seconds that the joint task says
  Position at_;
  std::vector<interaction::ActiveScm> scms_;
};

/// What a role asks for that the vehicle has not; empty: nothing.
std::string lacking(const Joint& joint, const std::string& role, const world::VehicleModel& vehicle,
                    const world::VehicleState& state) {
  return interaction::lacking(joint.library->roles.at(role).requirements,
                              interaction::capabilities_of(vehicle, state.energy));
}

}  // namespace

Result<RoleCost, Failure> cost_of(const Joint& joint, const std::string& role,
                                  const world::VehicleState& state, const Outlook& outlook) {
  if (const std::string lacks = lacking(joint, role, outlook.knowledge.vehicle, state);
      !lacks.empty())
    return failure(lacks);
  return Walk(joint, role, position_of(state.position), outlook).cost();
}

std::string no_role_for(const Joint& joint, const world::VehicleModel& vehicle,
                        const world::VehicleState& state) {
  std::vector<std::string> reasons;
  for (const std::string& role : joint.variant->roles) {
    const std::string lacks = lacking(joint, role, vehicle, state);
    if (lacks.empty()) return "";
    reasons.push_back(role + ": " + lacks);
  }
  return "it can play no role: " + joined(reasons, "; ");
}

}  // namespace skein::decision_node
