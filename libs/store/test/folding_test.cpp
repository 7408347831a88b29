// SPDX-License-Identifier: Apache-2.0
#include "folding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>
#include <tuple>

namespace skein::store {

static bool operator==(const Row& a, const Row& b) {
  return std::tie(a.at, a.kind, a.peer, a.slot, a.value, a.extra, a.flags, a.body) ==
         std::tie(b.at, b.kind, b.peer, b.slot, b.value, b.extra, b.flags, b.body);
}

namespace {

constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

rc::Gen<std::int64_t> any_number() {
  return rc::gen::oneOf(rc::gen::arbitrary<std::int64_t>(),
                        rc::gen::element<std::int64_t>(0, 1, -1, kLeast, kMost));
}

rc::Gen<Row> any_row() {
  return rc::gen::build<Row>(
      rc::gen::set(&Row::at, any_number()),
      rc::gen::set(&Row::kind, rc::gen::element<std::string>("received", "wakeup", "")),
      rc::gen::set(&Row::peer, rc::gen::element<std::int64_t>(0, 1, kLeast, kMost)),
      rc::gen::set(&Row::slot, rc::gen::arbitrary<std::string>()),
      rc::gen::set(&Row::value, any_number()), rc::gen::set(&Row::extra, any_number()),
      rc::gen::set(&Row::flags, any_number()), rc::gen::set(&Row::body));
}

TEST(Folding, OfNothingIsNothing) { EXPECT_TRUE(unfold(fold({})).empty()); }

TEST(Folding, TicksTakeAlmostNoRoom) {
  std::vector<Row> rows(4096);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].at = static_cast<std::int64_t>(i) * 100'000'000;
    rows[i].kind = "wakeup";
  }

  EXPECT_LT(fold(rows).size(), 200U);
}

RC_GTEST_PROP(Folding, GivesBackWhatItTook, ()) {
  const auto rows = *rc::gen::container<std::vector<Row>>(any_row());

  RC_ASSERT(unfold(fold(rows)) == rows);
}

RC_GTEST_PROP(Folding, WhateverTheBytesItThrowsOrReads, (const std::vector<std::uint8_t>& bytes)) {
  try {
    (void)unfold(bytes);
  } catch (const std::runtime_error&) {
    return;
  }
}

RC_GTEST_PROP(Folding, WhateverByteIsAnotherItThrowsOrReadsTheSame, (std::uint16_t which)) {
  const auto rows = *rc::gen::container<std::vector<Row>>(any_row());
  std::vector<std::uint8_t> folded = fold(rows);
  folded[which % folded.size()] ^= static_cast<std::uint8_t>(1U << (which / 256U % 8U));
  try {
    RC_ASSERT(unfold(folded) == rows);
  } catch (const std::runtime_error&) {
    return;
  }
}

RC_GTEST_PROP(Folding, WhereverItIsCutItThrows, (std::uint16_t where)) {
  const auto rows = *rc::gen::container<std::vector<Row>>(any_row());
  std::vector<std::uint8_t> folded = fold(rows);
  folded.resize(where % folded.size());

  RC_ASSERT_THROWS_AS(unfold(folded), std::runtime_error);
}

}  // namespace
}  // namespace skein::store
