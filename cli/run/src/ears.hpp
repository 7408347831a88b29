// SPDX-License-Identifier: Apache-2.0
// The DDS reception of a runner: its blackboard and the transport below.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "heard_records.hpp"
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
  bool is_news(const blackboard::Incoming& incoming);

  blackboard::DdsConfig config_;
  const node::Roster& roster_;
  std::function<void()> notify_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  std::vector<blackboard::Incoming> last_;  ///< words of the participant before
  HeardRecords records_;
};

}  // namespace skein::run_tool
