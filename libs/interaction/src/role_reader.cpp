// SPDX-License-Identifier: Apache-2.0
// A role: what a UAV needs for it, its parameters, and an automaton whose names and types fit them.
#include <algorithm>
#include <cctype>
#include <set>

#include "library_reader.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/interaction/check_automaton.hpp"
#include "skein/interaction/read_automaton.hpp"

namespace skein::interaction {

namespace {

using config::Reader;

bool is_name(const std::string& text) {
  const auto letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
  };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(), letter);
}

/// Checks what the componels of a role name against what there is.
class RoleChecker {
 public:
  explicit RoleChecker(const Library& library) : library_(library) {}

  void check(const Reader& block, Parameters known) {
    if (!block.is_map()) return;
    for (const auto& [name, value] : block.optional("local").entries()) {
      if (find(known, name) != nullptr) {
        value.error("the name '" + name + "' is taken already", "a name of its own");
      }
      known.push_back({name, check_call(value, known), false});
    }
    for (const Reader& item : block.optional("content").items()) {
      if (item.optional("block").present()) check(item, known);
      if (item.optional("task").present()) check_task(item, known);
      if (item.optional("action").present()) check_action(item, known);
    }
  }

 private:
  // "best-view(front, center)"; what it gives.
  ParameterType check_call(const Reader& reader, const Parameters& known) {
    const std::string text = trimmed(reader.text());
    const std::size_t open = text.find('(');
    if (open == std::string::npos || text.back() != ')') {
      reader.error("'" + text + "' is no call", "NAME(ARGUMENT, …)");
      return ParameterType::kPoint;
    }
    const std::string name = trimmed(text.substr(0, open));
    const auto found = library_.functions.find(name);
    if (found == library_.functions.end()) {
      const auto names = names_in(library_.functions);
      reader.error("unknown function '" + name + "'", "a function that is declared",
                   nearest_name(name, names));
      return ParameterType::kPoint;
    }
    check_arguments(reader, found->second, text.substr(open + 1, text.size() - open - 2), known);
    return found->second.gives;
  }

  void check_arguments(const Reader& reader, const Function& function, const std::string& text,
                       const Parameters& known) {
    std::vector<std::string> arguments;
    for (std::size_t at = 0; !trimmed(text).empty() && at <= text.size();) {
      const std::size_t comma = std::min(text.find(',', at), text.size());
      arguments.push_back(trimmed(text.substr(at, comma - at)));
      at = comma + 1;
    }
    if (arguments.size() != function.takes.size()) {
      reader.error(std::to_string(arguments.size()) + " arguments",
                   std::to_string(function.takes.size()));
      return;
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      check_name(reader, arguments[i], function.takes[i], known);
    }
  }

  void check_name(const Reader& reader, const std::string& name, ParameterType wanted,
                  const Parameters& known) {
    const Parameter* found = find(known, name);
    if (found == nullptr) {
      reader.error("unknown name '" + name + "'",
                   "a parameter of the role or of a block around it; text in quotes",
                   nearest_name(name, names_in(known)));
    } else if (!fits(found->type, wanted)) {
      reader.error("'" + name + "' is of type " + std::string(to_text(found->type)),
                   "one of type " + std::string(to_text(wanted)));
    }
  }

  void check_task(const Reader& task, const Parameters& known) {
    const Reader type = task.required("type");
    const auto found = library_.tasks.find(type.text());
    if (found == library_.tasks.end()) {
      if (type.is_scalar()) {
        type.error("unknown type of tasks '" + type.text() + "'", "one that `tasks` declares",
                   nearest_name(type.text(), names_in(library_.tasks)));
      }
      return;
    }
    const Reader given = task.optional("params");
    for (const Parameter& parameter : found->second) {
      if (parameter.optional || given.optional(parameter.name).present()) continue;
      task.error("'" + type.text() + "' without its parameter '" + parameter.name + "'",
                 "params: {" + parameter.name + ": …}");
    }
    for (const auto& [name, value] : given.entries()) {
      const Parameter* parameter = find(found->second, name);
      if (parameter == nullptr) {
        value.error("unknown parameter '" + name + "' of '" + type.text() + "'",
                    "one that `tasks` declares", nearest_name(name, names_in(found->second)));
      } else {
        check_value(value, parameter->type, known);
      }
    }
  }

  // A name, or a literal of the type: a number, text in quotes, coordinates, names of UAVs.
  void check_value(const Reader& reader, ParameterType wanted, const Parameters& known) {
    const config::Value& value = reader.value();
    if (reader.is_scalar() && !value.quoted && is_name(value.scalar)) {
      return check_name(reader, value.scalar, wanted, known);
    }
    switch (wanted) {
      case ParameterType::kNumber:
      case ParameterType::kTime:
        (void)reader.number();
        return;
      case ParameterType::kPoint:
        if (!reader.is_scalar()) (void)reader.numbers(3);
        return;
      case ParameterType::kUavList:
        for (const Reader& one : reader.items()) (void)one.text();
        return;
      case ParameterType::kObj:
      case ParameterType::kText:
        (void)reader.text();
        return;
    }
  }

  void check_action(const Reader& action, const Parameters& known) {
    (void)action.required("modality").name_among(modalities(), "a negotiation modality");
    for (const char* key : {"in", "out"}) {
      for (const auto& [name, value] : action.optional(key).entries()) {
        if (!value.is_scalar() || value.value().quoted || !is_name(value.text())) continue;
        const Parameter* found = find(known, value.text());
        if (found == nullptr) check_name(value, value.text(), ParameterType::kText, known);
      }
    }
  }

  const Library& library_;
};

std::vector<std::string> times_among(const Parameters& parameters) {
  std::vector<std::string> names;
  for (const Parameter& one : parameters)
    if (one.type == ParameterType::kTime) names.push_back(one.name);
  return names;
}

}  // namespace

Role read_role(const std::string& name, const Reader& reader, const Library& library,
               Diagnostics& problems) {
  reader.keys({"needs", "parameters", "automaton"});
  Role role;
  role.name = name;
  role.requirements = read_requirements(reader.optional("needs"));
  role.parameters = read_parameters(reader.optional("parameters"));
  const Reader automaton = reader.required("automaton");
  if (!automaton.present()) return role;
  const std::size_t before = problems.size();
  role.automaton = read_automaton(automaton, times_among(role.parameters));
  const bool sound = problems.size() == before;
  RoleChecker(library).check(automaton, role.parameters);
  // Only an automaton of sound form can be asked what it does.
  if (sound) check_automaton(role.automaton, reader.file(), problems);
  return role;
}

}  // namespace skein::interaction
