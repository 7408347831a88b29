// SPDX-License-Identifier: Apache-2.0
// Effects as short words, so that a test reads as a trace: "1 started", "dispatch 1", "refused
// START".
#pragma once

#include <string>
#include <vector>

#include "skein/executive/effect.hpp"

namespace skein::executive::testing {

struct Word {
  std::string operator()(const TaskEvent& e) const {
    return to_text(e.id) + " " + std::string(to_text(e.state));
  }
  std::string operator()(const Dispatch& e) const {
    return (e.joint ? "dispatch joint " : "dispatch ") + to_text(e.id);
  }
  std::string operator()(const Interrupt& e) const {
    return (e.joint ? "interrupt joint " : "interrupt ") + to_text(e.id);
  }
  std::string operator()(const SendSync& e) const {
    const bool there = e.word == SyncWord::kThere;
    return "sync " + std::to_string(e.id) + " to " + e.to +
           (there ? "" : " " + std::string(to_text(e.word)));
  }
  std::string operator()(const Reply& e) const {
    return (e.accepted ? "accepted " : "refused ") + std::string(to_text(e.request));
  }
  std::string operator()(const ForwardToSupervisor& e) const {
    return "forward " + (*this)(e.event);
  }
  std::string operator()(const Notice&) const { return ""; }
};

/// Without notices.
inline std::vector<std::string> show(const Effects& effects) {
  std::vector<std::string> words;
  for (const Effect& effect : effects) {
    std::string word = std::visit(Word{}, effect);
    if (!word.empty()) words.push_back(std::move(word));
  }
  return words;
}

/// The same without the replies of accepted requests.
inline std::vector<std::string> show_happenings(const Effects& effects) {
  std::vector<std::string> words = show(effects);
  std::erase_if(words, [](const std::string& word) { return word.rfind("accepted", 0) == 0; });
  return words;
}

}  // namespace skein::executive::testing
