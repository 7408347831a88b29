// SPDX-License-Identifier: Apache-2.0
// What is seen of others' samples as they pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/passive/capture.hpp"
#include "skein/foundation/random.hpp"

namespace skein::blackboard::passive {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kUserWriter = 0x02, kBuiltinWriter = 0xc2;

/// Writes RTPS by the book (RTPS 2.3, 9.4), in either order of bytes.
class MessageText {
 public:
  explicit MessageText(bool little, std::uint8_t participant = 1) : little_(little) {
    bytes_ = {'R', 'T', 'P', 'S', 2, 3, 1, 15};
    bytes_.resize(20, participant);
  }
  MessageText& at(std::uint32_t seconds, std::uint32_t fraction) {
    begin(0x09, 0);
    return number(seconds, 4).number(fraction, 4).end();
  }
  MessageText& data(std::uint64_t sequence, const Bytes& payload, std::uint8_t kind = kUserWriter,
                    bool with_qos = false) {
    begin(0x15, static_cast<std::uint8_t>(0x04 | (with_qos ? 0x02 : 0)));
    number(0, 2).number(16, 2).ends(kind, sequence);
    if (with_qos) number(0x70, 2).number(4, 2).number(7, 4).number(1, 2).number(0, 2);
    return append(payload).end();
  }
  MessageText& gone(std::uint64_t sequence) {
    begin(0x15, 0x08);
    return number(0, 2).number(16, 2).ends(kUserWriter, sequence).number(0, 4).end();
  }
  MessageText& fragments(std::uint64_t sequence, std::uint32_t first, std::uint16_t count,
                         std::uint16_t part, const Bytes& whole) {
    const std::size_t from = std::size_t{first - 1} * part;
    const std::size_t to = std::min(whole.size(), from + std::size_t{count} * part);
    return foul_fragments(
        sequence, first, count, part, whole.size(),
        {whole.begin() + static_cast<long>(from), whole.begin() + static_cast<long>(to)});
  }
  /// With figures that need not go with what is in them.
  MessageText& foul_fragments(std::uint64_t sequence, std::uint32_t first, std::uint16_t count,
                              std::uint16_t part, std::size_t size, const Bytes& content) {
    begin(0x16, 0);
    number(0, 2).number(28, 2).ends(kUserWriter, sequence).number(first, 4).number(count, 2);
    number(part, 2).number(static_cast<std::uint32_t>(size), 4);
    return append(content).end();
  }
  MessageText& unknown() {
    begin(0x06, 0);  // ACKNACK
    return number(1, 4).number(2, 4).end();
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  void begin(std::uint8_t kind, std::uint8_t flags) {
    bytes_.push_back(kind);
    bytes_.push_back(static_cast<std::uint8_t>(flags | (little_ ? 1 : 0)));
    begun_ = bytes_.size();
    number(0, 2);
  }
  MessageText& end() {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    const Bytes rest(bytes_.begin() + static_cast<long>(begun_) + 2, bytes_.end());
    bytes_.resize(begun_);
    number(static_cast<std::uint32_t>(rest.size()), 2);
    return append(rest);
  }
  MessageText& number(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i)
      bytes_.push_back(static_cast<std::uint8_t>(value >> 8 * (little_ ? i : size - 1 - i)));
    return *this;
  }
  MessageText& ends(std::uint8_t kind, std::uint64_t sequence) {
    append({0, 0, 0, 0, 0, 0, 5, kind});
    return number(static_cast<std::uint32_t>(sequence >> 32), 4)
        .number(static_cast<std::uint32_t>(sequence), 4);
  }
  MessageText& append(const Bytes& more) {
    bytes_.insert(bytes_.end(), more.begin(), more.end());
    return *this;
  }

