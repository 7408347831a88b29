// SPDX-License-Identifier: Apache-2.0
// Laws of the foundation on random values, against oracles that are slow and plain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/nearest.hpp"
#include "skein/foundation/random.hpp"
#include "skein/foundation/time.hpp"
#include "skein/foundation/whole.hpp"

namespace skein {
namespace {

constexpr int kTrials = 2000;

std::int64_t any_nanoseconds(Random& random) {
  // Of every magnitude, from one nanosecond to the ends of the range.
  return static_cast<std::int64_t>(random.bits() >> random.below(64)) *
         (random.chance(0.5) ? 1 : -1);
}

__extension__ using Wide = __int128;

Wide wide(std::int64_t x) { return x; }

std::int64_t clamped(Wide x) {
  const Wide low = std::numeric_limits<std::int64_t>::min();
  const Wide high = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(std::clamp(x, low, high));
}

TEST(DurationLaws, SumsAndDifferencesSaturateLikeWideArithmetic) {
  Random random(1);
  for (int i = 0; i < kTrials; ++i) {
    const std::int64_t a = any_nanoseconds(random);
    const std::int64_t b = any_nanoseconds(random);
    const Duration x = Duration::nanoseconds(a);
    const Duration y = Duration::nanoseconds(b);

    EXPECT_EQ((x + y).count(), clamped(wide(a) + wide(b)));
    // The one asymmetric value: its negation saturates first.
    if (b != std::numeric_limits<std::int64_t>::min()) {
      EXPECT_EQ((x - y).count(), clamped(wide(a) - wide(b)));
    }
  }
}

TEST(DurationLaws, MillisecondsSaturateLikeWideArithmetic) {
  Random random(8);
  int beyond = 0;
  for (int i = 0; i < kTrials; ++i) {
    const std::int64_t ms = any_nanoseconds(random);
    const Wide ns = wide(ms) * 1'000'000;

    EXPECT_EQ(Duration::milliseconds(ms).count(), clamped(ns)) << ms;
    if (ns != clamped(ns)) ++beyond;
  }
  EXPECT_GT(beyond, kTrials / 10) << "some of them have to be out of range";
  EXPECT_LT(beyond, kTrials * 9 / 10) << "and some in it";
}

// A double of any magnitude is a whole number times a power of two: beyond 2^126 the oracle keeps
// the sign alone.
Wide without_fraction(double number) {
  const double most = std::ldexp(1.0, 126);
  return static_cast<Wide>(std::clamp(number, -most, most));
}

double any_double(Random& random) {
  return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(200)) - 20);
}

TEST(WholeLaws, NumbersSaturateLikeWideArithmetic) {
  Random random(9);
  for (int i = 0; i < kTrials; ++i) {
    const double number = any_double(random);
    EXPECT_EQ(whole(number), clamped(without_fraction(number))) << number;
  }
}

TEST(WholeLaws, AtTheEndsOfTheRangeNothingWrapsAround) {
  constexpr double kEnd = 0x1p63, kInfinity = std::numeric_limits<double>::infinity();
  for (const double number :
       {kEnd, -kEnd, std::nextafter(kEnd, 0), std::nextafter(-kEnd, 0), std::nextafter(kEnd, 1e300),
        std::nextafter(-kEnd, -1e300), kInfinity, -kInfinity, 0.0, -0.9, 0.9}) {
    EXPECT_EQ(whole(number), clamped(without_fraction(number))) << number;
  }
}

TEST(DurationLaws, TextReadsBackAsTheSameNanoseconds) {
  Random random(2);
  for (int i = 0; i < kTrials; ++i) {
    const std::int64_t ns = any_nanoseconds(random);
    const std::string text = to_text(Duration::nanoseconds(ns));

    const bool negative = text[0] == '-';
    const std::string digits = negative ? text.substr(1) : text;
    const std::size_t point = digits.find('.');
    std::string fraction = point == std::string::npos ? "" : digits.substr(point + 1);
    ASSERT_LE(fraction.size(), 9U);
    fraction.resize(9, '0');
    const Wide value = static_cast<Wide>(std::stoull(digits.substr(0, point))) * 1'000'000'000 +
                       std::stoll(fraction);
    EXPECT_EQ(static_cast<std::int64_t>(negative ? -value : value), ns) << text;
  }
}

TEST(DurationLaws, SecondsAreWithinHalfANanosecondOrOneStepOfTheDouble) {
  Random random(3);
  for (int i = 0; i < kTrials; ++i) {
    const double s = random.uniform(-1e6, 1e6);

    const double error = std::abs(Duration::seconds(s).to_seconds() - s);

    EXPECT_LE(error, 0.5e-9 + 2 * std::abs(s) * std::numeric_limits<double>::epsilon());
  }
}

// Every text within one edit, by construction: the plain oracle of the distance.
std::set<std::string> one_edit_away(const std::string& text) {
  std::set<std::string> result;
  const std::string letters = "abc";
  for (std::size_t i = 0; i <= text.size(); ++i) {
    for (const char c : letters) result.insert(text.substr(0, i) + c + text.substr(i));
    if (i == text.size()) break;
    result.insert(text.substr(0, i) + text.substr(i + 1));
    for (const char c : letters) result.insert(text.substr(0, i) + c + text.substr(i + 1));
    if (i + 1 < text.size()) {
      std::string swapped = text;
      std::swap(swapped[i], swapped[i + 1]);
      result.insert(swapped);
    }
  }
  return result;
}

std::string any_word(Random& random, std::size_t length) {
  std::string word;
  for (std::size_t i = 0; i < length; ++i) word += static_cast<char>('a' + random.below(3));
  return word;
}

TEST(NearestNameLaws, AWordOneEditAwayIsFoundAmongFarOnes) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const std::string word = any_word(random, 4 + random.below(4));
    for (const std::string& typo : one_edit_away(word)) {
      EXPECT_EQ(nearest_name(typo, {"zzzzzzzz", word, "yyyyyyyyyy"}), word) << typo;
    }
  }
}

TEST(NearestNameLaws, NothingBeatsTheNameItself) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::string> candidates;
    for (int k = 0; k < 8; ++k) candidates.push_back(any_word(random, 3 + random.below(4)));
    const std::string& word = candidates[random.below(candidates.size())];

    EXPECT_EQ(nearest_name(word, candidates), word);
  }
}

TEST(RandomLaws, BelowNeverReachesItsBound) {
  Random random(6);
  for (int i = 0; i < kTrials; ++i) {
    const std::uint64_t n = 1 + (random.bits() >> random.below(64));
    EXPECT_LT(random.below(n == 0 ? 1 : n), n);
  }
}

TEST(RandomLaws, UniformStaysInItsInterval) {
  Random random(7);
  for (int i = 0; i < kTrials; ++i) {
    const double low = random.uniform(-10, 10);
    const double high = low + random.uniform(0, 5);
    const double x = random.uniform(low, high);
    EXPECT_GE(x, low);
    EXPECT_LE(x, high);
  }
}

}  // namespace
}  // namespace skein
