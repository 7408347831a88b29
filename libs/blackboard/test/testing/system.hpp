// SPDX-License-Identifier: Apache-2.0
// A small system of blackboards over one kind of transport, for the laws that all kinds share.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::testing {

inline const Node kGround{NodeNumber(1), "ground"};
inline const Node kSim{NodeNumber(2), "sim"};
inline const Node kMarvin{NodeNumber(3), "marvin"};

/// Where transports and time come from; one implementation per adapter.
class Medium {
 public:
  virtual ~Medium() = default;
  virtual std::unique_ptr<Transport> transport(const std::string& node) = 0;
  virtual Duration steady() const = 0;
  /// Lets time pass: until something arrives, or at most until `wakeup`.
  virtual void wait(Duration wakeup) = 0;
};
std::unique_ptr<Medium> make_medium();

/// ground and marvin over radio, marvin and sim on board, everybody in the world.
class System {
 public:
  System() : medium_(make_medium()) {}

  /// Starts or restarts a node; it reads all world slots.
  void start(const Node& node) { start_process(node.number, node); }
  /// A second process with the number of the node: a later life that runs beside it.
  void start_second(const Node& node) { start_process(second_of(node), node); }
  /// The process of the node dies: nothing of it remains.
  void kill(const Node& node) { nodes_.erase(node.number); }
  void kill_second(const Node& node) { nodes_.erase(second_of(node)); }

  Blackboard& operator[](const Node& node) { return *nodes_.at(node.number).blackboard; }
  Blackboard& second(const Node& node) { return *nodes_.at(second_of(node)).blackboard; }
  Now now() const { return {mission, medium_->steady()}; }
  Medium& medium() { return *medium_; }
  /// Sets the directed radio channel at both ends.
  void set_condition(const Node& from, const Node& to, const ChannelCondition& condition);
  void set_link(const Node& a, const Node& b, bool up);

  /// Everything that the node has received since it was started.
  const std::vector<Incoming>& received(const Node& node) {
    return nodes_.at(node.number).received;
  }
  /// The values of one slot among them.
  template <class T>
  std::vector<T> values(const Node& node) {
    std::vector<T> found;
    for (const Incoming& incoming : received(node)) {
      const auto* received = std::get_if<Received>(&incoming);
      if (received == nullptr) continue;
      if (const auto* value = std::get_if<T>(&received->sample)) found.push_back(*value);
    }
    return found;
  }
  /// The reports of one kind among them.
  template <class T>
  std::vector<T> reports(const Node& node) {
    std::vector<T> found;
    for (const Incoming& incoming : received(node)) {
      if (const auto* report = std::get_if<T>(&incoming)) found.push_back(*report);
    }
    return found;
  }

  /// Runs all nodes until the condition holds; false if it does not within a generous time.
  bool run_until(const std::function<bool()>& condition);
  bool run_until_reachable(const Node& a, const Node& b, bool reachable = true);

  MissionTime mission;
  std::size_t held_events = 1024;

 private:
  struct Running {
    std::unique_ptr<Transport> transport;
    std::unique_ptr<Blackboard> blackboard;
    std::vector<Incoming> received;
  };
  static NodeNumber second_of(const Node& node) { return NodeNumber(node.number.value() + 100); }
  void start_process(NodeNumber process, const Node& node);
  void step_all();

  std::unique_ptr<Medium> medium_;
  std::map<NodeNumber, Running> nodes_;
  std::map<NodeNumber, std::uint64_t> incarnations_;
};

}  // namespace skein::blackboard::testing
