// SPDX-License-Identifier: Apache-2.0
// `skein spy`: shows the traffic of a DDS domain.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"

namespace skein::spy_tool {

/// The information to show.
enum class Verb : std::uint8_t {
  kTable,   ///< nodes, slots and rates
  kTopics,  ///< ls
  kNodes,   ///< ps
  kEcho,
  kEvents,
  kRate,       ///< hz
  kBandwidth,  ///< bw
  kDelay,
  kLinks,
  kDoctor
};

struct SpyOptions {
  Verb verb = Verb::kTable;
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  /// DDS partitions to listen in; `*` and `?` as DDS has them.
  std::vector<std::string> partitions{"world", "onboard/*", "radio/*"};
  std::vector<std::string> slots;   ///< names or patterns; empty: all
  std::vector<std::string> topics;  ///< of others' types, in any partition; names or patterns
  std::string from;                 ///< only of this origin (name or number); empty: of all
  double duration = 0;      ///< [s] to listen; 0: 3 s for tables, for ever for samples and events
  double timeout = 0;       ///< [s] for the first sample of echo; 0: no limit
  std::uint64_t count = 0;  ///< samples to print; 0: no limit
  bool json = false;
  std::string where;                ///< only samples that fulfil it (docs/spy.md); empty: all
  std::vector<std::string> fields;  ///< of each sample only these: "task.id"
  std::uint64_t window = 1000;      ///< samples of a flow that hz, bw and delay look back on
  double every = 0;                 ///< [s] hz, bw, delay, links: again and again; 0: once
  bool unmatched = false, mismatch = false, endpoints = false;  ///< of ls
};

/// Does what the verb says, until the duration, the count or Ctrl-C. Data go to `out`, one JSON
/// object a line if asked for (the table: one document), messages to `err`. Exit codes: 0; 1 the
/// doctor found something; 2 wrong options; 3 no DDS; 4 nothing heard, with the reason on `err`.
int spy(const SpyOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::spy_tool
