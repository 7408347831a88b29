// SPDX-License-Identifier: Apache-2.0
// A joint task that shares an area: who maps what, and the flights over it.
#include <algorithm>

#include "interaction/interaction.hpp"
#include "interaction/role_tasks.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;
using Word = interaction::Status::Word;

// A session. In half of it each reckons the division, beside whatever its computer has to do.
constexpr Duration kSharing = Duration::milliseconds(120'000);
constexpr Duration kAgain = Duration::milliseconds(1'000);
constexpr Duration kPatience = Duration::milliseconds(240'000);  // then it is not shared

// At first the area that the action names, then what is nobody's any more.
std::vector<world::Polygon> areas_to_share(const AreaShare& share, const RolePlay& play,
                                           const std::string& action, const world::World& world) {
  if (share.agreed()) return share.nobodys();
  const interaction::Automaton& automaton = play.automaton();
  const config::Value* named = automaton[*automaton.find(action)].action()->in.find("area");
  const auto zone = named == nullptr ? std::nullopt : zone_of(*named, play.scope(), world);
  std::vector<world::Polygon> areas;
  if (zone) areas.push_back(*zone);
  return areas;
}

}  // namespace

Result<interaction::Rows, Failure> JointPlay::offer_of_area() const {
  return share_.offer(sweep_setting(my_.holders.at(self_)));
}

SweepSetting JointPlay::sweep_setting(const std::string& role) const {
  const auto& knowledge = host_.config().knowledge;
  return {knowledge, host_.world(), now(), sightings_.own()->state,
          device_of(my_.joint.library->roles.at(role), knowledge->vehicle)};
}

// ---- who maps what ----

void JointPlay::share_area(const std::string& action) {
  const std::vector<world::Polygon> areas = areas_to_share(share_, *play_, action, *host_.world());
  const MissionTime until = sharing_again_ ? sharing_again_->until : now() + kPatience;
  const std::string before = sharing_again_ ? sharing_again_->why : "";
  sharing_again_.reset();
  interaction::BeginNegotiation begin;
  begin.subject = my_.joint.subject + "/" + kAreaSharing;
  begin.modality = kAreaSharing;
  begin.members = my_.parties_of(play_->role(), action, self_);
  begin.within = kSharing;
  for (const world::Polygon& area : areas)
    begin.parameters.push_back(interaction::row_of("area", area));
  if (begin.members.size() == 1) {
    share_.take(areas);
    return tell_status(action, Word::kEnded);
  }
  if (now() >= until) return task_.leave("the area could not be shared: " + before);
  actions_[action] = begin.subject;
  sharing_again_ = Again{action, std::nullopt, until, before};  // it may fail at once
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  sharing_again_.reset();
  actions_.erase(action);
  // Nothing was left to whoever was lost, and nobody asks for more.
  if (areas.empty() && share_.agreed()) return tell_status(action, Word::kEnded);
  record_.failed(action, "the area cannot be shared");
  tell_status(action, Word::kAborted);
}

void JointPlay::area_shared(const interaction::Terms& terms,
                            const interaction::NegotiationOutcome& outcome) {
  const auto asked = std::find_if(actions_.begin(), actions_.end(),
                                  [&](const auto& one) { return one.second == terms.subject; });
  if (outcome.kind == Kind::kAgreed) share_.agree(outcome.result);
  if (asked == actions_.end()) return;
  const std::string action = asked->first;
  if (outcome.kind == Kind::kAgreed) {
    actions_.erase(asked);
    sharing_again_.reset();
    return tell_status(action, Word::kEnded);
  }
  host_.bus().emit(Notice{my_.joint.subject + ": the area is not shared yet: " + outcome.why});
  if (!sharing_again_) return;
  sharing_again_->at = now() + kAgain;
  sharing_again_->why = outcome.why;
}

// ---- flights ----

void JointPlay::map_area(const std::string& componel) {
  if (!share_.agreed()) return fail(componel, "the area is not shared");
  const SweepSetting setting = sweep_setting(play_->role());
  const auto way = share_.set_out(setting);
  if (!way) return fail(componel, way.error().why);
  if (way->empty()) return tell_status(componel, Word::kEnded);
  const executive::TaskId flight = give(componel, flight_along(*way));
  give(componel, look_along(flight, setting.device), flight);
}

// Without its device a flight maps nothing.
void JointPlay::look_changed(const executive::TaskEvent& event) {
  const auto look = looks_.find(event.id);
  if (look == looks_.end() || !is_terminal(event.state)) return;
  const executive::TaskId flight = look->second;
  looks_.erase(look);
  const auto flown = tasks_.find(flight);
  if (flown == tasks_.end() || event.state == executive::TaskState::kEnded) return;
  record_.failed(flown->second, event.reason);
  interaction_.aborts().note(flight, AbortedFor::kNothing);
  host_.run(executive::Abort{flight});
}

}  // namespace skein::decision_node
