// SPDX-License-Identifier: Apache-2.0
// Requests of operators in words.
#include "skein/ground_orders/operator_request.hpp"

#include <array>

#include "skein/foundation/overloaded.hpp"

namespace skein::ground_station {
namespace {

constexpr auto kActions = std::to_array<const char*>(
    {"plan", "abort", "message", "update", "mission", "cancel", "degree", "take_in_hand",
     "give_back", "resume_plan", "drop_plan", "close_air", "open_air", "tell_world",
     "global_mission", "declare_lost", "declare_found", "play", "finish"});
static_assert(kActions.size() == std::variant_size_v<Action>);

std::string object_of(const CloseAir& action) { return " " + action.volume.name; }
std::string object_of(const OpenAir& action) { return " " + action.name; }
std::string object_of(const SendGlobalMission& action) {
  return " " + skein::to_text(action.mission.id);
}
std::string object_of(const SetDegree& action) {
  return " " + action.uav + " " + std::to_string(action.change.degree);
}
template <class Other>
std::string object_of(const Other& action) {
  if constexpr (requires { action.uav; }) {
    return " " + action.uav;
  } else {
    return "";
  }
}

}  // namespace

std::string to_text(const OperatorDeed& deed) {
  return std::visit(Overloaded{[](const Action& it) {
                                 return kActions[it.index()] +
                                        std::visit([](const auto& one) { return object_of(one); },
                                                   it);
                               },
                               [](const AskForUav& it) { return "ask " + it.uav; },
                               [](const KeepUav& it) { return "keep " + it.uav; },
                               [](const LetGo& it) {
                                 return "let_go " + it.uav + (it.to.empty() ? "" : " to " + it.to);
                               },
                               [](const Answer& it) { return "answer " + it.does; },
                               [](const JudgeAlarm& it) {
                                 return "judge_alarm " + skein::to_text(it.alarm) + " " +
                                        std::string(to_text(it.state));
                               },
                               [](const SteerTo& it) { return "go " + it.uav; }},
                    deed);
}

std::string commanded_by(const OperatorDeed& deed) {
  const auto uav_of = [](const auto& one) -> std::string {
    // One that is declared lost or found is not commanded.
    using Deed = std::decay_t<decltype(one)>;
    constexpr bool told = std::is_same_v<Deed, DeclareLost> || std::is_same_v<Deed, DeclareFound>;
    if constexpr (!told && requires { one.uav; }) {
      return one.uav;
    } else {
      return "";
    }
  };
  if (const auto* action = std::get_if<Action>(&deed)) return std::visit(uav_of, *action);
  const auto* steer = std::get_if<SteerTo>(&deed);
  return steer == nullptr ? "" : steer->uav;
}

}  // namespace skein::ground_station
