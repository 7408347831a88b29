// SPDX-License-Identifier: Apache-2.0
// Plays a scenario in virtual time.
#pragma once

#include "played.hpp"
#include "progress.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

Played play_virtual(const scenario::Scenario& scenario, Progress& progress);

}  // namespace skein::run_tool
