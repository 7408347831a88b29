// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/fingerprint.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein {
namespace {

// The algorithm as its authors wrote it down (draft-eastlake-fnv: offset basis, prime, "xor, then
// multiply"), over the bytes that the header says.
std::uint64_t fnv1a(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : bytes) {
    hash ^= static_cast<std::uint8_t>(byte);
    hash *= 1099511628211ULL;
  }
  return hash;
}

std::string eight_bytes(std::uint64_t number) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFF);
  return bytes;
}

TEST(Fingerprint, IsFnv1aOfTheTextAndItsLength) {
  // The vector of the draft for "foobar".
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8ULL);
  for (const std::string text : {"", "a", "foobar", "Lousã"})
    EXPECT_EQ(Fingerprint().put(text).value(), fnv1a(text + eight_bytes(text.size()))) << text;
}

TEST(Fingerprint, OfANumberIsThatOfItsEightBytesLowestFirst) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const std::uint64_t number = random.bits() >> random.below(64);
    EXPECT_EQ(Fingerprint().put(number).value(), fnv1a(eight_bytes(number)));
  }
}

TEST(Fingerprint, OfNothingIsTheOffsetBasis) {
  EXPECT_EQ(Fingerprint().value(), 0xcbf29ce484222325ULL);
}

TEST(Fingerprint, TellsWhereOnePartEndsAndTheNextBegins) {
  const auto of = [](const std::vector<std::string>& parts) {
    Fingerprint print;
    for (const std::string& part : parts) print.put(part);
    return print.value();
  };
  std::map<std::uint64_t, std::vector<std::string>> seen;
  for (const std::vector<std::string>& parts : std::vector<std::vector<std::string>>{
           {"abc"}, {"ab", "c"}, {"a", "bc"}, {"a", "b", "c"}, {"abc", ""}, {"", "abc"}, {}, {""}})
    EXPECT_TRUE(seen.emplace(of(parts), parts).second);
}

TEST(Fingerprint, OfNoughtDoesNotDependOnItsSignAndThatOfOthersDoes) {
  EXPECT_EQ(Fingerprint().put(0.0).value(), Fingerprint().put(-0.0).value());
  EXPECT_NE(Fingerprint().put(1.0).value(), Fingerprint().put(-1.0).value());
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_NE(Fingerprint().put(least).value(), Fingerprint().put(0.0).value());
}

TEST(Fingerprint, DependsOnTheOrder) {
  EXPECT_NE(Fingerprint().put(std::uint64_t{1}).put(2.0).value(),
            Fingerprint().put(2.0).put(std::uint64_t{1}).value());
}

TEST(FingerprintText, HasSixteenDigitsThatReadBack) {
  EXPECT_EQ(fingerprint_text(0), "0000000000000000");
  EXPECT_EQ(fingerprint_text(0xABCDEF), "0000000000abcdef");
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const std::uint64_t number = random.bits() >> random.below(64);
    const std::string text = fingerprint_text(number);
    EXPECT_EQ(text.size(), 16U);
    EXPECT_EQ(std::stoull(text, nullptr, 16), number) << text;
  }
}

}  // namespace
}  // namespace skein
