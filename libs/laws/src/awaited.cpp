// SPDX-License-Identifier: Apache-2.0
#include "awaited.hpp"

#include <algorithm>

#include "checks.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::laws {

namespace {

using ground_station::Trigger;
using journal::Record;
namespace gs = ground_station;

constexpr double kBraking = 30;  // [s] from a policy until what it interrupted has stopped

bool is_way_out(const Trigger& leaf) {
  return std::holds_alternative<gs::OnSilence>(leaf.what) ||
         std::holds_alternative<gs::OnExpired>(leaf.what);
}

std::string stage_text(gs::MissionStage stage) {
  constexpr const char* kTexts[] = {"planned", "refused", "achieved", "failed", "evaluated"};
  return kTexts[static_cast<std::size_t>(stage)];
}

std::string awaited_text(const Trigger& leaf) {
  const auto of = [](const auto& id, const std::string& uav, std::string_view state) {
    return to_text(id) + " of " + uav + " " + std::string(state);
  };
  return std::visit(
      Overloaded{
          [](const gs::AtTime& on) { return "time " + seconds_text(on.at.to_seconds()); },
          [](const gs::OnAlarm& on) {
            const std::string id = on.id == gs::AlarmId() ? "" : " " + to_text(on.id);
            return "alarm" + id + " " + std::string(to_text(on.state));
          },
          [&](const gs::OnTask& on) { return "task " + of(on.task, on.uav, to_text(on.state)); },
          [](const gs::OnOperator& on) { return "operator " + on.does; },
          [](const gs::OnStep& on) { return "step " + on.step; },
          [](const gs::OnExpired& on) { return "expiry of what step " + on.step + " asked"; },
          [](const gs::OnRestart& on) { return "restart of " + on.uav; },
          [](const gs::OnHeld& on) { return "what was interrupted of " + on.uav; },
          [](const gs::OnSilence& on) {
            return "silence of " + on.uav + " for " + seconds_text(on.lasts.to_seconds());
          },
          [&](const gs::OnMission& on) {
            return "mission " + of(on.mission, on.uav, stage_text(on.state));
          },
          [&](const gs::OnGoal& on) { return "goal " + of(on.goal, on.uav, to_text(on.state)); },
          [](const gs::OnDegree& on) {
            return "degree " + std::to_string(on.degree) + " of " + on.uav;
          },
          [](const gs::OnTeamTask& on) { return "task " + to_text(on.task) + " of the team"; },
          [](const gs::OnGlobalMission& on) {
            return "global mission " + to_text(on.mission) + " " + std::string(to_text(on.stage));
          },
          [](const auto&) { return std::string("several things"); },
      },
      leaf.what);
}

bool is_of(const Record& record, std::string_view kind, const std::string& uav) {
  return record.kind() == kind && record.text("uav") == uav;
}

bool is_number(const Record& record, const char* key, std::uint64_t number) {
  return record.number(key, -1) == static_cast<double>(number);
}

}  // namespace

std::string seconds_text(double seconds) { return figure(seconds) + " s"; }

template <class Matches>
const Record* LogOfWaits::last(const Matches& matches) const {
  const auto found = std::find_if(records_.rbegin(), records_.rend(), matches);
  return found == records_.rend() ? nullptr : &*found;
}

bool LogOfWaits::did(std::string_view kind, std::string_view key, std::string_view text) const {
  return last([&](const Record& record) {
           return record.kind() == kind && record.text(key) == text;
         }) != nullptr;
}

bool LogOfWaits::came_about(const Trigger& leaf) const {
  const auto any = [&](const auto& matches) { return last(matches) != nullptr; };
  return std::visit(
      Overloaded{
          [&](const gs::AtTime& on) { return !records_.empty() && on.at <= records_.back().at(); },
          [&](const gs::OnAlarm& on) {
            return any([&](const Record& r) {
              return r.kind() == "alarm" && r.text("state") == to_text(on.state) &&
                     (on.id == gs::AlarmId() || is_number(r, "alarm", on.id.value()));
            });
          },
          [&](const gs::OnTask& on) {
            return any([&](const Record& r) {
              return is_of(r, "task", on.uav) && is_number(r, "task", on.task.value()) &&
                     r.text("state") == to_text(on.state);
            });
          },
          [&](const gs::OnGoal& on) {
            return any([&](const Record& r) {
              return is_of(r, "goal", on.uav) && is_number(r, "goal", on.goal.value()) &&
                     r.text("state") == to_text(on.state);
            });
          },
          [&](const gs::OnDegree& on) {
            return any([&](const Record& r) {
              return is_of(r, "degree", on.uav) && r.number("degree") == on.degree &&
                     r.find("by") != nullptr;
            });
          },
          [&](const gs::OnOperator& on) { return did("operator", "does", on.does); },
          [&](const gs::OnStep& on) { return did("step", "name", on.step); },
          [&](const gs::OnHeld& on) { return did("contact", "uav", on.uav); },
          [](const auto&) { return false; },
      },
      leaf.what);
}

