// SPDX-License-Identifier: Apache-2.0
// Conversion of samples to inputs of the ground station.
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

/// Converts received samples to inputs of GroundControl. Refuses samples that are not from the
/// decision node of a UAV, that answer another UAV's command, or that are invalid, with one record
/// per sender and slot. Thread rule: one thread. Cost: linear in the sample.
/// Source: spec 1.1, 1.3.
class Inbox {
 public:
  using Input = ground_station::GroundControl::Input;
  /// Parses a request of an operator; all errors at once.
  using ReadRequest =
      std::function<Result<std::vector<ground_station::OperatorDeed>, std::vector<std::string>>(
          const std::string& text)>;

  /// Without a reader every request of an operator is refused. The roster must outlive this object.
  Inbox(const node::Roster& roster, ReadRequest read_request);

  struct Read {
    std::optional<Input> input;              ///< absent: the sample is not for GroundControl
    std::optional<journal::Record> refusal;  ///< for the event log
  };
  Read read(const node::Input& input, MissionTime now);

  /// The event log record about an invalid sample; absent: already reported.
  std::optional<journal::Record> refuse(const node::Received& received,
                                        const wire::Violation& violation, MissionTime now);
  static constexpr std::size_t kAddressees = 1024;

  /// Records the addressee of a command: answers of other nodes to it are refused, until
  /// kAddressees further commands were sent.
  void sent(std::uint64_t command, node::NodeNumber addressee);
  bool is_uav(node::NodeNumber number) const;

 private:
  std::string why_not(const node::Received& received) const;
  Result<std::optional<Input>, wire::Violation> input_from(const node::Received& received) const;
  Input request_from(const wire::OperatorRequest& request) const;

  const node::Roster& roster_;
  ReadRequest read_request_;
  /// Addressees of the last commands, by number; no one waits for answers to older ones.
  std::map<std::uint64_t, node::NodeNumber> addressees_;
  Tally<std::pair<node::NodeNumber, wire::Slot>> refused_{256};
};

}  // namespace skein::ground
