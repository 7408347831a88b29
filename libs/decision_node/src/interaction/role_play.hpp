// SPDX-License-Identifier: Apache-2.0
// One role being played: its automaton, its computed values, and the constraints of active blocks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interaction/joint.hpp"
#include "skein/interaction/engine.hpp"
#include "skein/interaction/valid_position.hpp"

namespace skein::decision_node {

/// Whether some condition of a role refers to this message.
bool listens_to(const interaction::Automaton& role, const std::string& message);

class RolePlay {
 public:
  RolePlay(const Joint& joint, std::string role, Holders holders, std::string self);

  const std::string& role() const { return role_; }
  const interaction::Role& model() const { return joint_.library->roles.at(role_); }
  /// The values of names in its expressions: parameters and computed places.
  const Arguments& scope() const { return scope_; }
  void know(const std::string& local, Argument value) { scope_[local] = std::move(value); }
  /// It has no value; `why` is part of what a task that needs it fails by.
  void forget(const std::string& local, std::string why) {
    scope_.erase(local);
    unknown_.insert_or_assign(local, std::move(why));
  }
  /// The value of an expression in the scope. Refused: unknown name, with why it has no value.
  Result<Argument, Failure> value(const config::Value& expression) const;

  /// Passes an input to the automaton. Refused as by interaction::Engine.
  Result<interaction::Effects, Failure> tell(const interaction::Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const { return engine_.next_wakeup(); }
  bool is_over() const { return engine_.is_over(); }
  bool listens_to(const std::string& message) const {
    return decision_node::listens_to(automaton(), message);
  }
  /// The same, and it may still come true: no block around that condition is over. True before the
  /// role comes there.
  bool may_hear(const std::string& message) const;
  /// `uav` holds this role from now on. Precondition: it is a member of the joint task.
  void take_in(const std::string& uav, const std::string& role);
  /// `uav` holds no role any more.
  void lose(const std::string& uav) { holders_.erase(uav); }
  const Holders& holders() const { return holders_; }
  /// The UAV that plays this role.
  const std::string& self() const { return self_; }
  /// UAVs whose roles are given this argument, by name.
  std::vector<std::string> given(const Argument& argument) const;

  /// Changes of the SCMs of active blocks. After a restart of a block's loop the present states of
  /// its SCMs count as changes.
  std::vector<interaction::ScmFound> watch(const interaction::Position& own,
                                           const interaction::Observer& observer, MissionTime now);

  /// Whether some SCM of an active block does more than keep UAVs apart.
  bool is_bound() const;

  const interaction::Automaton& automaton() const { return engine_.automaton(); }
  std::vector<std::string> active_blocks() const;
  /// Whether a task or an action of the role is under way or about to be, or an instant will come
  /// that it waits for: else only a message can let it go on.
  bool goes_on() const;
  /// Whether the role runs and no task but flights (`goto`) is under way or can begin any more.
  bool has_only_flights_left() const;
  std::vector<std::string> violated() const;
  /// The block with this local parameter, and how it is computed.
  struct Local {
    interaction::ComponelIndex block = 0;
    std::string initialiser;
  };
  Local local(const std::string& name) const;
  /// SCMs for a place computed in this block: those of it and of the blocks around it; with `ahead`
  /// also those about places of later blocks of the role.
  std::vector<interaction::ActiveScm> scms_at(interaction::ComponelIndex block, bool ahead) const;

 private:
  bool may_do_more_than_fly(interaction::ComponelIndex componel, bool again) const;
  void forget_monitors_of_restarted(const interaction::Effects& effects);
  std::vector<interaction::ActiveScm> active_scms() const;

  const Joint& joint_;
  std::string role_;
  Holders holders_;
  std::string self_;
  Arguments scope_;
  std::map<std::string, std::string> unknown_;  ///< parameters last found without a value, and why
  interaction::Engine engine_;
  std::map<std::string, interaction::ScmMonitor> monitors_;  ///< by SCM
};

}  // namespace skein::decision_node
