// SPDX-License-Identifier: Apache-2.0
// The verbs in a domain that is told, without DDS.
#include "verbs/verbs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "testing/fake_observer.hpp"

namespace skein::spy_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;
using wire::Slot;

class Verbs : public ::testing::Test {
 protected:
  Verbs() {
    auto observer = std::make_unique<testing::FakeObserver>();
    observer_ = observer.get();
    options_.duration = 0.02;
    listener_.emplace(options_, std::move(observer));
  }
  testing::Story domain() { return testing::Story(*observer_); }

  int run(int (*verb)(const SpyOptions&, Listener&, std::ostream&, std::ostream&)) {
    return verb(options_, *listener_, out_, err_);
  }
  std::vector<Json> lines() const {
    std::vector<Json> all;
    std::istringstream in(out_.str());
    for (std::string line; std::getline(in, line);) all.push_back(Json::parse(line));
    return all;
  }
  static wire::TaskEvent task(std::uint64_t id, wire::TaskState state) {
    wire::TaskEvent event;
    event.header.origin = 10;
    event.header.destination = 1;
    event.header.sequence_number = id;
    event.uav = "marvin";
    event.id = id;
    event.state = state;
    return event;
  }

  SpyOptions options_;
  testing::FakeObserver* observer_ = nullptr;
  std::optional<Listener> listener_;
  std::ostringstream out_, err_;
};

TEST_F(Verbs, EchoPrintsWhatFulfilsTheCondition) {
  domain().node("marvin", 10).writes("marvin", Slot::kTaskEvent, "radio/marvin>ground");
  for (const std::uint64_t id : {1U, 2U, 3U, 4U})
    domain().says("marvin",
                  task(id, id % 2 == 0 ? wire::TaskState::kEnded : wire::TaskState::kRunning));
  options_.slots = {"TaskEvent"};
  options_.where = "id > 1 && state == ended";
  options_.fields = {"uav", "id"};

  EXPECT_EQ(run(echo), kExitOk) << err_.str();

  EXPECT_EQ(out_.str(), "marvin\t2\nmarvin\t4\n");
}

TEST_F(Verbs, EchoOfFieldsAsJsonHasStableKeys) {
  domain()
      .node("marvin", 10)
      .writes("marvin", Slot::kTaskEvent)
      .says("marvin", task(7, wire::TaskState::kEnded));
  options_.slots = {"TaskEvent"};
  options_.fields = {"id", "header.sequence_number"};
  options_.json = true;

  EXPECT_EQ(run(echo), kExitOk) << err_.str();

  ASSERT_EQ(lines().size(), 1U);
  EXPECT_EQ(
      lines()[0],
      Json::parse(
          R"({"slot":"TaskEvent","origin":10,"fields":{"id":7,"header.sequence_number":7}})"));
}

TEST_F(Verbs, EchoStopsAfterTheCountAndLosesNothingBetweenTheFirstAndTheNext) {
  domain().node("marvin", 10).writes("marvin", Slot::kTaskEvent);
  for (const std::uint64_t id : {1U, 2U, 3U})
    domain().says("marvin", task(id, wire::TaskState::kEnded));
  options_.slots = {"TaskEvent"};
  options_.fields = {"id"};
  options_.timeout = 5;
  options_.count = 2;

  EXPECT_EQ(run(echo), kExitOk) << err_.str();

  EXPECT_EQ(out_.str(), "1\n2\n");
}

TEST_F(Verbs, EchoShowsOthersTypesAsBytesWithTheirNames) {
  blackboard::Endpoint chatter;
  chatter.writer = true;
  chatter.topic = "rt/chatter";
  chatter.type = "std_msgs::msg::dds_::String_";
  domain().joins("talker", "").has("talker", chatter);
  domain().says_bytes("talker", "rt/chatter", {0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0});
  options_.topics = {"rt/*"};

  EXPECT_EQ(run(echo), kExitOk) << err_.str();

  EXPECT_THAT(out_.str(),
              StartsWith("rt/chatter  std_msgs::msg::dds_::String_  from talker, 11 bytes\n"));
  EXPECT_THAT(out_.str(), HasSubstr("hi."));
  ASSERT_EQ(observer_->subscriptions.size(), 1U);
  EXPECT_FALSE(observer_->subscriptions[0].keyed);
  EXPECT_EQ(observer_->subscriptions[0].partitions, (std::vector<std::string>{"", "*"}));
}

