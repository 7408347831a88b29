// SPDX-License-Identifier: Apache-2.0
// For whom a motion waits, and who waits for what is flown.
#include "merging/air_orders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/elementary/parameter_reader.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr functional::TaskId kMotion{3}, kPortion{4'500'000'000'000'007};
const MissionTime kNow = MissionTime::seconds(1);

merging::Volume stretch(double from, double to) { return {{from, 0}, {to, 0}, 5, 30, 50}; }

functional::Request flight(functional::TaskId id) {
  return {functional::Verb::kDispatch, id, "goto", {}};
}

/// Of "b", whose only peer has said this.
class Orders : public ::testing::Test {
 protected:
  void peer_says(merging::Claim claim) {
    merging::Message message;
    message.number = message.version = ++said_;
    message.claim = std::move(claim);
    merger_.handle(merging::Heard{"a", message}, kNow);
  }
  void waits_for(const merging::Volume& air) {
    waiting_ = waiting_since(kNow, flight(kMotion));
    merger_.handle(merging::Want{{{air}}}, kNow);
  }
  void flies(functional::TaskId id) {
    Airway airway;
    airway.request = flight(id);
    vehicle_.begin(Flown{airway});
  }
  supervisor::AirOrders seen() const {
    return air_orders("b", waiting_, portions_, vehicle_, merger_);
  }

  merging::Merger merger_{{"a", "b"}, "b"};
  std::uint64_t said_ = 0;
  VehicleAir vehicle_{merging::Margins()};
  std::optional<Waiting> waiting_;
  std::optional<Portions> portions_;
};

using world::Vector3;

Portions sweep() {
  functional::Request request = flight(kMotion);
  const std::vector<Vector3> points{
      {0, 400, 40}, {60, 400, 40}, {60, 0, 40}, {120, 0, 40}, {120, 400, 40}};
  request.parameters.add(elementary::points_parameter("waypoints", points));
  request.parameters.add("speed", 5.0);
  return *Portions::of(request, {points, 5}, Vector3::Zero(), 20);
}

TEST_F(Orders, AMotionWaitsForThoseWhoHoldItsAir) {
  peer_says({{stretch(0, 100)}, 0, {}, {}});
  waits_for(stretch(50, 60));
  EXPECT_THAT(seen().for_others, ElementsAre("a"));
  EXPECT_EQ(seen().waits, kMotion);
  EXPECT_EQ(seen().flies, std::nullopt);
}

TEST_F(Orders, WhatWaitsForNobodyToLeaveIsNotSaidToWait) {
  waits_for(stretch(50, 60));  // for the peer to tell what it has
  EXPECT_THAT(seen().for_others, IsEmpty());
  EXPECT_EQ(seen().waits, std::nullopt);
}

TEST_F(Orders, WhoWaitsForThePlaceAtItsEndIsToldFromWhoWaitsForItsWay) {
  merger_.handle(merging::Hold{{stretch(0, 100), stretch(100, 110)}}, kNow);
  flies(kMotion);
  peer_says({{}, 0, {stretch(40, 50)}, {"b"}});
  EXPECT_THAT(seen().for_its_way, ElementsAre("a"));
  EXPECT_THAT(seen().for_its_place, IsEmpty());
  EXPECT_EQ(seen().flies, kMotion);
  peer_says({{}, 0, {stretch(105, 130)}, {"b"}});
  EXPECT_THAT(seen().for_its_way, IsEmpty());
  EXPECT_THAT(seen().for_its_place, ElementsAre("a"));
}

TEST_F(Orders, OfASweepThatHasBegunTheWholeIsFlownAndNothingWaits) {
  peer_says({{stretch(0, 100)}, 0, {}, {}});
  waits_for(stretch(50, 60));
  portions_ = sweep();
  EXPECT_EQ(seen().waits, kMotion) << "its first portion";
  portions_->flown = kPortion;
  portions_->running = true;
  flies(kPortion);
  EXPECT_EQ(seen().flies, kMotion);
  EXPECT_EQ(seen().waits, std::nullopt);
  EXPECT_THAT(seen().for_others, IsEmpty());
  flies(functional::TaskId(9));
  EXPECT_EQ(seen().flies, functional::TaskId(9));
}

}  // namespace
}  // namespace skein::decision_node
