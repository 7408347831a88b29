// SPDX-License-Identifier: Apache-2.0
#include "skein/air/weather.hpp"

#include <algorithm>

namespace skein::air {

Weather::Weather(std::vector<std::uint32_t> numbers, Everywhere everywhere, Air& air)
    : numbers_(std::move(numbers)), everywhere_(everywhere), air_(air) {}

void Weather::hear(const wire::Sample& sample) {
  if (const auto* clock = std::get_if<wire::Clock>(&sample)) {
    const bool runs = clock->phase == wire::ClockPhase::kRunning;
    mission_time_ = clock->time;
    if (runs == running_ && clock->rate == rate_) return;
    running_ = runs;
    rate_ = clock->rate > 0 ? clock->rate : 1;
    apply();
  } else if (const auto* state = std::get_if<wire::LinkState>(&sample)) {
    states_[{state->from, state->to}] = *state;
    apply();
  }
}

Condition Weather::condition_of(const wire::LinkState& state) const {
  Condition condition;
  condition.up = state.up;
  condition.loss = std::max(state.loss, everywhere_.loss);
  const double delay = static_cast<double>(state.latency) / rate_;
  condition.delay = Duration::nanoseconds(static_cast<std::int64_t>(delay)) + everywhere_.delay;
  const double told = state.capacity / 8 * rate_;
  condition.rate = everywhere_.rate > 0 ? everywhere_.rate : told;
  return condition;
}

void Weather::apply() {
  for (std::size_t from = 0; from < numbers_.size(); ++from) {
    for (std::size_t to = 0; to < numbers_.size(); ++to) {
      if (from == to) continue;
      Condition condition;
      if (running_) {
        auto state = states_.find({numbers_[from], numbers_[to]});
        if (state == states_.end()) state = states_.find({0, 0});  // of every other link
        wire::LinkState fine;
        fine.up = true;
        condition = condition_of(state == states_.end() ? fine : state->second);
      }
      air_.set(from, to, condition);
    }
  }
}

}  // namespace skein::air
