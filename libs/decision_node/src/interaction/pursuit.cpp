// SPDX-License-Identifier: Apache-2.0
#include "interaction/pursuit.hpp"

#include <cmath>

#include "interaction/role_tasks.hpp"
#include "path_query.hpp"

namespace skein::decision_node {

namespace {

using interaction::Position;

constexpr double kBeside = 30;       // [m] of it, where the role says no place
constexpr double kFarthest = 100;    // [m] beside it
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

Pursuit::Pursuit(const PlaySurroundings& of, RoleCourse& course)
    : host_(of.host), sightings_(of.sightings), my_(of.my), course_(course) {}

// A place that the role gives is one beside where the target is now; one that is not beside it,
// since nothing was agreed on or it has moved since, says nothing of where to follow it.
void Pursuit::follow(const std::string& componel) {
  const RolePlay& play = course_.play();
  const interaction::Automaton& automaton = play.automaton();
  const interaction::Task& task = *automaton[*automaton.find(componel)].task();
  const config::Value* named = task.parameters.find("target");
  const auto target = named == nullptr ? Result<Argument, Failure>(failure("it has no target"))
                                       : value_of(*named, play.scope());
  const auto* name = target ? std::get_if<std::string>(&*target) : nullptr;
  if (name == nullptr) return course_.fail(componel, "what it follows has no name");
  const auto seen = course_.outlook().observer(*name);
  if (!seen) return course_.fail(componel, "nobody knows where '" + *name + "' is");
  const Position own = position_of(sightings_.own()->state.position);
  Following following{*name, side_of(seen->position, own), seen->position,
                      host_.config().knowledge->altitude};
  const config::Value* beside = task.parameters.find("beside");
  const auto place = beside == nullptr ? Result<Argument, Failure>(failure("none"))
                                       : value_of(*beside, play.scope());
  const auto* at = place ? std::get_if<Position>(&*place) : nullptr;
  if (at != nullptr && level_between(*at, seen->position) <= kFarthest) {
    following.side = {(*at)[0] - seen->position[0], (*at)[1] - seen->position[1], 0};
    following.height = (*at)[2] - host_.world()->terrain.elevation((*at)[0], (*at)[1]);
  }
  following_[componel] = following;
  course_.tell_status(componel, interaction::Status::Word::kRunning);
  if (auto why = fly_after(componel)) course_.fail(componel, *why);
}

std::optional<std::string> Pursuit::fly_after(const std::string& componel) {
  Following& following = following_.at(componel);
  const Outlook outlook = course_.outlook();
  const auto seen = outlook.observer(following.target);
  if (!seen) return std::nullopt;
  following.seen_at = seen->position;
  Position aim{seen->position[0] + following.side[0], seen->position[1] + following.side[1], 0};
  aim[2] = outlook.world.terrain.elevation(aim[0], aim[1]) + following.height;
  const world::Vector3& own = sightings_.own()->state.position;
  if ((own - vector_of(aim)).norm() < kAlreadyThere) return std::nullopt;
  const auto path = refine(path_query(outlook.knowledge.vehicle, own, vector_of(aim), outlook.now),
                           refiners::Setting{outlook.world, {}});
  if (!path) return "no way to '" + following.target + "': " + path.error().why;
  following.flies = true;
  course_.give(componel, flight_along({path->task.way.begin() + 1, path->task.way.end()}));
  return std::nullopt;
}

// Who hovers beside it flies on when it has moved; a place without a way is waited at.
void Pursuit::look() {
  for (const auto& [componel, following] : std::map(following_)) {
    const auto seen = course_.outlook().observer(following.target);
    if (following.flies || !seen) continue;
    if (level_between(seen->position, following.seen_at) < kMoves) continue;
    if (auto why = fly_after(componel))
      host_.bus().emit(Notice{my_.joint.subject + ": " + componel + ": " + *why});
  }
}

}  // namespace skein::decision_node
