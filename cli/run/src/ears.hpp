// SPDX-License-Identifier: Apache-2.0
// What a runner hears by: its board and the transport below.
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
  /// The roster outlives it.
  Ears(blackboard::DdsConfig config, const node::Roster& roster, std::function<void()> notify)
      : config_(std::move(config)), roster_(roster), notify_(std::move(notify)) {}

  /// A second call begins anew, as another participant with endpoints and ports of its own: what is
  /// wrong between the one before and somebody else is left behind. Records that were heard are
  /// not heard again, and of the others what their writers still have is. After an error it hears
  /// as before.
  Result<void, Failure> open(blackboard::Now now);
  /// What has come since. Precondition: opened.
  std::vector<blackboard::Incoming> listen(blackboard::Now now);

 private:
  /// Not a record that was heard before; then it is the last of its node.
  bool is_news(const blackboard::Incoming& incoming);

  blackboard::DdsConfig config_;
  const node::Roster& roster_;
  std::function<void()> notify_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  std::vector<blackboard::Incoming> last_;                  ///< words of the participant before
  using Version = std::pair<std::uint64_t, std::uint64_t>;  ///< incarnation, sequence
  std::map<blackboard::NodeNumber, Version> records_;       ///< the last of each node
};

}  // namespace skein::run_tool
