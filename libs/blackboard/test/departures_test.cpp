// SPDX-License-Identifier: Apache-2.0
// Participants that leave: how they say it, and what it does to those who hear it.
#include "adapters/rtps/departures.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "adapters/fastdds/participation.hpp"
#include "adapters/rtps/ports.hpp"
#include "skein/blackboard/domain_lease.hpp"

namespace skein::blackboard {
namespace {

using rtps::tells_departure;
using Message = std::vector<std::uint8_t>;

constexpr std::uint8_t kData = 0x15, kInfoTs = 0x09;
constexpr std::uint8_t kLittle = 1, kQos = 2, kContent = 4, kKey = 8;
constexpr std::uint8_t kAnnouncements = 0xc2, kOfWriters = 0x03;
constexpr int kAlive = 0, kDisposed = 1, kUnregistered = 2;

/// Numbers in the order of bytes of the message.
class Writing {
 public:
  explicit Writing(bool little = true) : little_(little) {}
  Writing& octets(const Message& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  Writing& number(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i)
      bytes_.push_back(
          static_cast<std::uint8_t>(value >> 8U * unsigned(little_ ? i : size - 1 - i)));
    return *this;
  }
  Writing& parameter(std::uint32_t which, const Message& value) {
    return number(which, 2).number(static_cast<std::uint32_t>(value.size()), 2).octets(value);
  }
  const Message& bytes() const { return bytes_; }

 private:
  bool little_;
  Message bytes_;
};

Message message(const Message& prefix) {
  Message bytes{'R', 'T', 'P', 'S', 2, 2, 1, 15};
  bytes.insert(bytes.end(), prefix.begin(), prefix.end());
  return bytes;
}

Message prefix(std::uint32_t number) {
  return Writing().octets({1, 15, 0, 0, 0, 0, 0, 0}).number(number, 4).bytes();
}

void add(Message& message, std::uint8_t kind, std::uint8_t flags, const Message& content) {
  const Writing head = Writing((flags & kLittle) != 0)
                           .octets({kind, flags})
                           .number(static_cast<std::uint32_t>(content.size()), 2);
  message.insert(message.end(), head.bytes().begin(), head.bytes().end());
  message.insert(message.end(), content.begin(), content.end());
}

/// What an announcement is made of.
struct Announcement {
  int status = kAlive;
  std::uint8_t writer = kAnnouncements;
  bool little = true, has_qos = true, has_content = true, has_key = false;
  std::uint32_t sequence = 1;
  Message key = Message(16, 7);
  Message content{0, 3, 0, 0};
};

void add(Message& to, const Announcement& one) {
  Writing body(one.little);
  body.number(0, 2).number(16, 2).octets(
      {0, 1, 0, 0xc7, 0, one.writer == kAnnouncements ? std::uint8_t{1} : std::uint8_t{0}, 0,
       one.writer});
  body.number(0, 4).number(one.sequence, 4);
  if (one.has_qos) {
    body.parameter(0x70, one.key);
    if (one.status != kAlive)
      body.parameter(0x71, {0, 0, 0, static_cast<std::uint8_t>(one.status)});
    body.parameter(1, {});
  }
  body.octets(one.content);
  const auto flags =
      static_cast<std::uint8_t>((one.little ? kLittle : 0) | (one.has_qos ? kQos : 0) |
                                (one.has_content ? kContent
                                 : one.has_key   ? kKey
                                                 : 0));
  add(to, kData, flags, body.bytes());
}

Message message(const Announcement& one) {
  Message bytes = message(prefix(1));
  add(bytes, kInfoTs, kLittle, Message(8));
  add(bytes, one);
  return bytes;
}

TEST(Departures, AreSaidByTheStatusOfAnAnnouncement) {
  for (const bool little : {true, false}) {
    for (const int status : {kDisposed, kUnregistered, kDisposed | kUnregistered}) {
      EXPECT_TRUE(tells_departure(message(Announcement{.status = status, .little = little})));
      EXPECT_TRUE(tells_departure(
          message(Announcement{.status = status, .little = little, .has_content = false})));
    }
    EXPECT_FALSE(tells_departure(message(Announcement{.little = little})));
    EXPECT_FALSE(tells_departure(message(Announcement{.little = little, .has_qos = false})));
  }
}

TEST(Departures, AreSaidByAnAnnouncementWithoutContent) {
  for (const bool has_key : {true, false})
    EXPECT_TRUE(tells_departure(
        message(Announcement{.has_qos = false, .has_content = false, .has_key = has_key})));
}

TEST(Departures, OfWritersAndReadersAreNotMeant) {
  EXPECT_FALSE(tells_departure(message(Announcement{.status = kDisposed, .writer = kOfWriters})));
}

TEST(Departures, AreFoundBehindOtherSubmessages) {
  Message bytes = message(Announcement{});
  add(bytes, {.status = kDisposed});
  EXPECT_TRUE(tells_departure(bytes));
}

RC_GTEST_PROP(DeparturesLaw, AreNotReadInWhatIsCutShortBeforeTheStatus, ()) {
  const Message whole = message(Announcement{.status = kDisposed});
  const auto length = *rc::gen::inRange<std::size_t>(0, whole.size() - 12);
  RC_ASSERT(!tells_departure({whole.data(), length}));
}

RC_GTEST_PROP(DeparturesLaw, AnythingCanBeAsked, (Message bytes)) {
  Message begun = message(prefix(1));
  add(begun, kData, *rc::gen::arbitrary<std::uint8_t>(), bytes);
  (void)tells_departure(bytes);
  (void)tells_departure(begun);
}

// ---- over Fast DDS ----

/// Participants that come and go, as datagrams to one that listens.
class PassersBy {
 public:
  explicit PassersBy(std::uint32_t domain) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
    to_.sin_family = AF_INET;
    to_.sin_port = htons(static_cast<std::uint16_t>(rtps::first_port(domain, 0)));
    inet_pton(AF_INET, rtps::kLoopback, &to_.sin_addr);
  }
  PassersBy(const PassersBy&) = delete;
  PassersBy& operator=(const PassersBy&) = delete;
  ~PassersBy() { close(socket_); }

