// SPDX-License-Identifier: Apache-2.0
#include "joint_places.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "checks.hpp"

namespace skein::laws {

std::vector<Held> roles_held(const JointHistory& history) {
  std::vector<Held> all;
  for (const JointTold& told : history.joints) {
    std::optional<Held> open;
    for (const JointTold::Phase& phase : told.phases) {
      const bool runs = phase.phase == "running";
      if (open && (!runs || phase.role != open->role)) {
        open->until = phase.at;
        all.push_back(*open);
        open.reset();
      }
      if (runs && !open) open = Held{told.uav, told.joint, phase.role, phase.at, kNever};
    }
    if (open) all.push_back(*open);
  }
  return all;
}

const interaction::Model* model_of(const History& history, const std::string& joint) {
  const auto& library = history.scenario->interaction;
  if (library == nullptr) return nullptr;
  const auto model = library->models.find(joint.substr(0, joint.find('(')));
  return model == library->models.end() ? nullptr : &model->second;
}

std::map<std::string, std::string> arguments_of(const std::string& joint,
                                                const interaction::Variant& variant) {
  std::map<std::string, std::string> all;
  const auto open = joint.find('('), close = joint.find(')');
  std::istringstream words(joint.substr(open + 1, close - open - 1));
  for (const interaction::Parameter& one : variant.parameters) {
    if (one.type != interaction::ParameterType::kUavList) words >> all[one.name];
  }
  return all;
}

namespace {

constexpr double kTelling = 5;  // [s] by radio, of where a point is
constexpr double kOldest = 30;  // [s] what sensors saw before counts as unknown (spec 7.6)

/// The last instant until `at` until which it surely heard what the ground station told.
double last_told(const History& history, const std::string& uav, double at) {
  const auto& named = history.scenario->radio.relays;
  std::set<std::string> relays(named.begin(), named.end());
  std::erase_if(relays, [&](const std::string& one) { return history.dead.contains(one); });
  return history.joint.last_reached("ground", uav, relays, at, kTelling);
}

}  // namespace

std::optional<world::Vector3> where(const History& history, const std::string& name,
                                    const std::string& uav, double at) {
  if (const auto moving = history.uavs.find(name); moving != history.uavs.end()) {
    const auto sample = moving->second.at(at);
    return sample ? std::optional(sample->position) : std::nullopt;
  }
  std::optional<world::Vector3> place = history.place(name, at);
  for (const PointTold& told : history.joint.points) {
    if (told.name != name || told.at > at) continue;
    // While it is on its way, some know and some do not.
    place = told.at + kTelling < at ? std::optional(told.position) : std::nullopt;
  }
  // What moves all the time is where it was said to be last, unless that is long ago, or was not
  // heard here.
  const double heard = last_told(history, uav, at);
  for (const ObjectTold& told : history.objects_told) {
    if (told.name != name || told.told > at) continue;
    const bool known = at - told.seen < kOldest - kTelling && told.told <= heard;
    place = known ? std::optional(told.position) : std::nullopt;
  }
  if (place) place->z() = std::max(place->z(), history.terrain.elevation(place->x(), place->y()));
  return place;
}

namespace {

/// What a place of a constraint stands for: a UAV that holds a role, every other one, a point.
std::vector<std::string> names_of(const History& history, const PlaceTold& told,
                                  const interaction::Variant& variant, const std::string& word) {
  const auto arguments = arguments_of(told.joint, variant);
  if (const auto argument = arguments.find(word); argument != arguments.end()) {
    return {argument->second};
  }
  std::vector<std::string> names;
  for (const Held& held : roles_held(history.joint)) {
    const bool then = held.joint == told.joint && held.from <= told.at && told.at < held.until;
    const bool meant = word == "R*" ? held.uav != told.uav : held.role == word;
    if (then && meant) names.push_back(held.uav);
  }
  return names;
}

bool stands(double measured, interaction::Relation relation, double required, double slack) {
  using interaction::Relation;
  switch (relation) {
    case Relation::kLess:
    case Relation::kAtMost:
      return measured <= required + slack;
    case Relation::kGreater:
    case Relation::kAtLeast:
      return measured >= required - slack;
    case Relation::kEqual:
      break;
  }
  return std::abs(measured - required) <= slack;
}

}  // namespace

std::vector<Violation> distances_broken(const History& history, const PlaceTold& told,
                                        const interaction::Variant& variant, double slack) {
  constexpr double kSeconds = 1.5;  // of telemetry
  std::vector<Violation> result;
  for (const interaction::ScmInstance& instance : variant.table.scms) {
    if (std::find(told.scms.begin(), told.scms.end(), instance.id) == told.scms.end()) continue;
    for (const auto& constraint :
         history.scenario->interaction->scms.at(instance.scm).constraints) {
      const auto* term = std::get_if<interaction::Term>(&constraint.than);
      if (constraint.quantity != interaction::SpatialConstraint::Quantity::kDistance || !term) {
        continue;
      }
      const auto* formal = std::get_if<std::string>(term);
      const interaction::Term figure_of = formal ? instance.arguments.at(*formal) : *term;
      const auto* required = std::get_if<double>(&figure_of);
      const auto* word = std::get_if<std::string>(&instance.arguments.at(constraint.of.front()));
      if (required == nullptr || word == nullptr) continue;
      for (const std::string& name : names_of(history, told, variant, *word)) {
        const auto at = where(history, name, told.uav, told.at);
        if (!at) continue;
        const bool moves = history.uavs.count(name) > 0;
        const double old = moves ? kSeconds * history.uavs.at(name).spec->model.max_speed : 0;
        const double measured = (*at - told.position).norm();
        if (stands(measured, constraint.relation, *required, slack + old)) continue;
        result.push_back({"", told.at, told.uav, 0,
                          "its role " + told.role + " sends it to " + figure(measured) +
                              " m from " + name + ", against " + instance.id + ": " +
                              figure(*required) + " m"});
      }
    }
  }
  return result;
}

std::vector<Violation> places_against_constraints(const History& history) {
  constexpr double kSlack = 0.5;  // [m]
  std::vector<Violation> result;
  for (const PlaceTold& told : history.joint.places) {
    const interaction::Model* model = model_of(history, told.joint);
    if (model == nullptr) continue;
    for (const interaction::Variant& variant : model->variants) {
      for (Violation& one : distances_broken(history, told, variant, kSlack)) {
        result.push_back(std::move(one));
      }
    }
  }
  return result;
}

const interaction::Variant* variant_of(const History& history, const JointTold& told) {
  const interaction::Model* model = model_of(history, told.joint);
  if (model == nullptr) return nullptr;
  for (const interaction::Variant& one : model->variants) {
    if (one.name == told.variant) return &one;
  }
  return nullptr;
}

std::set<std::string> shared_areas(const History& history, const interaction::Variant& variant) {
  std::set<std::string> areas;
  for (const std::string& name : variant.roles) {
    const auto table = variant.table.parameters.find(name);
    const interaction::Role& role = history.scenario->interaction->roles.at(name);
    for (const interaction::Componel& one : role.automaton.componels()) {
      if (one.action() == nullptr || one.action()->modality != "area-sharing") continue;
      const config::Value* area = one.action()->in.find("area");
      if (area == nullptr || table == variant.table.parameters.end()) continue;
      if (table->second.contains(area->scalar)) areas.insert(table->second.at(area->scalar));
    }
  }
  return areas;
}

std::vector<Look> looks_for(const History& history, const std::string& joint) {
  std::vector<Look> looks;
  for (const RoleTaskTold& task : history.joint.tasks) {
    if (task.joint != joint) continue;
    const Uav& uav = history.uavs.at(task.uav);
    for (const Activity& look : uav.activities) {
      if (look.task == task.task && look.looks()) looks.push_back({&uav, &look});
    }
  }
  return looks;
}

}  // namespace skein::laws
