// SPDX-License-Identifier: Apache-2.0
// The DDS reception of a runner: its blackboard and the transport below.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"
#include "skein/node/roster.hpp"

namespace skein::run_tool {

/// Reads the world channel as the runner. Thread rule: one thread; `notify` is called from others.
class Ears {
 public:
  /// The roster must outlive this object.
  Ears(blackboard::DdsConfig config, const node::Roster& roster, std::function<void()> notify)
      : config_(std::move(config)), roster_(roster), notify_(std::move(notify)) {}

  /// Opens the DDS participant. A second call replaces it by a new one with its own endpoints and
  /// ports, which resolves discovery problems of the old one. Records received before are not
  /// delivered again; missed ones are, if their writers still have them. After an error the old
  /// participant stays in use.
  Result<void, Failure> open(blackboard::Now now);
  /// Samples received since the last call. Precondition: opened.
  std::vector<blackboard::Incoming> listen(blackboard::Now now);

 private:
  /// Not a record that was heard before; then it is the last of its process.
  bool is_news(const blackboard::Incoming& incoming);

  blackboard::DdsConfig config_;
  const node::Roster& roster_;
  std::function<void()> notify_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  std::vector<blackboard::Incoming> last_;  ///< words of the participant before
  /// Node and incarnation: of two processes with one name both may speak.
  using Process = std::pair<blackboard::NodeNumber, std::uint64_t>;
  std::map<Process, std::uint64_t> records_;  ///< sequence number of the last record
};

}  // namespace skein::run_tool
