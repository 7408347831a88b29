// SPDX-License-Identifier: Apache-2.0
#include "joint_constraints.hpp"

namespace skein::ground_setup {

namespace {

using Json = nlohmann::ordered_json;
using interaction::SpatialConstraint;
using interaction::Term;

std::string_view name_of(SpatialConstraint::Quantity quantity) {
  switch (quantity) {
    case SpatialConstraint::Quantity::kDistance:
      return "distance";
    case SpatialConstraint::Quantity::kAzimuth:
      return "azimuth";
    case SpatialConstraint::Quantity::kAltitude:
      break;
  }
  return "altitude";
}

Json json_of(const Term& term) {
  if (const auto* word = std::get_if<std::string>(&term)) return *word;
  return std::get<double>(term);
}

// A parameter of the SCM is what its instance gives it.
Json given(const interaction::ScmInstance& instance, const Term& term) {
  const auto* word = std::get_if<std::string>(&term);
  const auto argument = word == nullptr ? instance.arguments.end() : instance.arguments.find(*word);
  return json_of(argument == instance.arguments.end() ? term : argument->second);
}

Json given(const interaction::ScmInstance& instance, const std::vector<std::string>& places) {
  Json words = Json::array();
  for (const std::string& place : places) words.push_back(given(instance, Term(place)));
  return words;
}

Json json_of(const interaction::ScmInstance& instance, const SpatialConstraint& constraint) {
  Json json{{"quantity", name_of(constraint.quantity)},
            {"of", given(instance, constraint.of)},
            {"relation", to_text(constraint.relation)},
            {"than",
             std::visit([&](const auto& than) { return given(instance, than); }, constraint.than)}};
  if (constraint.relation == interaction::Relation::kEqual) {
    json["tolerance"] = constraint.tolerance;
  }
  return json;
}

Json json_of(const interaction::Library& library, const interaction::ScmInstance& instance,
             const interaction::ScmPlace& place) {
  Json all = Json::array();
  for (const SpatialConstraint& one : library.scms.at(instance.scm).constraints) {
    all.push_back(json_of(instance, one));
  }
  return {{"scm", instance.id}, {"role", place.role}, {"blocks", place.blocks}, {"all", all}};
}

Json json_of(const interaction::Library& library, const interaction::Variant& variant) {
  Json arguments = Json::array(), constraints = Json::array();
  for (const interaction::Parameter& one : variant.parameters) {
    if (one.type != interaction::ParameterType::kUavList) arguments.push_back(one.name);
  }
  for (const interaction::ScmPlace& place : variant.table.places) {
    for (const interaction::ScmInstance& instance : variant.table.scms) {
      if (instance.id == place.id) constraints.push_back(json_of(library, instance, place));
    }
  }
  return {{"arguments", std::move(arguments)},
          {"roles", variant.roles},
          {"constraints", std::move(constraints)}};
}

}  // namespace

Json joint_constraints(const interaction::Library& library) {
  Json models = Json::object();
  for (const auto& [task, model] : library.models) {
    Json& variants = models[task] = Json::object();
    for (const interaction::Variant& variant : model.variants) {
      variants[variant.name] = json_of(library, variant);
    }
  }
  return models;
}

}  // namespace skein::ground_setup
