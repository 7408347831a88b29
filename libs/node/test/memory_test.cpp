// SPDX-License-Identifier: Apache-2.0
// Nodes that die and come back with what they knew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "skein/blackboard/memory_transport.hpp"
#include "skein/foundation/random.hpp"
#include "skein/node/host.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "testing/fake_node.hpp"

namespace skein::node {
namespace {

using journal::Record;
using testing::abort_request;
using testing::at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr NodeNumber kGround(1);
constexpr NodeNumber kUav(10);

// Counts what it gets, asks for a job at each third, answers each event with one of the same number
// and writes a line: all it does follows from all it was ever given.
class Counter final : public Node {
 public:
  // `words`: bytes of the reason that each answer gives.
  explicit Counter(NodeNumber peer, std::size_t words = 0) : peer_(peer), words_(words) {}

  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* done = std::get_if<JobDone>(&input)) {
      count_ += static_cast<std::uint64_t>(std::any_cast<int>(done->result));
      return {line(now, "job")};
    }
    const auto* received = std::get_if<Received>(&input);
    if (received == nullptr) return {};
    const auto* request = std::get_if<wire::TaskRequest>(&received->sample);
    if (request == nullptr) return {};
    ++count_;
    Effects effects{line(now, "got " + std::to_string(request->id)),
                    Send{peer_, answer(1000 + count_), MissionTime::max()}};
    if (count_ % 3 == 0)
      effects.push_back(StartJob{count_, [](const TimeIsUp&) { return std::any(10); }});
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override { return std::nullopt; }

 private:
  wire::TaskEvent answer(std::uint64_t number) const {
    wire::TaskEvent event;
    event.id = number;
    event.reason = std::string(words_, 'w');
    return event;
  }
  Log line(MissionTime now, const std::string& text) const {
    return {Record(now, "uav", "line").with("text", text).with("count", count_)};
  }

  NodeNumber peer_;
  std::size_t words_;
  std::uint64_t count_ = 0;
};

// Sends an event at each instant of a list and writes what comes back.
class Caller final : public Node {
 public:
  explicit Caller(std::vector<double> instants) : instants_(std::move(instants)) {}

  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* received = std::get_if<Received>(&input)) {
      const auto* answer = std::get_if<wire::TaskEvent>(&received->sample);
      if (answer == nullptr) return {};
      return {Log{Record(now, "ground", "answer").with("number", answer->id)}};
    }
    if (!std::holds_alternative<Wakeup>(input)) return {};
    ++next_;
    return {Send{kUav, abort_request(next_), MissionTime::max()}};
  }
  std::optional<MissionTime> next_wakeup() const override {
    if (next_ >= instants_.size()) return std::nullopt;
    return at(instants_[next_]);
  }

 private:
  std::vector<double> instants_;
  std::size_t next_ = 0;
};

struct Played {
  std::vector<std::uint64_t> answers;
  std::vector<std::string> lines, notices, reached;
  std::vector<std::pair<std::uint64_t, bool>> marks;  ///< of the lines: number, again

  void see(const Record& record) {
    if (record.kind() == "notice") notices.emplace_back(record.text("text"));
    if (record.kind() == "reach") reached.push_back(to_json(record));
    if (record.kind() == "line") lines.emplace_back(record.text("text"));
    if (record.kind() == "answer")
      answers.push_back(static_cast<std::uint64_t>(record.number("number")));
  }
};

// The ground calls, the UAV counts.
Played play(const std::vector<double>& calls, const std::vector<Crash>& crashes,
            std::size_t words = 0) {
  const Roster roster({"uav"});
  VirtualConfig config;
  config.time_limit = at(60);
  config.crashes = crashes;
  Played played;
  run_virtual(
      roster,
      [&](const std::string& name) -> std::unique_ptr<Node> {
        if (name == "ground") return std::make_unique<Caller>(calls);
        return std::make_unique<Counter>(kGround, words);
      },
      config, [&](const Record& record) { played.see(record); });
  return played;
}

TEST(Memory, ANodeThatComesBackGoesOnWhereItWas) {
  const auto played = play({1, 2, 3, 20, 21}, {{at(5), "uav", at(10), true}});

  EXPECT_THAT(played.lines, ElementsAre("got 1", "got 2", "got 3", "job", "got 4", "got 5", "job"));
  EXPECT_THAT(played.answers, ElementsAre(1001, 1002, 1003, 1014, 1015));
}

TEST(Memory, WithoutItANodeBeginsAnew) {
  const auto played = play({1, 2, 20}, {{at(5), "uav", at(10), false}});

  EXPECT_THAT(played.answers, ElementsAre(1001, 1002, 1001));
}

TEST(Memory, WhatCameWhileItWasDeadIsHandledOnceItIsBack) {
  const auto played = play({1, 6, 7, 8, 20}, {{at(5), "uav", at(10), true}});

  EXPECT_THAT(played.answers, ElementsAre(1001, 1002, 1003, 1004, 1015));
}

