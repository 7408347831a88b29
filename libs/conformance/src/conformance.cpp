// SPDX-License-Identifier: Apache-2.0
#include "skein/conformance/conformance.hpp"

#include <utility>

#include "skein/foundation/overloaded.hpp"

namespace skein::conformance {

namespace {
constexpr const char* kRestart = "killed and started again, it is there in a new incarnation";
}  // namespace

Conformance::Conformance(Config config) : config_(std::move(config)), points_(points_of(config_)) {}

std::vector<Conformance::Point> Conformance::points_of(const Config& config) {
  using C = Conformance;
  const Duration answer = config.answer_within;
  const Duration act = config.act_within;
  std::vector<Point> points{
      {"it tells of itself all the time", &C::nothing, &C::tells_of_itself, answer},
      {"an unknown type is refused with a reason", &C::unknown_type, &C::refused, answer},
      {"an unknown parameter is refused with a reason", &C::unknown_parameter, &C::refused, answer},
      {"an interruption of nothing is answered by aborted", &C::interrupt_of_nothing, &C::refused,
       answer},
      {"a way is refused on the ground", &C::way, &C::refused, answer},
      {"a takeoff runs, ends, and leaves it in the air", &C::takeoff, &C::is_up, act},
      {"a task that comes again is answered, not done again", &C::the_same_again, &C::told_again,
       answer, true},
      {"a way is flown to its end", &C::way, &C::arrives, act, true},
      {"a way begins to run", &C::way, &C::runs, answer, true},
      {"a second motion is refused while one is active", &C::second_motion, &C::refused, answer,
       true},
      {"a task under way that comes again is told as running", &C::the_same_again, &C::told_again,
       answer, true},
      {"an interrupted way is aborted, and it stays where it is", &C::interrupt, &C::stays, act,
       true},
      {"a wait begins to run", &C::wait, &C::runs, answer, true},
      {"an interrupted wait is aborted", &C::interrupt, &C::aborted, answer, true}};
  if (config.restart_within) {
    points.push_back({"a wait runs when it is to be restarted", &C::wait, &C::runs, answer, true});
    points.push_back({kRestart, &C::nothing_new, &C::is_back, *config.restart_within, true});
    points.push_back({"what was under way then may be asked for again, and begins",
                      &C::the_same_again, &C::runs, answer, true});
    points.push_back({"and when it is interrupted the vehicle stays where it is", &C::interrupt,
                      &C::stays, act, true});
  }
  if (!config.device.empty()) {
    points.push_back({"a look runs, and its perceptions come", &C::look, &C::looks, act, true});
    points.push_back({"an interrupted look is aborted", &C::interrupt, &C::aborted, answer, true});
  }
  points.push_back({"a landing ends on the ground", &C::land, &C::is_down, act, true});
  points.push_back({"on the ground a way is refused again", &C::way, &C::refused, answer});
  return points;
}

std::vector<functional::Request> Conformance::handle(const Input& input, MissionTime now) {
  if (done()) return {};
  std::vector<functional::Request> requests;
  if (!begun_) requests = begin(now);
  std::visit(Overloaded{[](const Tick&) {},
                        [&](const functional::Status& it) { seen_.statuses.push_back(it); },
                        [&](const world::Telemetry& it) {
                          seen_.telemetry.push_back(it);
                          if (!first_) first_ = it;
                          last_ = it;
                        },
                        [&](const world::Perception& it) { seen_.perceptions.push_back(it); },
                        [&](const Restarted&) { seen_.restarted = true; }},
             input);
  const Point& point = points_[point_];
  if (const Judgement judgement = (this->*point.judge)(now)) {
    decide(*judgement);
  } else if (now - seen_.began >= point.within) {
    const auto statuses = of_task();
    decide(statuses.empty() ? "no answer"
                            : "after " + std::string(to_text(statuses.back().state)) +
                                  " nothing that was expected");
  }
  return requests;
}

std::vector<functional::Request> Conformance::begin(MissionTime now) {
  while (!done() && points_[point_].needs_flight && !is_airborne()) decide("it is not in the air");
  seen_ = {};
  seen_.began = now;
  refused_.reset();
  begun_ = true;
  return done() ? std::vector<functional::Request>() : (this->*points_[point_].ask)();
}

void Conformance::decide(const std::string& seen) {
  verdicts_.push_back({points_[point_].name, seen.empty(), seen});
  ++point_;
  begun_ = false;
}

// It is asked for the next point at once, and looked at again when a point has had its time.
std::optional<MissionTime> Conformance::next_wakeup() const {
  if (done()) return std::nullopt;
  return begun_ ? seen_.began + points_[point_].within : seen_.began;
}

bool Conformance::wants_restart() const {
  return !done() && begun_ && points_[point_].name == kRestart;
}

bool Conformance::is_airborne() const { return last_ && last_->state.airborne; }

}  // namespace skein::conformance
