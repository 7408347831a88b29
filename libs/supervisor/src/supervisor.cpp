// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/supervisor.hpp"

#include <algorithm>

#include "core.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

Supervisor::Supervisor(Config config) : core_(std::make_unique<Core>(std::move(config))) {}
Supervisor::~Supervisor() = default;
Supervisor::Supervisor(Supervisor&&) noexcept = default;
Supervisor& Supervisor::operator=(Supervisor&&) noexcept = default;

Effects Supervisor::handle(const Input& input, MissionTime now) {
  return core_->handle(input, now);
}
std::optional<MissionTime> Supervisor::next_wakeup() const { return core_->next_wakeup(); }
bool Supervisor::engaged() const { return core_->engaged(); }
const mission::PlanReport& Supervisor::report() const { return core_->report(); }

namespace {

Config checked(Config config) {
  SKEIN_EXPECTS(config.knowledge != nullptr);
  SKEIN_EXPECTS(config.world != nullptr);
  return config;
}

}  // namespace

Supervisor::Core::Core(Config config)
    : config_(checked(std::move(config))),
      world_(config_.world),
      wind_(config_.knowledge->vehicle, config_.world->wind) {
  book_.next_id = config_.first_id;
  vehicle_.position = config_.knowledge->home;
}

// First what the input says, then what follows from it: contingencies, jobs, commitment, safety.
Effects Supervisor::Core::handle(const Input& input, MissionTime now) {
  now_ = std::max(now_, now);
  std::visit([this](const auto& one) { on(one); }, input);
  if (engaged_) {
    watch();
    settle_true_goals();
    watch_air();
    start_job();
    commit();
    keep_safe();
  }
  publish();
  return std::exchange(out_, {});
}

// What is past has been dealt with.
std::optional<MissionTime> Supervisor::Core::next_wakeup() const {
  if (!engaged_) return std::nullopt;
  std::optional<MissionTime> next;
  const auto count = [&](std::optional<MissionTime> at) {
    if (at && *at > now_ && *at != MissionTime::max()) next = earliest(next, at);
  };
  count(wait_again_);
  count(end_of_safe_wait());
  if (need_) count(need_->not_before);
  count(next_closing());
  for (const auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry)) continue;
    if (entry.seen.started && !entry.overdue && !ends_by_order(entry.task)) {
      count(*entry.seen.started + entry.task.duration.most + config_.grace);
    }
    if (!entry.seen.started && !entry.late) count(late_from(entry));
  }
  if (const auto goal = next_to_give()) count(due(*goal));
  return next;
}

}  // namespace skein::supervisor
