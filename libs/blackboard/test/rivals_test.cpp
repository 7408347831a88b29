// SPDX-License-Identifier: Apache-2.0
// Two processes with the number of one node: who holds it, what becomes of the other's words, and
// that a restart is not taken for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "testing/memory_boards.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

using testing::degree;
using ::testing::ElementsAre;
using testing::hand_over;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::task_event;

const Node kGround{NodeNumber(1), "ground"};
const Node kUav{NodeNumber(2), "uav"};
/// Processes that are this UAV, or say that they are.
const NodeNumber kFirst(2), kSecond(102);
constexpr Duration kPeriod = Duration::milliseconds(200);
constexpr Duration kLease = Duration::milliseconds(600);
/// After it one of two is refused.
constexpr Duration kSettled = Duration::milliseconds(1'500);

/// One that the UAV says to the ground station.
wire::Heartbeat heartbeat_of(std::uint64_t incarnation, std::uint64_t sequence) {
  wire::Heartbeat heartbeat;
  heartbeat.header.origin = kUav.number.value();
  heartbeat.header.destination = kGround.number.value();
  heartbeat.header.incarnation = incarnation;
  heartbeat.header.sequence_number = sequence;
  return heartbeat;
}

class Rivals {
 public:
  Rivals() { start(kGround.number, 1); }

  void start(NodeNumber process, std::uint64_t incarnation, bool guesses = false) {
    Config config;
    config.self = process == kGround.number ? kGround.number : kUav.number;
    config.incarnation = incarnation;
    config.guesses_incarnation = guesses;
    config.heartbeat_period = kPeriod;
    config.channels = station_link(kGround, kUav);
    boards_.start(process, config);
  }
  void kill(NodeNumber process) { boards_.kill(process); }
  bool runs(NodeNumber process) const { return boards_.runs(process); }
  Blackboard& operator[](NodeNumber process) { return boards_[process]; }
  void run_for(Duration span) { boards_.run_until(boards_.time() + span); }
  void send(NodeNumber from, wire::Sample sample) {
    const NodeNumber to = from == kGround.number ? kUav.number : kGround.number;
    ASSERT_TRUE(boards_[from].send(std::move(sample), to, boards_.now()).has_value());
  }
  void inject(const wire::Sample& sample) { boards_.hub().inject("radio/uav>ground", sample); }
  template <class T>
  std::vector<T> all(NodeNumber process) const {
    std::vector<T> found;
    const auto said = incoming_.find(process);
    if (said == incoming_.end()) return found;
    for (const Incoming& one : said->second)
      if (const auto* it = std::get_if<T>(&one)) found.push_back(*it);
    return found;
  }
  std::vector<std::uint64_t> events(NodeNumber process) const {
    std::vector<std::uint64_t> ids;
    for (const Received& one : all<Received>(process))
      if (const auto* event = std::get_if<wire::TaskEvent>(&one.sample)) ids.push_back(event->id);
    return ids;
  }
  std::vector<int> degrees() const {
    std::vector<int> values;
    for (const Received& one : all<Received>(kGround.number))
      if (const auto* said = std::get_if<wire::AutonomyDegree>(&one.sample))
        values.push_back(said->degree);
    return values;
  }
  std::size_t refused() const { return all<Dropped>(kGround.number).size(); }
  /// Fields that the ground has named for the first time.
  std::vector<std::string> named() const {
    std::vector<std::string> fields;
    for (const Dropped& one : all<Dropped>(kGround.number))
      if (one.first && !one.why.ends_with(" times)")) fields.push_back(one.field);
    return fields;
  }

 private:
  std::map<NodeNumber, std::vector<Incoming>> incoming_;
  testing::MemoryBoards boards_{[this](NodeNumber process, Incoming&& incoming) {
    incoming_[process].push_back(std::move(incoming));
  }};
};

struct Second {
  std::uint64_t incarnation = 0;
  bool guesses = false;
};

class SecondProcess : public ::testing::TestWithParam<Second> {
 protected:
  SecondProcess() {
    rivals.start(kFirst, 10);
    rivals.run_for(kSettled);
  }
  void start_second() { rivals.start(kSecond, GetParam().incarnation, GetParam().guesses); }

  Rivals rivals;
};

TEST_P(SecondProcess, IsRefusedAndNamedOnce) {
  start_second();
  rivals.run_for(kSettled);
  const std::size_t before = rivals.refused();
  rivals.send(kSecond, degree(1));
  rivals.send(kSecond, task_event(77));
  rivals.run_for(kSettled);

  EXPECT_THAT(rivals.named(), ElementsAre("header.incarnation"));
  EXPECT_GT(rivals.refused(), before);
  EXPECT_THAT(rivals.degrees(), IsEmpty());
  EXPECT_THAT(rivals.events(kGround.number), IsEmpty());
  EXPECT_TRUE(rivals[kGround.number].reachable(kUav.number));
}

TEST_P(SecondProcess, LeavesTheSessionOfTheFirstAsItWas) {
  rivals.send(kFirst, task_event(1));
  rivals.run_for(kPeriod);
  rivals.send(kFirst, task_event(2));
  start_second();
  rivals.send(kFirst, task_event(3));
  rivals.run_for(kPeriod);
  rivals.send(kFirst, task_event(4));
  rivals.send(kFirst, hand_over(5, 40'000));
  rivals.run_for(kSettled);
  rivals.send(kFirst, task_event(6));
  rivals.run_for(kSettled);

  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1, 2, 3, 4, 6));
  EXPECT_THAT(rivals.all<EventsLost>(kGround.number), IsEmpty());
  EXPECT_EQ(rivals[kFirst].unacknowledged(kGround.number), 0U);
}

TEST_P(SecondProcess, LeavesTheLastValueToTheFirst) {
  rivals.send(kFirst, degree(4));
  rivals.run_for(kPeriod);
  start_second();
  rivals.send(kSecond, degree(1));
  rivals.run_for(kSettled);

  ASSERT_FALSE(rivals.degrees().empty());
  EXPECT_EQ(rivals.degrees().back(), 4);
}

TEST_P(SecondProcess, DoesNotTakeWhatIsSentToTheFirst) {
  start_second();
  rivals.run_for(kSettled);
  for (const std::uint64_t id : {1, 2, 3}) rivals.send(kGround.number, task_event(id));
  rivals.run_for(kSettled);

  EXPECT_THAT(rivals.events(kFirst), ElementsAre(1, 2, 3));
  EXPECT_THAT(rivals.events(kSecond), IsEmpty());
}

TEST_P(SecondProcess, IsTheNodeOnceTheFirstIsSilent) {
  start_second();
  rivals.run_for(kSettled);
  rivals.kill(kFirst);
  rivals.send(kSecond, degree(1));
  rivals.send(kSecond, task_event(7));
  rivals.run_for(kLease + kSettled);

  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(7));
  EXPECT_THAT(rivals.degrees(), ElementsAre(1));
}

