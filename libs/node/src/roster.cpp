// SPDX-License-Identifier: Apache-2.0
#include "skein/node/roster.hpp"

#include <algorithm>

namespace skein::node {

namespace {

using wire::Role;
using wire::Slot;

constexpr std::uint32_t kFirstUav = 10;
constexpr std::uint32_t kFirstFunctional = 500;

/// The slots a member writes on the world channel. Who leads the clock writes that too
/// (HostConfig).
std::vector<Slot> world_writes_of(Role role) {
  switch (role) {
    case Role::kGround:
      return {Slot::kDirectoryEntry, Slot::kMissionState, Slot::kJournalEntry, Slot::kUavBoard,
              Slot::kUavTasks,       Slot::kGroundBoard,  Slot::kOperatorReply};
    case Role::kOperator:
      return {Slot::kOperatorRequest};
    case Role::kDdn:
      return {Slot::kDirectoryEntry, Slot::kJournalEntry};
    case Role::kSim:
      return {Slot::kDirectoryEntry, Slot::kClock, Slot::kLinkState, Slot::kJournalEntry,
              Slot::kTruth};
    case Role::kFunctional:
      return {Slot::kDirectoryEntry, Slot::kJournalEntry, Slot::kTruth};
    default:
      return {};
  }
}

blackboard::Node as_node(const Member& member) { return {member.number, member.name}; }

}  // namespace

Roster::Roster(const std::vector<std::string>& uavs,
               const std::map<std::string, std::string>& functional)
    : members_{{"ground", Role::kGround, NodeNumber(1)},
               {"sim", Role::kSim, NodeNumber(2)},
               {"runner", Role::kRunner, NodeNumber(3)},
               {"operator", Role::kOperator, NodeNumber(4)}} {
  std::uint32_t number = kFirstUav;
  for (const std::string& uav : uavs) members_.push_back({uav, Role::kDdn, NodeNumber(number++)});
  number = kFirstFunctional;
  for (const std::string& uav : uavs) {
    const auto named = functional.find(uav);
    if (named == functional.end()) continue;
    if (find(named->second) == nullptr) {
      members_.push_back({named->second, Role::kFunctional, NodeNumber(number++)});
    }
    functional_.emplace(find(uav)->number, find(named->second)->number);
  }
}

Roster Roster::only(const std::vector<std::string>& names) const {
  Roster some = *this;
  std::erase_if(some.members_, [&](const Member& member) {
    return std::find(names.begin(), names.end(), member.name) == names.end();
  });
  return some;
}

NodeNumber Roster::functional_of(NodeNumber uav) const {
  const auto found = functional_.find(uav);
  return found == functional_.end() ? sim() : found->second;
}

bool Roster::serves(const Member& functional, const Member& uav) const {
  const bool plays = functional.role == Role::kSim || functional.role == Role::kFunctional;
  return plays && uav.role == Role::kDdn && functional_of(uav.number) == functional.number;
}

const Member* Roster::find(std::string_view name) const {
  const auto found = std::find_if(members_.begin(), members_.end(),
                                  [&](const Member& member) { return member.name == name; });
  return found == members_.end() ? nullptr : &*found;
}

const Member* Roster::find(NodeNumber number) const {
  const auto found = std::find_if(members_.begin(), members_.end(),
                                  [&](const Member& member) { return member.number == number; });
  return found == members_.end() ? nullptr : &*found;
}

std::string Roster::name_of(NodeNumber number) const {
  const Member* member = find(number);
  return member == nullptr ? "node " + to_text(number) : member->name;
}

std::map<NodeNumber, std::string> Roster::names() const {
  std::map<NodeNumber, std::string> names;
  for (const Member& member : members_) names.emplace(member.number, member.name);
  return names;
}

std::vector<blackboard::ChannelConfig> Roster::channels_of(const Member& member) const {
  std::vector<blackboard::ChannelConfig> channels{blackboard::world_channel()};
  channels.front().slots = world_writes_of(member.role);
  const auto add = [&](const std::vector<blackboard::ChannelConfig>& link) {
    channels.insert(channels.end(), link.begin(), link.end());
  };
  for (const Member& other : members_) {
    if (other.number == member.number) continue;
    if (member.role == Role::kGround && other.role == Role::kDdn) {
      add(blackboard::station_link(as_node(member), as_node(other)));
    } else if (member.role == Role::kDdn && other.role == Role::kGround) {
      add(blackboard::station_link(as_node(other), as_node(member)));
    } else if (member.role == Role::kDdn && other.role == Role::kDdn) {
      add(blackboard::radio_link(as_node(member), as_node(other)));
    } else if (serves(other, member)) {
      add(blackboard::onboard_link(as_node(member), as_node(other)));
    } else if (serves(member, other)) {
      add(blackboard::onboard_link(as_node(other), as_node(member)));
    }
  }
  return channels;
}

std::vector<wire::Slot> Roster::world_reads_of(wire::Role role) {
  switch (role) {
    case Role::kGround:
      return {Slot::kClock, Slot::kLinkState, Slot::kOperatorRequest};
    case Role::kDdn:
      return {Slot::kClock, Slot::kLinkState};
    case Role::kOperator:  // what the ground station knows, not what is
      return {Slot::kClock,    Slot::kLinkState,   Slot::kMissionState, Slot::kUavBoard,
              Slot::kUavTasks, Slot::kGroundBoard, Slot::kOperatorReply};
    case Role::kSim:  // where vehicles are that others play: for the radio
      return {Slot::kDirectoryEntry, Slot::kMissionState, Slot::kTruth};
    case Role::kFunctional:
      return {Slot::kClock};
    default:
      break;
  }
  return {Slot::kDirectoryEntry, Slot::kClock,        Slot::kLinkState,
          Slot::kMissionState,   Slot::kJournalEntry, Slot::kTruth};
}

}  // namespace skein::node
