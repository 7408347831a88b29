// SPDX-License-Identifier: Apache-2.0
// No request of an operator, however wrong, may crash the ground station that reads it.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "skein/scenario/operator_request.hpp"
#include "skein/scenario/scenario.hpp"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

/// A team, so that what is for a team is read too.
std::shared_ptr<const skein::scenario::Scenario> flown() {
  auto scenario = skein::scenario::read_scenario(SKEIN_SOURCE_DIR "/scenarios/team/five.yaml");
  require(scenario.has_value());
  return std::make_shared<const skein::scenario::Scenario>(std::move(*scenario));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static skein::scenario::RequestReader reader(flown());
  const auto deeds = reader.read({reinterpret_cast<const char*>(data), size});
  require(deeds.has_value() || !deeds.error().empty());
  return 0;
}
