// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/merging.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

merging::Volumes any_volumes() {
  merging::Volumes all;
  for (int n = *rc::gen::inRange(0, 5); n > 0; --n) all.push_back(any_volume());
  return all;
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

  const auto back = from_wire(to_wire(message));

  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == message);
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