TEST_F(Verbs, EchoSaysOfMalformedBytesWhatIsWrong) {
  domain()
      .node("marvin", 10)
      .writes("marvin", Slot::kTelemetry)
      .says_bytes("marvin", "Telemetry", {0, 1, 0, 0, 9});
  options_.slots = {"Telemetry"};

  EXPECT_EQ(run(echo), kExitOk) << err_.str();

  ASSERT_EQ(lines().size(), 1U);
  EXPECT_EQ(lines()[0]["slot"], "Telemetry");
  EXPECT_TRUE(lines()[0].contains("malformed"));
}

TEST_F(Verbs, EchoReadsOnlyWhatIsAskedForAndTheNames) {
  domain()
      .node("marvin", 10)
      .writes("marvin", Slot::kTelemetry)
      .writes("marvin", Slot::kJournalEntry);
  options_.slots = {"Tele*"};

  EXPECT_EQ(run(echo), kExitTimeout);

  EXPECT_TRUE(observer_->reads("Telemetry"));
  EXPECT_TRUE(observer_->reads("DirectoryEntry"));
  EXPECT_FALSE(observer_->reads("JournalEntry"));
}

TEST_F(Verbs, EchoOfAnUnknownFieldIsRefusedWithTheNearest) {
  options_.slots = {"TaskEvent"};
  options_.fields = {"reasn"};
  options_.where = "satte == ended && id >";

  const Diagnostics wrong = check_echo(options_, *listener_);

  ASSERT_EQ(wrong.size(), 2U);
  EXPECT_EQ(wrong.all()[0].nearest, "reason");
  EXPECT_THAT(wrong.all()[1].message, HasSubstr("column 23"));
}

// Why nothing came: one test a cause.

TEST_F(Verbs, SilenceOfADomainWithoutAnybodyIsTold) {
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(err_.str(), StartsWith("nothing heard: nobody there: "));
}

TEST_F(Verbs, SilenceForWantOfAWriterIsTold) {
  domain().node("marvin", 10).writes("marvin", Slot::kTelemetry, "elsewhere");
  options_.slots = {"Telemetry"};
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(err_.str(), StartsWith("nothing heard: no writer: nobody writes Telemetry"));
  EXPECT_THAT(err_.str(), HasSubstr("writers of it in elsewhere"));
}

TEST_F(Verbs, SilenceForRefusedQosIsTold) {
  blackboard::Endpoint clock = reader_of(Slot::kClock, {"world"});
  clock.writer = true;
  clock.qos = {};
  domain().joins("sim").has("sim", clock);
  options_.slots = {"Clock"};
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(
      err_.str(),
      StartsWith("nothing heard: QoS refused: Clock of sim: the writer offers best effort"));
}

TEST_F(Verbs, SilenceOfAnotherTypeUnderAKnownNameIsTold) {
  blackboard::Endpoint clock = reader_of(Slot::kClock, {"world"});
  clock.writer = true;
  clock.type = "rosgraph::Clock";
  domain().joins("sim").has("sim", clock);
  options_.slots = {"Clock"};
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(err_.str(),
              HasSubstr("QoS refused: Clock of sim: the writer offers the type rosgraph::Clock"));
}

TEST_F(Verbs, SilenceOfAWriterIsTold) {
  domain().node("marvin", 10).writes("marvin", Slot::kTelemetry);
  options_.slots = {"Telemetry"};
  options_.timeout = 0.02;
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(err_.str(), StartsWith("nothing heard: silent writer: 1 writers of Telemetry"));
}

TEST_F(Verbs, SilenceBecauseNothingFitsIsTold) {
  domain()
      .node("marvin", 10)
      .writes("marvin", Slot::kTaskEvent)
      .says("marvin", task(1, wire::TaskState::kEnded));
  options_.slots = {"TaskEvent"};
  options_.where = "id > 9";
  EXPECT_EQ(run(echo), kExitTimeout);
  EXPECT_THAT(err_.str(), StartsWith("nothing heard: nothing fits: 1 samples came"));
}

TEST_F(Verbs, ListTellsWritersReadersAndWhoIsAlone) {
  domain()
      .node("sim", 2)
      .node("ground", 1)
      .writes("sim", Slot::kClock)
      .reads("ground", Slot::kClock);
  domain().reads("ground", Slot::kTruth);
  options_.slots = {"Clock", "Truth"};
  options_.json = true;

  EXPECT_EQ(run(show_topics), kExitOk);

  ASSERT_EQ(lines().size(), 2U);
  EXPECT_EQ(lines()[0]["topic"], "Clock");
  EXPECT_EQ(lines()[0]["writers"], 1);
  EXPECT_EQ(lines()[0]["readers"], 1);
  EXPECT_EQ(lines()[0]["unmatched"], 0);
  EXPECT_EQ(lines()[0]["class"], "state");
  EXPECT_EQ(lines()[1]["unmatched"], 1);
  EXPECT_EQ(observer_->subscriptions.size(), 1U) << "of the names; it looks, it does not read";
}

