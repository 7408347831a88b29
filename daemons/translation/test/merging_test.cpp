// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/merging.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "skein/blackboard/channel.hpp"

namespace skein::translation {
namespace {

merging::Volume any_volume() {
  const auto figure = [](int low, int high) { return *rc::gen::inRange(low, high) / 8.0; };
  const double floor = figure(-400, 4000);
  return {{figure(-9000, 9000), figure(-9000, 9000)},
          {figure(-9000, 9000), figure(-9000, 9000)},
          figure(1, 900),
          floor,
          floor + figure(1, 900)};
}

/// Some begin where the one before ended, some stay there, some stay elsewhere.
merging::Volumes any_volumes() {
  merging::Volumes all;
  for (int n = *rc::gen::inRange(0, 5); n > 0; --n) {
    merging::Volume one = any_volume();
    if (!all.empty() && *rc::gen::arbitrary<bool>()) one.from = all.back().to;
    if (*rc::gen::arbitrary<bool>()) one.to = one.from;
    all.push_back(one);
  }
  return all;
}

/// A leg in pieces, as a way has it, each higher by `rise`, and where it stays at its end.
merging::Volumes leg(const world::Vector2& from, const world::Vector2& to, int pieces,
                     double rise = 0) {
  merging::Volumes all;
  world::Vector2 begins = from;
  for (int n = 1; n <= pieces; ++n) {
    const world::Vector2 ends = from + static_cast<double>(n) / pieces * (to - from);
    const double above = n * rise;
    all.push_back({begins, ends, 12.3, 20 + above, 30 + above});
    begins = ends;
  }
  const double above = pieces * rise;
  all.push_back({begins, begins, 7.1, 20 + above, 30 + above});
  return all;
}

wire::MergeMessage that_holds(const merging::Volumes& held) {
  merging::Message message;
  message.claim.held = held;
  return to_wire(message);
}

RC_GTEST_PROP(MergeMessage, ComesBackAsItWent, ()) {
  merging::Message message;
  message.number = *rc::gen::arbitrary<std::uint64_t>();
  message.claim = {
      any_volumes(), *rc::gen::arbitrary<std::uint64_t>(), any_volumes(),
      *rc::gen::element(std::vector<std::string>{}, std::vector<std::string>{"heliv", "karma"}),
      *rc::gen::arbitrary<bool>()};
  message.answered = *rc::gen::arbitrary<std::uint64_t>();
  message.granted = *rc::gen::arbitrary<bool>();
  message.asks = *rc::gen::arbitrary<bool>();
  message.of = *rc::gen::element<std::string>("", "karma");
  message.version = *rc::gen::arbitrary<std::uint64_t>();
  message.known = *rc::gen::arbitrary<std::uint64_t>();
  message.brief = *rc::gen::arbitrary<bool>();
  message.lacks = *rc::gen::arbitrary<bool>();

  const auto back = from_wire(to_wire(message));

  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == message);
}

RC_GTEST_PROP(MergeMessage, PiecesOfALegComeBackWithinANanometre, ()) {
  const auto figure = [] { return *rc::gen::inRange(-90'000, 90'000) / 9.7; };
  const bool level = *rc::gen::arbitrary<bool>();
  merging::Volumes air = leg({figure(), figure()}, {figure(), figure()}, *rc::gen::inRange(1, 250),
                             level ? 0 : figure() / 1'000);
  const auto given_back = *rc::gen::inRange<std::size_t>(0, air.size());
  air.erase(air.begin(), air.begin() + static_cast<std::ptrdiff_t>(given_back));

  const auto back = from_wire(that_holds(air));

  RC_ASSERT(back.has_value());
  const merging::Volumes& held = back->claim.held;
  RC_ASSERT(held.size() == air.size());
  RC_ASSERT(held.back() == air.back());
  for (std::size_t i = 0; i < air.size(); ++i) {
    RC_ASSERT((held[i].from - air[i].from).norm() < 1e-9);
    RC_ASSERT((held[i].to - air[i].to).norm() < 1e-9);
    if (i > 0) RC_ASSERT(held[i].from == held[i - 1].to);  // RC_ASSERT evaluates both sides of ||
    RC_ASSERT(held[i].radius == air[i].radius);
    RC_ASSERT(std::abs(held[i].floor - air[i].floor) <= (level ? 0 : 1e-9));
    RC_ASSERT(std::abs(held[i].ceiling - air[i].ceiling) <= (level ? 0 : 1e-9));
  }
}

TEST(MergeMessage, ALegIsOneRowHoweverLongItIs) {
  for (const double rise : {0.0, -2.7}) {
    const wire::MergeMessage near = that_holds(leg({0, 0}, {70, 10}, 2, rise));
    const wire::MergeMessage far = that_holds(leg({0, 0}, {1'900, 300}, 39, rise));

    EXPECT_EQ(near.held.size(), 2U);
    EXPECT_EQ(blackboard::channel_bytes(far), blackboard::channel_bytes(near));
  }
}

TEST(MergeMessage, WhatIsWiderHigherOrElsewhereIsARowOfItsOwn) {
  merging::Volumes air = leg({0, 0}, {200, 0}, 4);
  air.pop_back();
  for (const auto& changed : {merging::Volume{{200, 0}, {250, 0}, 13, 20, 30},
                              merging::Volume{{200, 0}, {250, 0}, 12.3, 19, 30},
                              merging::Volume{{200, 0}, {250, 0}, 12.3, 20, 31},
                              merging::Volume{{200, 0}, {249, 0}, 12.3, 20, 30},
                              merging::Volume{{200, 0}, {200, 50}, 12.3, 20, 30},
                              merging::Volume{{201, 0}, {251, 0}, 12.3, 20, 30}}) {
    air.push_back(changed);
    const wire::MergeMessage sample = that_holds(air);
    EXPECT_EQ(sample.held.size(), 2U);
    EXPECT_EQ(from_wire(sample)->claim.held.back(), changed);
    air.pop_back();
  }
}

TEST(MergeMessage, ARowThatNobodySendsIsRefused) {
  const auto problem = [](const auto& change) {
    wire::MergeMessage sample = that_holds(leg({0, 0}, {200, 0}, 4));
    change(sample.held);
    const auto back = from_wire(sample);
    return back ? "" : back.error().field + ": " + back.error().why;
  };

  EXPECT_EQ(problem([](auto& held) { held[0].pieces = 0; }), "held[0].pieces: not from 1 to 100");
  EXPECT_EQ(problem([](auto& held) { held[0].pieces = 101; }), "held[0].pieces: not from 1 to 100");
  EXPECT_EQ(problem([](auto& held) { held[1].line.resize(3); }),
            "held[1].line: more than two places");
  EXPECT_EQ(problem([](auto& held) { held[0].line.clear(); }), "held[0].line: nowhere");
  EXPECT_EQ(problem([](auto&) {}), "");
}

TEST(MergeMessage, AirWithoutExtentIsRefusedByItsPlace) {
  merging::Message message;
  message.claim.held = {{{0, 0}, {9, 0}, 5, 10, 20}, {{0, 0}, {9, 0}, 0, 10, 20}};
  message.claim.wanted = {{{0, 0}, {9, 0}, 5, 20, 20}};

  EXPECT_EQ(from_wire(to_wire(message)).error(),
            (wire::Violation{"held[1].radius", "not greater than 0"}));
  message.claim.held.pop_back();
  EXPECT_EQ(from_wire(to_wire(message)).error(),
            (wire::Violation{"wanted[0].ceiling_z", "not above the floor"}));
}

}  // namespace
}  // namespace skein::translation
