// SPDX-License-Identifier: Apache-2.0
// One line of a trace as an input of the engine, and an effect as a line. Source: spec 7.8.
#pragma once

#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/interaction/effect.hpp"
#include "skein/interaction/input.hpp"

namespace skein::model_tool {

/// Content of one line.
struct TraceLine {
  MissionTime at;
  interaction::Input input;
};

Result<TraceLine, Failure> read_line(std::string_view text);

/// The line of an effect, without its newline.
std::string to_line(const interaction::Effect& effect);
/// {"refused": N, "why": "…"}
std::string refused_line(std::size_t number, const std::string& why);

}  // namespace skein::model_tool
