// SPDX-License-Identifier: Apache-2.0
// Spec 7.8 word for word, without regard to cost: everything is looked at every time. Shares the
// types of automata, inputs and effects with the engine, and no code.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/interaction/automaton.hpp"
#include "skein/interaction/effect.hpp"
#include "skein/interaction/input.hpp"

namespace skein::interaction::testing {

class NaiveEngine {
 public:
  explicit NaiveEngine(const Automaton& automaton) : automaton_(automaton) {}

  /// As Engine::handle(); absent if the input is refused.
  std::optional<Effects> handle(const Input& input, MissionTime at) {
    if (refused(input, at)) return std::nullopt;
    out_.clear();
    play_instants(at);
    now_ = at;
    if (!over_) take(input);
    cycles();
    return out_;
  }

 private:
  using Id = ComponelIndex;
  enum Value { kNo, kYes, kNever };

  const Block& block(Id id) const { return *automaton_[id].block(); }
  bool is_block(Id id) const { return automaton_[id].block() != nullptr; }
  std::string state_of(Id id) const { return states_.count(id) > 0 ? states_.at(id) : ""; }
  bool over(Id id) const { return state_of(id) == "ended" || state_of(id) == "aborted"; }

  bool refused(const Input& input, MissionTime at) const {
    if (now_ && at < *now_) return true;
    if (std::holds_alternative<Start>(input)) return start_.has_value() && !over_;
    const auto* status = std::get_if<Status>(&input);
    if (status == nullptr) return false;
    const auto id = automaton_.find(status->componel);
    return !id || is_block(*id);
  }

  // --- inputs
  // --------------------------------------------------------------------------------------

  void take(const Input& input) {
    if (std::holds_alternative<Start>(input)) {
      start_ = now_;
      enter_bi(0);
    } else if (std::holds_alternative<Abort>(input)) {
      abort();
    } else if (const auto* status = std::get_if<Status>(&input)) {
      take_status(*status);
    } else if (const auto* message = std::get_if<Message>(&input)) {
      message_arrives(message->text);
    } else if (const auto* report = std::get_if<ScmReport>(&input)) {
      const char* const words[] = {"violated", "satisfied", "undetermined"};
      bool heard = false;
      for (const Id id : ba_) {
        const auto& scms = block(id).scms;
        heard = heard || std::find(scms.begin(), scms.end(), report->scm) != scms.end();
      }
      if (heard) message_arrives(report->scm + " " + words[static_cast<int>(report->finding)]);
    }
  }

  void take_status(const Status& status) {
    const char* const words[] = {"running", "ended", "aborted"};
    const Id id = *automaton_.find(status.componel);
    const std::string said = words[static_cast<int>(status.word)];
    if (state_of(id) == "scheduled" || state_of(id) == "running") {
      if (said != state_of(id)) change(id, said);
    } else if (state_of(id) == "aborting") {
      change(id, "aborted");
    }
    settle();
  }

  void message_arrives(const std::string& message) {
    for (const Id id : bi_) pending_[id].insert(message);
    for (const Id id : ba_) pending_[id].insert(message);
  }

  void abort() {
    if (bi_.count(0) > 0) archive(0);
    if (ba_.count(0) > 0 && state_of(0) != "aborting") deactivate(0);
    settle();
  }

  // --- instants
  // ------------------------------------------------------------------------------------

  void play_instants(MissionTime until) {
    while (now_ && !over_) {
      std::optional<MissionTime> next;
      for (const Id id : bi_) earliest(block(id).precondition, next);
      for (const Id id : bi_) earliest(block(id).exit, next);
      for (const Id id : ba_) earliest(block(id).exit, next);
      if (!next || *next > until) return;
      now_ = next;
      cycles();
    }
  }

  void earliest(const Formula& formula, std::optional<MissionTime>& next) const {
    for (const Clause& clause : formula) {
      for (const Literal& literal : clause) {
        const auto* time = std::get_if<TimeIs>(&literal.condition);
        const auto at = time != nullptr ? instant_of(*time) : std::nullopt;
        if (at && *at > *now_ && (!next || *at < *next)) next = at;
      }
    }
  }

  std::optional<MissionTime> instant_of(const TimeIs& time) const {
    if (std::holds_alternative<TimeIs::Epoch>(time.since)) return MissionTime() + time.after;
    if (std::holds_alternative<TimeIs::ModelStart>(time.since)) return *start_ + time.after;
    const auto& event = std::get<TimeIs::Event>(time.since);
    const auto happened = dates_.find({event.componel, std::string(to_text(event.state))});
    if (happened == dates_.end()) return std::nullopt;
    return happened->second + time.after;
  }