  bool little_;
  Bytes bytes_;
  std::size_t begun_ = 0;
};

const Bytes kFour{0, 1, 0, 0};
const std::string kWriter = "010101010101010101010101.00000502";

Bytes counting(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  return bytes;
}

class MessagesOfBothOrders : public ::testing::TestWithParam<bool> {
 protected:
  MessageText message() const { return MessageText(GetParam()); }
  MessageData reader_;
};
INSTANTIATE_TEST_SUITE_P(Bytes, MessagesOfBothOrders, ::testing::Bool(), [](const auto& one) {
  return one.param ? "little_endian" : "big_endian";
});

TEST_P(MessagesOfBothOrders, AreReadWithWriterNumberTimeAndContent) {
  const Bytes payload{0, 1, 0, 0, 9, 8, 7, 6};
  const auto seen = reader_.take(
      message().unknown().at(1000, 0x80000000).data((3ULL << 32U) + 5, payload).bytes());

  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].writer, kWriter);
  EXPECT_EQ(seen[0].sequence, (3ULL << 32U) + 5);
  EXPECT_EQ(seen[0].sent, 1000'500'000'000);
  EXPECT_EQ(seen[0].bytes, payload);
}

TEST_P(MessagesOfBothOrders, MayHaveQosInLineAndSeveralSamples) {
  const auto seen = reader_.take(
      message().data(1, kFour, kUserWriter, true).gone(2).data(3, counting(8)).bytes());

  ASSERT_THAT(seen, SizeIs(3));
  EXPECT_EQ(seen[0].bytes, kFour);
  EXPECT_THAT(seen[1].bytes, IsEmpty());
  EXPECT_EQ(seen[2].bytes, counting(8));
}

TEST_P(MessagesOfBothOrders, OfDiscoveryAreNotGiven) {
  EXPECT_THAT(reader_.take(message().data(1, kFour, kBuiltinWriter).bytes()), IsEmpty());
}

TEST_P(MessagesOfBothOrders, GiveWhatGoesToSeveralReadersAndAgainOnce) {
  EXPECT_THAT(reader_.take(message().data(1, kFour).bytes()), SizeIs(1));
  EXPECT_THAT(reader_.take(message().data(1, kFour).bytes()), IsEmpty());
  EXPECT_THAT(reader_.take(message().data(3, kFour).bytes()), SizeIs(1));
  EXPECT_THAT(reader_.take(message().data(2, kFour).bytes()), SizeIs(1));
  EXPECT_THAT(reader_.take(message().data(2, kFour).bytes()), IsEmpty());
  EXPECT_THAT(reader_.take(MessageText(GetParam(), 2).data(2, kFour).bytes()), SizeIs(1));
}

TEST_P(MessagesOfBothOrders, PutFragmentsTogetherInAnyOrder) {
  const Bytes whole = counting(2500);
  EXPECT_THAT(reader_.take(message().fragments(4, 3, 1, 1000, whole).bytes()), IsEmpty());
  EXPECT_THAT(reader_.take(message().fragments(4, 3, 1, 1000, whole).bytes()), IsEmpty());
  const auto seen = reader_.take(message().fragments(4, 1, 2, 1000, whole).bytes());
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].bytes, whole);
  EXPECT_THAT(reader_.take(message().fragments(4, 1, 3, 1000, whole).bytes()), IsEmpty());
}

// Its 50th fragment of a byte would be written far behind the sample if fragments were of 1,000.
TEST_P(MessagesOfBothOrders, TakeNoFragmentsOfAnotherSizeForASample) {
  const Bytes whole = counting(100);
  EXPECT_THAT(reader_.take(message().fragments(4, 1, 49, 1, whole).bytes()), IsEmpty());
  EXPECT_THAT(reader_.take(message().foul_fragments(4, 50, 1, 1000, 100, counting(1000)).bytes()),
              IsEmpty());
  const auto seen = reader_.take(message().fragments(4, 50, 51, 1, whole).bytes());
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].bytes, whole);
}

TEST_P(MessagesOfBothOrders, ThatAreCutShortAnywhereHarmNobody) {
  const Bytes whole = counting(300);
  const Bytes all = message()
                        .at(1, 2)
                        .data(1, kFour, kUserWriter, true)
                        .fragments(2, 1, 3, 100, whole)
                        .data(3, counting(20))
                        .bytes();
  for (std::size_t length = 0; length < all.size(); ++length) {
    MessageData reader;
    EXPECT_LE(reader.take({all.data(), length}).size(), 3U);
  }
}

