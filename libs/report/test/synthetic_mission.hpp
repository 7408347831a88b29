// SPDX-License-Identifier: Apache-2.0
// Invented runs in the form of their event logs, to develop and test the report against.
#pragma once

#include <string>

#include "skein/report/run_info.hpp"

namespace skein::report::testing {

/// A mission like COMETS, May 2005: three UAVs, 25 minutes, an alarm confirmed and a false one
/// infirmed, aborted tasks, a rendezvous, a link cut with expired messages, a restarted daemon, a
/// failed expectation.
RunInfo comets_info();
std::string comets_journal();

/// Many UAVs with many tasks and messages: about `lines` lines.
RunInfo swarm_info(std::size_t uavs);
std::string swarm_journal(std::size_t uavs, std::size_t lines, std::uint64_t seed);

}  // namespace skein::report::testing
