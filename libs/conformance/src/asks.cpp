// SPDX-License-Identifier: Apache-2.0
// What is asked for each point.
#include <cmath>

#include "skein/conformance/conformance.hpp"

namespace skein::conformance {

using functional::Parameters;
using functional::Request;
using functional::Verb;

Request Conformance::dispatch(std::string type, Parameters parameters) {
  asked_ = {Verb::kDispatch, new_task(), std::move(type), std::move(parameters)};
  return asked_;
}

/// On the circle around where it first was, at a part of a turn; at flight height.
std::vector<double> Conformance::point_at(double part) const {
  const world::Vector3 home = first_ ? first_->state.position : world::Vector3::Zero();
  const double angle = 2 * std::acos(-1.0) * part;
  return {home.x() + config_.reach * std::cos(angle), home.y() + config_.reach * std::sin(angle),
          home.z() + config_.height};
}

std::vector<Request> Conformance::nothing() {
  asked_ = {};
  return {};
}

// What was asked stays what is asked about.
std::vector<Request> Conformance::nothing_new() { return {}; }

std::vector<Request> Conformance::unknown_type() { return {dispatch("no-such-task", {})}; }

std::vector<Request> Conformance::unknown_parameter() {
  return {dispatch("takeoff", {{"altitude", "", {config_.height}}, {"no-such-thing", "", {1}}})};
}

std::vector<Request> Conformance::interrupt_of_nothing() {
  asked_ = {Verb::kInterrupt, new_task()};
  return {asked_};
}

// Each time to another side, so that there is a way to fly.
std::vector<Request> Conformance::way() {
  const double part = static_cast<double>(next_task_) * 0.37;
  std::vector<double> points = point_at(part);
  const std::vector<double> second = point_at(part + 0.2);
  points.insert(points.end(), second.begin(), second.end());
  return {dispatch("goto", {{"waypoints", "", points}})};
}

std::vector<Request> Conformance::takeoff() {
  return {dispatch("takeoff", {{"altitude", "", {config_.height}}})};
}

std::vector<Request> Conformance::the_same_again() { return {asked_}; }

// The way that is under way stays what is asked again and interrupted.
std::vector<Request> Conformance::second_motion() {
  const Request under_way = asked_;
  const std::vector<Request> second = way();
  refused_ = asked_.id;
  asked_ = under_way;
  return second;
}

std::vector<Request> Conformance::interrupt() { return {{Verb::kInterrupt, asked_.id}}; }

std::vector<Request> Conformance::look() {
  return {dispatch("takeshot", {{"device", config_.device, {}}})};
}

std::vector<Request> Conformance::wait() { return {dispatch("wait", {})}; }

std::vector<Request> Conformance::land() { return {dispatch("land", {})}; }

}  // namespace skein::conformance