TEST_P(MessagesOfBothOrders, ThatAreChangedAnywhereHarmNobody) {
  const Bytes all = message()
                        .at(1, 2)
                        .data(1, kFour, kUserWriter, true)
                        .fragments(2, 1, 3, 100, counting(300))
                        .data(3, counting(20))
                        .bytes();
  Random random(1, "passive/changed");
  for (int i = 0; i < 20'000; ++i) {
    Bytes changed = all;
    for (int n = 0; n < 3; ++n)
      changed[random.below(changed.size())] = static_cast<std::uint8_t>(random.below(256));
    for (const SampleData& one : reader_.take(changed))
      ASSERT_LE(one.bytes.size(), MessageData::kLongest);
  }
}

TEST(NumbersOfAWriter, AreToldApartInAnyOrderWithinWhatIsRemembered) {
  MessageData reader;
  Random random(1, "passive/numbers");
  std::vector<std::uint64_t> given;
  std::set<std::uint64_t> sent;
  for (std::uint64_t next = 1; next < 5000; next += random.below(20)) {
    const std::uint64_t sequence = next > 400 ? next - random.below(400) : next;
    sent.insert(sequence);
    for (const SampleData& one : reader.take(MessageText(true).data(sequence, kFour).bytes()))
      given.push_back(one.sequence);
  }
  std::ranges::sort(given);
  EXPECT_TRUE(std::ranges::equal(given, sent));
}

class Captured : public ::testing::Test {
 protected:
  static Endpoint writer(const std::string& topic, const std::string& partition) {
    Endpoint endpoint;
    endpoint.guid = kWriter;
    endpoint.writer = true;
    endpoint.topic = topic;
    endpoint.type = "skein::idl::" + topic;
    endpoint.partitions = {partition};
    return endpoint;
  }
  void pass(std::uint64_t sequence) {
    capture_.take(MessageText(true).at(5, 0).data(sequence, kFour).bytes(), 7);
  }
  void ask(const std::string& partition) {
    capture_.read({"Telemetry", "skein::idl::Telemetry", true, {partition}, {}});
  }
  std::size_t told() { return capture_.turn(Duration::seconds(1)).size(); }

  Capture capture_;
};

TEST_F(Captured, SamplesAreToldWithTopicPartitionAndTimes) {
  capture_.note(EndpointSeen{writer("Telemetry", "radio/a>b"), false});
  ask("radio/*");
  pass(1);
  const auto samples = capture_.turn(Duration::seconds(1));

  ASSERT_THAT(samples, SizeIs(1));
  EXPECT_EQ(samples[0].topic, "Telemetry");
  EXPECT_EQ(samples[0].writer, kWriter);
  EXPECT_EQ(samples[0].partition, "radio/a>b");
  EXPECT_EQ(samples[0].sent, 5'000'000'000);
  EXPECT_EQ(samples[0].heard, 7);
  EXPECT_EQ(samples[0].bytes, kFour);
}

TEST_F(Captured, SamplesWaitForTheirWriterToBeFoundAndForWhoAsks) {
  pass(1);
  EXPECT_EQ(told(), 0U);
  capture_.note(EndpointSeen{writer("Telemetry", "radio/a>b"), false});
  EXPECT_EQ(told(), 0U);
  ask("radio/*");
  EXPECT_EQ(told(), 0U);  // its last turn was the one before

  pass(2);
  EXPECT_EQ(told(), 1U);
}

TEST_F(Captured, SamplesThatNobodyAsksForAreNotKept) {
  ask("onboard/*");
  capture_.note(EndpointSeen{writer("Telemetry", "radio/a>b"), false});
  pass(1);
  for (int i = 0; i < Capture::kTurns; ++i) EXPECT_EQ(told(), 0U);
  ask("radio/*");
  EXPECT_EQ(told(), 0U);
}

TEST_F(Captured, SamplesOfWhomNobodyFindsAreHeldWithinBounds) {
  for (std::uint64_t i = 1; i <= Capture::kMostHeld + 10; ++i) pass(i);
  capture_.note(EndpointSeen{writer("Telemetry", "radio/a>b"), false});
  ask("radio/*");
  EXPECT_EQ(told(), Capture::kMostHeld);
}

}  // namespace
}  // namespace skein::blackboard::passive
