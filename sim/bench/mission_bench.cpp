// SPDX-License-Identifier: Apache-2.0
// Cost of simulating: a whole mission of three vehicles, and one step of one vehicle.
#include <benchmark/benchmark.h>

#include <fstream>
#include <sstream>

#include "skein/sim/simulator.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::sim {
namespace {

world::VehicleModel model_of(const std::string& name) {
  const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/" + name + ".yaml";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return world::read_vehicle_model(text.str(), path).value();
}

SimulatorConfig three_vehicles() {
  world::TerrainSpec terrain;
  terrain.west = terrain.south = -400;
  terrain.east = 1200;
  terrain.north = 1000;
  terrain.hills = {{{300, 700}, 60, 150}};
  SimulatorConfig config{world::Terrain(terrain)};
  config.wind = {0.6, 2, 0.5};
  config.radio = {2500, true, Duration::milliseconds(20), 0.01, 0.05};
  for (const std::string name : {"marvin", "heliv", "karma"}) {
    SimulatedVehicle vehicle;
    vehicle.name = name;
    vehicle.model = model_of(name);
    vehicle.start = {0, 10.0 * static_cast<double>(config.vehicles.size())};
    config.vehicles.push_back(vehicle);
  }
  world::WorldObject fire;
  fire.name = fire.kind = "fire";
  fire.position = {640, 420};
  config.objects = {fire};
  return config;
}

/// All take off, look all the time and wait in the wind, stepped as a runtime steps them.
std::size_t fly(Simulator& simulator, double until) {
  std::size_t effects = 0;
  const auto give = [&](const char* uav, std::uint64_t task, const char* type,
                        functional::Parameters parameters, double now) {
    const FunctionalRequest request{
        uav, {functional::Verb::kDispatch, functional::TaskId(task), type, parameters}};
    effects += simulator.handle(request, MissionTime::seconds(now)).size();
  };
  for (const char* uav : {"marvin", "heliv", "karma"})
    give(uav, 1, "takeoff", functional::Parameters().add("altitude", 60), 0);
  const std::pair<const char*, const char*> devices[] = {
      {"marvin", "fire-sensor"}, {"heliv", "visible"}, {"karma", "mapping"}};
  for (const auto& [uav, device] : devices)
    give(uav, 2, "takeshot", functional::Parameters().add("device", device), 0);
  while (*simulator.next_wakeup() <= MissionTime::seconds(until))
    effects += simulator.handle(Tick{}, *simulator.next_wakeup()).size();
  return effects;
}

void mission_of_three_vehicles(benchmark::State& state) {
  for (auto _ : state) {
    Simulator simulator(three_vehicles());
    benchmark::DoNotOptimize(fly(simulator, 2400));
  }
  state.counters["mission_s/s"] = benchmark::Counter(
      2400.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(mission_of_three_vehicles)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skein::sim

BENCHMARK_MAIN();
