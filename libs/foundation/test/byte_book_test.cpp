// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/byte_book.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace skein {
namespace {

RC_GTEST_PROP(ByteBook, HoldsWhatWasSetLastOfEachNumberAndZeroOfAllOthers, ()) {
  ByteBook book;
  std::map<std::uint64_t, std::uint8_t> expected;
  for (const auto& [number, value] :
       *rc::gen::arbitrary<std::vector<std::pair<std::uint64_t, std::uint8_t>>>()) {
    book.set(number % 1000, value);
    expected[number % 1000] = value;
  }
  for (std::uint64_t number = 0; number < 1200; ++number) {
    const auto found = expected.find(number);
    RC_ASSERT(book.of(number) == (found == expected.end() ? 0 : found->second));
    RC_ASSERT(book.knows(number) == (book.of(number) != 0));
  }
}

TEST(ByteBook, TakesTwoBytesOfEachOfManyThatFollowOneAnother) {
  ByteBook book;
  for (std::uint64_t number = 1; number <= 100'000; ++number) book.set(number, 3);
  EXPECT_LT(book.memory(), 200'000U);
  EXPECT_EQ(book.of(77'777), 3);
  book.clear();
  EXPECT_EQ(book.memory(), 0U);
}

}  // namespace
}  // namespace skein
