// SPDX-License-Identifier: Apache-2.0
// A scenario as it ships, to be looked at or changed.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "skein/scenario/scenario.hpp"

namespace skein::ground_setup {

/// scenarios/comets/confirmed.yaml; a failure of the test if it cannot be read.
inline scenario::Scenario comets() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

}  // namespace skein::ground_setup
