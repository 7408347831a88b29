// SPDX-License-Identifier: Apache-2.0
// A joint task: its model, members and arguments.
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
#include "skein/mission/high_level_task.hpp"
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::decision_node {

/// The value of a parameter: a number; a name (of an object or point) or text; a point; UAVs.
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
  /// Identifies the joint task among its members: made of model, arguments and members.
  std::string subject;

  /// Whether a negotiation is about this joint task.
  bool has(const std::string& negotiated) const { return negotiated.starts_with(subject + "/"); }
  /// All members but `self`.
  std::vector<std::string> others(const std::string& self) const;
};

/// A high-level task that names an interaction model, as a planner would make it: its arguments are
/// those of the model's variants, in their order.
mission::ElementaryTask as_planned(const mission::HighLevelTask& task,
                                   const interaction::Library& library);

/// What is different where the same members ask for the same joint task, at the same first
/// argument, by a subject made of other values: "duration 400, not 315". Absent: they do not.
std::optional<std::string> difference(const Joint& joint, const std::string& other_subject);

/// The joint task of an elementary task. Refused: unknown model, no variant for this number of
/// members, a parameter missing or of another type, a member that is not in `team`, this UAV not
/// among the members.
Result<Joint, Failure> joint_of(const mission::ElementaryTask& task,
                                const std::shared_ptr<const interaction::Library>& library,
                                const std::string& self, const std::vector<std::string>& team);

/// What that UAV tells its partners of the joint task, without what becomes of it.
interaction::JointTaskStatus status_of(const Joint& joint, const std::string& uav);

/// The same joint task for a subset of its members (`self` included), in the variant for their
/// number; nothing if there is no such variant.
std::optional<Joint> among(const Joint& joint, const std::vector<std::string>& members);

/// The values of the parameters of a role.
Arguments arguments_of(const Joint& joint, const std::string& role);

/// Those that are numbers: seconds of conditions on time that name them.
std::map<std::string, double> numbers_of(const Arguments& arguments);

/// The value of an expression of a role: a name in the scope, or a literal. Refused: unknown name.
Result<Argument, Failure> value_of(const config::Value& expression, const Arguments& scope);

/// UAVs to the roles they hold.
using Holders = std::map<std::string, std::string>;

/// Of two that hear each other again: whether those of `theirs`, who go on without some of `mine`,
/// are more than these, or as many with the first name. Where each goes on without the other both
/// see it alike, so one of them yields, also if a third one counts for both.
bool outweigh(const Holders& theirs, const Holders& mine);

/// The values of the places and numbers of an SCM, as seen by `self`. Points without a name get the
/// name of their parameter.
interaction::ScmBinding binding_of(const Joint& joint, const interaction::ScmInstance& instance,
                                   const Holders& holders, const std::string& self);
/// Whether the SCM involves no role: it constrains the place whatever the partners do.
bool is_about_places(const Joint& joint, const interaction::ScmInstance& instance);

}  // namespace skein::decision_node
