// SPDX-License-Identifier: Apache-2.0
// Joint tasks in the report: bands, violations, sequence diagrams.
#include <gtest/gtest.h>

#include "builders.hpp"
#include "story/joint_story.hpp"
#include "timeline/timeline.hpp"
#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::salvage;

constexpr const char* kLog =
    R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
{"at":5,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"loading"}
{"at":5,"node":"uav1","kind":"negotiation","uav":"uav1","joint":"watch(P1) of uav1, uav2/roles","modality":"role-allocation","opener":"uav1","opened":5,"state":"offered","rows":"perceive 3"}
{"at":5.1,"node":"uav1","kind":"message","slot":"NegotiationMessage","from":"uav1","to":"uav2","sequence":1,"direction":"sent"}
{"at":5.2,"node":"uav2","kind":"message","slot":"NegotiationMessage","from":"uav1","to":"uav2","sequence":1,"direction":"received"}
{"at":5.3,"node":"uav2","kind":"message","slot":"NegotiationMessage","from":"uav2","to":"uav1","sequence":1,"direction":"sent"}
{"at":6,"node":"uav2","kind":"negotiation","uav":"uav2","joint":"watch(P1) of uav1, uav2/roles","modality":"role-allocation","opener":"uav1","opened":5,"state":"agreed","rows":"uav1 perceive"}
{"at":10,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"perceive","blocks":"b10"}
{"at":20,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"perceive","blocks":"b10 b12"}
{"at":30,"node":"uav1","kind":"scm","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","scm":"mcs2","state":"violated","place":"P1","relation":"<","measured":61.5,"required":50}
{"at":30,"node":"sim","kind":"telemetry","uav":"uav1","position":[30,0,20],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":31,"node":"uav1","kind":"place","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","parameter":"pl15","by":"valid-position","position":[25,10,20],"scms":"mcs1 mcs2"}
{"at":34,"node":"sim","kind":"telemetry","uav":"uav1","position":[34,0,20],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":35,"node":"uav1","kind":"scm","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","scm":"mcs2","state":"satisfied"}
{"at":36,"node":"uav1","kind":"negotiation","uav":"uav1","joint":"map(Z) of uav1, uav2/area-sharing","modality":"area-sharing","opener":"uav1","opened":35.5,"state":"agreed","rows":"uav1 0 0 10 0 10 10, uav2"}
{"at":36.1,"node":"uav2","kind":"negotiation","uav":"uav2","joint":"map(Z) of uav1, uav2/area-sharing","modality":"area-sharing","opener":"uav1","opened":35.5,"state":"agreed","rows":"uav1 0 0 10 0 10 10, uav2"}
{"at":40,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"aborted","role":"perceive","why":"no contact"}
)";

class JointView : public ::testing::Test {
 protected:
  JointView() : read_(salvage(kLog)), story_(tell({}, read_.journal)) {
    EXPECT_TRUE(read_.errors.empty());
  }
  JointTasks told() const { return tell_joint_tasks(read_.journal, story_); }
  std::string written(void (*write)(Markup&, const skein::report::Run&)) const {
    const Statistics figures = measure(story_, read_.journal);
    const Deliberation plans = tell_deliberation(read_.journal);
    const RunInfo info{};
    Markup out;
    write(out, skein::report::Run{info, read_.journal, story_, figures, plans});
    return out.take();
  }

  SalvagedJournal read_;
  Chronology story_;
};

TEST_F(JointView, AJointTaskIsItsPhasesWithRoleAndBlocks) {
  const std::vector<JointStory> stories = told().stories;

  ASSERT_EQ(stories.size(), 1U);
  ASSERT_EQ(stories[0].segments.size(), 3U);
  EXPECT_EQ(stories[0].segments[0].phase, "loading");
  EXPECT_EQ(stories[0].segments[0].span, (Span{5, 10}));
  EXPECT_EQ(stories[0].segments[2].blocks, "b10 b12");
  EXPECT_EQ(stories[0].segments[2].span, (Span{20, 40}));
  EXPECT_EQ(stories[0].end, "aborted");
  EXPECT_EQ(stories[0].why, "no contact");
}

TEST(JointTimeline, ATaskOfARoleIsNamedAsItsModelNamesIt) {
  const std::string page = testing::page_of_timeline(
      std::string(testing::kFlight) +
      R"({"at":10,"node":"uav1","kind":"role-task","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","componel":"t14","block":"b15","task":500047000,"of":2,"type":"goto"}
{"at":10,"node":"uav1","kind":"task","uav":"uav1","task":500047000,"type":"goto","state":"running"}
{"at":60,"node":"uav1","kind":"task","uav":"uav1","task":500047000,"type":"goto","state":"ended"}
)");

  EXPECT_EQ(count(page, ">t14 goto<"), 1U);
  EXPECT_EQ(count(page, "uav1: task t14 goto (500047000)"), 1U);
}

TEST_F(JointView, AViolationLastsUntilTheConstraintHoldsAgain) {
  const std::vector<ViolationStory> violations = told().violations;

  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].span, (Span{30, 35}));
  EXPECT_EQ(violations[0].what, "to P1 61.5, required < 50");
}