INSTANTIATE_TEST_SUITE_P(OfOneName, SecondProcess,
                         ::testing::Values(Second{50, false}, Second{50, true}, Second{5, false},
                                           Second{5, true}));

TEST(Rivals, BothProcessesAreToldOnce) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  rivals.start(kSecond, 50);
  rivals.run_for(kSettled);

  ASSERT_THAT(rivals.all<TakenForOlder>(kFirst), SizeIs(1));
  EXPECT_EQ(rivals.all<TakenForOlder>(kFirst)[0].heard, 50U);
  ASSERT_THAT(rivals.all<TakenForOlder>(kSecond), SizeIs(1));
  EXPECT_EQ(rivals.all<TakenForOlder>(kSecond)[0].heard, 10U) << "the first goes on to be heard";
}

// Who is restarted while two run hears the later one first. Once that is gone the other is the
// node.
TEST(Rivals, TheFirstIsHeardAgainByAPeerThatWasRestartedBesideTheSecond) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  rivals.kill(kGround.number);
  rivals.start(kGround.number, 2);
  rivals.send(kFirst, degree(4));
  rivals.send(kFirst, task_event(1));
  for (std::uint64_t sequence = 1; sequence < 10; ++sequence) {
    rivals.inject(heartbeat_of(50, sequence));
    rivals.run_for(kPeriod);
  }
  ASSERT_THAT(rivals.events(kGround.number), IsEmpty()) << "the second is heard";

  rivals.run_for(kLease + kSettled);
  EXPECT_TRUE(rivals[kGround.number].reachable(kUav.number));
  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1));
  EXPECT_THAT(rivals.degrees(), ElementsAre(4));
  rivals.send(kGround.number, task_event(2));
  rivals.send(kFirst, task_event(3));
  rivals.run_for(kSettled);
  EXPECT_THAT(rivals.events(kFirst), ElementsAre(2));
  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1, 3));
}

