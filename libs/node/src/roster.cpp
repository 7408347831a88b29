// SPDX-License-Identifier: Apache-2.0
#include "skein/node/roster.hpp"

#include <algorithm>
#include <utility>

namespace skein::node {

namespace {

using blackboard::Party;
using wire::Role;

constexpr std::uint32_t kFirstUav = 10;
constexpr std::uint32_t kFirstFunctional = 500;

/// Who leads the clock writes that too, whatever its role (HostConfig).
Party party_of(Role role) {
  switch (role) {
    case Role::kGround:
      return Party::kGround;
    case Role::kDdn:
      return Party::kUav;
    case Role::kSim:
      return Party::kSim;
    case Role::kFunctional:
      return Party::kFunctional;
    case Role::kOperator:
      return Party::kOperator;
    default:
      return Party::kOthers;
  }
}

bool has_radio(Role role) { return role == Role::kGround || role == Role::kDdn; }

blackboard::Node as_node(const Member& member) { return {member.number, member.name}; }

}  // namespace

Roster::Roster(const std::vector<std::string>& uavs,
               const std::map<std::string, std::string>& functional)
    : slots_(std::shared_ptr<void>(), &blackboard::SlotTable::shipped()) {
  std::vector<Member> members{{"ground", Role::kGround, NodeNumber(1)},
                              {"sim", Role::kSim, NodeNumber(2)},
                              {"runner", Role::kRunner, NodeNumber(3)},
                              {"operator", Role::kOperator, NodeNumber(4)}};
  std::uint32_t number = kFirstUav;
  for (const std::string& uav : uavs) members.push_back({uav, Role::kDdn, NodeNumber(number++)});
  std::map<NodeNumber, NodeNumber> layers;
  std::map<std::string, NodeNumber> numbers;
  number = kFirstFunctional;
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    const auto named = functional.find(uavs[i]);
    if (named == functional.end()) continue;
    const auto [layer, is_new] = numbers.try_emplace(named->second, number);
    if (is_new) members.push_back({named->second, Role::kFunctional, NodeNumber(number++)});
    layers.emplace(NodeNumber(kFirstUav + static_cast<std::uint32_t>(i)), layer->second);
  }
  set_members(std::move(members));
  functional_ = std::make_shared<const std::map<NodeNumber, NodeNumber>>(std::move(layers));
}

Roster Roster::only(const std::vector<std::string>& names) const {
  std::vector<Member> some = *members_;
  std::erase_if(some, [&](const Member& member) {
    return std::find(names.begin(), names.end(), member.name) == names.end();
  });
  Roster roster = *this;
  roster.set_members(std::move(some));
  return roster;
}

void Roster::set_members(std::vector<Member> members) {
  std::vector<std::string> uavs;
  for (const Member& member : members)
    if (member.role == Role::kDdn) uavs.push_back(member.name);
  uavs_ = std::move(uavs);
  members_ = std::make_shared<const std::vector<Member>>(std::move(members));
}

Roster Roster::relayed_by(const std::vector<std::string>& names) const {
  Roster relayed = *this;
  for (const std::string& name : names) {
    const Member* member = find(name);
    if (member != nullptr) relayed.relays_.insert(member->number);
  }
  return relayed;
}

Roster Roster::with_slots(blackboard::SlotTable table) const {
  Roster other = *this;
  other.slots_ = std::make_shared<const blackboard::SlotTable>(std::move(table));
  return other;
}

NodeNumber Roster::functional_of(NodeNumber uav) const {
  const auto found = functional_->find(uav);
  return found == functional_->end() ? sim() : found->second;
}

bool Roster::serves(const Member& functional, const Member& uav) const {
  const bool plays = functional.role == Role::kSim || functional.role == Role::kFunctional;
  return plays && uav.role == Role::kDdn && functional_of(uav.number) == functional.number;
}

const Member* Roster::find(std::string_view name) const {
  const auto found = std::ranges::find(*members_, name, &Member::name);
  return found == members_->end() ? nullptr : &*found;
}

const Member* Roster::find(NodeNumber number) const {
  const auto found = std::ranges::find(*members_, number, &Member::number);
  return found == members_->end() ? nullptr : &*found;
}

std::string Roster::name_of(NodeNumber number) const {
  const Member* member = find(number);
  return member == nullptr ? "node " + to_text(number) : member->name;
}

std::map<NodeNumber, std::string> Roster::names() const {
  std::map<NodeNumber, std::string> names;
  for (const Member& member : *members_) names.emplace(member.number, member.name);
  return names;
}

std::vector<blackboard::ChannelConfig> Roster::channels_of(const Member& member) const {
  std::vector<blackboard::ChannelConfig> channels = channels_but_between_uavs(member);
  if (member.role != Role::kDdn) return channels;
  for (const Member& other : *members_) {
    if (other.role != Role::kDdn) continue;
    const auto link = channels_between(member, other);
    channels.insert(channels.end(), link.begin(), link.end());
  }
  channels.shrink_to_fit();  // kept by every node of a large team
  return channels;
}

std::vector<blackboard::ChannelConfig> Roster::channels_but_between_uavs(
    const Member& member) const {
  std::vector<blackboard::ChannelConfig> channels{blackboard::world_channel()};
  channels.front().slots = slots_->between(party_of(member.role), Party::kWorld);
  for (const Member& other : *members_) {
    if (member.role == Role::kDdn && other.role == Role::kDdn) continue;
    const auto link = channels_between(member, other);
    channels.insert(channels.end(), link.begin(), link.end());
  }
  return channels;
}

std::vector<blackboard::ChannelConfig> Roster::channels_between(const Member& a,
                                                                const Member& b) const {
  if (!are_connected(a, b)) return {};
  if (has_radio(a.role) && has_radio(b.role)) return radio_between(a, b);
  const bool is_served = serves(b, a);
  return blackboard::onboard_link(as_node(is_served ? a : b), as_node(is_served ? b : a), *slots_);
}

std::vector<NodeNumber> Roster::peers_of(const Member& member) const {
  std::vector<NodeNumber> peers;
  for (const Member& other : *members_)
    if (are_connected(member, other)) peers.push_back(other.number);
  return peers;
}

bool Roster::are_connected(const Member& a, const Member& b) const {
  if (a.number == b.number) return false;
  return (has_radio(a.role) && has_radio(b.role)) || serves(a, b) || serves(b, a);
}

std::vector<blackboard::ChannelConfig> Roster::radio_between(const Member& a,
                                                             const Member& b) const {
  if (b.role == Role::kGround) return radio_between(b, a);
  std::vector<blackboard::ChannelConfig> link =
      a.role == Role::kGround ? blackboard::station_link(as_node(a), as_node(b), *slots_)
                              : blackboard::radio_link(as_node(a), as_node(b), *slots_);
  if (relays_.empty()) return link;
  for (blackboard::ChannelConfig& channel : link) {
    blackboard::RelayEnds ends;
    ends.from = relays_.contains(channel.from);
    ends.to = relays_.contains(channel.to);
    ends.from_station = channel.from == ground();
    ends.to_station = channel.to == ground();
    blackboard::add_relayed(channel, ends, *slots_);
  }
  return link;
}

std::vector<wire::Slot> Roster::world_reads_of(wire::Role role) const {
  return slots_->between(Party::kWorld, party_of(role));
}

}  // namespace skein::node