  // --- conditions
  // ----------------------------------------------------------------------------------

  bool still_possible(const std::string& from, const std::string& to) const {
    if (from.empty()) return true;
    if (from == "scheduled") return to != "scheduled";
    if (from == "running") return to != "scheduled" && to != "running";
    if (from == "aborting") return to == "aborted" || to == "over";
    return false;
  }

  Value value(const Literal& literal, Id of) const {
    Value plain = kNo;
    bool settled = false;  // true, and for ever
    if (const auto* is = std::get_if<ComponelIs>(&literal.condition)) {
      const std::string wanted(to_text(is->state));
      const std::string state = state_of(is->componel);
      const bool there = wanted == "over" ? over(is->componel) : state == wanted;
      settled = there && over(is->componel);
      plain = there ? kYes : still_possible(state, wanted) ? kNo : kNever;
    } else if (const auto* message = std::get_if<MessagePending>(&literal.condition)) {
      plain = pending_.count(of) > 0 && pending_.at(of).count(message->message) > 0 ? kYes : kNo;
    } else {
      const auto& time = std::get<TimeIs>(literal.condition);
      const auto at = instant_of(time);
      const bool passed = at && *at <= *now_;
      if (time.passed) {
        plain = passed ? kYes : kNo;
        settled = passed;
      } else {
        plain = passed ? kNever : kYes;
      }
    }
    Value result = plain;
    if (literal.negated) result = plain != kYes ? kYes : settled ? kNever : kNo;
    if (result == kNever && literal.modality == Modality::kOptional) return kYes;
    return result;
  }

  Value value(const Formula& formula, Id of) const {
    bool all = true;
    for (const Clause& clause : formula) {
      bool some = false;
      bool hope = false;
      for (const Literal& literal : clause) {
        some = some || value(literal, of) == kYes;
        hope = hope || value(literal, of) != kNever;
      }
      if (!hope) return kNever;
      all = all && some;
    }
    return all ? kYes : kNo;
  }

  bool exit_true(Id id) const {
    return !block(id).exit.empty() && value(block(id).exit, id) == kYes;
  }

  bool only_continues(Id id) const {
    if (block(id).type != BlockType::kLoop) return false;
    for (const Clause& clause : block(id).exit) {
      for (const Literal& literal : clause) {
        if (value(literal, id) == kYes && literal.effect == ExitEffect::kExit) return false;
      }
    }
    return true;
  }

  void read(const Formula& formula, Id id) {
    for (const Clause& clause : formula) {
      for (const Literal& literal : clause) {
        const auto* message = std::get_if<MessagePending>(&literal.condition);
        if (message == nullptr || literal.negated) continue;
        if (pending_[id].erase(message->message) > 0) say(Read{message->message, name(id)});
      }
    }
  }

  // --- the cycle
  // -----------------------------------------------------------------------------------

  void cycles() {
    while (!over_ && start_) {
      changed_ = false;
      for (const auto& [id, visit] : visits(bi_)) {
        if (bi_.count(id) == 0 || visits_[id] != visit || !exit_true(id)) continue;
        read(block(id).exit, id);
        archive(id);
      }
      for (const auto& [id, visit] : visits(ba_)) {
        if (ba_.count(id) == 0 || leaving_.count(id) > 0 || !exit_true(id)) continue;
        const bool anew = only_continues(id);
        read(block(id).exit, id);
        if (anew) {
          leaving_[id] = "restart";
          stop_content(id);
        } else {
          deactivate(id);
        }
        settle();
      }
      for (const auto& [id, visit] : visits(bi_)) {
        if (bi_.count(id) == 0 || visits_[id] != visit) continue;
        const Value pre = value(block(id).precondition, id);
        if (pre == kNever) archive(id);
        if (pre != kYes) continue;
        read(block(id).precondition, id);
        bi_.erase(id);
        ba_.insert(id);
        change(id, "running");
        begin(id);
      }
      if (!changed_) return;
    }
  }

  // The blocks that are there now, with how often each has come.
  std::map<Id, int> visits(const std::set<Id>& blocks) const {
    std::map<Id, int> all;
    if (over_) return all;
    for (const Id id : blocks) all[id] = visits_.at(id);
    return all;
  }

  // --- what is done
  // --------------------------------------------------------------------------------

