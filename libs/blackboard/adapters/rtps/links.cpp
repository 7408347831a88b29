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
  for (std::size_t i = 0; i < plan.channels.size(); ++i) {
    plans_.push_back(plan_link(plan, i, config));
    awaited_.await(i, plans_.back());
  }
}

Result<void, Failure> Links::open(const Make& make) {
  SKEIN_EXPECTS(links_.empty());
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    links_.emplace_back(plans_[i], make(i, plans_[i]), log_);
    if (auto opened = links_.back().open(); !opened) return opened;
  }
  return {};
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
  return mailbox_.take();
}

void Links::flush() {
  const auto until = Endpoints::Clock::now() + kLastWords;
  for (Link& link : links_) link.flush(until);
}

}  // namespace skein::blackboard::rtps
