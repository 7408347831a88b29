// SPDX-License-Identifier: Apache-2.0
// A joint task as this UAV is asked for it: which model, with whom, about what.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/interaction/model.hpp"
#include "skein/interaction/model_hash.hpp"
#include "skein/interaction/scm_monitor.hpp"
#include "skein/mission/elementary_plan.hpp"

namespace skein::decision_node {

/// The value of a parameter: a number, a name (of an object, a point, or a text), a point, UAVs.
using Argument = std::variant<double, std::string, interaction::Position, std::vector<std::string>>;
using Arguments = std::map<std::string, Argument>;

struct Joint {
  executive::TaskId task;
  std::shared_ptr<const interaction::Library> library;
  const interaction::Variant* variant = nullptr;  ///< of the library
  std::string model;                              ///< type of the joint task
  interaction::ModelHash hash;
  std::vector<std::string> members;  ///< in order, this UAV among them
  Arguments arguments;               ///< of the variant's parameters
  /// The same at all who are asked for the same: model, arguments, members.
  std::string subject;
};

/// Refused: no such model, no variant for so many, a parameter missing or of another type, a member
/// that is not of `team`, this UAV not among them.
Result<Joint, Failure> joint_of(const mission::ElementaryTask& task,
                                const std::shared_ptr<const interaction::Library>& library,
                                const std::string& self, const std::vector<std::string>& team);

/// The same joint task among these of its members alone, `self` among them, in the variant for so
/// many; nothing where there is none.
std::optional<Joint> among(const Joint& joint, const std::vector<std::string>& members);

/// What the parameters of a role stand for.
Arguments arguments_of(const Joint& joint, const std::string& role);

/// The value of an expression of a role: a name of the scope, or a literal. Refused: not known.
Result<Argument, Failure> value_of(const config::Value& expression, const Arguments& scope);

/// Who holds what: role by UAV.
using Holders = std::map<std::string, std::string>;

/// What the places and numbers of an SCM stand for, seen from `self`. Points without a name get
/// that of their parameter.
interaction::ScmBinding binding_of(const Joint& joint, const interaction::ScmInstance& instance,
                                   const Holders& holders, const std::string& self);
/// It names no role: it says where to be, whatever the partners do.
bool is_about_places(const Joint& joint, const interaction::ScmInstance& instance);

}  // namespace skein::decision_node
