// SPDX-License-Identifier: Apache-2.0
// Ways that something is looked at along are flown in portions.
#include <utility>

#include "core.hpp"
#include "merging/merging.hpp"

namespace skein::decision_node {

/// What waits is from now on the portion that comes next. Who got out of the way between two of
/// them comes back to where it left the way.
void Merging::cut() {
  functional::Request& flight = waiting_->request;
  if (portions_ && portions_->task() == flight.id) {
    flight = portions_->next(portions_->running ? place_ : std::nullopt);
    return;
  }
  portions_.reset();
  if (may_be_raised(true)) return;
  const auto task = flight_of(flight, *core_.config().merging, situation());
  if (task) portions_ = Portions::of(flight, *task, vehicle_.state().position, 2 * margins_.way);
  if (portions_) flight = portions_->next();
}

/// Under a number of its own, but for the last: with that the motion is over.
void Merging::take_portion(functional::Request& flight) {
  if (!portions_ || portions_->task() != flight.id) return portions_.reset();
  portions_->take();
  if (portions_->is_last_taken()) {
    if (portions_->running) runs_already_ = portions_->task();
    return portions_.reset();
  }
  flight.id = own_ids_.take();
  portions_->flown = flight.id;
}

bool Merging::flies_portion() const {
  return portions_ && portions_->flown && vehicle_.flies(*portions_->flown);
}

/// So early that it has the next portion, as a rule, before it would stop.
void Merging::ask_ahead() {
  if (!flies_portion() || waiting_ || portions_->ahead || portions_->stopped) return;
  const Airway& flight = vehicle_.flown()->airway;
  if (!portions_->is_near_end(flight.way->length_left())) return;
  AirwaySituation there = resting_at(situation(), *flight.end);
  there.passing = true;
  auto airways = airways_of(portions_->next(), false, *core_.config().merging, there);
  if (!airways) return;  // as it will be refused there
  waiting_ = waiting_since(core_.bus().now(), portions_->next());
  want(std::move(*airways));
}

void Merging::had_ahead(Airway airway) {
  waiting_->since = core_.bus().now();
  waiting_->note(core_.bus(), "ahead", &airway);
  portions_->ahead = std::move(airway);
  waiting_.reset();
  hold();
}

/// It flies on without a stop, waits for its air where the portion ended, or the motion ends with
/// it: also when an own task waits for that, which nobody can be asked for air before.
void Merging::portion_over(const functional::Status& status) {
  const bool goes_on = status.state == functional::TaskState::kEnded && !portions_->stopped &&
                       core_.own_tasks().none_open();
  if (goes_on && portions_->ahead) return fly_on();
  if (waiting_) stop_waiting();
  if (goes_on) {
    waiting_ = waiting_since(core_.bus().now(), portions_->next());
    return;
  }
  const functional::TaskId task = portions_->task();
  portions_.reset();
  hold();
  core_.post_status({task, functional::TaskState::kAborted,
                     status.reason.empty() ? "interrupted between two portions" : status.reason,
                     status.cause});
}

void Merging::fly_on() {
  Airway next = *std::exchange(portions_->ahead, std::nullopt);
  core_.bus().emit(AirNoted{portions_->task(), next.request.type, "had", {}, 0, {}, next.air});
  Flown flight{std::move(next), false, false, vehicle_.air()};
  take_portion(flight.airway.request);
  functional::Request request = flight.airway.request;
  vehicle_.begin(std::move(flight));
  hold();
  core_.vehicle().begin(std::move(request));
}

std::optional<functional::TaskId> Merging::stop_portions(functional::TaskId task) {
  if (!flies_portion() || portions_->task() != task) return std::nullopt;
  portions_->stopped = true;
  portions_->ahead.reset();
  if (waiting_) stop_waiting();
  hold();
  return portions_->flown;
}

}  // namespace skein::decision_node
