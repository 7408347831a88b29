// SPDX-License-Identifier: Apache-2.0
#include "watch/beliefs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "skein/functional/task_type.hpp"

namespace skein::supervisor {

namespace {

// A state of the vehicle that was on its way while it landed is not believed that it flies.
constexpr Duration kLandingSettles = Duration::milliseconds(3000);
// The wind is believed to be another when it is known well and differs by much [m/s].
constexpr double kWindKnown = 0.6, kOtherWind = 0.75;
constexpr double kSure = 3.5;  // deviations: it is looked at with every state

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

Beliefs::Beliefs(const Knowledge& knowledge, std::shared_ptr<const world::World> world)
    : knowledge_(knowledge), world_(std::move(world)), wind_(knowledge.vehicle, world_->wind) {
  vehicle_.position = knowledge.home;
}

// ---- the world ----

void Beliefs::take(std::shared_ptr<const world::World> changed) {
  world_ = std::move(changed);
  ++revision_;
}

double Beliefs::learn(const mission::ChangeWorld& change) {
  auto changed = std::make_shared<world::World>(*world_);
  double moved = 0;
  if (change.place) {
    const auto known = changed->places.find(change.place->name);
    if (known != changed->places.end()) moved = (known->second - change.place->at).norm();
    put(*change.place, *changed);
  } else {
    put(*change.ground, *changed);
  }
  take(std::move(changed));
  return moved;
}

void Beliefs::close(const mission::ChangeWorld& change) {
  auto changed = std::make_shared<world::World>(*world_);
  std::vector<world::Volume>& volumes = changed->volumes;
  volumes.erase(std::remove_if(volumes.begin(), volumes.end(),
                               [&](const auto& one) { return one.name == change.volume.name; }),
                volumes.end());
  if (!change.remove) volumes.push_back(change.volume);
  take(std::move(changed));
}

// What is planned keeps its dates: what takes longer shows by itself.
std::optional<world::Wind> Beliefs::feel_wind() {
  const world::Wind felt = wind_.wind();
  const double off = (world::mean_velocity(felt) - world::mean_velocity(world_->wind)).norm();
  if (wind_.spread() > kWindKnown || off < std::max(kOtherWind, kSure * wind_.spread())) return {};
  auto changed = std::make_shared<world::World>(*world_);
  changed->wind = felt;
  take(std::move(changed));
  return felt;
}

// ---- the vehicle ----

void Beliefs::see_end(const executive::TaskEvent& event, MissionTime now) {
  const functional::Leaves leaves = functional::TaskTypes::shipped().of(event.type).leaves;
  if (leaves == functional::Leaves::kInTheAir) {
    vehicle_.airborne = true;
    grounded_until_ = MissionTime();
  } else if (leaves == functional::Leaves::kOnTheGround) {
    vehicle_.airborne = false;
    grounded_until_ = now + kLandingSettles;
  }
}

std::set<std::string> Beliefs::see(const world::VehicleState& state,
                                   const std::vector<std::string>& failed, MissionTime now) {
  vehicle_ = state;
  vehicle_.airborne = state.airborne && now >= grounded_until_;
  wind_.see(vehicle_, now);
  std::set<std::string> newly;
  std::set<std::string> broken(failed.begin(), failed.end());
  std::set_difference(broken.begin(), broken.end(), broken_.begin(), broken_.end(),
                      std::inserter(newly, newly.end()));
  broken_ = std::move(broken);
  return newly;
}

}  // namespace skein::supervisor
