// SPDX-License-Identifier: Apache-2.0
// A role that follows what moves: one flight after the other to where it is now.
#include <algorithm>
#include <cmath>

#include "interaction/interaction.hpp"
#include "interaction/role_tasks.hpp"
#include "path_query.hpp"

namespace skein::decision_node {

namespace {

using interaction::Position;
using Word = interaction::Status::Word;

constexpr double kBeside = 30;       // [m] of it, where the role says no place
constexpr double kMoves = 10;        // [m] it moves before it is flown after
constexpr double kAlreadyThere = 3;  // [m]

double level_between(const Position& a, const Position& b) {
  return (vector_of(a) - vector_of(b)).head<2>().norm();
}

/// On the side of it where one is.
Position side_of(const Position& target, const Position& own) {
  const double level = level_between(target, own);
  const double share = level > 1 ? kBeside / level : 0;
  return {share * (own[0] - target[0]), level > 1 ? share * (own[1] - target[1]) : kBeside, 0};
}

}  // namespace

// A place that the role gives is one beside where the target is now.
void JointPlay::follow(const std::string& componel) {
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::Task& task = *automaton[*automaton.find(componel)].task();
  const config::Value* named = task.parameters.find("target");
  const auto target = named == nullptr ? Result<Argument, Failure>(failure("it has no target"))
                                       : value_of(*named, play_->scope());
  const auto* name = target ? std::get_if<std::string>(&*target) : nullptr;
  if (name == nullptr) return fail(componel, "what it follows has no name");
  const auto seen = outlook().observer(*name);
  if (!seen) return fail(componel, "nobody knows where '" + *name + "' is");
  const Position own = position_of(sightings_.own()->state.position);
  Following following{*name, side_of(seen->position, own), seen->position,
                      host_.config().knowledge->altitude};
  const config::Value* beside = task.parameters.find("beside");
  const auto place = beside == nullptr ? Result<Argument, Failure>(failure("none"))
                                       : value_of(*beside, play_->scope());
  if (const auto* at = place ? std::get_if<Position>(&*place) : nullptr) {
    following.side = {(*at)[0] - seen->position[0], (*at)[1] - seen->position[1], 0};
    following.height = (*at)[2] - host_.world()->terrain.elevation((*at)[0], (*at)[1]);
  }
  following_[componel] = following;
  tell_status(componel, Word::kRunning);
  if (auto why = fly_after(componel)) fail(componel, *why);
}

/// Why not, if there is no way.
std::optional<std::string> JointPlay::fly_after(const std::string& componel) {
  Following& following = following_.at(componel);
  const Outlook outlook = this->outlook();
  const auto seen = outlook.observer(following.target);
  if (!seen) return std::nullopt;  // it is waited for where it was
  following.seen_at = seen->position;
  Position aim{seen->position[0] + following.side[0], seen->position[1] + following.side[1], 0};
  aim[2] = outlook.world.terrain.elevation(aim[0], aim[1]) + following.height;
  const world::Vector3& own = sightings_.own()->state.position;
  if ((own - vector_of(aim)).norm() < kAlreadyThere) return std::nullopt;
  const auto path = refine(path_query(outlook.knowledge.vehicle, own, vector_of(aim), outlook.now),
                           refiners::Setting{outlook.world, {}});
  if (!path) return "no way to '" + following.target + "': " + path.error().why;
  following.flies = true;
  give(componel, flight_along({path->task.way.begin() + 1, path->task.way.end()}));
  return std::nullopt;
}

// Who hovers beside it flies on when it has moved; a place without a way is waited at.
void JointPlay::look_after_followed() {
  for (const auto& [componel, following] : std::map(following_)) {
    const auto seen = outlook().observer(following.target);
    if (following.flies || !seen) continue;
    if (level_between(seen->position, following.seen_at) < kMoves) continue;
    if (auto why = fly_after(componel))
      host_.bus().emit(Notice{my_.joint.subject + ": " + componel + ": " + *why});
  }
}

/// False: it is no flight after anything, or what becomes of it is told as of other tasks.
bool JointPlay::flew_after(const executive::TaskEvent& event, const std::string& componel) {
  const auto found = following_.find(componel);
  if (found == following_.end()) return false;
  if (!is_terminal(event.state)) return true;
  found->second.flies = false;
  tasks_.erase(event.id);
  const bool asked = interaction_.aborts().take(event.id) == AbortedFor::kRole;
  if (event.state == executive::TaskState::kEnded && !asked) return true;
  if (!asked) record_.aborted(componel, event.reason);
  following_.erase(found);
  tell_status(componel, Word::kAborted);
  return true;
}

}  // namespace skein::decision_node
