// SPDX-License-Identifier: Apache-2.0
// What the transports over RTPS have in common: the channels of a node, and what comes in on them.
#include "links.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::blackboard::rtps {
namespace {

/// How long the end of a node may be held up by those who have not yet got its last words.
constexpr std::chrono::milliseconds kLastWords{2000};

}  // namespace

void Links::plan(const TransportPlan& plan, const DdsConfig& config) {
  SKEIN_EXPECTS(plans_.empty());
  log_ = config.log;
  heartbeats_ = HeartbeatReader::of(plan, config);
  for (std::size_t i = 0; i < plan.channels.size(); ++i) {
    plans_.push_back(plan_link(plan, i, config));
    awaited_.await(i, plans_.back());
    if (heartbeats_ && heartbeats_->covers(i))
      std::erase(plans_.back().reads, wire::Slot::kHeartbeat);
  }
  scouts_ = scouts_of(plans_, config);
}

std::set<wire::Slot> Links::written() const {
  std::set<wire::Slot> slots;
  for (const LinkPlan& plan : plans_) slots.insert(plan.writes.begin(), plan.writes.end());
  return slots;
}

Result<void, Failure> Links::open(const Make& make) {
  SKEIN_EXPECTS(links_.empty());
  for (std::size_t i = 0; i < plans_.size(); ++i)
    if (auto opened = open_one(i, plans_[i], make); !opened) return opened;
  if (heartbeats_) {
    if (auto opened = open_one(links_.size(), heartbeats_->link(), make); !opened) return opened;
  }
  return scouts_ ? open_one(links_.size(), *scouts_, make) : Result<void, Failure>();
}

Result<void, Failure> Links::open_one(std::size_t channel, const LinkPlan& plan, const Make& make) {
  links_.emplace_back(plan, make(channel, plan), log_);
  return links_.back().open();
}

bool Links::write(std::size_t channel, const wire::Sample& sample) {
  return links_.at(channel).write(sample);
}

Result<void, Failure> Links::set_up(std::size_t channel, bool up) {
  return links_.at(channel).set_up(up);
}

std::vector<Arrival> Links::take() {
  for (const auto& [channel, slot] : awaited_.take()) links_.at(channel).attend(slot);
  for (const auto& [channel, slot] : matches_.take()) links_.at(channel).meet(slot);
  return heartbeats_ ? sorted(mailbox_.take()) : mailbox_.take();
}

std::vector<Arrival> Links::sorted(std::vector<Arrival> arrivals) const {
  std::erase_if(arrivals, [this](Arrival& arrival) {
    if (arrival.channel < plans_.size()) return false;
    arrival.channel = heartbeats_->channel_of(arrival);
    return !links_[arrival.channel].up();
  });
  return arrivals;
}

void Links::flush() {
  const auto until = Endpoints::Clock::now() + kLastWords;
  for (Link& link : links_) link.flush(until);
}

void Links::close() {
  for (Link& link : links_)
    if (auto closed = link.set_up(false); !closed && log_) log_(closed.error().why);
}

}  // namespace skein::blackboard::rtps