TEST(Memory, AJobThatHadNotEndedBeginsAgainAndEndsOnce) {
  const auto played = play({1, 2, 3, 20}, {{at(3.02), "uav", at(10), true}});

  EXPECT_THAT(played.lines, ElementsAre("got 1", "got 2", "got 3", "job", "got 4"));
}

TEST(Memory, TheGroundMayDieTooAndAsksNothingTwice) {
  const auto played = play({1, 2, 3, 20, 21}, {{at(2.5), "ground", at(10), true}});

  EXPECT_THAT(played.answers, ElementsAre(1001, 1002, 1003, 1014, 1015));
}

// Whoever dies, whenever, however often and for how long: in the end everything was asked once,
// handled once, in order, and answered once; so too if each answer goes in parts.
RC_GTEST_PROP(Memory, NothingIsLostAndNothingDoneTwice, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<double> calls;
  for (double t = 0.1; t < 30; t += random.uniform(0.05, 2)) calls.push_back(t);
  std::vector<Crash> crashes;
  for (std::uint64_t i = 1 + random.below(4); i > 0; --i) {
    const MissionTime dies = at(random.uniform(0, 35));
    crashes.push_back({dies, random.chance(0.5) ? "uav" : "ground",
                       dies + Duration::seconds(random.uniform(0, 8)), true});
  }

  const std::size_t words = random.chance(0.5) ? 20'000 : 0;

  const Played played = play(calls, crashes, words);

  std::vector<std::string> got;
  for (const std::string& line : played.lines)
    if (line != "job") got.push_back(line);
  RC_ASSERT(got.size() == calls.size());
  for (std::size_t i = 0; i < got.size(); ++i) RC_ASSERT(got[i] == "got " + std::to_string(i + 1));
  RC_ASSERT(played.answers.size() == calls.size());
  for (std::size_t i = 1; i < played.answers.size(); ++i)
    RC_ASSERT(played.answers[i] > played.answers[i - 1]);
}

// ---- who plays the world ----

// Counts all that it was ever given; told by Started that it is another life.
class World final : public Node {
 public:
  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* started = std::get_if<Started>(&input))
      return {Log{Record(now, "sim", "line")
                      .with("text", "life " + std::to_string(started->incarnation) + " at " +
                                        std::to_string(beats_))}};
    if (std::holds_alternative<Wakeup>(input)) ++beats_;
    return {};
  }
  std::optional<MissionTime> next_wakeup() const override { return at(beats_ + 1); }

 private:
  int beats_ = 0;
};

std::vector<std::string> lives_of_the_world(const std::vector<Crash>& crashes) {
  const Roster roster({"uav"});
  VirtualConfig config;
  config.time_limit = at(60);
  config.crashes = crashes;
  Played played;
  run_virtual(
      roster,
      [&](const std::string& name) -> std::unique_ptr<Node> {
        if (name == "sim") return std::make_unique<World>();
        return std::make_unique<Caller>(std::vector<double>());
      },
      config, [&](const Record& record) { played.see(record); });
  return played.lines;
}

TEST(Memory, TheWorldIsAsItWasWhenWhoPlaysItComesBackWithNothingItKnew) {
  EXPECT_THAT(lives_of_the_world({{at(5.5), "sim", at(10), false}}),
              ElementsAre("life 1 at 0", "life 2 at 5"));
}

TEST(Memory, ALifeThatForgotMayItselfBeGoneOnFrom) {
  EXPECT_THAT(lives_of_the_world({{at(5.5), "sim", at(10), false},
                                  {at(20.5), "sim", at(22), true},
                                  {at(30.5), "sim", at(31), false}}),
              ElementsAre("life 1 at 0", "life 2 at 5", "life 4 at 30"));
}

// ---- a host of its own, killed between what it keeps and what it does ----

struct PowerIsGone {};

// Keeps so many inputs; with the last of them the power goes, before anything follows from it.
class UntilThePowerGoes final : public InputLog {
 public:
  explicit UntilThePowerGoes(std::size_t inputs) : left_(inputs) {}
  Result<void, Failure> append(const LogEntry& entry) override {
    (void)kept.append(entry);
    if (--left_ == 0) throw PowerIsGone{};
    return {};
  }
  void told(std::uint64_t lines) override { kept.told(lines); }
  Result<void, Failure> recall(
      const std::function<Result<void, Failure>(const LogEntry&)>& take) const override {
    return kept.recall(take);
  }
  std::uint64_t lines_told() const override { return kept.lines_told(); }

  MemoryInputLog kept;

 private:
  std::size_t left_;
};

