// SPDX-License-Identifier: Apache-2.0
#include "flight.hpp"

#include <algorithm>
#include <cmath>

#include "skein/foundation/overloaded.hpp"
#include "skein/world/steering.hpp"

namespace skein::autopilot {

namespace {

/// Accepted, a mode or arming has to come true within this.
constexpr Duration kTrueWithin = Duration::milliseconds(5'000);
constexpr double kLeastTolerance = 2;  // [m]
constexpr double kSlow = 1;            // [m/s]
constexpr double kRest = 0.3;          // [m/s]
constexpr Duration kRestTime = Duration::milliseconds(1'000);

bool comes_at_once(const Goal& goal) {
  return std::holds_alternative<InMode>(goal) || std::holds_alternative<Armed>(goal);
}

/// What only an armed vehicle can reach.
bool needs_motors(const Goal& goal) {
  return std::holds_alternative<AtHeight>(goal) || std::holds_alternative<Near>(goal);
}

}  // namespace

Flight::Flight(const world::VehicleModel& model)
    : tolerance_(std::max(kLeastTolerance, world::reaching_distance(model, {}))) {}

void Flight::begin(std::deque<Step> steps) {
  steps_ = std::move(steps);
  stage_ = steps_.empty() ? Stage::kNone : Stage::kAsking;
  ticket_.reset();
  answered_ = false;
  still_since_.reset();
}

void Flight::hear(const Commands::Outcome& outcome) {
  if (ticket_ != outcome.ticket || answered_) return;
  if (!outcome.accepted && !steps_.front().may_fail) return fail(outcome.why);
  answered_ = true;
  if (steps_.front().moves) stage_ = Stage::kUnderWay;
}

void Flight::fail(std::string why) {
  begin({});
  why_ = std::move(why);
  stage_ = Stage::kFailed;
}

Flight::Stage Flight::step(const Picture& picture, Duration now, Commands& commands, Hand& hand,
                           Outbox& out) {
  if (stage_ == Stage::kFailed || steps_.empty()) return stage_;
  if (!ticket_) {
    ask(now, commands, hand, out);
    return stage_;
  }
  if (!answered_) {
    answered_at_ = now;
    return stage_;
  }
  const Goal& goal = steps_.front().goal;
  if (is_true(goal, picture, now)) {
    steps_.pop_front();
    ticket_.reset();
    answered_ = false;
    if (steps_.empty()) stage_ = Stage::kDone;
    return step(picture, now, commands, hand, out);
  }
  if (comes_at_once(goal) && now - answered_at_ > kTrueWithin) {
    const bool arming = std::holds_alternative<Armed>(goal);
    fail(arming ? "the autopilot took the order to arm, and did not arm"
                : "the autopilot took the order to change its mode, and did not change it");
  } else if (needs_motors(goal) && !picture.is_armed() && now - answered_at_ > kTrueWithin) {
    fail("the vehicle was disarmed");
  }
  return stage_;
}

void Flight::ask(Duration now, Commands& commands, Hand& hand, Outbox& out) {
  const Step& step = steps_.front();
  if (!step.modes.empty()) hand.ask_for(step.modes, now);
  ticket_ = commands.ask(step.command, now, out);
  answered_at_ = now;
}

bool Flight::is_true(const Goal& goal, const Picture& picture, Duration now) {
  const world::VehicleState& state = picture.state();
  const auto is_near = [&](const Near& near) {
    const world::Vector3 away = near.point - state.position;
    return away.head<2>().norm() <= tolerance_ && std::abs(away.z()) <= tolerance_ &&
           (!near.stops || state.velocity.norm() <= kSlow);
  };
  const auto rests = [&] {
    if (state.velocity.norm() > kRest) {
      still_since_.reset();
      return false;
    }
    if (!still_since_) still_since_ = now;
    return now - *still_since_ >= kRestTime;
  };
  return std::visit(Overloaded{[](const Answered&) { return true; },
                               [&](const InMode& in) { return picture.mode() == in.mode; },
                               [&](const Armed&) { return picture.is_armed(); },
                               [&](const AtHeight& at) {
                                 return state.airborne &&
                                        std::abs(state.position.z() - at.height) <= tolerance_ &&
                                        std::abs(state.velocity.z()) <= 2 * kRest;
                               },
                               [&](const Near& near) { return is_near(near); },
                               [&](const OnGround&) { return !state.airborne; },
                               [&](const AtRest&) { return rests(); }},
                    goal);
}

std::string Flight::activity() const {
  return steps_.empty() || steps_.front().activity.empty() ? "" : steps_.front().activity;
}

}  // namespace skein::autopilot
