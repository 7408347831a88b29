// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/contract.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/result.hpp"

namespace skein {
namespace {

TEST(Contract, ABrokenOneStopsTheProcessAndSaysWhere) {
  const auto halve = [](int x) {
    SKEIN_EXPECTS(x % 2 == 0);
    return x / 2;
  };

  EXPECT_EQ(halve(4), 2);
  EXPECT_DEATH((void)halve(3), "broken precondition: x % 2 == 0 \\(.*contract_test.cpp:[0-9]+\\)");
}

TEST(Contract, AnInvariantSaysThatItIsOne) {
  EXPECT_DEATH(SKEIN_ENSURES(1 > 2), "broken invariant: 1 > 2");
}

TEST(Result, AFailureCarriesItsSentence) {
  const Result<int, Failure> result = failure("no such thing");

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().why, "no such thing");
}

TEST(ExitCode, EachMeansOneThing) {
  const int codes[] = {kExitOk,      kExitNegative, kExitBadInput,   kExitSystem,
                       kExitTimeout, kExitInternal, kExitInterrupted};
  for (const int a : codes) {
    EXPECT_EQ(std::count(std::begin(codes), std::end(codes), a), 1);
  }
}

}  // namespace
}  // namespace skein
