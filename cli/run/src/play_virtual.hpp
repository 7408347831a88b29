// SPDX-License-Identifier: Apache-2.0
// Plays a scenario in virtual time.
#pragma once

#include "progress.hpp"
#include "skein/run_tool/played.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

Played play_virtual(const scenario::Scenario& scenario, Progress& progress);

}  // namespace skein::run_tool
