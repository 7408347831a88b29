// SPDX-License-Identifier: Apache-2.0
// A node that does what a test says and keeps what it was given.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "skein/blackboard/link_instance.hpp"
#include "skein/node/node.hpp"

namespace skein::node::testing {

/// What a FakeNode was given, and what it answers; outlives the node.
struct Diary {
  std::vector<std::pair<MissionTime, Input>> inputs;
  std::function<Effects(const Input&, MissionTime)> answer;
  /// Given once, with the next input, if there is no `answer`.
  Effects effects;
  std::optional<MissionTime> wakeup;

  /// The inputs of one kind, in order.
  template <class T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const auto& [at, input] : inputs) {
      if (const auto* one = std::get_if<T>(&input)) found.push_back(*one);
    }
    return found;
  }
  /// The samples of one slot, in order.
  template <class T>
  std::vector<T> samples() const {
    std::vector<T> found;
    for (const Received& received : all<Received>()) {
      if (const auto* one = std::get_if<T>(&received.sample)) found.push_back(*one);
    }
    return found;
  }
};

class FakeNode final : public Node {
 public:
  explicit FakeNode(Diary& diary) : diary_(diary) {}

  Effects handle(const Input& input, MissionTime now) override {
    diary_.inputs.emplace_back(now, input);
    if (std::holds_alternative<Wakeup>(input)) diary_.wakeup.reset();
    return diary_.answer ? diary_.answer(input, now) : std::exchange(diary_.effects, {});
  }
  std::optional<MissionTime> next_wakeup() const override { return diary_.wakeup; }

 private:
  Diary& diary_;
};

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

inline wire::TaskRequest abort_request(std::uint64_t id) {
  wire::TaskRequest request;
  request.kind = wire::RequestKind::kAbort;
  request.id = id;
  return request;
}

inline wire::LinkState link(NodeNumber from, NodeNumber to, bool up) {
  wire::LinkState state;
  state.header.instance = blackboard::link_instance(from, to);
  state.from = from.value();
  state.to = to.value();
  state.up = up;
  return state;
}

}  // namespace skein::node::testing
