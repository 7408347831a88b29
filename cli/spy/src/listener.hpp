// SPDX-License-Identifier: Apache-2.0
// The spy's ears: readers in any partitions, no writers.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "skein/blackboard/dds_transport.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/node/waker.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::spy_tool {

/// One thing heard, whatever it is.
struct Heard {
  Duration at;  ///< steady
  const std::variant<wire::Sample, blackboard::Malformed>& content;
};

class Listener {
 public:
  using Tap = std::function<void(const blackboard::RawSample&)>;

  /// Wrong slots are errors of the options. `tap`: as in DdsConfig.
  explicit Listener(const SpyOptions& options, Tap tap = {})
      : options_(options), tap_(std::move(tap)) {}

  /// Slots that are no slots, with the nearest that are.
  Diagnostics check() const;
  Result<void, Failure> open();
  /// Hands over everything heard until `until` (none: for ever), Ctrl-C, or `use` says false.
  void listen(std::optional<Duration> until, const std::function<bool(const Heard&)>& use);

  /// The node's name if its directory entry was heard, else "node 7".
  std::string name_of(std::uint32_t number) const;
  const std::map<std::uint32_t, wire::DirectoryEntry>& directory() const { return directory_; }
  bool wanted(wire::Slot slot) const;
  bool interrupted() const { return waker_.stop_requested(); }

 private:
  bool hear(const blackboard::Arrival& arrival, const std::function<bool(const Heard&)>& use);

  const SpyOptions& options_;
  Tap tap_;
  node::Waker waker_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::map<std::uint32_t, wire::DirectoryEntry> directory_;
};

}  // namespace skein::spy_tool
