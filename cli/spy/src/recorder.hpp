// SPDX-License-Identifier: Apache-2.0
// Samples into an MCAP file, and out of one.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/mcap/scan.hpp"
#include "skein/mcap/writer.hpp"

namespace skein::spy_tool {

/// A sample as it was on the wire.
struct Taken {
  wire::Slot slot = wire::Slot::kHeartbeat;
  std::string partition;
  std::uint64_t heard = 0, sent = 0;  ///< [ns since 1970]
  std::string bytes;                  ///< CDR behind its 4-byte header
  bool operator==(const Taken&) const = default;
};

/// Writes each sample's bytes as they are: a channel for each slot and partition, topic
/// "PARTITION/SLOT", encoding cdr, schema omgidl. With JSON another one beside it, topic
/// ".../json", that opens everywhere. No clock: the caller flushes.
class Recorder {
 public:
  Recorder(bool with_json, mcap::Writer::Sink sink);

  void take(const Taken& taken);
  void flush() { writer_.flush(); }
  void close() { writer_.close(); }
  std::uint64_t samples() const { return samples_; }
  std::uint64_t bytes() const { return writer_.bytes(); }

 private:
  struct Pair {
    mcap::ChannelId cdr = 0, json = 0;
  };
  const Pair& channels_of(const Taken& taken);
  void write_json(mcap::ChannelId channel, const Taken& taken);

  bool with_json_;
  mcap::Writer writer_;
  std::map<wire::Slot, mcap::SchemaId> schemas_;
  mcap::SchemaId any_json_ = 0;
  std::map<std::pair<std::string, wire::Slot>, Pair> channels_;
  std::uint64_t samples_ = 0;
};

/// Hands over the samples of a file, in its order; other channels are passed over. What the scan
/// says of the file.
mcap::Contents samples_of(std::string_view file, const std::function<void(Taken)>& use);

}  // namespace skein::spy_tool