// One heartbeat of an older life may have been late.
TEST(Rivals, ALateHeartbeatOfAFormerLifeDoesNotBringItBack) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  rivals.kill(kFirst);
  rivals.run_for(kSettled);
  ASSERT_FALSE(rivals[kGround.number].reachable(kUav.number));
  for (const std::uint64_t sequence : {7, 8, 8, 8}) {
    rivals.inject(heartbeat_of(9, sequence));
    rivals.run_for(kPeriod);
  }

  EXPECT_FALSE(rivals[kGround.number].reachable(kUav.number));
}

// The supervisor of services starts it again and again.
TEST(Rivals, ASecondProcessThatIsStartedAgainDoesNotTakeTheNodeEither) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  for (std::uint64_t life = 50; life < 60; ++life) {
    rivals.start(kSecond, life);
    rivals.run_for(kPeriod + kPeriod);
  }
  rivals.run_for(kSettled);
  rivals.send(kFirst, task_event(1));
  rivals.run_for(kSettled);

  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1));
  const auto reached = rivals.all<Reachability>(kGround.number);
  EXPECT_THAT(reached, SizeIs(4)) << "the first, two lives of the second, the first again";
}

TEST(Rivals, ARestartIsTheNodeWithItsFirstHeartbeat) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  rivals.kill(kFirst);
  rivals.start(kFirst, 11);
  rivals.send(kFirst, degree(3));
  rivals.send(kFirst, task_event(1));
  rivals.run_for(Duration::milliseconds(20));

  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1));
  EXPECT_THAT(rivals.degrees(), ElementsAre(3));
  EXPECT_TRUE(rivals.all<Reachability>(kGround.number).back().restarted);
  rivals.run_for(kSettled);
  EXPECT_THAT(rivals.named(), IsEmpty());
}

TEST(Rivals, ALonelyHeartbeatOfALaterLifeDoesNotSilenceTheNode) {
  Rivals rivals;
  rivals.start(kFirst, 10);
  rivals.run_for(kSettled);
  rivals.inject(heartbeat_of(50, 1));
  rivals.run_for(kSettled);
  rivals.send(kFirst, task_event(1));
  rivals.run_for(kPeriod);

  EXPECT_TRUE(rivals[kGround.number].reachable(kUav.number));
  EXPECT_THAT(rivals.events(kGround.number), ElementsAre(1));
}

// Processes of one name are started, killed and started again as the seed says, each life later
// than all before it. While two run, the one that was there first is the node, and what the other
// says is not heard; a process that runs alone is heard whatever was before. No event is handled
// twice or out of order.
RC_GTEST_PROP(Rivals, TheFirstOfTwoIsHeardAndARestartAtOnce, ()) {
  const auto steps = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::uint8_t>>(rc::gen::inRange<std::uint8_t>(0, 4)));
  Rivals rivals;
  std::uint64_t life = 0, id = 0;
  std::vector<std::uint64_t> due;
  std::map<NodeNumber, std::vector<std::uint64_t>> waiting;  // at processes that are not heard
  std::optional<NodeNumber> holder;
  const auto other = [](NodeNumber one) { return one == kFirst ? kSecond : kFirst; };
  for (const std::uint8_t step : steps) {
    const NodeNumber one = step % 2 == 0 ? kFirst : kSecond;
    const bool both = rivals.runs(kFirst) && rivals.runs(kSecond);
    if (step < 2) {  // started, again if it runs
      rivals.start(one, ++life);
      waiting[one].clear();
      if (!holder) holder = one;
      if (both && holder == one) {
        rivals.run_for(kLease + kPeriod);
        // The node was silent while another waited to be it: that one was heard, perhaps.
        if (rivals.events(kGround.number).size() > due.size())
          std::ranges::copy(waiting[other(one)], std::back_inserter(due));
        RC_ASSERT(rivals.events(kGround.number) == due);
        rivals.kill(other(one));
        waiting[other(one)].clear();
        rivals.run_for(kLease + kPeriod);
      }
    } else if (rivals.runs(one)) {
      rivals.kill(one);
      waiting[one].clear();
      if (holder == one)
        holder = rivals.runs(other(one)) ? std::optional(other(one)) : std::nullopt;
    }
    rivals.run_for(kSettled);
    for (const NodeNumber process : {kFirst, kSecond}) {
      if (!rivals.runs(process)) continue;
      rivals.send(process, task_event(++id));
      waiting[process].push_back(id);
    }
    if (holder) {
      std::ranges::copy(waiting[*holder], std::back_inserter(due));
      waiting[*holder].clear();
    }
    rivals.run_for(kSettled);
    RC_ASSERT(rivals.events(kGround.number) == due);
  }
}

}  // namespace
}  // namespace skein::blackboard
