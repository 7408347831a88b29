// SPDX-License-Identifier: Apache-2.0
// Interaction models: what several UAVs do together, as data. Roles, spatial constraint models and
// models are separate pieces; coordination tables bind them. Source: T V.2, spec 7.1.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/interaction/automaton.hpp"
#include "skein/interaction/requirement.hpp"

namespace skein::interaction {

enum class ParameterType : std::uint8_t {
  kObj,    ///< named object that the observer tracks; usable where a point is
  kPoint,  ///< named, or coordinates [m, ENU]
  kTime,   ///< instant or duration [s]
  kUavList,
  kNumber,
  kText,
};
/// "Obj", "Point", "Time", "UAVlist", "Number", "Text".
std::string_view to_text(ParameterType type);
/// Whether an argument of type `given` may be used for a parameter of type `wanted`.
constexpr bool fits(ParameterType given, ParameterType wanted) {
  return given == wanted || (given == ParameterType::kObj && wanted == ParameterType::kPoint);
}

struct Parameter {
  std::string name;
  ParameterType type = ParameterType::kText;
  bool optional = false;  ///< of tasks
  bool operator==(const Parameter&) const = default;
};
using Parameters = std::vector<Parameter>;
const Parameter* find(const Parameters& parameters, std::string_view name);

/// Source: T def. V.1.
struct Role {
  std::string name;
  std::vector<Requirement> requirements;
  Parameters parameters;
  Automaton automaton;
};

/// A number, or the name of a parameter.
using Term = std::variant<double, std::string>;

/// One constraint, seen from the UAV that holds it: its distance to a place, or its azimuth or
/// altitude in a celestial frame (origin, direction of azimuth 0, counter-clockwise), against a
/// number, the distance between two places, or the direction of a place. Source: T V.2.3.
struct SpatialConstraint {
  enum class Quantity : std::uint8_t { kDistance, kAzimuth, kAltitude };
  Quantity quantity = Quantity::kDistance;
  std::vector<std::string> of;  ///< one place of a distance, two of an angle: origin, azimuth 0
  Relation relation = Relation::kLess;
  /// [m] or [rad]; or two places: their distance; or one place: its angle.
  std::variant<Term, std::vector<std::string>> than;
  double tolerance = 0;  ///< of kEqual: [m] or [rad]
};

/// Spatial constraint model: a conjunction over places and numbers of its own.
/// Source: T def. V.2.
struct Scm {
  struct Formal {
    std::string name;
    bool place = true;  ///< else a number
  };
  std::string name;
  std::vector<Formal> parameters;
  std::vector<SpatialConstraint> constraints;
};

/// Number of UAVs that may hold a role.
struct Arity {
  int least = 1;
  std::optional<int> most;
  bool operator==(const Arity&) const = default;
};
/// "1", "at least 1", "at most 3", "1 to 3".
std::string to_text(const Arity& arity);

/// A coordination action of one role is carried out together with one of another, or the same,
/// role. Source: T def. V.3.
struct Correspondence {
  std::string role, action;
  std::string target_role, target_action;
  std::optional<int> number;  ///< number of holders of the target role that take part; absent: all
};

/// An SCM with arguments.
struct ScmInstance {
  std::string id;
  std::string scm;
  /// For a place: a parameter of the variant, a role (meaning its holders), or "R*" (every other
  /// member).
  std::map<std::string, Term> arguments;
};

/// When an SCM must hold: while one of these blocks of the role is active. Source: T def. V.4.
struct ScmPlace {
  std::string id, role;
  std::vector<std::string> blocks;
};

/// Binds the roles and SCMs of a variant. Source: T V.2.4.
struct CoordinationTable {
  std::map<std::string, Arity> arities;         ///< by role
  std::vector<Correspondence> correspondences;  ///< each is listed for both sides
  std::vector<ScmInstance> scms;
  std::vector<ScmPlace> places;
  /// The variant's parameter, by role and parameter of the role.
  std::map<std::string, std::map<std::string, std::string>> parameters;
};

/// One way to do a joint task, for some number of UAVs. Source: T def. V.5.
struct Variant {
  std::string name;
  Parameters parameters;
  std::vector<std::string> roles;
  CoordinationTable table;
  /// Roles that the ground station may play for a UAV that does not deliberate.
  std::set<std::string> by_ground = {};
};

/// The variants of one type of elementary joint task; `task` is the name of that type.
struct Model {
  std::string task;
  std::vector<Variant> variants;
};
/// Whether the ground station may play some role of some variant.
bool has_roles_by_ground(const Model& model);

/// Signature of a function that computes a local parameter.
struct Function {
  std::vector<ParameterType> takes;
  ParameterType gives = ParameterType::kPoint;
};

/// All definitions that were read together, checked: all names exist, all types fit.
struct Library {
  std::map<std::string, Role> roles;
  std::map<std::string, Scm> scms;
  std::map<std::string, Model> models;
  std::map<std::string, Parameters> tasks;    ///< parameters of each task type
  std::map<std::string, Function> functions;  ///< best-view, relay-position, valid-position, …
};

/// The automaton of a role in a variant: its blocks have the SCMs of the coordination table.
Automaton automaton_in(const Library& library, const Variant& variant, const std::string& role);

}  // namespace skein::interaction
