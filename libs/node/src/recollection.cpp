// SPDX-License-Identifier: Apache-2.0
#include "recollection.hpp"

#include <memory>
#include <utility>

#include "skein/foundation/overloaded.hpp"

namespace skein::node {

namespace {

bool is_state(const wire::Sample& sample) {
  return wire::slot_class(wire::slot_of(sample)) == wire::SlotClass::kState;
}

/// Answers as the clock of the job did.
TimeIsUp again(const JobClock& clock) {
  if (!clock.given) return {};
  const auto left = std::make_shared<std::uint64_t>(clock.questions);
  return [left, ran_out = clock.ran_out] {
    if (*left == 0) return ran_out;
    --*left;
    return false;
  };
}

}  // namespace

Result<Survey, Failure> survey(const InputLog& memory) {
  Survey found;
  const auto read = memory.recall_lives([&](const LogEntry& entry) -> Result<void, Failure> {
    if (const auto* started = std::get_if<Started>(&entry.input)) {
      if (started->incarnation <= found.incarnation)
        return failure("a later incarnation of it has the number of an earlier one");
      found = {started->incarnation, 1, found.births + 1, {}};
    } else if (found.births == 0) {
      return failure("it does not begin with the start of a node");
    } else if (std::holds_alternative<Resumed>(entry.input)) {
      ++found.lives;
    } else if (const auto* unsent = std::get_if<Unsent>(&entry.input)) {
      found.unsent.insert(unsent->send);
    }
    return {};
  });
  if (!read) return tl::unexpected(read.error());
  return found;
}

Result<void, Failure> Recollection::run(const InputLog& memory) {
  told_ = memory.lines_told();
  node_.begin_recall();
  auto taken = memory.recall([this](const LogEntry& entry) { return take(entry); });
  follow(node_.end_recall(), until_);
  if (taken && told_ > lines_) {
    return failure("what it was given does not explain the " + std::to_string(told_) +
                   " lines that it wrote: another version of the program, or another scenario");
  }
  return taken;
}

Result<void, Failure> Recollection::take(const LogEntry& entry) {
  if (entry.at < until_) return failure("its time goes back");
  until_ = entry.at;
  if (std::holds_alternative<Started>(entry.input)) be_born();
  if (blackboard_ != nullptr && births_ == survey_.births) tell(entry);
  if (const auto* reach = std::get_if<Reachability>(&entry.input))
    reachable_[reach->peer] = reach->reachable;
  return std::visit(Overloaded{[&](const JobEnded& ended) { return end(ended, entry.at); },
                               [](const Skipped&) { return Result<void, Failure>(); },
                               [](const Acknowledged&) { return Result<void, Failure>(); },
                               [](const Resumed&) { return Result<void, Failure>(); },
                               [](const Unsent&) { return Result<void, Failure>(); },
                               [&](const auto& one) { return give(one, entry.at); }},
                    entry.input);
}

// An incarnation that forgot: only what it plays of the world is as before.
void Recollection::be_born() {
  if (births_++ == 0) return;
  lines_ = sends_ = 0;
  reachable_.clear();
  states_.clear();
  lines_left_.clear();
  jobs_.clear();
  stopped_.clear();
  finished_ = false;
}

// What the blackboard did with its peers before the node was given the input.
void Recollection::tell(const LogEntry& entry) {
  std::visit(
      Overloaded{
          [&](const Received& one) {
            blackboard_->recall_received(wire::slot_of(one.sample), wire::header_of(one.sample));
          },
          [&](const Skipped& one) { blackboard_->recall_received(one.slot, one.header); },
          [&](const Acknowledged& one) {
            blackboard_->recall_acknowledged(one.peer, one.sequence);
          },
          [&](const Reachability& one) { blackboard_->recall_reachable(one.peer, one.reachable); },
          [&](const Undelivered& one) { blackboard_->recall_given_up(one.to, one.sequence); },
          [](const auto&) {}},
      entry.input);
}

Result<void, Failure> Recollection::give(const Input& input, MissionTime at) {
  follow(node_.handle(input, at), at);
  return {};
}

Result<void, Failure> Recollection::end(const JobEnded& ended, MissionTime at) {
  auto job = jobs_.extract(ended.id);
  if (job.empty()) return failure("job " + std::to_string(ended.id) + " ended that nobody began");
  stopped_.erase(ended.id);
  return give(JobDone{ended.id, job.mapped().work(again(ended.clock)), ended.clock}, at);
}

void Recollection::follow(Effects effects, MissionTime at) {
  for (Effect& effect : effects) {
    std::visit(
        Overloaded{
            [&](Send& one) { sent(std::move(one), at); },
            [&](Publish& one) {
              if (!is_state(one.sample)) return;
              const std::pair key{wire::slot_of(one.sample), wire::header_of(one.sample).instance};
              world_states_.insert_or_assign(key, std::move(one));
            },
            [&](Log& one) {
              if (lines_++ >= told_) lines_left_.push_back(std::move(one));
            },
            [&](StartJob& one) { jobs_.insert_or_assign(one.id, std::move(one)); },
            [&](StopJob& one) { stopped_.insert(one.id); }, [&](Finish&) { finished_ = true; }},
        effect);
  }
}

void Recollection::sent(Send send, MissionTime at) {
  if (births_ == survey_.births && survey_.unsent.contains(sends_++)) return;
  if (is_state(send.sample)) {
    const StateKey key{send.to, wire::slot_of(send.sample), wire::header_of(send.sample).instance};
    states_.insert_or_assign(key, std::move(send));
  } else if (blackboard_ != nullptr && births_ == survey_.births) {
    blackboard_->recall_sent(std::move(send.sample), send.to, at, {send.expires, send.receipt});
  }
}

Effects Recollection::left_of_the_world() {
  Effects effects;
  for (auto& [key, publish] : world_states_) effects.emplace_back(std::move(publish));
  return effects;
}

Effects Recollection::left() {
  Effects effects = left_of_the_world();
  for (auto& [key, send] : states_) effects.emplace_back(std::move(send));
  for (Log& line : lines_left_) effects.emplace_back(std::move(line));
  for (auto& [id, job] : jobs_) effects.emplace_back(std::move(job));
  for (const std::uint64_t id : stopped_) effects.emplace_back(StopJob{id});
  if (finished_) effects.emplace_back(Finish{});
  return effects;
}

Result<void, Failure> explains(const InputLog& memory, Node& node) {
  auto found = survey(memory);
  if (!found) return tl::unexpected(found.error());
  return Recollection(node, nullptr, std::move(*found)).run(memory);
}

}  // namespace skein::node
