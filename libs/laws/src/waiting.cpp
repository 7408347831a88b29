// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/waiting.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <functional>
#include <set>

#include "awaited.hpp"
#include "skein/journal/lines/run.hpp"

namespace skein::laws {

namespace {

using ground_station::Action;
using ground_station::Trigger;
using journal::Record;

/// A step or an operator's action, whichever.
struct Deed {
  std::string name;  ///< as in Waiting
  const Trigger* when = nullptr;
  const std::vector<Action>* actions = nullptr;
};

class Waits {
 public:
  Waits(const scenario::Scenario& scenario, const std::vector<Record>& records) : log_(records) {
    for (const auto& step : scenario.ground.script.steps)
      note({"step " + step.name, &step.when, &step.actions}, log_.did("step", "name", step.name));
    for (const auto& action : scenario.ground.script.operators)
      note({"operator " + action.does, &action.when, &action.actions},
           log_.did("operator", "does", action.does));
  }

  std::vector<Waiting> from_the_end() {
    for (const Deed& deed : undone_) {
      if (has<ground_station::Finish>(deed, [](const auto&) { return true; })) look(deed);
    }
    return std::move(found_);
  }

 private:
  void note(Deed deed, bool is_done) {
    if (!is_done) undone_.push_back(std::move(deed));
  }

  template <class Wanted, class Matches>
  static bool has(const Deed& deed, const Matches& matches) {
    return std::any_of(deed.actions->begin(), deed.actions->end(), [&](const Action& action) {
      const auto* one = std::get_if<Wanted>(&action);
      return one != nullptr && matches(*one);
    });
  }

  void look(const Deed& deed) {
    if (!seen_.insert(&deed).second) return;
    for (const Trigger* leaf : missing(*deed.when, log_)) {
      Waiting waiting = log_.standing_of(*leaf);
      waiting.step = deed.name;
      found_.push_back(std::move(waiting));
      look_behind(*leaf);
    }
  }

  // Those that would bring it about.
  void look_behind(const Trigger& leaf) {
    const auto named = [&](const std::string& name) {
      look_at([&](const Deed& deed) { return deed.name == name; });
    };
    if (const auto* on = std::get_if<ground_station::OnStep>(&leaf.what)) named("step " + on->step);
    if (const auto* on = std::get_if<ground_station::OnOperator>(&leaf.what))
      named("operator " + on->does);
    if (const auto* on = std::get_if<ground_station::OnTask>(&leaf.what)) {
      look_at([&](const Deed& deed) {
        return has<ground_station::SendPlan>(deed, [&](const auto& plan) {
          return plan.uav == on->uav &&
                 std::any_of(plan.tasks.begin(), plan.tasks.end(),
                             [&](const auto& one) { return one.task.id == on->task; });
        });
      });
    }
    if (const auto* on = std::get_if<ground_station::OnGoal>(&leaf.what)) {
      look_at([&](const Deed& deed) {
        return has<ground_station::SendMission>(deed, [&](const auto& sent) {
          return sent.uav == on->uav &&
                 std::any_of(sent.mission.tasks.begin(), sent.mission.tasks.end(),
                             [&](const auto& one) { return one.id == on->goal; });
        });
      });
    }
  }

  void look_at(const std::function<bool(const Deed&)>& wanted) {
    for (const Deed& deed : undone_)
      if (wanted(deed)) look(deed);
  }

  LogOfWaits log_;
  std::vector<Deed> undone_;
  std::set<const Deed*> seen_;
  std::vector<Waiting> found_;
};

}  // namespace

std::vector<Waiting> waits_of(const scenario::Scenario& scenario,
                              const std::vector<Record>& records) {
  const bool finished = std::any_of(records.begin(), records.end(), [](const Record& record) {
    return record.kind() == "mission" && record.text("state") == "finished";
  });
  if (finished) return {};
  return Waits(scenario, records).from_the_end();
}

std::vector<Record> waiting_lines(const std::vector<Waiting>& waits, MissionTime at) {
  std::vector<Record> lines;
  for (const Waiting& one : waits) {
    journal::lines::Waiting line;
    line.step = one.step;
    line.awaited = one.awaited;
    line.is = one.is;
    line.since = one.since;
    line.why = one.why;
    lines.push_back(journal::record_of(at, "runner", line));
  }
  return lines;
}

std::string to_text(const Waiting& waiting) {
  std::string text = waiting.step + " waits for " + waiting.awaited + ": " + waiting.is;
  if (waiting.since) text += " since " + seconds_text(*waiting.since);
  if (!waiting.why.empty()) text += " (" + waiting.why + ")";
  return text;
}

}  // namespace skein::laws
