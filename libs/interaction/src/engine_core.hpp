// SPDX-License-Identifier: Apache-2.0
// The engine in three layers: facts (states, messages, instants), formulas to evaluate again, and
// transitions.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agenda.hpp"
#include "compiled.hpp"
#include "skein/interaction/engine.hpp"
#include "truth.hpp"

namespace skein::interaction {

class Engine::Core {
 public:
  explicit Core(std::shared_ptr<const Automaton> automaton);

  Result<Effects, Failure> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const { return agenda_.next(); }
  ComponelState state(ComponelIndex componel) const { return entries_[componel].state; }
  bool is_over() const { return over_; }
  const Automaton& automaton() const { return *automaton_; }

 private:
  /// The set that a block is in (Engine: BI, BA or out); other componels are always out.
  enum class Place : std::uint8_t { kOut, kInactive, kActive };
  /// What a leaving block does when all its content is over.
  enum class Leaving : std::uint8_t { kNot, kToAborted, kToEnded, kToRestart };

  struct Entry {
    ComponelState state = ComponelState::kNone;
    Place place = Place::kOut;
    Leaving leaving = Leaving::kNot;
    bool stopping = false;          ///< its content is being interrupted, one after the other
    std::size_t open = 0;           ///< how many of its content are not over
    std::uint64_t entered = 0;      ///< the step in which it became inactive
    std::set<std::string> pending;  ///< messages
    MissionTime restarted;          ///< when it last began anew
    int restarts = 0;               ///< how often it began anew at that instant
    /// When it came to each AskedState, in this activation of its parent.
    std::array<std::optional<MissionTime>, 6> since;
  };
  /// Blocks whose formulas must be evaluated again, in document order.
  using Ripe = std::set<ComponelIndex>;

  const Block& block(ComponelIndex index) const { return *(*automaton_)[index].block(); }
  bool listens(Watch watch) const;
  void emit(Effect::What what) { effects_.push_back({now_, std::move(what)}); }

  // Facts (engine_facts.cpp).
  std::optional<std::string> refusal(const Input& input, MissionTime now) const;
  std::optional<MissionTime> instant(const TimeIs& is) const;
  Truth truth(const Literal& literal, const Entry& block) const;
  Truth truth(Watch watch) const;
  bool continues(ComponelIndex loop) const;
  void set_state(ComponelIndex componel, ComponelState state);
  void forget(ComponelIndex componel);
  void look_again(Watch watch);
  void set_timer(std::size_t timer);
  void pass_until(MissionTime now);
  void hear(const std::string& message);
  void read(Watch watch);

  // Transitions (engine_core.cpp).
  void apply(const Input& input);
  void run_cycles();
  template <class Visit>
  bool step(Ripe& ripe, const Visit& visit);
  bool leave_inactive(ComponelIndex block);
  bool leave_active(ComponelIndex block);
  bool enter_active(ComponelIndex block);
  void make_inactive(ComponelIndex block);
  void activate(ComponelIndex block);
  void begin_content(ComponelIndex block);
  void drop(ComponelIndex block);
  void deactivate(ComponelIndex block);
  void leave(ComponelIndex block, Leaving to);
  void stop_content(ComponelIndex block);
  void content_over(ComponelIndex block);
  void restart(ComponelIndex block);
  void finish(ComponelIndex block, ComponelState state);
  void one_over(ComponelIndex componel);
  void change_status(ComponelIndex componel, Status::Word word);
  void abort_model(std::string why);

  std::shared_ptr<const Automaton> automaton_;
  Compiled compiled_;
  std::vector<Entry> entries_;
  Ripe inactive_exits_, active_exits_, preconditions_;
  Agenda agenda_;  ///< future instants, by the timers of `compiled_`
  std::optional<MissionTime> started_;
  MissionTime now_ = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());
  std::uint64_t step_ = 1;
  bool over_ = false;
  std::string abort_reason_;
  Effects effects_;
};

}  // namespace skein::interaction
