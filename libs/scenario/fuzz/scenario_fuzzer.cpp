// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reading of scenarios; and one that is accepted holds what
// the rest of Skein takes for granted.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/scenario/scenario.hpp"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void look_at(const skein::scenario::Scenario& scenario) {
  require(!scenario.uavs.empty());
  for (const auto& uav : scenario.uavs) require(uav.degree >= 1 && uav.degree <= 5);
  for (const auto& cut : scenario.radio.cuts) require(cut.from < cut.until && cut.a != cut.b);
  require(skein::world::problems_of(scenario.world.terrain).empty());
  require(skein::ground_station::problems_of(scenario.ground.script).empty());
  require(skein::ground_station::problems_of(scenario.ground.pps).empty());
  const auto verdicts = skein::scenario::check(scenario.expectations, {});
  require(verdicts.size() == scenario.expectations.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto scenario =
      skein::scenario::read_scenario_text(text, SKEIN_SOURCE_DIR "/scenarios/comets/fuzz.yaml");
  if (scenario) {
    look_at(*scenario);
  } else {
    require(!scenario.error().empty());
  }
  return 0;
}