TEST(JointStory, AViolationEndsWithWhatWatchesIt) {
  const auto read = salvage(
      R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":10,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"perceive","blocks":"b12"}
{"at":30,"node":"uav1","kind":"scm","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","scm":"mcs2","state":"violated","place":"P1","relation":"<","measured":61.5,"required":50}
{"at":31,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"perceive","blocks":"b12 b13","violated":"mcs2"}
{"at":32,"node":"uav1","kind":"joint","uav":"uav1","joint":"map(Z) of uav1, uav2","task":3,"model":"watch","variant":"v1","phase":"loading"}
{"at":33,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"relay","blocks":"b20"}
{"at":90,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"ended","role":"relay"}
)");
  const auto violations = tell_joint_tasks(read.journal, tell({}, read.journal)).violations;

  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].span, (Span{30, 33})) << "the new role does not watch mcs2";
}

TEST(JointStory, AViolationEndsWithTheJointTaskEvenIfThatStillNamesIt) {
  const auto read = salvage(
      R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":10,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"running","role":"perceive","blocks":"b12"}
{"at":30,"node":"uav1","kind":"scm","uav":"uav1","joint":"watch(P1) of uav1, uav2","role":"perceive","scm":"mcs1","state":"violated","place":"uav2","relation":">","measured":18,"required":20}
{"at":33,"node":"uav1","kind":"joint","uav":"uav1","joint":"watch(P1) of uav1, uav2","task":2,"model":"watch","variant":"v1","phase":"ended","role":"perceive","violated":"mcs1"}
{"at":90,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
)");
  const auto violations = tell_joint_tasks(read.journal, tell({}, read.journal)).violations;

  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].span, (Span{30, 33}));
}

TEST_F(JointView, ASessionHasItsMembersStepsAndMessages) {
  const std::vector<SessionStory> sessions = told().sessions;

  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[0].members, (std::vector<std::string>{"uav1", "uav2"}));
  EXPECT_EQ(sessions[0].steps.size(), 2U);
  ASSERT_EQ(sessions[0].messages.size(), 2U);
  EXPECT_EQ(sessions[0].messages[0].received, 5.2);
  EXPECT_FALSE(sessions[0].messages[1].received);
}

// Two sessions at one time, and an echo after the end of one.
TEST(JointStory, AMessageBelongsToTheSessionThatItNames) {
  const auto read = salvage(
      R"({"at":5,"node":"uav1","kind":"negotiation","uav":"uav1","joint":"watch/roles","modality":"role-allocation","opener":"uav1","opened":5,"state":"offered","rows":"perceive 3"}
{"at":5,"node":"uav2","kind":"negotiation","uav":"uav2","joint":"watch/roles","modality":"role-allocation","opener":"uav2","opened":5,"state":"offered","rows":"perceive 4"}
{"at":5,"node":"uav1","kind":"message","slot":"NegotiationMessage","from":"uav1","to":"uav2","sequence":1,"direction":"sent","subject":"watch/roles","opener":"uav1","opened":5}
{"at":5,"node":"uav2","kind":"message","slot":"NegotiationMessage","from":"uav2","to":"uav1","sequence":1,"direction":"sent","subject":"watch/roles","opener":"uav2","opened":5}
{"at":5.2,"node":"uav2","kind":"message","slot":"NegotiationMessage","from":"uav1","to":"uav2","sequence":1,"direction":"received","subject":"watch/roles","opener":"uav1","opened":5}
{"at":6,"node":"uav2","kind":"negotiation","uav":"uav2","joint":"watch/roles","modality":"role-allocation","opener":"uav1","opened":5,"state":"agreed","rows":"uav1 perceive"}
{"at":6.5,"node":"uav2","kind":"message","slot":"NegotiationMessage","from":"uav2","to":"uav1","sequence":2,"direction":"sent","subject":"watch/roles","opener":"uav1","opened":5}
)");
  ASSERT_TRUE(read.errors.empty());

  const auto sessions = tell_joint_tasks(read.journal, tell({}, read.journal)).sessions;

  ASSERT_EQ(sessions.size(), 2U);
  ASSERT_EQ(sessions[0].messages.size(), 2U);
  EXPECT_EQ(sessions[0].messages[0].from, "uav1");
  EXPECT_EQ(sessions[0].messages[0].received, 5.2);
  EXPECT_EQ(sessions[0].messages[1].sent, 6.5);
  ASSERT_EQ(sessions[1].messages.size(), 1U);
  EXPECT_EQ(sessions[1].messages[0].from, "uav2");
  EXPECT_EQ(sessions[1].members, (std::vector<std::string>{"uav1", "uav2"}));
}

