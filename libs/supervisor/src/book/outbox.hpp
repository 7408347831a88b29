// SPDX-License-Identifier: Apache-2.0
// The effects of a call: decisions, states of goals, requests to the executive, the plan.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "book/book.hpp"
#include "skein/supervisor/supervisor.hpp"

namespace skein::supervisor {

/// The application of an operator, for Decided.
struct Application {
  std::string applied, cause, inputs, outcome;
  MissionTime began;
};

/// Collects the effects of the current call in the order in which they arise, and keeps the call's
/// instant. Changes of goals' states are made here, so that each is reported. Lifetime: refers to
/// the book.
class Outbox {
 public:
  explicit Outbox(Book& book) : book_(book) {}

  /// A call begins. `now` never decreases.
  void begin(MissionTime now);
  MissionTime now() const { return now_; }
  /// The call ends: returns its effects, with PlanChanged if the plan changed.
  Effects close();

  void add(Effect effect) { effects_.push_back(std::move(effect)); }
  void notice(std::string text) { add(Notice{std::move(text)}); }
  void send(executive::Input input) { add(ToExecutive{std::move(input)}); }
  void decide(Application application);
  /// Reserves a place among the effects for a decision that is reported before its consequences but
  /// worded after them. Precondition: decide(place, …) follows in the same call.
  std::size_t reserve_decision();
  void decide(std::size_t place, Application application);
  /// Sets and reports the state; no effect on a settled goal, or if it is in that state already.
  void set_state(Goal& goal, GoalState state, const std::string& why = {});

  /// The text with ids of tasks and goals replaced by descriptions; each goal is described once.
  std::string in_words(const std::string& text) const;
  /// "plan 3, 7 tasks": the plan that close() will report.
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