  std::string name(Id id) const { return automaton_[id].id; }
  void say(Effect::What what) { out_.push_back({*now_, std::move(what)}); }

  void change(Id id, const std::string& state) {
    static const std::map<std::string, ComponelState> kStates{
        {"scheduled", ComponelState::kScheduled},
        {"running", ComponelState::kRunning},
        {"aborting", ComponelState::kAborting},
        {"aborted", ComponelState::kAborted},
        {"ended", ComponelState::kEnded}};
    states_[id] = state;
    dates_[{id, state}] = *now_;
    if (over(id)) dates_[{id, "over"}] = *now_;
    changed_ = true;
    say(StateChanged{name(id), kStates.at(state)});
  }

  void enter_bi(Id id) {
    bi_.insert(id);
    ++visits_[id];
    pending_[id].clear();
    change(id, "scheduled");
  }

  void begin(Id id) {
    for (const LocalParameter& local : block(id).locals) say(Compute{local.name});
    for (const Id below : block(id).content) {
      if (is_block(below)) {
        enter_bi(below);
        continue;
      }
      change(below, "scheduled");
      if (automaton_[below].task() != nullptr) {
        say(Run{name(below)});
      } else {
        change(below, "running");
        say(Negotiate{name(below)});
      }
    }
  }

  void archive(Id id) {
    bi_.erase(id);
    change(id, "aborted");
    if (id == 0) end_model();
    settle();
  }

  void deactivate(Id id) {
    leaving_[id] = "aborted";
    change(id, "aborting");
    stop_content(id);
  }

  void stop_content(Id id) {
    being_told_.insert(id);
    for (const Id below : block(id).content) {
      if (bi_.count(below) > 0) {
        archive(below);
      } else if (ba_.count(below) > 0) {
        if (state_of(below) != "aborting") deactivate(below);
      } else if (state_of(below) == "scheduled" || state_of(below) == "running") {
        change(below, "aborting");
        if (automaton_[below].task() != nullptr) say(Interrupt{name(below)});
        if (automaton_[below].action() != nullptr) say(Withdraw{name(below)});
      }
      settle();
    }
    being_told_.erase(id);
  }

  // As long as some active block has all its content over, innermost first.
  void settle() {
    for (bool found = true; found && !over_;) {
      found = false;
      for (auto id = ba_.rbegin(); id != ba_.rend() && !found; ++id) {
        if (being_told_.count(*id) > 0) continue;
        const auto& content = block(*id).content;
        found = std::all_of(content.begin(), content.end(), [&](Id one) { return over(one); });
        if (!found) continue;
        content_over(*id);
        break;
      }
    }
  }

  void content_over(Id id) {
    std::string to = leaving_.count(id) > 0 ? leaving_[id] : "";
    if (to.empty()) to = block(id).type == BlockType::kLoop ? "restart" : "ended";
    leaving_.erase(id);
    if (to == "restart") return restart(id);
    ba_.erase(id);
    change(id, to);
    if (id == 0) return end_model();
    const Id parent = automaton_[id].parent;
    if (to != "ended" || block(id).end != EndMode::kImmediate || leaving_.count(parent) > 0) return;
    leaving_[parent] = block(parent).type == BlockType::kLoop ? "restart" : "ended";
    stop_content(parent);
  }

  void restart(Id id) {
    if (++restarts_[{id, *now_}] == 1000) {
      being_told_.insert(id);  // it does not begin anew until it is told to stop
      return abort();
    }
    for (Id below = id + 1; below < automaton_.size(); ++below) {
      bool inside = false;
      for (Id up = below; up != 0; up = automaton_[up].parent) {
        inside = inside || automaton_[up].parent == id;
      }
      if (!inside) continue;
      states_.erase(below);
      std::erase_if(dates_, [&](const auto& date) { return date.first.first == below; });
    }
    changed_ = true;
    begin(id);
  }

  void end_model() {
    over_ = true;
    say(ModelOver{state_of(0) == "ended" ? ComponelState::kEnded : ComponelState::kAborted, ""});
  }

  const Automaton& automaton_;
  Effects out_;
  std::optional<MissionTime> now_, start_;
  bool over_ = false, changed_ = false;
  std::set<Id> bi_, ba_, being_told_;
  std::map<Id, std::string> states_, leaving_;
  std::map<Id, std::set<std::string>> pending_;
  std::map<std::pair<Id, std::string>, MissionTime> dates_;
  std::map<std::pair<Id, MissionTime>, int> restarts_;
  std::map<Id, int> visits_;
};

}  // namespace skein::interaction::testing
