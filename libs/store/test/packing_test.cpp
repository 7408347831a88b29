// SPDX-License-Identifier: Apache-2.0
#include "packing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <stdexcept>

namespace skein::store {
namespace {

using Bytes = std::vector<std::uint8_t>;

Row row(std::int64_t peer, const std::string& slot, Bytes body) {
  Row one;
  one.kind = "received";
  one.peer = peer;
  one.slot = slot;
  one.flags = 1;
  one.body = std::move(body);
  return one;
}

/// So long, and unlike each other.
Bytes board(std::uint8_t seed) {
  Bytes bytes(2600);
  std::uint32_t value = seed;
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>((value = value * 1664525 + 1013904223) >> 24);
  return bytes;
}

TEST(Packing, ABoardThatIsLikeTheOneBeforeTakesAlmostNothing) {
  Packing packing;
  Row first = row(2, "PlanBoard", board(1)), second = first;
  second.body[700] ^= 0x55;
  packing.pack(first);

  packing.pack(second);

  EXPECT_LT(second.body.size(), 60U);
}

TEST(Packing, WhatDoesNotBecomeShorterStaysAsItIs) {
  Packing packing;
  Row first = row(2, "PlanBoard", board(1));

  packing.pack(first);

  EXPECT_EQ(first.body, board(1));
  EXPECT_EQ(first.flags, 1);
}

TEST(Packing, ARowWithoutABodyHasNoneAfter) {
  Packing packing;
  Row empty = row(2, "", {});

  packing.pack(empty);

  EXPECT_TRUE(empty.body.empty());
  packing.unpack(empty);
  EXPECT_TRUE(empty.body.empty());
}

TEST(Packing, WhatTheBodyBeforeItIsMissingForIsDamaged) {
  Packing packing;
  Row first = row(2, "PlanBoard", board(1)), second = first;
  second.body[700] ^= 0x55;
  packing.pack(first);
  packing.pack(second);

  Packing reading;
  EXPECT_THROW(reading.unpack(second), std::runtime_error);
}

RC_GTEST_PROP(Packing, GivesBackWhatItTookInAnyOrderOfStreamsAndLives, ()) {
  auto writing = std::make_unique<Packing>();
  Packing reading;
  std::map<std::pair<std::int64_t, std::string>, Bytes> last;
  const int rows = *rc::gen::inRange(0, 60);
  for (int i = 0; i < rows; ++i) {
    if (*rc::gen::inRange(0, 10) == 0) writing = std::make_unique<Packing>();
    const auto peer = *rc::gen::inRange<std::int64_t>(1, 3);
    const std::string slot = *rc::gen::element<std::string>("PlanBoard", "Telemetry");
    Bytes& body = last[{peer, slot}];
    if (body.empty() || *rc::gen::inRange(0, 4) == 0)
      body = *rc::gen::arbitrary<Bytes>();
    else
      body[*rc::gen::inRange<std::size_t>(0, body.size())] = *rc::gen::arbitrary<std::uint8_t>();
    const Row before = row(peer, slot, body);
    Row one = before;

    writing->pack(one);
    RC_ASSERT(one.body.size() <= before.body.size());
    reading.unpack(one);

    RC_ASSERT(one.body == before.body);
    RC_ASSERT(one.flags == before.flags);
  }
}

RC_GTEST_PROP(Packing, WhateverTheBytesItThrowsOrReads, (const Bytes& bytes)) {
  Packing packing;
  Row one = row(1, "Telemetry", bytes);
  one.flags |= kPacked;
  try {
    packing.unpack(one);
  } catch (const std::runtime_error&) {
    return;
  }
}

RC_GTEST_PROP(Packing, WhateverByteOfAFrameIsChangedItThrowsOrReads, (std::uint8_t which)) {
  Packing packing, reading;
  Row first = row(2, "PlanBoard", board(1)), second = first;
  second.body[700] ^= 0x55;
  packing.pack(first);
  packing.pack(second);
  reading.unpack(first);
  second.body[which % second.body.size()] ^= static_cast<std::uint8_t>(1 + which / 8);
  try {
    reading.unpack(second);
  } catch (const std::runtime_error&) {
    return;
  }
}

}  // namespace
}  // namespace skein::store
