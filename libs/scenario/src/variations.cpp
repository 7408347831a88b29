// SPDX-License-Identifier: Apache-2.0
// What a run draws from its seed.
#include <cmath>

#include "skein/foundation/overloaded.hpp"
#include "skein/foundation/random.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario {

namespace {

using ground_station::Trigger;

// A waiting time with this mean [s].
double exponential(Random& random, double mean) { return -mean * std::log(1 - random.uniform()); }

// Instants of a Poisson process over the mission, each followed by a pause of mean length `mean`.
template <class Use>
void draw(Random random, double per_hour, double mean, MissionTime limit, Use use) {
  if (per_hour <= 0) return;
  double at = exponential(random, 3600 / per_hour);
  while (at < limit.to_seconds()) {
    const double length = std::max(1.0, exponential(random, mean));
    use(MissionTime::seconds(at), Duration::seconds(length));
    at += length + exponential(random, 3600 / per_hour);
  }
}

void delay(Trigger& trigger, Duration by) {
  const auto each = [&](std::vector<Trigger>& of) {
    for (Trigger& one : of) delay(one, by);
  };
  std::visit(Overloaded{[&](ground_station::AtTime& time) { time.at = time.at + by; },
                        [&](ground_station::AllOf& all) { each(all.of); },
                        [&](ground_station::AnyOf& any) { each(any.of); }, [](auto&) {}},
             trigger.what);
}

}  // namespace

void draw_random_faults(Scenario& scenario) {
  const RandomFaults& random = scenario.faults.random;
  std::vector<std::string> nodes = scenario.uav_names();
  nodes.emplace_back("ground");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      draw(Random(scenario.seed, "cut " + nodes[i] + " " + nodes[j]), random.cuts_per_hour,
           random.mean_cut, scenario.duration_limit, [&](MissionTime at, Duration length) {
             scenario.radio.cuts.push_back({nodes[i], nodes[j], at, at + length});
           });
    }
  }
  nodes.emplace_back("sim");
  for (const std::string& node : nodes) {
    draw(Random(scenario.seed, "kill " + node), random.kills_per_hour, random.mean_dead,
         scenario.duration_limit, [&](MissionTime at, Duration length) {
           scenario.faults.kills.push_back({at, node, length});
         });
  }
}

void draw_variations(Scenario& scenario) {
  const auto with = [&](const std::optional<Variations::Range>& range, const std::string& what,
                        auto use) {
    if (range) use(Random(scenario.seed, "variation " + what).uniform(range->low, range->high));
  };
  const Variations& vary = scenario.variations;
  with(vary.wind_speed, "wind speed", [&](double x) { scenario.world.wind.speed = x; });
  with(vary.wind_toward, "wind toward", [&](double x) { scenario.world.wind.toward = x; });
  for (UavSpec& uav : scenario.uavs) {
    with(vary.speed_factor, "speed of " + uav.name, [&](double x) { uav.speed_factor = x; });
  }
  with(vary.latency, "latency",
       [&](double x) { scenario.radio.model.latency = Duration::seconds(x); });
  with(vary.loss, "loss", [&](double x) { scenario.radio.model.loss = x; });
  with(vary.start_delay, "start delay", [&](double x) {
    for (auto& step : scenario.ground.script.steps) delay(step.when, Duration::seconds(x));
    for (auto& one : scenario.ground.script.operators) delay(one.when, Duration::seconds(x));
  });
}

}  // namespace skein::scenario
