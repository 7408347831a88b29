// SPDX-License-Identifier: Apache-2.0
// Agents whose messages are handed over one at a time, in the order they were sent.
#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skein/temporal/agent.hpp"

namespace skein::temporal::testing {

inline MissionTime at(std::int64_t ns) { return MissionTime::nanoseconds(ns); }

/// A network by names: `MastnBuilder().node("a1", "A")…`.
class MastnBuilder {
 public:
  MastnBuilder() {
    network_.nodes.emplace_back("v0");
    network_.owner.push_back(0);
  }
  MastnBuilder& node(const std::string& name, const std::string& agent) {
    network_.nodes.push_back(name);
    network_.owner.push_back(place(network_.agents, agent, true));
    return *this;
  }
  MastnBuilder& arc(const std::string& from, const std::string& to, Ticks min, Ticks max) {
    network_.arcs.push_back(
        {place(network_.nodes, from, false), place(network_.nodes, to, false), min, max});
    return *this;
  }
  operator Mastn() const { return network_; }  // NOLINT(google-explicit-constructor): a builder

 private:
  static std::uint32_t place(std::vector<std::string>& names, const std::string& name, bool add) {
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return i;
    }
    EXPECT_TRUE(add) << name;
    names.push_back(name);
    return static_cast<std::uint32_t>(names.size() - 1);
  }
  Mastn network_;
};

/// Two agents with an external arc: v0 -[0,10]-> a1 -[5,20]-> a2 =[0,100]=> b1 -[5,20]-> b2, and
/// v0 -[0,200]-> b2. Nodes 1 to 4, arcs 0 to 4 in this order.
inline Mastn two_agents() {
  return MastnBuilder()
      .node("a1", "A")
      .node("a2", "A")
      .node("b1", "B")
      .node("b2", "B")
      .arc("v0", "a1", 0, 10)
      .arc("a1", "a2", 5, 20)
      .arc("a2", "b1", 0, 100)
      .arc("b1", "b2", 5, 20)
      .arc("v0", "b2", 0, 200);
}

class PostOffice {
 public:
  PostOffice(Algorithm algorithm, const Mastn& network, const AgentOptions& options = {})
      : network_(network) {
    for (AgentIndex i = 0; i < network.agents.size(); ++i) {
      agents_.push_back(make_agent(algorithm, network, i, options).value());
    }
    if (algorithm == Algorithm::kCip) agents_.push_back(make_supervisor(network, options).value());
    for (auto& agent : agents_) post(agent->start(at(0)).messages);
  }

  Agent& agent(AgentIndex index) { return *agents_[index]; }
  std::deque<Message>& box() { return box_; }

  /// The owner of the arcs is told; its messages are posted and returned.
  std::vector<Message> disturb(const std::vector<ArcUpdate>& changes, MissionTime now = at(0)) {
    const AgentIndex owner = owner_of(network_, network_.arcs[changes.front().arc]);
    auto output = agents_[owner]->on_disturbance(changes, now);
    EXPECT_TRUE(output.has_value());
    post(output->messages);
    return output->messages;
  }

  void post(const std::vector<Message>& messages) {
    for (const Message& message : messages) {
      if (message.receiver) {
        box_.push_back(message);
        continue;
      }
      for (AgentIndex i = 0; i < agents_.size(); ++i) {
        if (i == message.sender) continue;
        box_.push_back(message);
        box_.back().receiver = i;
      }
    }
  }

  /// Hands over the first message; gives it.
  Message deliver_one(MissionTime now = at(0)) {
    Message message = box_.front();
    box_.pop_front();
    auto output = agents_[*message.receiver]->on_message(message, now);
    EXPECT_TRUE(output.has_value()) << to_text(output.error().error);
    if (output) post(output->messages);
    return message;
  }

  std::vector<Message> deliver_all(MissionTime now = at(0)) {
    std::vector<Message> delivered;
    while (!box_.empty() && delivered.size() < 10'000) delivered.push_back(deliver_one(now));
    EXPECT_TRUE(box_.empty());
    return delivered;
  }

  /// What is in the box between the two is lost, and both are told.
  void cut(AgentIndex one, AgentIndex other, MissionTime now = at(0)) {
    std::erase_if(box_, [&](const Message& m) {
      return (m.sender == one && m.receiver == other) || (m.sender == other && m.receiver == one);
    });
    tell(one, other, false, now);
    tell(other, one, false, now);
  }
  void heal(AgentIndex one, AgentIndex other, MissionTime now = at(0)) {
    tell(one, other, true, now);
    tell(other, one, true, now);
  }

  std::pair<Ticks, Ticks> window(NodeIndex node) {
    Agent& owner = *agents_[network_.owner[node]];
    return {owner.earliest(node), owner.latest(node)};
  }

 private:
  void tell(AgentIndex agent, AgentIndex peer, bool up, MissionTime now) {
    auto output = agents_[agent]->on_link(peer, up, now);
    ASSERT_TRUE(output.has_value());
    post(output->messages);
  }

  Mastn network_;
  std::vector<std::unique_ptr<Agent>> agents_;
  std::deque<Message> box_;
};

using Window = std::pair<Ticks, Ticks>;

}  // namespace skein::temporal::testing
