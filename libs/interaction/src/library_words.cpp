// SPDX-License-Identifier: Apache-2.0
// The small words of libraries: types, parameters, relations, functions.
#include "library_reader.hpp"

namespace skein::interaction {

using config::Reader;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<ParameterType> read_type(const Reader& reader) {
  static const std::vector<std::string> kNames{"Obj", "Point", "Time", "UAVlist", "Number", "Text"};
  if (!reader.present()) reader.error("no type", "Obj, Point, Time, UAVlist, Number or Text");
  const std::string name =
      reader.name_among(kNames, "a type: Obj, Point, Time, UAVlist, Number, Text");
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<ParameterType>(i);
  }
  return std::nullopt;
}

Parameters read_parameters(const Reader& reader, bool optional) {
  Parameters parameters;
  for (const auto& [written, type] : reader.entries()) {
    Parameter parameter;
    parameter.name = written;
    if (optional && !written.empty() && written.back() == '?') {
      parameter.name.pop_back();
      parameter.optional = true;
    }
    if (parameter.name.empty()) type.error("an empty name", "a name");
    if (find(parameters, parameter.name) != nullptr) {
      type.error("the parameter '" + parameter.name + "' is there twice", "a name of its own");
    }
    // One without a known type is kept, so that its uses are no further errors.
    parameter.type = read_type(type).value_or(ParameterType::kText);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

std::optional<Relation> relation_of(const std::string& text) {
  if (text == "<") return Relation::kLess;
  if (text == "<=" || text == "≤") return Relation::kAtMost;
  if (text == "=") return Relation::kEqual;
  if (text == ">=" || text == "≥") return Relation::kAtLeast;
  if (text == ">") return Relation::kGreater;
  return std::nullopt;
}

Function read_function(const Reader& reader) {
  reader.keys({"takes", "gives"});
  Function function;
  for (const Reader& one : reader.required("takes").items()) {
    function.takes.push_back(read_type(one).value_or(ParameterType::kText));
  }
  function.gives = read_type(reader.required("gives")).value_or(ParameterType::kText);
  return function;
}

std::vector<std::string> names_in(const Parameters& parameters) {
  std::vector<std::string> names;
  for (const Parameter& one : parameters) names.push_back(one.name);
  return names;
}

const std::vector<std::string>& modalities() {
  static const std::vector<std::string> kAll{
      "role-allocation", "time-interval", "area-sharing", "perception-positions",
      "relay-chain",     "plan-merging",  "task-auction"};
  return kAll;
}

}  // namespace skein::interaction