TEST_F(Verbs, ListOfMismatchesNamesTheTwoAndThePolicy) {
  blackboard::Endpoint truth = reader_of(Slot::kTruth, {"world"});
  truth.qos.reliable = true;
  domain().joins("sim").joins("tool").writes("sim", Slot::kTruth).has("tool", truth, ".reader");
  domain().writes("sim", Slot::kClock).reads("tool", Slot::kClock);
  options_.mismatch = true;

  EXPECT_EQ(run(show_topics), kExitOk);

  EXPECT_THAT(
      out_.str(),
      HasSubstr("Truth: sim > tool: the writer offers best effort, the reader asks for reliable"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("Clock")));
}

TEST_F(Verbs, ListOfMismatchesSaysThatThereAreNone) {
  domain().joins("sim").joins("tool").writes("sim", Slot::kClock).reads("tool", Slot::kClock);
  options_.mismatch = true;

  EXPECT_EQ(run(show_topics), kExitOk);

  EXPECT_EQ(out_.str(), "");
  EXPECT_EQ(err_.str(), "no topic with types or QoS that do not fit among 2 endpoints\n");
}

TEST_F(Verbs, NodesAreListedWithWhatIsKnownOfThem) {
  domain()
      .node("ground", 1, wire::Role::kGround)
      .node("marvin", 10, wire::Role::kDdn, false)
      .joins("rviz", "");
  options_.json = true;

  EXPECT_EQ(run(show_nodes), kExitOk);

  ASSERT_EQ(lines().size(), 3U);
  EXPECT_EQ(lines()[0]["node"], "ground");
  EXPECT_EQ(lines()[0]["process"], 1001);
  EXPECT_EQ(lines()[1]["ready"], false);
  EXPECT_EQ(lines()[2]["node"], "rviz");
  EXPECT_TRUE(lines()[2]["role"].is_null());
  EXPECT_TRUE(lines()[2]["version"].is_null());
}

TEST_F(Verbs, EventsTellWhoComesSpeaksAndGoes) {
  domain().node("marvin", 10).writes("marvin", Slot::kTaskEvent, "radio/marvin>ground");
  domain().says("marvin", task(3, wire::TaskState::kEnded)).says_bytes("marvin", "TaskEvent", {});
  blackboard::Endpoint moved = reader_of(Slot::kTaskEvent, {"cut"});
  moved.writer = true;
  domain()
      .has("marvin", moved)
      .see(blackboard::EndpointGone{"marvin.TaskEvent"})
      .leaves("marvin", true);
  options_.json = true;

  EXPECT_EQ(run(show_events), kExitOk);

  std::vector<std::string> told;
  for (const Json& line : lines()) told.push_back(line["event"]);
  EXPECT_THAT(told, ::testing::IsSupersetOf({"joined", "new-writer", "sample", "instance-gone",
                                             "changed-writer", "writer-gone", "silent"}));
  EXPECT_THAT(err_.str(), HasSubstr("2 sample")) << "that of the directory too";
}

TEST_F(Verbs, EventsAreAsManyLinesAsWereAskedForWhateverTheyTell) {
  domain().node("marvin", 10).joins("heliv").joins("karma").leaves("karma");
  options_.json = true;
  options_.count = 2;

  EXPECT_EQ(run(show_events), kExitOk);

  EXPECT_EQ(lines().size(), 2U);
}

TEST_F(Verbs, AFlowIsOneAlthoughNamesComeLaterThanSamples) {
  domain().joins("sim").writes("sim", Slot::kTelemetry).writes("sim", Slot::kDirectoryEntry);
  wire::Telemetry telemetry;
  telemetry.header.origin = 2;
  telemetry.header.destination = 10;
  domain().says("sim", telemetry, 10).node("marvin", 10).says("sim", telemetry, 11);
  options_.slots = {"Telemetry"};
  options_.verb = Verb::kRate;
  options_.json = true;

  EXPECT_EQ(run(show_rates), kExitOk);

  ASSERT_EQ(lines().size(), 1U);
  EXPECT_EQ(lines()[0]["from"], "sim");
  EXPECT_EQ(lines()[0]["to"], "marvin");
  EXPECT_EQ(lines()[0]["samples"], 2);
}

