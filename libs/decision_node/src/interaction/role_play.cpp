// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_play.hpp"

#include <algorithm>
#include <set>

#include "interaction/places.hpp"

namespace skein::decision_node {

namespace {

using interaction::Block;
using interaction::ComponelIndex;
using interaction::ComponelState;

constexpr double kFollowed = 3;  // [m] two deviations of a place that sensors follow

bool is_active(ComponelState state) {
  return state == ComponelState::kRunning || state == ComponelState::kAborting;
}

bool names(const interaction::Formula& formula, const std::string& message) {
  for (const interaction::Clause& clause : formula) {
    for (const interaction::Literal& literal : clause) {
      const auto* pending = std::get_if<interaction::MessagePending>(&literal.condition);
      if (pending != nullptr && pending->message == message) return true;
    }
  }
  return false;
}

/// Whether a condition of the componel, which may be a block, is about the message.
bool refers_to(const interaction::Componel& one, const std::string& message) {
  const interaction::Block* block = one.block();
  return block != nullptr && (names(block->precondition, message) || names(block->exit, message));
}

}  // namespace

bool listens_to(const interaction::Automaton& role, const std::string& message) {
  return std::ranges::any_of(role.componels(),
                             [&](const auto& one) { return refers_to(one, message); });
}

RolePlay::RolePlay(const Joint& joint, std::string role, Holders holders, std::string self)
    : joint_(joint),
      role_(std::move(role)),
      holders_(std::move(holders)),
      self_(std::move(self)),
      scope_(arguments_of(joint, role_)),
      engine_(std::make_shared<const interaction::Automaton>(
          with_times(automaton_in(*joint.library, *joint.variant, role_), numbers_of(scope_)))) {}

Result<interaction::Effects, Failure> RolePlay::tell(const interaction::Input& input,
                                                     MissionTime now) {
  auto effects = engine_.handle(input, now);
  if (effects) forget_monitors_of_restarted(*effects);
  return effects;
}

Result<Argument, Failure> RolePlay::value(const config::Value& expression) const {
  auto value = value_of(expression, scope_);
  const auto unknown = value ? unknown_.end() : unknown_.find(expression.scalar);
  if (unknown != unknown_.end()) return failure(value.error().why + ": " + unknown->second);
  return value;
}

// A block that is over begins anew with the loop around it.
bool RolePlay::may_hear(const std::string& message) const {
  const auto is_out = [&](ComponelIndex componel) {
    const ComponelState state = engine_.state(componel);
    return interaction::is_over(state) || state == ComponelState::kAborting;
  };
  for (ComponelIndex i = 0; i < automaton().size(); ++i) {
    if (!refers_to(automaton()[i], message)) continue;
    bool is_there = true;
    for (ComponelIndex around = i; automaton()[around].parent != around;) {
      around = automaton()[around].parent;
      is_there = is_there && !is_out(around);
    }
    if (is_there) return true;
  }
  return false;
}

// Lists of the members among its parameters have it too.
void RolePlay::take_in(const std::string& uav, const std::string& role) {
  holders_[uav] = role;
  for (auto& [name, value] : arguments_of(joint_, role_)) scope_.insert_or_assign(name, value);
}

void RolePlay::forget_monitors_of_restarted(const interaction::Effects& effects) {
  for (const interaction::Effect& effect : effects) {
    const auto* changed = std::get_if<interaction::StateChanged>(&effect.what);
    if (changed == nullptr || changed->state != ComponelState::kScheduled) continue;
    const auto index = automaton().find(changed->componel);
    const Block* around = automaton()[automaton()[*index].parent].block();
    for (const std::string& scm : around->scms) monitors_.erase(scm);
  }
}

std::vector<interaction::ActiveScm> RolePlay::active_scms() const {
  std::set<std::string> active;
  for (ComponelIndex i = 0; i < automaton().size(); ++i) {
    const Block* block = automaton()[i].block();
    if (block == nullptr || !is_active(engine_.state(i))) continue;
    active.insert(block->scms.begin(), block->scms.end());
  }
  return scms_of(joint_, role_, holders_, self_,
                 [&](const auto& instance, const auto&) { return active.contains(instance.id); });
}

bool RolePlay::is_bound() const {
  using interaction::Relation;
  using interaction::SpatialConstraint;
  const auto keeps_apart = [](const SpatialConstraint& one) {
    const bool is_least = one.relation == Relation::kAtLeast || one.relation == Relation::kGreater;
    return one.quantity == SpatialConstraint::Quantity::kDistance && is_least;
  };
  const auto active = active_scms();
  return std::any_of(active.begin(), active.end(), [&](const interaction::ActiveScm& one) {
    const auto& constraints = one.scm.constraints;
    return !std::all_of(constraints.begin(), constraints.end(), keeps_apart);
  });
}

std::vector<interaction::ScmFound> RolePlay::watch(const interaction::Position& own,
                                                   const interaction::Observer& observer,
                                                   MissionTime now) {
  interaction::ScmLimits limits;
  limits.seen = kFollowed;
  std::vector<interaction::ScmFound> found;
  std::set<std::string> active;
  for (interaction::ActiveScm& one : active_scms()) {
    active.insert(one.id);
    const auto monitor =
        monitors_.try_emplace(one.id, one.id, std::move(one.scm), std::move(one.binding), limits);
    if (auto change = monitor.first->second.update(own, observer, now)) {
      found.push_back(std::move(*change));
    }
  }
  std::erase_if(monitors_, [&](const auto& one) { return !active.contains(one.first); });
  return found;
}

std::vector<std::string> RolePlay::given(const Argument& argument) const {
  std::vector<std::string> uavs;
  for (const auto& [uav, role] : holders_) {
    const Arguments arguments = arguments_of(joint_, role);
    const auto is_it = [&](const auto& one) { return one.second == argument; };
    if (std::any_of(arguments.begin(), arguments.end(), is_it)) uavs.push_back(uav);
  }
  return uavs;
}

std::vector<std::string> RolePlay::active_blocks() const {
  std::vector<std::string> blocks;
  for (ComponelIndex i = 0; i < automaton().size(); ++i) {
    const bool block = automaton()[i].block() != nullptr;
    if (block && is_active(engine_.state(i))) blocks.push_back(automaton()[i].id);
  }
  return blocks;
}

bool RolePlay::goes_on() const {
  if (engine_.is_over() || engine_.next_wakeup()) return true;
  for (ComponelIndex i = 0; i < automaton().size(); ++i) {
    const bool block = automaton()[i].block() != nullptr;
    const interaction::ComponelState state = engine_.state(i);
    if (!block && (state == interaction::ComponelState::kScheduled || is_active(state)))
      return true;
  }
  return false;
}

bool RolePlay::has_only_flights_left() const {
  return engine_.state(0) == ComponelState::kRunning && !may_do_more_than_fly(0, false);
}

// `again`: a loop around it may begin it anew.
bool RolePlay::may_do_more_than_fly(ComponelIndex componel, bool again) const {
  const ComponelState state = engine_.state(componel);
  const bool is_out = interaction::is_over(state) || state == ComponelState::kAborting;
  if (is_out && !again) return false;
  const interaction::Componel& one = automaton()[componel];
  if (one.task() != nullptr) return one.task()->type != "goto";
  if (one.block() == nullptr) return false;
  const bool begins_anew = again || one.block()->type == interaction::BlockType::kLoop;
  return std::ranges::any_of(one.block()->content, [&](ComponelIndex inner) {
    return may_do_more_than_fly(inner, begins_anew);
  });
}

std::vector<std::string> RolePlay::violated() const {
  std::vector<std::string> all;
  for (const auto& [id, monitor] : monitors_) {
    if (monitor.finding() == interaction::ScmReport::Finding::kViolated) all.push_back(id);
  }
  return all;
}

RolePlay::Local RolePlay::local(const std::string& name) const {
  for (ComponelIndex i = 0; i < automaton().size(); ++i) {
    const Block* block = automaton()[i].block();
    if (block == nullptr) continue;
    for (const interaction::LocalParameter& one : block->locals) {
      if (one.name == name) return {i, one.initialiser};
    }
  }
  return {};
}

std::vector<interaction::ActiveScm> RolePlay::scms_at(ComponelIndex block, bool ahead) const {
  std::set<std::string> around{automaton()[block].id};
  for (ComponelIndex i = block; automaton()[i].parent != i; i = automaton()[i].parent) {
    around.insert(automaton()[automaton()[i].parent].id);
  }
  return scms_of(joint_, role_, holders_, self_, [&](const auto& instance, const auto& blocks) {
    const bool holds = std::any_of(blocks.begin(), blocks.end(),
                                   [&](const auto& one) { return around.contains(one); });
    return holds || (ahead && is_about_places(joint_, instance));
  });
}

}  // namespace skein::decision_node
