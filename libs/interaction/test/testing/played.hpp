// SPDX-License-Identifier: Apache-2.0
// An automaton as text, played.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "skein/interaction/engine.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "testing/show.hpp"

namespace skein::interaction::testing {

/// A started engine; what it does is collected as lines without their instants.
class Played {
 public:
  explicit Played(const std::string& automaton, double start = 0) {
    auto read = read_automaton(automaton, "test");
    if (!read) throw std::invalid_argument(to_text(read.error()));
    engine_ = std::make_unique<Engine>(std::make_shared<const Automaton>(std::move(*read)));
    at(start, Start{});
  }

  Played& at(double seconds, const Input& input) {
    const auto effects = engine_->handle(input, MissionTime::seconds(seconds));
    refusal_ = effects ? "" : effects.error().why;
    lines_.clear();
    for (const std::string& line : show(effects.value_or(Effects{}))) {
      instants_.push_back(line.substr(0, line.find(' ')));
      lines_.push_back(line.substr(line.find(' ') + 1));
    }
    seconds_ = seconds;
    return *this;
  }
  Played& running(const std::string& id) {
    return at(seconds_, Status{id, Status::Word::kRunning});
  }
  Played& ended(const std::string& id) { return at(seconds_, Status{id, Status::Word::kEnded}); }
  Played& aborted(const std::string& id) {
    return at(seconds_, Status{id, Status::Word::kAborted});
  }
  Played& message(const std::string& text) { return at(seconds_, Message{text}); }

  /// Of the last input.
  const std::vector<std::string>& lines() const { return lines_; }
  const std::string& refusal() const { return refusal_; }
  /// Of the last effect.
  std::string last_instant() const { return instants_.empty() ? "" : instants_.back(); }
  ComponelState state(const std::string& id) const {
    return engine_->state(*engine_->automaton().find(id));
  }
  const Engine& engine() const { return *engine_; }

 private:
  std::unique_ptr<Engine> engine_;
  std::vector<std::string> lines_, instants_;
  std::string refusal_;
  double seconds_ = 0;
};

}  // namespace skein::interaction::testing
