// SPDX-License-Identifier: Apache-2.0
// What others are told in a call: decisions, states of goals, requests to the executive, the plan.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "book/book.hpp"
#include "skein/supervisor/supervisor.hpp"

namespace skein::supervisor {

/// What a Decided says, with its beginning.
struct Application {
  std::string applied, cause, inputs, outcome;
  MissionTime began;
};

/// The effects of the call that is running, in the order in which they come about, and its instant.
/// A change of a goal's state is told as it is made, so it is made here. Lifetime: refers to the
/// book.
class Outbox {
 public:
  explicit Outbox(Book& book) : book_(book) {}

  /// A call begins. Its instant never decreases.
  void begin(MissionTime now);
  MissionTime now() const { return now_; }
  /// It ends: the plan is told of if it changed.
  Effects close();

  void add(Effect effect) { effects_.push_back(std::move(effect)); }
  void notice(std::string text) { add(Notice{std::move(text)}); }
  void send(executive::Input input) { add(ToExecutive{std::move(input)}); }
  void decide(Application application);
  /// For a decision that is told before its consequences and worded after them: its place in what
  /// is told. Precondition: decide(place, …) in the same call.
  std::size_t reserve_decision();
  void decide(std::size_t place, Application application);
  /// A goal that is settled stays so; the same state is not told twice.
  void set_state(Goal& goal, GoalState state, const std::string& why = {});

  /// Tasks by what they are of, goals by what they are; each goal once.
  std::string in_words(const std::string& text) const;
  /// "plan 3, 7 tasks": that which will be told of when the call ends.
  std::string plan_text() const;
  const mission::PlanReport& report() const { return report_; }

 private:
  void publish();
  static bool is_as_told(const Goal& goal, const mission::GoalStatus& told);

  Book& book_;
  MissionTime now_;
  Effects effects_;
  std::uint64_t decisions_ = 0;
  mission::PlanReport report_;
};

/// "goals 701 702", "tasks 100 101".
template <class Ids>
std::string list_of(const std::string& what, const Ids& ids) {
  std::string text = what;
  for (const auto& id : ids) text += " " + to_text(id);
  return text;
}

/// "a; b".
std::string joined(const std::vector<std::string>& texts);

}  // namespace skein::supervisor
