// SPDX-License-Identifier: Apache-2.0
// The nodes of a system, their numbers, and the channels between them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/slot_table.hpp"
#include "skein/foundation/shared_list.hpp"

namespace skein::node {

using blackboard::NodeNumber;

struct Member {
  std::string name;
  wire::Role role = wire::Role::kDdn;
  NodeNumber number;
};

/// All nodes of a scenario. Numbers follow from the scenario alone, so daemons started by hand on
/// different machines agree on them without communication: ground 1, sim 2, runner 3, operators
/// (all of them) 4, UAVs from 10 in the order of the scenario file, separate functional layers from
/// 500 in the order of their UAVs. Copies share what they hold. Source: spec 1.3.
class Roster {
 public:
  /// `uavs`: names of the UAVs, distinct, none of them "ground", "sim", "runner" or "operator".
  /// `functional`: by UAV, the name of the node that is its functional layer, distinct from all
  /// names above. UAVs that are absent there have the simulator as functional layer.
  explicit Roster(const std::vector<std::string>& uavs,
                  const std::map<std::string, std::string>& functional = {});

  const std::vector<Member>& members() const { return *members_; }
  /// The names of the UAVs, in their order.
  SharedList<std::string> uavs() const { return uavs_; }
  const Member* find(std::string_view name) const;
  const Member* find(NodeNumber number) const;
  /// The name, or "node 7" for a number that is not in the roster.
  std::string name_of(NodeNumber number) const;
  std::map<NodeNumber, std::string> names() const;

  NodeNumber ground() const { return NodeNumber(1); }
  NodeNumber sim() const { return NodeNumber(2); }
  NodeNumber runner() const { return NodeNumber(3); }
  NodeNumber operators() const { return NodeNumber(4); }
  /// The functional layer of a UAV of this roster.
  NodeNumber functional_of(NodeNumber uav) const;

  /// A copy of this roster in which these members (ground station, UAVs) are relays.
  Roster relayed_by(const std::vector<std::string>& names) const;
  const std::set<NodeNumber>& relays() const { return relays_; }

  /// A copy of this roster with this slot table instead of SlotTable::shipped().
  Roster with_slots(blackboard::SlotTable table) const;
  const blackboard::SlotTable& slots() const { return *slots_; }

  /// A copy of this roster with these members only; numbers stay. No channels lead to the others.
  Roster only(const std::vector<std::string>& names) const;

  /// Every channel that starts or ends at the member: radio between the ground and each UAV and
  /// between any two UAVs, onboard between a UAV and its functional layer, and the world.
  std::vector<blackboard::ChannelConfig> channels_of(const Member& member) const;
  /// The same without those between two UAVs, which channels_between() gives.
  std::vector<blackboard::ChannelConfig> channels_but_between_uavs(const Member& member) const;
  /// The two channels between two members, radio or onboard; empty if there are none.
  std::vector<blackboard::ChannelConfig> channels_between(const Member& a, const Member& b) const;
  /// The members to which a radio or onboard channel leads.
  std::vector<NodeNumber> peers_of(const Member& member) const;
  /// The slots a member reads on the world channel.
  std::vector<wire::Slot> world_reads_of(wire::Role role) const;

 private:
  void set_members(std::vector<Member> members);
  bool serves(const Member& functional, const Member& uav) const;
  bool are_connected(const Member& a, const Member& b) const;
  std::vector<blackboard::ChannelConfig> radio_between(const Member& a, const Member& b) const;

  std::shared_ptr<const std::vector<Member>> members_;
  SharedList<std::string> uavs_;
  std::set<NodeNumber> relays_;
  std::shared_ptr<const blackboard::SlotTable> slots_;
  /// By UAV; absent: the simulator.
  std::shared_ptr<const std::map<NodeNumber, NodeNumber>> functional_;
};

}  // namespace skein::node