class AHost : public ::testing::Test {
 protected:
  std::unique_ptr<Host> open(const std::string& name, std::unique_ptr<Node> node,
                             blackboard::Transport& transport, InputLog* memory, Played& played) {
    HostConfig config;
    config.memory = memory;
    HostPorts ports;
    ports.journal = [&played](const Record& record, LineMark mark) {
      played.see(record);
      if (record.kind() == "line") played.marks.emplace_back(mark.number, mark.again);
    };
    ports.start_job = [](const StartJob&) {};
    ports.finish = [] {};
    auto host = Host::open(roster_, *roster_.find(name), std::move(node), transport, config, ports);
    EXPECT_TRUE(host.has_value()) << host.error().why;
    return std::move(*host);
  }
  blackboard::Now now() const { return {time_, time_ - MissionTime()}; }
  void settle(Host& a, Host& b) {
    for (int i = 0; i < 40; ++i) {
      time_ = time_ + Duration::milliseconds(50);
      a.step(now());
      a.lines_have_left();
      b.step(now());
    }
  }

  const Roster roster_{{"uav"}};
  MissionTime time_;
};

// For every input that it may be: the power goes after it was kept and before anything was done
// about it.
TEST_F(AHost, KilledBetweenKeepingAndDoingDoesItInItsNextLife) {
  for (std::size_t inputs = 1; inputs <= 6; ++inputs) {
    blackboard::MemoryHub hub;
    blackboard::MemoryTransport ground_side(hub);
    Played at_ground, at_uav;
    UntilThePowerGoes memory(inputs);
    auto ground = open("ground", std::make_unique<Caller>(std::vector<double>{1, 1, 1, 1}),
                       ground_side, nullptr, at_ground);
    {
      blackboard::MemoryTransport uav_side(hub);
      auto uav = open("uav", std::make_unique<Counter>(kGround), uav_side, &memory, at_uav);
      ground->start(now());
      const auto lives = [&] {
        uav->start(now());
        settle(*uav, *ground);
      };
      EXPECT_THROW(lives(), PowerIsGone) << inputs;
    }
    blackboard::MemoryTransport uav_side(hub);
    auto uav = open("uav", std::make_unique<Counter>(kGround), uav_side, &memory.kept, at_uav);
    uav->start(now());
    settle(*uav, *ground);

    EXPECT_THAT(at_ground.answers, ElementsAre(1001, 1002, 1003, 1004)) << inputs;
    EXPECT_THAT(at_uav.lines, ElementsAre("got 1", "got 2", "got 3", "got 4")) << inputs;
  }
}

// Keeps everything but that lines have left, when the power goes instead.
class UntilLinesLeft final : public InputLog {
 public:
  explicit UntilLinesLeft(std::uint64_t lines) : lines_(lines) {}
  Result<void, Failure> append(const LogEntry& entry) override { return kept.append(entry); }
  void told(std::uint64_t lines) override {
    if (lines == lines_) throw PowerIsGone{};
    kept.told(lines);
  }
  Result<void, Failure> recall(const Take& take) const override { return kept.recall(take); }
  std::uint64_t lines_told() const override { return kept.lines_told(); }

  MemoryInputLog kept;

 private:
  std::uint64_t lines_;
};

TEST_F(AHost, KilledBetweenGivingALineOutAndNotingItGivesItOutAgainWithItsNumber) {
  blackboard::MemoryHub hub;
  blackboard::MemoryTransport ground_side(hub);
  Played at_ground, at_uav;
  UntilLinesLeft memory(2);
  auto ground = open("ground", std::make_unique<Caller>(std::vector<double>{1, 1.5, 2}),
                     ground_side, nullptr, at_ground);
  {
    blackboard::MemoryTransport uav_side(hub);
    auto uav = open("uav", std::make_unique<Counter>(kGround), uav_side, &memory, at_uav);
    ground->start(now());
    uav->start(now());
    EXPECT_THROW(settle(*uav, *ground), PowerIsGone);
  }
  blackboard::MemoryTransport uav_side(hub);
  auto uav = open("uav", std::make_unique<Counter>(kGround), uav_side, &memory.kept, at_uav);
  uav->start(now());
  settle(*uav, *ground);

  EXPECT_THAT(at_uav.lines, ElementsAre("got 1", "got 2", "got 2", "got 3"));
  EXPECT_THAT(at_uav.marks,
              ElementsAre(Pair(1, false), Pair(2, false), Pair(2, true), Pair(3, false)));
}

// The leader of the clock is dead, too: the life that nobody tells the time hears the ground
// station, and ends without having begun.
class WhoDiesUnstarted : public AHost {
 protected:
  void SetUp() override {
    ground_ = open("ground", std::make_unique<Caller>(std::vector<double>{1}), ground_side_,
                   nullptr, at_ground_);
    ground_->start(now());
    live(true, 2);
    live(false, 10);
  }
  // A life of so many seconds.
  void live(bool is_started, int seconds) {
    blackboard::MemoryTransport side(hub_);
    auto uav = open("uav", std::make_unique<Counter>(kGround), side, &memory_, at_uav_);
    if (is_started) uav->start(now());
    for (int i = 0; i < seconds; i += 2) settle(*uav, *ground_);
  }