Waiting LogOfWaits::standing_of(const Trigger& leaf) const {
  Waiting waiting;
  waiting.is = "not yet";
  if (const auto* on = std::get_if<gs::OnTask>(&leaf.what)) waiting = of_task(*on);
  if (const auto* on = std::get_if<gs::OnGoal>(&leaf.what)) waiting = of_goal(*on);
  if (std::holds_alternative<gs::OnStep>(leaf.what) ||
      std::holds_alternative<gs::OnOperator>(leaf.what))
    waiting.is = "not done";
  if (std::holds_alternative<gs::OnAlarm>(leaf.what)) waiting.why = deaths();
  waiting.awaited = awaited_text(leaf);
  return waiting;
}

Waiting LogOfWaits::of_task(const gs::OnTask& on) const {
  const auto is_it = [&](const Record& r) {
    return is_of(r, "task", on.uav) && is_number(r, "task", on.task.value());
  };
  Waiting waiting;
  const Record* now = last(is_it);
  if (now == nullptr) {
    waiting.is = "never begun";
    ask_commands(on.uav, "START " + to_text(on.task) + " ", waiting);
    return waiting;
  }
  waiting.is = now->text("state");
  waiting.since = now->at().to_seconds();
  const auto first = std::find_if(records_.begin(), records_.end(), [&](const Record& r) {
    return is_it(r) && !r.text("reason").empty();
  });
  const std::string told(first == records_.end() ? "" : first->text("reason"));
  waiting.why = why_of(on.uav, *waiting.since, told);
  return waiting;
}

Waiting LogOfWaits::of_goal(const gs::OnGoal& on) const {
  Waiting waiting;
  const Record* now = last([&](const Record& r) {
    return is_of(r, "goal", on.uav) && is_number(r, "goal", on.goal.value());
  });
  if (now == nullptr) {
    waiting.is = "never received";
    ask_commands(on.uav, "MISSION ", waiting);
    return waiting;
  }
  waiting.is = now->text("state");
  waiting.since = now->at().to_seconds();
  waiting.why = why_of(on.uav, *waiting.since, std::string(now->text("why")));
  return waiting;
}

// A policy says more than "displaced by" its own task.
std::string LogOfWaits::why_of(const std::string& uav, double at, const std::string& told) const {
  const Record* policy = last([&](const Record& r) {
    const double carried_out = r.at().to_seconds();
    return is_of(r, "contact", uav) && carried_out <= at && carried_out >= at - kBraking;
  });
  if (policy == nullptr) return told;
  return "its contact-loss policy " + std::string(policy->text("policy")) + " at " +
         seconds_text(policy->at().to_seconds()) + (told.empty() ? "" : "; " + told);
}

// Of what was asked for in vain, the last.
void LogOfWaits::ask_commands(const std::string& uav, const std::string& what,
                              Waiting& waiting) const {
  const Record* failed = last([&](const Record& r) {
    return is_of(r, "command", uav) && r.text("what").starts_with(what) &&
           (r.text("state") == "expired" || r.text("state") == "refused");
  });
  if (failed == nullptr) return;
  waiting.since = failed->at().to_seconds();
  waiting.why = std::string(failed->text("what")) + " " + std::string(failed->text("state")) +
                ": " + std::string(failed->text("why"));
}

// Who was dead may have missed it.
std::string LogOfWaits::deaths() const {
  std::string text;
  for (const Record& r : records_) {
    if (r.kind() != "fault") continue;
    text += (text.empty() ? "" : ", ") + std::string(r.text("what")) + " " +
            std::string(r.text("target")) + " at " + seconds_text(r.at().to_seconds());
  }
  return text;
}

std::vector<const Trigger*> missing(const Trigger& trigger, const LogOfWaits& log) {
  std::vector<const Trigger*> leaves;
  const auto add = [&](const Trigger& inner) {
    const auto more = missing(inner, log);
    leaves.insert(leaves.end(), more.begin(), more.end());
    return more.empty();
  };
  if (const auto* all = std::get_if<gs::AllOf>(&trigger.what)) {
    for (const Trigger& inner : all->of) add(inner);
  } else if (const auto* any = std::get_if<gs::AnyOf>(&trigger.what)) {
    for (const Trigger& inner : any->of)
      if (add(inner)) return {};
    const bool others = !std::all_of(leaves.begin(), leaves.end(),
                                     [](const Trigger* leaf) { return is_way_out(*leaf); });
    if (others) std::erase_if(leaves, [](const Trigger* leaf) { return is_way_out(*leaf); });
  } else if (!log.came_about(trigger)) {
    leaves.push_back(&trigger);
  }
  return leaves;
}

}  // namespace skein::laws
