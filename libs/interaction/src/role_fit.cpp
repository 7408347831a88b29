// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/role_fit.hpp"

#include <deque>
#include <memory>

#include "skein/interaction/engine.hpp"

namespace skein::interaction {

namespace {

/// Plays an automaton whose tasks all end well, one after the other.
class NominalPlay {
 public:
  explicit NominalPlay(const Automaton& automaton)
      : engine_(std::make_shared<const Automaton>(automaton)) {}

  std::vector<NominalStep> play() {
    note(engine_.handle(Start{}, now_));
    while (!engine_.is_over() && !again_) {
      if (!running_.empty()) {
        const std::string task = running_.front();
        running_.pop_front();
        note(engine_.handle(Status{task, Status::Word::kRunning}, now_));
        note(engine_.handle(Status{task, Status::Word::kEnded}, now_));
      } else if (const auto wakeup = engine_.next_wakeup()) {
        now_ = *wakeup;
        note(engine_.handle(Tick{}, now_));
      } else {
        break;  // it waits for what does not come
      }
    }
    return std::move(steps_);
  }

 private:
  void note(const Result<Effects, Failure>& effects) {
    for (const Effect& effect : *effects) {
      if (const auto* compute = std::get_if<Compute>(&effect.what)) {
        computed_.push_back(compute->parameter);
      } else if (const auto* run = std::get_if<Run>(&effect.what)) {
        begin(run->task);
      } else if (const auto* interrupt = std::get_if<Interrupt>(&effect.what)) {
        running_.push_front(interrupt->task);
      }
    }
  }

  void begin(const std::string& task) {
    again_ = again_ || !begun_.insert(task).second;
    if (again_) return;
    steps_.push_back({task, std::move(computed_)});
    computed_.clear();
    running_.push_back(task);
  }

  Engine engine_;
  MissionTime now_;
  std::vector<NominalStep> steps_;
  std::vector<std::string> computed_;
  std::deque<std::string> running_;
  std::set<std::string> begun_;
  bool again_ = false;
};

}  // namespace

std::vector<NominalStep> nominal_path(const Automaton& automaton) {
  return NominalPlay(automaton).play();
}

const Variant* variant_for(const Model& model, std::size_t members) {
  for (const Variant& variant : model.variants) {
    std::size_t least = 0, most = 0;
    bool open = false;
    for (const auto& [role, arity] : variant.table.arities) {
      least += static_cast<std::size_t>(arity.least);
      most += static_cast<std::size_t>(arity.most.value_or(0));
      open = open || !arity.most;
    }
    if (least <= members && (open || members <= most)) return &variant;
  }
  return nullptr;
}

}  // namespace skein::interaction
