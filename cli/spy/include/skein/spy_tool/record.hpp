// SPDX-License-Identifier: Apache-2.0
// `skein spy record` and `skein spy play`: what is on the wire, into a file and out of it again.
#pragma once

#include <iosfwd>
#include <string>

#include "skein/spy_tool/spy.hpp"

namespace skein::spy_tool {

struct RecordOptions {
  SpyOptions spy;  ///< slots, partitions, duration (0: until Ctrl-C) and count as for echo
  std::string file;
  bool with_json = false;  ///< each sample as JSON too
  bool passive = false;    ///< see blackboard::PassiveObserver
};

/// Writes every sample's bytes as they came, with the partition they came in, to an MCAP file,
/// which is flushed every second: a crash leaves all but the last second. Exit codes: 0, 2 wrong
/// options, 3 no DDS, no right to look, or the file cannot be written, 4 nothing heard.
int record(const RecordOptions& options, std::ostream& out, std::ostream& err);

struct PlayOptions {
  std::uint32_t domain = 0;
  blackboard::NetworkConfig network;
  std::string file;
  double rate = 1;  ///< seconds of the recording per second, > 0
  double wait = 2;  ///< [s] before the first sample, in which readers find the writers
};

/// Writes the samples of a recording again, byte for byte, to the slots and partitions that they
/// were in, at the intervals they came. Exit codes: 0, 2 no recording, 3 no DDS, 130 Ctrl-C.
int play(const PlayOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::spy_tool