TEST_F(Verbs, RatesLeaveOutHistories) {
  domain().node("sim", 2).writes("sim", Slot::kClock);
  for (int i = 0; i < 5; ++i) domain().says("sim", wire::Clock{}, 0.001 * i);  // a history
  for (int i = 0; i <= 10; ++i) domain().says("sim", wire::Clock{}, 10 + 0.1 * i);
  options_.slots = {"Clock"};
  options_.verb = Verb::kRate;
  options_.json = true;

  EXPECT_EQ(run(show_rates), kExitOk) << err_.str();

  ASSERT_EQ(lines().size(), 1U);
  EXPECT_EQ(lines()[0]["samples"], 11);
  EXPECT_NEAR(lines()[0]["rate"].get<double>(), 10, 0.1);
}

TEST_F(Verbs, BandwidthCountsBytesOfTheWire) {
  domain().node("sim", 2).writes("sim", Slot::kClock);
  for (int i = 0; i <= 4; ++i) domain().says("sim", wire::Clock{}, 10 + 0.25 * i);
  options_.slots = {"Clock"};
  options_.verb = Verb::kBandwidth;
  options_.json = true;

  EXPECT_EQ(run(show_rates), kExitOk) << err_.str();

  const auto size = static_cast<double>(blackboard::encoded_size(wire::Clock{}));
  EXPECT_NEAR(lines()[0]["bytes_per_second"].get<double>(), 4 * size, 1);
  EXPECT_EQ(lines()[0]["mean"].get<double>(), size);
}

TEST_F(Verbs, DelayIsFromWritingToComing) {
  domain().node("sim", 2).writes("sim", Slot::kTruth);
  for (int i = 1; i <= 4; ++i) domain().says("sim", wire::Truth{}, 10 + i, 0.01 * i);
  options_.slots = {"Truth"};
  options_.verb = Verb::kDelay;
  options_.json = true;

  EXPECT_EQ(run(show_rates), kExitOk) << err_.str();

  EXPECT_NEAR(lines()[0]["least"].get<double>(), 0.01, 1e-6);
  EXPECT_NEAR(lines()[0]["p99"].get<double>(), 0.04, 1e-6);
}

TEST_F(Verbs, LinksTellWhoHearsWhom) {
  wire::Heartbeat there, back;
  there.header.origin = 10;
  there.header.destination = 1;
  there.header.incarnation = 5;
  there.events_to = 9;
  back.header.origin = 1;
  back.header.destination = 10;
  back.ack_incarnation = 5;
  back.ack_sequence = 7;
  domain()
      .node("ground", 1)
      .node("marvin", 10)
      .writes("marvin", Slot::kHeartbeat)
      .writes("ground", Slot::kHeartbeat);
  domain().says("marvin", there, -1).says("ground", back, -1);
  options_.json = true;

  EXPECT_EQ(run(show_links), kExitOk) << err_.str();

  ASSERT_EQ(lines().size(), 2U);
  EXPECT_EQ(lines()[1]["from"], "marvin");
  EXPECT_EQ(lines()[1]["to"], "ground");
  EXPECT_EQ(lines()[1]["waiting"], 2);
  EXPECT_NEAR(lines()[1]["heartbeat"].get<double>(), 1, 0.5);
}

TEST_F(Verbs, TheDoctorFindsTwoProgramsThatSayTheyAreTheSameNode) {
  domain().node("ground", 1);
  domain().joins("double").writes("double", Slot::kDirectoryEntry);
  wire::DirectoryEntry entry;
  entry.header.origin = 1;
  entry.name = "ground";
  entry.process = 4711;
  domain().says("double", entry);

  EXPECT_EQ(run(examine), kExitNegative);

  EXPECT_THAT(out_.str(),
              HasSubstr("BAD   nodes: 2 programs say that they are ground: process 4711 at "
                        "127.0.0.1:7411, process 1001 at 127.0.0.1:7411"));
}

TEST_F(Verbs, TheDoctorFindsNothingWrongInADomainThatIsWell) {
  domain().node("ground", 1).node("marvin", 10).writes("ground", Slot::kClock);

  EXPECT_EQ(run(examine), kExitOk) << out_.str();

  EXPECT_THAT(out_.str(), HasSubstr("good  schemas: all programs of ours have the layout"));
}

TEST_F(Verbs, TheDoctorSaysThatDdsRefusesToTakePart) {
  observer_->refuses = "no interface that is up has address 10.1.2.3";
  EXPECT_FALSE(listener_->open().has_value());

  EXPECT_EQ(run(examine), kExitNegative);

  EXPECT_THAT(out_.str(), HasSubstr("BAD   DDS: no interface that is up has address 10.1.2.3"));
}

}  // namespace
}  // namespace skein::spy_tool
