// SPDX-License-Identifier: Apache-2.0
// One line of a trace as an input of the executive, and an effect as a line.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/resource.hpp"
#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::mle_tool {

/// What one line says.
struct TraceLine {
  MissionTime at;
  executive::Input input;
};

/// Formats: cli/mle/README.md.
Result<TraceLine, Failure> read_line(std::string_view text);

/// `{"takeoff": {"resources": ["motion"]}, …}` over the elementary types.
Result<executive::TypeTable, Failure> read_types(std::string_view text);

/// The line of an effect, without its newline; absent for an effect that the trace does not show.
std::optional<std::string> to_line(const executive::Effect& effect, MissionTime at);
/// `{"at":S,"refused":"line","line":N,"why":"…"}`
std::string wrong_line(MissionTime at, std::size_t number, const std::string& why);

}  // namespace skein::mle_tool
