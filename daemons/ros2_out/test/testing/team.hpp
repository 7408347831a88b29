// SPDX-License-Identifier: Apache-2.0
// A team of one that is told to ROS 2, and time for others to hear it.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "skein/blackboard/domain_lease.hpp"
#include "skein/ros2_out/ros2_out.hpp"

namespace skein::ros2_out::testing {

/// Mission time zero is 1970, the local frame stands at 40° north, 8° west.
class Team {
 public:
  Team() {
    Ros2Config config;
    config.domain = lease_.domain();
    config.narrator = {{"marvin"}, {40, -8, 200}, 0};
    auto opened = Ros2Out::open(std::move(config));
    EXPECT_TRUE(opened.has_value()) << (opened ? "" : opened.error().why);
    if (!opened) return;
    out_ = std::move(*opened);
    out_->attach([this] {
      const std::lock_guard lock(mutex_);
      asked_ = true;
      wake_.notify_one();
    });
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team() {
    if (out_) out_->detach();
  }

  std::uint32_t domain() const { return lease_.domain(); }

  /// One of everything, again and again, until the condition holds; false if it does not in time.
  bool tell_until(const std::function<bool()>& condition) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < until) {
      tell_all();
      if (condition()) return true;
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(50), [this] { return asked_; });
      asked_ = false;
    }
    return false;
  }
  /// What was asked for on skein/mission since the last time.
  std::vector<wire::OperatorRequest> requests() {
    std::vector<wire::OperatorRequest> all;
    for (wire::Sample& sample : out_->take()) {
      all.push_back(std::move(std::get<wire::OperatorRequest>(sample)));
    }
    return all;
  }

 private:
  void tell_all() {
    steady_ = steady_ + Duration::seconds(1);
    const auto at = MissionTime::seconds(1'000'000.25).count();
    wire::Telemetry telemetry;
    telemetry.uav = "marvin";
    telemetry.position = {0, 0, 50};
    telemetry.energy = 0.75;
    wire::UavTasks tasks;
    tasks.uav = "marvin";
    tasks.tasks = {{3, "goto", wire::TaskState::kRunning, "", 0, false, false}};
    wire::GroundBoard ground;
    ground.alarms.emplace_back();
    ground.alarms[0].id = 4;
    wire::UavBoard board;
    board.uav = "marvin";
    board.reachable = true;
    wire::OperatorReply reply;
    reply.who = "ros2";
    reply.number = 7;
    for (wire::Sample sample : {wire::Sample(telemetry), wire::Sample(tasks), wire::Sample(ground),
                                wire::Sample(board), wire::Sample(reply)}) {
      wire::header_of(sample).mission_time = at;
      out_->sees(sample);
    }
    node::DaemonState state;
    state.now = {MissionTime::nanoseconds(at), steady_};
    out_->turn(state);
  }

  blackboard::DomainLease lease_ = blackboard::claim_domain().value();
  std::unique_ptr<Ros2Out> out_;
  Duration steady_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool asked_ = false;
};

}  // namespace skein::ros2_out::testing
