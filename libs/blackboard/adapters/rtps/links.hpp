// SPDX-License-Identifier: Apache-2.0
// What the transports over RTPS have in common: the channels of a node, and what comes in on them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "adapters/rtps/awaited_writers.hpp"
#include "adapters/rtps/heartbeat_reader.hpp"
#include "adapters/rtps/link.hpp"
#include "adapters/rtps/mailbox.hpp"
#include "adapters/rtps/matches.hpp"
#include "adapters/rtps/scouts.hpp"
#include "skein/blackboard/dds_config.hpp"

namespace skein::blackboard::rtps {

/// The reader of all heartbeats over radio is one more channel to the vendor, behind the others.
/// Thread rule: that of Transport; mailbox(), awaited() and matches() are for the middleware's
/// threads, too.
class Links {
 public:
  using Make = std::function<std::unique_ptr<Endpoints>(std::size_t channel, const LinkPlan& link)>;

  /// Once, before the middleware tells of others.
  void plan(const TransportPlan& plan, const DdsConfig& config);
  /// The slots that the node writes, on any channel; known once it is planned.
  std::set<wire::Slot> written() const;
  /// Once, after it: all channels, with the endpoints that the vendor makes.
  Result<void, Failure> open(const Make& make);

  /// As those of Transport.
  bool write(std::size_t channel, const wire::Sample& sample);
  Result<void, Failure> set_up(std::size_t channel, bool up);
  std::vector<Arrival> take();
  /// The last words of the node: waits, within bounds, until everybody in the world has got them.
  void flush();
  /// The end: all channels are taken down.
  void close();

  Mailbox& mailbox() { return mailbox_; }
  AwaitedWriters& awaited() { return awaited_; }
  Matches& matches() { return matches_; }

 private:
  Result<void, Failure> open_one(std::size_t channel, const LinkPlan& plan, const Make& make);
  /// Those that came by the reader of heartbeats are of the channels that they were said on.
  std::vector<Arrival> sorted(std::vector<Arrival> arrivals) const;

  Mailbox mailbox_;
  AwaitedWriters awaited_{mailbox_};
  Matches matches_{mailbox_};
  std::vector<LinkPlan> plans_;
  std::optional<HeartbeatReader> heartbeats_;
  std::optional<LinkPlan> scouts_;
  Link::Log log_;
  std::vector<Link> links_;  ///< by channel; behind them those of heartbeats and scouts, if any
};

}  // namespace skein::blackboard::rtps