  blackboard::MemoryHub hub_;
  blackboard::MemoryTransport ground_side_{hub_};
  MemoryInputLog memory_;
  Played at_ground_, at_uav_;
  std::unique_ptr<Host> ground_;
};

TEST_F(WhoDiesUnstarted, IsHeardAtOnceInItsNextLife) {
  live(true, 8);

  EXPECT_THAT(at_ground_.reached, ElementsAre(HasSubstr("true")));
}

// Keeps nothing, and has something to say of it twice.
class WithNews final : public InputLog {
 public:
  Result<void, Failure> append(const LogEntry&) override {
    ++kept_;
    return {};
  }
  std::string take_news() override {
    if (kept_ == 2) return "little room";
    return kept_ == 4 ? "room again" : "";
  }
  void told(std::uint64_t) override {}
  Result<void, Failure> recall(const Take&) const override { return {}; }
  std::uint64_t lines_told() const override { return 0; }

 private:
  int kept_ = 0;
};

TEST_F(AHost, SaysWhatItsMemoryHasToSay) {
  blackboard::MemoryHub hub;
  blackboard::MemoryTransport ground_side(hub), uav_side(hub);
  Played at_ground, at_uav;
  WithNews memory;
  auto ground = open("ground", std::make_unique<Caller>(std::vector<double>{1, 1, 1, 1}),
                     ground_side, nullptr, at_ground);
  auto uav = open("uav", std::make_unique<Counter>(kGround), uav_side, &memory, at_uav);
  ground->start(now());
  uav->start(now());

  settle(*uav, *ground);

  EXPECT_THAT(at_uav.notices, ElementsAre("little room", "room again"));
}

TEST_F(AHost, SaysFromWhenItWas) {
  blackboard::MemoryHub hub;
  Played played;
  MemoryInputLog memory;
  (void)memory.append({at(3), Started{7}});
  (void)memory.append({at(8), Wakeup{}});
  blackboard::MemoryTransport transport(hub);

  const auto host = open("uav", std::make_unique<Counter>(kGround), transport, &memory, played);

  EXPECT_EQ(host->resumed_from(), at(8));
}

// ---- what cannot be ----

Result<void, Failure> explained(const std::vector<LogEntry>& entries, std::uint64_t told = 0) {
  MemoryInputLog memory;
  for (const LogEntry& entry : entries) (void)memory.append(entry);
  memory.told(told);
  Counter node(kGround);
  return explains(memory, node);
}

TEST(AMemory, ThatExplainsNothingIsNone) {
  EXPECT_TRUE(explained({}).has_value());
  EXPECT_TRUE(explained({{at(0), Started{1}}, {at(1), Wakeup{}}}).has_value());
  EXPECT_THAT(explained({{at(1), Wakeup{}}}).error().why,
              HasSubstr("does not begin with the start"));
  EXPECT_THAT(explained({{at(2), Started{1}}, {at(1), Wakeup{}}}).error().why,
              HasSubstr("its time goes back"));
  EXPECT_THAT(explained({{at(2), Started{1}}, {at(3), JobEnded{4, {}}}}).error().why,
              HasSubstr("job 4 ended that nobody began"));
  EXPECT_THAT(explained({{at(2), Started{1}}}, 5).error().why,
              HasSubstr("does not explain the 5 lines that it wrote"));
}

// A job that was cut short after so many questions is cut short there again.
TEST(AMemory, GivesAJobItsFormerClock) {
  for (const JobClock clock :
       {JobClock{}, JobClock{true, false, 9}, JobClock{true, true, 0}, JobClock{true, true, 7}}) {
    testing::Diary diary;
    std::optional<std::uint64_t> noes;
    diary.answer = [&](const Input& input, MissionTime) -> Effects {
      if (!std::holds_alternative<Started>(input)) return {};
      return {StartJob{1, [&](const TimeIsUp& time_is_up) {
                         noes.reset();
                         if (!time_is_up) return std::any();
                         noes = 0;
                         while (*noes < 100 && !time_is_up()) ++*noes;
                         return std::any();
                       }}};
    };
    MemoryInputLog memory;
    (void)memory.append({at(0), Started{1}});
    (void)memory.append({at(1), JobEnded{1, clock}});
    testing::FakeNode node(diary);

    ASSERT_TRUE(explains(memory, node).has_value());

    EXPECT_EQ(noes.has_value(), clock.given);
    EXPECT_EQ(noes.value_or(100), clock.ran_out ? clock.questions : 100U);
  }
}

}  // namespace
}  // namespace skein::node
