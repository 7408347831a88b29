// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/describe.hpp"

#include <cstdio>

#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string instant_text(const TimeIs& is, const Automaton& automaton) {
  const std::string after = is.named.empty() ? to_text(is.after) + " s" : is.named;
  return std::visit(Overloaded{[&](TimeIs::Epoch) { return after; },
                               [&](TimeIs::ModelStart) { return after + " after the start"; },
                               [&](const TimeIs::Event& event) {
                                 return after + " after " + automaton[event.componel].id + " " +
                                        std::string(to_text(event.state));
                               }},
                    is.since);
}

/// Terms of an SCM as an instance gives them.
class Arguments {
 public:
  explicit Arguments(const ScmInstance& instance) : instance_(instance) {}

  std::string operator()(const std::string& formal) const {
    const auto found = instance_.arguments.find(formal);
    return found == instance_.arguments.end() ? formal : text(found->second);
  }
  std::string operator()(const Term& term) const {
    const auto* name = std::get_if<std::string>(&term);
    return name != nullptr ? (*this)(*name) : text(term);
  }

 private:
  static std::string text(const Term& term) {
    const auto* name = std::get_if<std::string>(&term);
    if (name == nullptr) return number_text(std::get<double>(term));
    return *name == "R*" ? "all others" : *name;
  }
  const ScmInstance& instance_;
};

std::string describe(const SpatialConstraint& one, const Arguments& argument) {
  const bool distance = one.quantity == SpatialConstraint::Quantity::kDistance;
  std::string text =
      distance ? "distance to " + argument(one.of[0])
               : std::string(one.quantity == SpatialConstraint::Quantity::kAzimuth ? "azimuth"
                                                                                   : "altitude") +
                     " from " + argument(one.of[0]) + " (0 to " + argument(one.of[1]) + ")";
  text += " " + std::string(to_text(one.relation)) + " ";
  const std::string unit = distance ? " m" : " rad";
  if (const auto* places = std::get_if<std::vector<std::string>>(&one.than)) {
    text += distance ? "that of " + argument(places->at(0)) + " to " + argument(places->at(1))
                     : "that of " + argument(places->at(0));
  } else {
    text += argument(std::get<Term>(one.than)) + unit;
  }
  if (one.tolerance > 0) text += " ± " + number_text(one.tolerance);
  return text;
}

}  // namespace

std::string describe(const Literal& literal, const Automaton& automaton) {
  std::string text = literal.negated ? "not " : "";
  text += std::visit(
      Overloaded{[&](const ComponelIs& is) {
                   return automaton[is.componel].id + " " + std::string(to_text(is.state));
                 },
                 [](const MessagePending& is) { return "message '" + is.message + "'"; },
                 [&](const TimeIs& is) {
                   return std::string(is.passed ? "" : "before ") + instant_text(is, automaton);
                 }},
      literal.condition);
  if (literal.modality == Modality::kOptional) text += " if it can";
  if (literal.effect == ExitEffect::kContinue) text += " (begins anew)";
  return text;
}

std::vector<std::string> describe(const Formula& formula, const Automaton& automaton) {
  std::vector<std::string> lines;
  for (const Clause& clause : formula) {
    std::string line = lines.empty() ? "" : "and ";
    for (std::size_t i = 0; i < clause.size(); ++i) {
      line += (i > 0 ? " or " : "") + describe(clause[i], automaton);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string describe(const Requirement& requirement) {
  return std::visit(
      Overloaded{[&](std::monostate) { return requirement.capability; },
                 [&](const std::string& value) { return requirement.capability + ": " + value; },
                 [&](const Requirement::Bound& bound) {
                   return requirement.capability + " " + std::string(to_text(bound.relation)) +
                          " " + number_text(bound.value);
                 }},
      requirement.value);
}

std::vector<std::string> describe(const Scm& scm, const ScmInstance& instance) {
  std::vector<std::string> lines;
  for (const SpatialConstraint& one : scm.constraints) {
    lines.push_back(describe(one, Arguments(instance)));
  }
  return lines;
}

}  // namespace skein::interaction
