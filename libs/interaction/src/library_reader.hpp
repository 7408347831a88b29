// SPDX-License-Identifier: Apache-2.0
// Readers of the parts of a library. Unreadable parts are reported, and left out or given a
// harmless value.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/config/reader.hpp"
#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// Without spaces around it.
std::string trimmed(const std::string& text);
/// "Obj", "Point", …
std::optional<ParameterType> read_type(const config::Reader& reader);
/// `{front: Obj, duration: Time}`; with `optional`, a name that ends with `?` may be left out.
Parameters read_parameters(const config::Reader& reader, bool optional = false);
/// "<", "<=", "≤", "=", …
std::optional<Relation> relation_of(const std::string& text);
/// `{takes: [Point, Point], gives: Point}`
Function read_function(const config::Reader& reader);
/// Reads a role and checks its automaton, and its calls, tasks and actions against `library`.
/// `problems`: the diagnostics of `reader`.
Role read_role(const std::string& name, const config::Reader& reader, const Library& library,
               Diagnostics& problems);
Scm read_scm(const std::string& name, const config::Reader& reader);
/// Reads a variant and checks it against the roles and SCMs of `library`.
Variant read_variant(const std::string& name, const config::Reader& reader, const Library& library);

/// Names in a map, for "did you mean".
template <class Value>
std::vector<std::string> names_in(const std::map<std::string, Value>& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}
std::vector<std::string> names_in(const Parameters& parameters);

/// Negotiation modalities (spec 7.4).
const std::vector<std::string>& modalities();

}  // namespace skein::interaction
