// SPDX-License-Identifier: Apache-2.0
// What is believed of places and of the ground, and what of the plan was about something else.
#include <algorithm>
#include <cmath>

#include "core.hpp"
#include "planning/terms.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::supervisor {

namespace {

// Nearer than this it is the same place [m]: for what is planned, for what is under way.
constexpr double kSamePlace = 5, kStillInView = 15;
// The wind is believed to be another when it is known well and differs by much [m/s].
constexpr double kWindKnown = 0.6, kOtherWind = 0.75;
constexpr double kSure = 3.5;  // deviations: it is looked at with every state

bool names(const mission::HighLevelTask& task, const std::string& place) {
  const auto is_it = [&](const std::string& name) { return same_name(name, place); };
  return std::any_of(task.arguments.begin(), task.arguments.end(), [&](const auto& argument) {
    return std::visit(Overloaded{[&](const std::string& name) { return is_it(name); },
                                 [&](const std::vector<std::string>& all) {
                                   return std::any_of(all.begin(), all.end(), is_it);
                                 },
                                 [](const auto&) { return false; }},
                      argument);
  });
}

// What burns, or has burnt, is no risk any more.
void set_cell(world::GroundState& ground, std::size_t cell, world::CellState state) {
  if (ground.state.empty()) ground.state.resize(ground.grid.size(), world::CellState::kQuiet);
  ground.state[cell] = state;
  if (state != world::CellState::kFire) return;
  if (ground.risk.empty()) ground.risk.assign(ground.grid.size(), 0.5);
  ground.risk[cell] = 0;
}

void put(const mission::KnownPlace& place, world::World& world) {
  world.places[place.name] = place.at;
  if (!place.cells) return;
  const world::Grid& grid = world.ground.grid;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const bool inside = (grid.centre(cell) - place.at.head<2>()).norm() <= place.radius;
    if (inside || grid.at(place.at.head<2>()) == cell) set_cell(world.ground, cell, *place.cells);
  }
}

void put(const mission::KnownGround& known, world::World& world) {
  world::GroundState& ground = world.ground;
  for (std::size_t cell = 0; cell < ground.grid.size(); ++cell) {
    if (!world::contains(known.area, ground.grid.centre(cell))) continue;
    if (known.cells) set_cell(ground, cell, *known.cells);
    if (known.mapped) {
      if (ground.mapped.empty()) ground.mapped.resize(ground.grid.size(), false);
      ground.mapped[cell] = true;
    }
    if (known.risk) {
      if (ground.risk.empty()) ground.risk.assign(ground.grid.size(), 0.5);
      ground.risk[cell] = *known.risk;
    }
  }
}

}  // namespace

void Supervisor::Core::learn(const mission::ChangeWorld& change) {
  const std::vector<std::string> problems = problems_of(change);
  out_.push_back(Answer{problems.empty(), problems});
  const std::string cause = to_text(change);
  if (!problems.empty()) {
    return decide({"0 user request", cause, "world", "refused: " + joined(problems), now_});
  }
  auto changed = std::make_shared<world::World>(*world_);
  std::optional<world::Vector3> before;
  if (change.place) {
    const auto known = changed->places.find(change.place->name);
    if (known != changed->places.end()) before = known->second;
    put(*change.place, *changed);
  } else {
    put(*change.ground, *changed);
  }
  world_ = std::move(changed);
  ++world_revision_;
  decide({"0 user request", cause, "world", "accepted", now_});
  const double moved = before ? (*before - change.place->at).norm() : 0;
  if (engaged_ && moved > kSamePlace)
    look_elsewhere(change.place->name, moved > kStillInView, cause + " elsewhere");
}

// Plans from now on reckon with the wind that is felt, once it is known to be another. What is
// planned keeps its dates: what takes longer shows by itself.
void Supervisor::Core::feel_wind() {
  const world::Wind felt = wind_.wind();
  const double off = (world::mean_velocity(felt) - world::mean_velocity(world_->wind)).norm();
  if (wind_.spread() > kWindKnown || off < std::max(kOtherWind, kSure * wind_.spread())) return;
  auto changed = std::make_shared<world::World>(*world_);
  changed->wind = felt;
  world_ = std::move(changed);
  ++world_revision_;
  const auto figure = [](double value) {
    return to_text(Duration::seconds(std::round(10 * value) / 10));
  };
  notice("the wind is felt to be " + figure(felt.speed) + " m/s towards " +
         figure(felt.toward * 180 / M_PI) + " degrees north of east");
}

// Plans for a place that lies elsewhere than was thought are made again; what was seen counts.
void Supervisor::Core::look_elsewhere(const std::string& place, bool far,
                                      const std::string& cause) {
  std::optional<GoalId> first;
  std::set<GoalId> stopped;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    const bool open = !is_settled(goal.state) && goal.state != GoalState::kHandedOver;
    const bool given = book_.is_given(id);
    if (!open || goal.queued || !names(goal.task, place) || (given && !far)) continue;
    if (!first) first = id;
    if (given) stopped.insert(id);
  }
  if (!first) return;
  retire(book_.falling_with(stopped));
  need(first, true, cause + ", which goal " + to_text(*first) + " is about");
}

}  // namespace skein::supervisor
