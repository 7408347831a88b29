// SPDX-License-Identifier: Apache-2.0
// Values as CDR, against bytes derived by hand from the standard and against a reader of its own.
#include "skein/foundation/cdr_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein {
namespace {

using Bytes = std::vector<std::uint8_t>;

enum class Colour : std::uint8_t { kRed = 1, kBlue = 2 };

struct Point {
  double x = 0;
  std::int16_t y = 0;
};
template <class Visitor>
void visit_fields(Visitor& visitor, const Point& point) {
  visitor("x", point.x);
  visitor("y", point.y);
}

/// Counts, then writes into exactly so much room.
template <class... Values>
Bytes written(const Values&... values) {
  CdrWriter counter;
  (counter("value", values), ...);
  Bytes bytes(counter.used(), 0xEE);
  CdrWriter writer{std::span<std::uint8_t>(bytes)};
  (writer("value", values), ...);
  EXPECT_EQ(writer.used(), counter.used());
  return bytes;
}

TEST(CdrWriter, WritesTheLowestByteFirst) {
  EXPECT_EQ(written(std::uint32_t{0x01020304}), (Bytes{4, 3, 2, 1}));
  EXPECT_EQ(written(std::int16_t{-2}), (Bytes{0xFE, 0xFF}));
  EXPECT_EQ(written(1.0F), (Bytes{0, 0, 0x80, 0x3F}));  // IEEE 754: 0x3F800000
  EXPECT_EQ(written(true, false), (Bytes{1, 0}));
}

TEST(CdrWriter, AlignsEachScalarToItsSizeWithNoughts) {
  EXPECT_EQ(written(std::uint8_t{7}, std::uint16_t{1}), (Bytes{7, 0, 1, 0}));
  EXPECT_EQ(written(std::uint8_t{7}, std::uint32_t{1}), (Bytes{7, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(written(std::uint8_t{7}, std::uint64_t{1}),
            (Bytes{7, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(CdrWriter, EndsTextWithANoughtThatCounts) {
  EXPECT_EQ(written(std::string("ab")), (Bytes{3, 0, 0, 0, 'a', 'b', 0}));
  EXPECT_EQ(written(std::string()), (Bytes{1, 0, 0, 0, 0}));
}

TEST(CdrWriter, AlignsWhatFollowsATextFromTheBeginningNotFromTheText) {
  EXPECT_EQ(written(std::string("ab"), std::uint16_t{5}),
            (Bytes{3, 0, 0, 0, 'a', 'b', 0, 0, 5, 0}));
}

TEST(CdrWriter, SequencesHaveTheirCountInFrontAndArraysDoNot) {
  EXPECT_EQ(written(std::vector<std::uint8_t>{9, 8}), (Bytes{2, 0, 0, 0, 9, 8}));
  EXPECT_EQ(written(std::vector<std::uint8_t>{}), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(written(std::array<std::uint8_t, 2>{9, 8}), (Bytes{9, 8}));
}

TEST(CdrWriter, EnumerationsAreNumbersOf32BitsWhateverHoldsThem) {
  EXPECT_EQ(written(Colour::kBlue), (Bytes{2, 0, 0, 0}));
}

TEST(CdrWriter, ARecordIsItsFieldsOneAfterTheOther) {
  EXPECT_EQ(written(Point{1, -1}), (Bytes{0, 0, 0, 0, 0, 0, 0xF0, 0x3F, 0xFF, 0xFF}));
  EXPECT_EQ(written(std::vector<Point>{{0, 1}, {0, 2}}).size(), 4U + 4 + 8 + 2 + 6 + 8 + 2);
}

TEST(CdrWriterDeathTest, RoomThatIsTooSmallIsABrokenInvariant) {
  Bytes room(3);
  CdrWriter writer{std::span<std::uint8_t>(room)};
  EXPECT_DEATH(writer("value", std::uint32_t{1}), "");
}

/// Reads what the standard says, without the code under test.
class Reader {
 public:
  explicit Reader(const Bytes& bytes) : bytes_(bytes) {}

  template <class T>
  T scalar() {
    while (at_ % sizeof(T) != 0) EXPECT_EQ(bytes_.at(at_++), 0) << "padding";
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bits |= static_cast<std::uint64_t>(bytes_.at(at_++)) << (8 * i);
    T value;
    std::memcpy(&value, &bits, sizeof(T));
    return value;
  }
  std::string text() {
    std::string result;
    for (auto left = scalar<std::uint32_t>(); left > 1; --left)
      result += static_cast<char>(bytes_.at(at_++));
    EXPECT_EQ(bytes_.at(at_++), 0);
    return result;
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

TEST(CdrWriterLaws, AnyRowOfValuesIsReadBack) {
  Random random(3);
  for (int trial = 0; trial < 500; ++trial) {
    const auto small = static_cast<std::uint8_t>(random.below(256));
    const double number = random.uniform(-1e9, 1e9);
    const std::string text(random.below(9), 'x');
    const auto half = static_cast<std::int16_t>(random.bits());
    std::vector<std::uint32_t> many;
    for (std::uint64_t i = random.below(4); i > 0; --i)
      many.push_back(static_cast<std::uint32_t>(random.bits()));
    const auto great = static_cast<std::int64_t>(random.bits());

    const Bytes bytes = written(small, number, text, half, many, small, great);
    Reader reader(bytes);

    EXPECT_EQ(reader.scalar<std::uint8_t>(), small);
    EXPECT_EQ(reader.scalar<double>(), number);
    EXPECT_EQ(reader.text(), text);
    EXPECT_EQ(reader.scalar<std::int16_t>(), half);
    ASSERT_EQ(reader.scalar<std::uint32_t>(), many.size());
    for (const std::uint32_t one : many) EXPECT_EQ(reader.scalar<std::uint32_t>(), one);
    EXPECT_EQ(reader.scalar<std::uint8_t>(), small);
    EXPECT_EQ(reader.scalar<std::int64_t>(), great);
    EXPECT_TRUE(reader.at_end());
  }
}

TEST(ByteReversed, TwiceIsTheSameAndOnceIsFromLastToFirst) {
  EXPECT_EQ(byte_reversed(std::uint32_t{0x01020304}), 0x04030201U);
  EXPECT_EQ(byte_reversed(std::uint8_t{7}), 7);
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const std::uint64_t number = random.bits();
    EXPECT_EQ(byte_reversed(byte_reversed(number)), number);
  }
}

}  // namespace
}  // namespace skein
