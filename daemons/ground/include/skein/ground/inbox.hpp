// SPDX-License-Identifier: Apache-2.0
// What samples mean to the ground station.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/tally.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "skein/journal/record.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::ground {

/// Makes inputs of GroundControl of what comes to the node. What does not come from the decision
/// node of a UAV, answers another UAV's command, or makes no sense, is refused, which is said once
/// for each sender and slot. Thread rule: one thread. Cost: that of the sample.
/// Source: spec 1.1, 1.3.
class Inbox {
 public:
  using Input = ground_station::GroundControl::Input;
  /// What an operator asks in a text, or every reason why that says nothing of sense.
  using ReadRequest =
      std::function<Result<std::vector<ground_station::OperatorDeed>, std::vector<std::string>>(
          const std::string& text)>;

  /// Without a reader every request of an operator is refused. The roster must outlive this.
  Inbox(const node::Roster& roster, ReadRequest read_request);

  struct Read {
    std::optional<Input> input;              ///< absent: it is nothing for GroundControl
    std::optional<journal::Record> refusal;  ///< for the event log
  };
  Read read(const node::Input& input, MissionTime now);

  /// The line for the event log about a sample that makes no sense; absent: said already.
  std::optional<journal::Record> refuse(const node::Received& received,
                                        const wire::Violation& violation, MissionTime now);
  static constexpr std::size_t kAddressees = 1024;

  /// Only this node answers that command from now on, until kAddressees more were sent.
  void sent(std::uint64_t command, node::NodeNumber addressee);
  bool is_uav(node::NodeNumber number) const;

 private:
  std::string why_not(const node::Received& received) const;
  Result<std::optional<Input>, wire::Violation> input_from(const node::Received& received) const;
  Input request_from(const wire::OperatorRequest& request) const;

  const node::Roster& roster_;
  ReadRequest read_request_;
  /// Of the last commands, by number; whoever answers an older one, nobody waits for it.
  std::map<std::uint64_t, node::NodeNumber> addressees_;
  Tally<std::pair<node::NodeNumber, wire::Slot>> refused_{256};
};

}  // namespace skein::ground