TEST_F(JointView, TheTimelineShowsRolesBlocksAndViolations) {
  const std::string page = written(write_timeline);

  EXPECT_EQ(count(page, "Joint tasks"), 1U);
  EXPECT_EQ(count(page, "class=\"joint-running\""), 1U);
  EXPECT_EQ(count(page, "joint-block"), 2U);
  EXPECT_EQ(count(page, "class=\"violated\""), 1U);
  EXPECT_EQ(count(page, "aborted: no contact"), 1U);
}

TEST_F(JointView, ANegotiationIsASequenceDiagramWithWhatWasLost) {
  const std::string page = written(write_negotiations);

  EXPECT_EQ(count(page, "<svg class=\"sequence\""), 2U);
  EXPECT_EQ(count(page, "class=\"life\""), 4U);
  EXPECT_EQ(count(page, "class=\"message\""), 1U);
  EXPECT_EQ(count(page, "class=\"message cut\""), 1U);
  EXPECT_EQ(count(page, "agreed: uav1 perceive"), 2U);  // as text, and when it is pointed at
}

TEST_F(JointView, PlacesOfRolesAreToldWithTheirConstraints) {
  const std::vector<RolePlaceStory> places = told().places;

  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].parameter, "pl15");
  EXPECT_EQ(places[0].scms, "mcs1 mcs2");
  EXPECT_EQ(places[0].position.y, 10);
}

TEST_F(JointView, ASharedAreaIsToldOnceWhoeverTellsIt) {
  const std::vector<PartStory> parts = told().parts;

  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].uav, "uav1");
  EXPECT_EQ(parts[0].corners.size(), 3U);
}

TEST_F(JointView, TheMapShowsPartsPlacesAndWhereAConstraintWasViolated) {
  const std::string map = written([](Markup& out, const skein::report::Run& run) {
    write_joint_map(out, run, MapFrame{{-100, -100, 100, 100}, 400, 400, 2});
  });

  EXPECT_EQ(count(map, "class=\"part u0\""), 1U);
  EXPECT_EQ(count(map, "class=\"role-place u0\""), 1U);
  EXPECT_EQ(count(map, "under mcs1 mcs2"), 1U);
  // From (30, 0) to (34, 0) at two pixels a metre.
  EXPECT_EQ(count(map, "class=\"violated-stretch\" d=\"M260 200L268 200"), 1U) << map;
}

TEST_F(JointView, TheLegendOfTheMapSaysWhatIsDrawnOfJointTasks) {
  const std::string legend = written(write_map_legend);

  EXPECT_EQ(count(legend, "constraint violated"), 1U);
  EXPECT_EQ(count(legend, "place of a role"), 1U);
  EXPECT_EQ(count(legend, "part of a shared area"), 1U);
}

TEST_F(JointView, WithoutJointTasksThereIsNothing) {
  read_ = salvage("");
  story_ = tell({}, read_.journal);

  EXPECT_EQ(written(write_negotiations), "");
  EXPECT_EQ(count(written(write_timeline), "Joint tasks"), 0U);
}

}  // namespace
}  // namespace skein::report
