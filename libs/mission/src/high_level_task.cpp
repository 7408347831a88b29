// SPDX-License-Identifier: Apache-2.0
// High-level tasks in words, and the words of the enumerations around them.
#include "skein/mission/high_level_task.hpp"

#include "skein/foundation/overloaded.hpp"
#include "skein/foundation/shortest_text.hpp"
#include "words.hpp"

namespace skein::mission {

namespace {

constexpr Words<Placement, 5> kPlacements{{{Placement::kBest, "best"},
                                           {Placement::kLast, "last"},
                                           {Placement::kInTime, "in-time"},
                                           {Placement::kTour, "tour"},
                                           {Placement::kFirst, "first"}}};
constexpr Words<GoalState, 7> kGoalStates{{{GoalState::kReceived, "received"},
                                           {GoalState::kPlanned, "planned"},
                                           {GoalState::kUnderWay, "under-way"},
                                           {GoalState::kAchieved, "achieved"},
                                           {GoalState::kFailed, "failed"},
                                           {GoalState::kCancelled, "cancelled"},
                                           {GoalState::kHandedOver, "handed-over"}}};
static_assert(kGoalStates.size() == static_cast<std::size_t>(GoalState::kCount));

std::string text_of(const Argument& argument) {
  return std::visit(Overloaded{[](const std::string& name) { return name; },
                               [](double number) { return shortest_text(number); },
                               [](const world::Vector3& point) {
                                 return "(" + shortest_text(point.x()) + " " +
                                        shortest_text(point.y()) + " " + shortest_text(point.z()) +
                                        ")";
                               },
                               [](const std::vector<std::string>& names) {
                                 std::string text = "(";
                                 for (const std::string& name : names) {
                                   if (text.size() > 1) text += " ";
                                   text += name;
                                 }
                                 return text + ")";
                               }},
                    argument);
}

// "start-after-goal 701 0 to 60".
std::string text_of(const GoalBound& bound) {
  const std::string most =
      bound.most == Duration::max() ? " or more" : " to " + to_text(bound.most);
  return std::string(bound.on_end ? "end" : "start") + "-after-goal " + to_text(bound.goal) + " " +
         to_text(bound.least) + most;
}

std::string text_of(const TimeConstraints& time, const std::vector<GoalBound>& after) {
  std::string text;
  const auto add = [&](std::string_view what, const std::optional<MissionTime>& bound) {
    if (!bound) return;
    text += text.empty() ? " [" : ", ";
    text += std::string(what) + " " + to_text(*bound);
  };
  add("start-after", time.start_after);
  add("start-before", time.start_before);
  add("end-after", time.end_after);
  add("end-before", time.end_before);
  for (const GoalBound& bound : after) text += (text.empty() ? " [" : ", ") + text_of(bound);
  return text.empty() ? text : text + "]";
}

}  // namespace

std::string to_text(const HighLevelTask& task) {
  std::string text = task.name;
  for (const Argument& argument : task.arguments) text += " " + text_of(argument);
  return text + text_of(task.time, task.after);
}

std::string_view to_text(Placement placement) { return word_of(kPlacements, placement); }
std::optional<Placement> placement_from(std::string_view text) {
  return value_of(kPlacements, text);
}

std::string_view to_text(GoalState state) { return word_of(kGoalStates, state); }
std::optional<GoalState> goal_state_from(std::string_view text) {
  return value_of(kGoalStates, text);
}

}  // namespace skein::mission