  void comes(std::uint32_t number, std::chrono::microseconds lease) {
    const Message locator =
        Writing().number(1, 4).number(7, 4).octets(Message(12)).octets({127, 0, 0, 1}).bytes();
    const Message duration =
        Writing().number(0, 4).number(static_cast<std::uint32_t>(lease.count() * 4295), 4).bytes();
    say(number, {.content = Writing()
                                .octets({0, 3, 0, 0})
                                .parameter(0x15, {2, 2, 0, 0})
                                .parameter(0x16, {1, 15, 0, 0})
                                .parameter(0x50, guid(number))
                                .parameter(0x58, {3, 0, 0, 0})
                                .parameter(0x02, duration)
                                .parameter(0x32, locator)
                                .parameter(0x31, locator)
                                .parameter(0x01, {})
                                .bytes()});
  }
  void goes(std::uint32_t number) {
    say(number,
        {.status = kDisposed | kUnregistered, .has_content = false, .sequence = 2, .content = {}});
  }

 private:
  static Message guid(std::uint32_t number) {
    Message bytes = prefix(number);
    bytes.insert(bytes.end(), {0, 0, 1, 0xc1});
    return bytes;
  }
  void say(std::uint32_t number, Announcement one) {
    Message bytes = message(prefix(number));
    one.key = guid(number);
    add(bytes, one);
    (void)sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to_),
                 sizeof to_);
  }

  int socket_;
  sockaddr_in to_{};
};

/// How many came and how they were gone.
class Discovery final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  void on_participant_discovery(
      eprosima::fastdds::dds::DomainParticipant* /*participant*/,
      eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override {
    using Info = eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;
    const std::lock_guard lock(mutex_);
    if (info.status == Info::DISCOVERED_PARTICIPANT) ++count_.came;
    if (info.status == Info::REMOVED_PARTICIPANT) ++count_.left;
    if (info.status == Info::DROPPED_PARTICIPANT) ++count_.silent;
    changed_.notify_all();
  }

  struct Count {
    int came = 0, left = 0, silent = 0;
  };
  /// Once so many came, but after ten seconds at the latest.
  void await(int came) {
    await([=, this] { return count_.came >= came; });
  }
  /// Once all are gone that came, but after ten seconds at the latest.
  Count when_all_are_gone() {
    return await([this] { return count_.came == count_.left + count_.silent; });
  }

 private:
  Count await(const std::function<bool()>& holds) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(10), holds);
    return count_;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Count count_;
};

class FastDds : public ::testing::Test {
 protected:
  FastDds() {
    DdsConfig config;
    config.domain = lease_.value().domain();
    config.participant_name = "marvin";
    const auto joined = us_.join(config, &discovery_, {}, fastdds::Departures::kLeftToTheLease);
    EXPECT_TRUE(joined.has_value());
  }

  Discovery discovery_;
  Result<DomainLease, Failure> lease_ = claim_domain();
  fastdds::Participation us_;
};

// A round is no longer than what a socket holds: none is lost where Fast DDS is slow. Without the
// filter each of 20 runs ends with the assertion of Fast DDS.
TEST_F(FastDds, WhoLeavesWhileItsLeaseEndsHarmsNobody) {
  using std::chrono::microseconds;
  constexpr std::uint32_t kRounds = 60, kPassers = 50;
  PassersBy passers(lease_.value().domain());
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    const std::uint32_t first = round * kPassers;
    for (std::uint32_t i = 0; i < kPassers; ++i)
      passers.comes(first + i, microseconds(500 + 100 * i));
    for (std::uint32_t i = 0; i < kPassers; ++i) passers.goes(first + i);
    discovery_.await(static_cast<int>(first + kPassers));
  }
  const Discovery::Count count = discovery_.when_all_are_gone();
  EXPECT_EQ(count.came, kRounds * kPassers);
  EXPECT_EQ(count.silent, count.came);
  EXPECT_EQ(count.left, 0);
}

}  // namespace
}  // namespace skein::blackboard
