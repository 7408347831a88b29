// SPDX-License-Identifier: Apache-2.0
// `skein operate` and `skein status`: an operator at the shell.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "skein/blackboard/network.hpp"

namespace skein::operate_tool {

/// How the ground station is reached.
struct StationOptions {
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  double patience = 10;  ///< [s] for the ground station to be heard
};

struct OperateOptions {
  StationOptions station;
  std::string who;           ///< empty: the user's name
  std::uint64_t number = 0;  ///< of the request; 0: from the wall clock, so that they grow
  std::string request;       ///< the list of actions; `all` as a UAV: see for_all
  bool wait = true;          ///< until all commands came to their end
  double limit = 120;        ///< [s] of waiting for that
  bool json = false;         ///< the last answer as one JSON object
};

/// Asks, again until it is answered, and tells what comes of it. Exit codes: 0 all commands are
/// acknowledged (without `wait`: it was accepted), 1 refused, or some command was refused or
/// expired, 2 wrong options, 3 no DDS, 4 no answer.
int operate(const OperateOptions& options, std::ostream& out, std::ostream& err);

struct StatusOptions {
  StationOptions station;
  bool watch = false;  ///< each second, until Ctrl-C or the end of the mission
  bool json = false;   ///< one JSON document; with `watch` one a line
};

/// What the ground station knows. Exit codes: 0, 2 wrong options, 3 no DDS, 4 nothing heard.
int status(const StatusOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::operate_tool
