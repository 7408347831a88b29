// SPDX-License-Identifier: Apache-2.0
// Requests of operators: looked at as a whole, then done.
#include "skein/ground_station/operator_desk.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/functional/steering_ids.hpp"
#include "skein/ground_station/stand_ins.hpp"

namespace skein::ground_station {
namespace {

static_assert(functional::kFirstSteeringId.value() > StandIns::kFirstId);

constexpr std::size_t kMostDeeds = 64;
constexpr std::size_t kMostUnderWay = 256;  // of one operator

std::string tag_of(const std::string& who, std::uint64_t number) {
  return "request " + who + " " + std::to_string(number);
}

bool is_printable(const std::string& name) {
  return std::none_of(name.begin(), name.end(),
                      [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

std::string text_of(const std::vector<OperatorDeed>& deeds) {
  std::vector<std::string> texts;
  for (const OperatorDeed& deed : deeds) texts.push_back(to_text(deed));
  return joined(texts, ", ");
}

}  // namespace

std::vector<OperatorDesk::Effect> OperatorDesk::handle(const OperatorRequest& request,
                                                       const Surroundings& around,
                                                       MissionTime now) {
  const Entry* known = find(request.who, request.number);
  if (known != nullptr && known->fingerprint == request.fingerprint) {
    news_.insert({request.who, request.number});  // what came of it is told again
    return {};
  }
  Draft draft{request, around, now, hands_, {}, problems_of_form(request), steering_};
  const bool is_sound = draft.problems.empty();
  draft.problems.insert(draft.problems.end(), request.problems.begin(), request.problems.end());
  for (const OperatorDeed& deed : request.deeds) draft_deed(deed, draft);
  const bool accepted = draft.problems.empty();
  OperatorAnswered answer{request.who, request.number, accepted, !accepted, draft.problems, {}};
  if (!is_sound) {
    refusals_.push_back(std::move(answer));
    return {};
  }
  remember(request, std::move(answer));
  return accepted ? adopt(draft) : Effects{asked(draft)};
}

// What makes it a request at all, and one of its own.
std::vector<std::string> OperatorDesk::problems_of_form(const OperatorRequest& request) const {
  std::vector<std::string> why;
  if (request.who.empty() || request.who.size() > kLongestName || !is_printable(request.who)) {
    why.push_back("an operator's name has 1 to " + std::to_string(kLongestName) +
                  " bytes and no control characters");
  }
  if (request.number == 0) why.emplace_back("requests are numbered from 1");
  if (request.deeds.size() > kMostDeeds) {
    why.push_back("more than " + std::to_string(kMostDeeds) + " actions in one request");
  }
  const std::string number = "number " + std::to_string(request.number);
  const auto one = operators_.find(request.who);
  if (one == operators_.end()) {
    if (operators_.size() >= kOperators) why.emplace_back("there are too many operators");
  } else if (one->second.requests.contains(request.number)) {
    why.push_back(number + " was another request: numbers are for one request each");
  } else if (request.number <= one->second.forgotten) {
    why.push_back(number + " is too old: numbers grow from request to request");
  } else if (one->second.requests.size() >= kMostUnderWay) {
    why.emplace_back("too many requests are under way");
  }
  return why;
}

const OperatorDesk::Entry* OperatorDesk::find(const std::string& who, std::uint64_t number) const {
  const auto one = operators_.find(who);
  if (one == operators_.end()) return nullptr;
  const auto entry = one->second.requests.find(number);
  return entry == one->second.requests.end() ? nullptr : &entry->second;
}

void OperatorDesk::remember(const OperatorRequest& request, OperatorAnswered answer) {
  const Key key{request.who, request.number};
  Operator& owner = operators_[request.who];
  asked_by_[tag_of(request.who, request.number)] = key;
  owner.requests[request.number] = {request.fingerprint, std::move(answer)};
  news_.insert(key);
  forget(owner);
}

OperatorAsked OperatorDesk::asked(const Draft& draft) {
  const OperatorRequest& request = draft.request;
  return {request.who, request.number, text_of(request.deeds), draft.problems.empty(),
          joined(draft.problems, "; ")};
}

OperatorDesk::Effects OperatorDesk::adopt(Draft& draft) {
  Effects effects{asked(draft)};
  for (const auto& [uav, hand] : draft.hands) {
    if (hand_of(uav) != hand) effects.emplace_back(HandChanged{uav, hand});
  }
  effects.insert(effects.end(), draft.effects.begin(), draft.effects.end());
  hands_ = std::move(draft.hands);
  steering_ = std::move(draft.steering);
  return effects;
}

// Those that are not complete are remembered until they are.
void OperatorDesk::forget(Operator& one) {
  for (auto entry = one.requests.begin();
       entry != one.requests.end() && one.requests.size() > kRequestsKept;) {
    const OperatorAnswered& answer = entry->second.answer;
    const bool is_news = news_.contains({answer.who, answer.number});
    if (!answer.complete || is_news) {
      ++entry;
      continue;
    }
    one.forgotten = std::max(one.forgotten, entry->first);
    asked_by_.erase(tag_of(answer.who, answer.number));
    entry = one.requests.erase(entry);
  }
}

const UavOnBoard* OperatorDesk::find(const Draft& draft, const std::string& uav) {
  const auto& uavs = draft.around.board.uavs;
  const auto found =
      std::find_if(uavs.begin(), uavs.end(), [&](const auto& one) { return one.name == uav; });
  return found == uavs.end() ? nullptr : &*found;
}

bool OperatorDesk::may_command(Draft& draft, const std::string& uav) {
  if (find(draft, uav) == nullptr) {
    draft.problems.push_back("unknown UAV '" + uav + "'");
    return false;
  }
  const std::string& holder = draft.hands[uav].holder;
  if (holder.empty() || holder == draft.request.who) return true;
  draft.problems.push_back(uav + " is in hand of " + holder + ": ask for it first");
  return false;
}

void OperatorDesk::draft_deed(const OperatorDeed& deed, Draft& draft) const {
  const std::string commanded = commanded_by(deed);
  if (!commanded.empty() && !may_command(draft, commanded)) return;
  std::visit([&](const auto& one) { take(one, draft); }, deed);
}

void OperatorDesk::take(const Action& action, Draft& draft) const {
  const DoActions deed{{action}, tag_of(draft.request.who, draft.request.number)};
  if (const auto* taken = std::get_if<TakeInHand>(&action)) {
    draft.hands[taken->uav] = {draft.request.who, {}, {}};
  } else if (const auto* given = std::get_if<GiveBack>(&action)) {
    const UavOnBoard* uav = find(draft, given->uav);
    const bool is_taken = draft.hands[given->uav].holder == draft.request.who;
    if (!uav->degree_before_taken && !is_taken) {
      draft.problems.push_back(given->uav + " was not taken in hand: it cannot be given back");
      return;
    }
    draft.hands[given->uav] = {};
    // Of one that was at degree 1 before, only the hand is given back.
    if (!uav->degree_before_taken && runs_at_ground(uav->degree)) return;
  }
  draft.effects.emplace_back(deed);
}

void OperatorDesk::take(const AskForUav& deed, Draft& draft) const {
  Hand& hand = draft.hands[deed.uav];
  if (find(draft, deed.uav) == nullptr) {
    draft.problems.push_back("unknown UAV '" + deed.uav + "'");
  } else if (hand.holder.empty()) {
    draft.problems.push_back("nobody has " + deed.uav + " in hand: take it");
  } else if (hand.holder == draft.request.who) {
    draft.problems.push_back(deed.uav + " is in your hand");
  } else if (!hand.asker.empty() && hand.asker != draft.request.who) {
    draft.problems.push_back(hand.asker + " asks for " + deed.uav + " already");
  } else if (hand.asker.empty()) {
    hand.asker = draft.request.who;
    hand.passes_at = draft.now + kPatience;
  }
}

void OperatorDesk::take(const KeepUav& deed, Draft& draft) const {
  Hand& hand = draft.hands[deed.uav];
  if (hand.holder != draft.request.who) {
    draft.problems.push_back(deed.uav + " is not in your hand");
  } else {
    hand = {hand.holder, {}, {}};
  }
}

void OperatorDesk::take(const LetGo& deed, Draft& draft) const {
  Hand& hand = draft.hands[deed.uav];
  if (hand.holder != draft.request.who) {
    draft.problems.push_back(deed.uav + " is not in your hand");
  } else if (deed.to.size() > kLongestName || !is_printable(deed.to)) {
    draft.problems.emplace_back("that is no operator's name");
  } else {
    hand = {deed.to, {}, {}};
  }
}

void OperatorDesk::take(const Answer& deed, Draft& draft) const {
  const std::vector<std::string>& wanted = draft.around.answers;
  if (std::find(wanted.begin(), wanted.end(), deed.does) != wanted.end()) {
    draft.effects.emplace_back(OperatorActs{deed.does});
    return;
  }
  draft.problems.push_back("the script does not wait for '" + deed.does + "'" +
                           did_you_mean(nearest_name(deed.does, wanted)));
}

void OperatorDesk::take(const JudgeAlarm& deed, Draft& draft) const {
  const auto& alarms = draft.around.alarms;
  const auto found = std::find_if(alarms.begin(), alarms.end(),
                                  [&](const Alarm& one) { return one.id == deed.alarm; });
  const std::string name = "alarm " + skein::to_text(deed.alarm);
  if (found == alarms.end()) {
    draft.problems.push_back("there is no " + name);
  } else if (deed.state == AlarmState::kRaised) {
    draft.problems.emplace_back("an alarm is judged confirmed or infirmed");
  } else if (found->state == AlarmState::kConfirmed && deed.state != found->state) {
    draft.problems.push_back(name + " is confirmed for good");
  } else if (found->state != deed.state) {
    draft.effects.emplace_back(deed);
  }
}

void OperatorDesk::take(const SteerTo& deed, Draft& draft) const {
  const UavOnBoard* uav = find(draft, deed.uav);
  if (deed.points.empty()) draft.problems.emplace_back("a way has points");
  if (draft.hands[deed.uav].holder != draft.request.who) {
    draft.problems.push_back(deed.uav + " is not in your hand: take it in hand first");
  }
  if (!uav->airborne && !deed.drives)
    draft.problems.push_back(deed.uav + " is not in the air: give it a plan with a takeoff first");
  std::uint64_t& next =
      draft.steering.try_emplace(deed.uav, functional::kFirstSteeringId.value()).first->second;
  PlannedTask way;
  way.task.id = executive::TaskId(next++);
  way.task.type = "goto";
  way.mode = executive::InsertionMode::kVut;
  way.targets = {{AtPoints{deed.points}, "waypoints"}};
  draft.effects.emplace_back(DoActions{{Action(SendPlan{deed.uav, {way}})},
                                       tag_of(draft.request.who, draft.request.number)});
}

std::vector<OperatorDesk::Effect> OperatorDesk::wake(MissionTime now) {
  Effects effects;
  for (auto& [uav, hand] : hands_) {
    if (!hand.passes_at || *hand.passes_at > now) continue;
    hand = {hand.asker, {}, {}};
    effects.emplace_back(HandChanged{uav, hand});
  }
  return effects;
}

std::optional<MissionTime> OperatorDesk::next_wakeup() const {
  std::optional<MissionTime> wakeup;
  for (const auto& [uav, hand] : hands_) wakeup = earliest(wakeup, hand.passes_at);
  return wakeup;
}

void OperatorDesk::note(const CommandChanged& change, MissionTime now) {
  const auto put = [&](auto& commands) {
    const auto known = std::find_if(commands.rbegin(), commands.rend(),
                                    [&](const auto& one) { return one.command == change.command; });
    if (known != commands.rend()) {
      known->state = change.state;
      known->why = change.why;
      if (is_settled(change.state)) known->settled = now;
    } else if (change.state == CommandState::kIssued) {
      commands.push_back(
          {change.command, change.uav, change.what, change.asked_by, change.state, "", now, {}});
    }
  };
  put(latest_);
  if (latest_.size() > kCommandsKept) latest_.pop_front();
  const auto asked = asked_by_.find(change.asked_by);
  if (asked == asked_by_.end()) return;
  put(operators_.at(asked->second.first).requests.at(asked->second.second).answer.commands);
  news_.insert(asked->second);
}

void OperatorDesk::note(const Anomaly& anomaly) {
  const auto asked = asked_by_.find(anomaly.asked_by);
  if (asked == asked_by_.end()) return;
  Entry& entry = operators_.at(asked->second.first).requests.at(asked->second.second);
  entry.answer.problems.push_back(anomaly.why);
  news_.insert(asked->second);
}

void OperatorDesk::note(const GiveGlobalMission& mission) {
  const auto asked = asked_by_.find(mission.mission.asked_by);
  if (asked != asked_by_.end()) given_.insert_or_assign(mission.mission.id, asked->second);
}

void OperatorDesk::note(const GlobalMissionChanged& change) {
  const auto given = given_.find(change.mission);
  if (given == given_.end()) return;
  const Key key = given->second;
  given_.erase(given);
  news_.insert(key);
  if (change.stage != GlobalStage::kRefused) return;
  operators_.at(key.first)
      .requests.at(key.second)
      .answer.problems.push_back("global mission " + skein::to_text(change.mission) +
                                 " is refused: " + change.why);
}

std::vector<OperatorAnswered> OperatorDesk::take_answers() {
  std::vector<OperatorAnswered> answers = std::exchange(refusals_, {});
  for (const auto& [who, number] : std::exchange(news_, {})) {
    const auto waits = [&](const auto& given) { return given.second == Key(who, number); };
    if (std::ranges::any_of(given_, waits)) {
      news_.insert({who, number});
      continue;
    }
    OperatorAnswered& answer = operators_.at(who).requests.at(number).answer;
    answer.complete = std::all_of(answer.commands.begin(), answer.commands.end(),
                                  [](const IssuedCommand& one) { return is_settled(one.state); });
    answers.push_back(answer);
  }
  return answers;
}

Hand OperatorDesk::hand_of(const std::string& uav) const {
  const auto found = hands_.find(uav);
  return found == hands_.end() ? Hand() : found->second;
}

}  // namespace skein::ground_station
