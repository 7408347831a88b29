// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/model.hpp"

#include <algorithm>

namespace skein::interaction {

std::string_view to_text(ParameterType type) {
  constexpr std::string_view kNames[] = {"Obj", "Point", "Time", "UAVlist", "Number", "Text"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string_view to_text(Relation relation) {
  constexpr std::string_view kNames[] = {"<", "≤", "=", "≥", ">"};
  return kNames[static_cast<std::size_t>(relation)];
}

std::string to_text(const Arity& arity) {
  if (!arity.most) return "at least " + std::to_string(arity.least);
  if (*arity.most == arity.least) return std::to_string(arity.least);
  if (arity.least == 0) return "at most " + std::to_string(*arity.most);
  return std::to_string(arity.least) + " to " + std::to_string(*arity.most);
}

const Parameter* find(const Parameters& parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

bool has_roles_by_ground(const Model& model) {
  return std::any_of(model.variants.begin(), model.variants.end(),
                     [](const Variant& one) { return !one.by_ground.empty(); });
}

Automaton automaton_in(const Library& library, const Variant& variant, const std::string& role) {
  Automaton automaton = library.roles.at(role).automaton;
  for (const ScmPlace& place : variant.table.places) {
    if (place.role != role) continue;
    for (const std::string& id : place.blocks) {
      std::vector<std::string>& scms = automaton[*automaton.find(id)].block()->scms;
      if (std::find(scms.begin(), scms.end(), place.id) == scms.end()) scms.push_back(place.id);
    }
  }
  return automaton;
}

}  // namespace skein::interaction
