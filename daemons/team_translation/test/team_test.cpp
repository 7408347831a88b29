// SPDX-License-Identifier: Apache-2.0
// What a team says crosses the wire, and what makes no sense does not.
#include "skein/team_translation/team.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "skein/team/global_mission.hpp"

namespace skein::translation {
namespace {

using namespace auction;

// One of each form.
interaction::Requirements some_needs() {
  using interaction::Requirement;
  interaction::Requirements needs{{"hovering", {}}, {"camera", "ir"}};
  for (int relation = 0; relation <= static_cast<int>(interaction::Relation::kGreater); ++relation)
    needs.push_back({"payload", Requirement::Bound{interaction::Relation(relation), 2.5}});
  return needs;
}

Task task(std::uint32_t number) {
  Task one;
  one.number = TaskNumber(number);
  one.duration = 20;
  one.needs = 5;
  one.least_members = 2;
  one.earliest = 3;
  one.at = {1, 2};
  one.pinned = MemberNumber(1);
  one.forbidden = {MemberNumber(2)};
  one.repeatable = true;
  mission::HighLevelTask work;
  work.id = mission::GoalId(number);
  work.name = "look";
  work.arguments = {std::string("P1"), 20.0};
  one.work = std::make_shared<const team::Order>(work, "operator", some_needs());
  return one;
}

// What crossed, whichever of the two slots it takes.
template <class Message>
Message crossed(const Message& message) {
  const wire::Sample sample = to_wire(TeamMessage(message));
  EXPECT_EQ(wire::find_violation(sample), std::nullopt);
  const auto* about = std::get_if<wire::TeamMessage>(&sample);
  const auto read =
      about != nullptr ? from_wire(*about) : from_wire(std::get<wire::TeamSale>(sample));
  EXPECT_TRUE(read.has_value());
  return std::get<Message>(read.value());
}

void expect_same(const Task& one, const Task& other) {
  EXPECT_EQ(one.number, other.number);
  EXPECT_EQ(one.duration, other.duration);
  EXPECT_EQ(one.needs, other.needs);
  EXPECT_EQ(one.least_members, other.least_members);
  EXPECT_EQ(one.earliest, other.earliest);
  EXPECT_EQ(one.deadline, other.deadline);
  EXPECT_EQ(one.at, other.at);
  EXPECT_EQ(one.pinned, other.pinned);
  EXPECT_EQ(one.forbidden, other.forbidden);
  EXPECT_EQ(one.repeatable, other.repeatable);
}

std::shared_ptr<const Ledger> ledger() {
  auto book = std::make_shared<Ledger>();
  book->term = 3;
  book->revision = 9;
  book->missions = {MissionNumber(1)};
  LedgerEntry& entry = book->entries[TaskNumber(11)];
  entry.task = task(11);
  entry.stage = Stage::kGranted;
  entry.owners = {MemberNumber(0), MemberNumber(1)};
  entry.sale = std::uint64_t{1} << 40U;
  entry.finished = {MemberNumber(1)};
  entry.stopped = {MemberNumber(0)};
  entry.revision = 8;
  entry.why = "sold to marvin for 12 s";
  book->precedences = {{TaskNumber(11), TaskNumber(12)}};
  book->routes[MemberNumber(1)] = {TaskNumber(11)};
  book->losses.declare(MemberNumber(4), true);
  book->losses.declare(MemberNumber(5), true);
  book->losses.declare(MemberNumber(5), false);
  return book;
}

TEST(Team, ALedgerCrossesTheWireWithTheWorkOfItsTasks) {
  const std::shared_ptr<const Ledger> truth = ledger();
  const Beat beat = crossed(Beat{3, 7, truth});

  EXPECT_EQ(beat.term, 3U);
  EXPECT_EQ(beat.committed, 7U);
  ASSERT_NE(beat.ledger, nullptr);
  const Ledger& book = *beat.ledger;
  EXPECT_EQ(book.missions, truth->missions);
  EXPECT_EQ(book.precedences, truth->precedences);
  EXPECT_EQ(book.routes, truth->routes);
  EXPECT_EQ(book.losses, truth->losses);
  const LedgerEntry &read = book.entries.at(TaskNumber(11)),
                    &said = truth->entries.at(TaskNumber(11));
  expect_same(read.task, said.task);
  EXPECT_EQ(team::order_of(read.task)->task, team::order_of(said.task)->task);
  EXPECT_EQ(team::order_of(read.task)->asked_by, "operator");
  EXPECT_EQ(team::order_of(read.task)->needs, some_needs());
  EXPECT_EQ(read.stage, said.stage);
  EXPECT_EQ(read.owners, said.owners);
  EXPECT_EQ(read.sale, said.sale);
  EXPECT_EQ(read.finished, said.finished);
  EXPECT_EQ(read.stopped, said.stopped);
  EXPECT_EQ(read.revision, said.revision);
  EXPECT_EQ(read.why, said.why);
}

// What is to be done says itself how long after others it begins.
TEST(Team, DelaysCrossTheWireInALedgerAndInAMission) {
  Task then = task(12);
  mission::HighLevelTask order = team::order_of(then)->task;
  order.after = {{mission::GoalId(11), false, Duration::seconds(60), Duration::seconds(300)}};
  then.work = std::make_shared<const team::Order>(order, "operator");
  const Precedence delayed{TaskNumber(11), TaskNumber(12),
                           team::delay_after(TaskNumber(11), order)};
  ASSERT_TRUE(delayed.delay.bounds_above());
  Ledger book = *ledger();
  book.entries[TaskNumber(12)].task = then;
  book.precedences = {delayed};
  Status status;
  status.missions = {{MissionNumber(8), {{task(11), then}, {delayed}}}};

  EXPECT_EQ(crossed(Beat{3, 7, std::make_shared<const Ledger>(book)}).ledger->precedences,
            book.precedences);
  EXPECT_EQ(crossed(status).missions.at(0).lot.precedences, book.precedences);
}

TEST(Team, ABeatToOneThatHasTheLedgerIsWithoutIt) {
  EXPECT_EQ(crossed(Beat{3, 7, nullptr}).ledger, nullptr);
}

TEST(Team, AStatusCrossesTheWire) {
  Status status;
  status.term = 4;
  status.revision = 6;
  status.bids = false;
  status.wants = {{TaskNumber(1), 2}};
  status.done = {{{TaskNumber(3), 4}, MissionTime::seconds(71.5)}};
  status.stopped = {{TaskNumber(5), 6}};
  status.stopped_why = {"no way"};
  status.missions = {{MissionNumber(8), {{task(21)}, {{TaskNumber(21), TaskNumber(22)}}}}};
  status.losses.declare(MemberNumber(2), true);

  const Status read = crossed(status);

  EXPECT_EQ(read.term, 4U);
  EXPECT_EQ(read.revision, 6U);
  EXPECT_FALSE(read.bids);
  EXPECT_EQ(read.wants, status.wants);
  EXPECT_EQ(read.done, status.done);
  EXPECT_EQ(read.stopped, status.stopped);
  EXPECT_EQ(read.stopped_why, status.stopped_why);
  ASSERT_EQ(read.missions.size(), 1U);
  EXPECT_EQ(read.missions[0].number, MissionNumber(8));
  expect_same(read.missions[0].lot.tasks.at(0), task(21));
  EXPECT_EQ(read.missions[0].lot.precedences, status.missions[0].lot.precedences);
  EXPECT_EQ(read.losses, status.losses);
}

TEST(Team, VotesCrossTheWire) {
  const VoteRequest request = crossed(VoteRequest{5, true, 3, 9});
  EXPECT_EQ(request.term, 5U);
  EXPECT_TRUE(request.trial);
  EXPECT_EQ(request.ledger_term, 3U);
  EXPECT_EQ(request.ledger_revision, 9U);
  EXPECT_EQ(crossed(Vote{5, true}).term, 5U);
  EXPECT_TRUE(crossed(Vote{5, true}).trial);
  EXPECT_EQ(crossed(NewerTerm{6}).term, 6U);
}

TEST(Team, ACallCrossesTheWireWithoutTheWorkThatTheLedgerHas) {
  const auto lot = std::make_shared<const Catalogue>(
      Lot{{task(11), task(12)}, {{TaskNumber(11), TaskNumber(12)}}});

  const auto read = std::get<Call>(crossed(
      ToMember(Call{SaleNumber(7), 2, lot, {TaskNumber(11)}, 1, {TaskNumber(12)}, 3, true})));

  EXPECT_EQ(read.sale, SaleNumber(7));
  EXPECT_EQ(read.round, 2U);
  expect_same(read.lot->task(TaskNumber(12)), task(12));
  EXPECT_EQ(read.lot->task(TaskNumber(12)).work, nullptr);
  EXPECT_EQ(read.lot->lot().precedences, lot->lot().precedences);
  EXPECT_EQ(read.route, std::vector{TaskNumber(11)});
  EXPECT_EQ(read.fixed, 1U);
  EXPECT_EQ(read.items, std::vector{TaskNumber(12)});
  EXPECT_EQ(read.gaps, 3U);
  EXPECT_TRUE(read.between);
}

TEST(Team, AnAwardCrossesTheWire) {
  const auto lot = std::make_shared<const Catalogue>(Lot{{task(11)}, {}});

  const auto read =
      std::get<Award>(crossed(ToMember(Award{SaleNumber(7), 2, lot, {TaskNumber(11)}})));

  EXPECT_EQ(read.route, std::vector{TaskNumber(11)});
}

TEST(Team, AnOfferCrossesTheWireEvenWithEnergyWithoutBound) {
  Offer offer;
  offer.sale = SaleNumber(7);
  offer.round = 2;
  offer.abilities = 9;
  offer.free_from = 4;
  offer.energy = std::numeric_limits<double>::infinity();
  offer.legs = {{1, 2, 3}};
  offer.items = {{TaskNumber(11), 5, {{0, {1, 1, 1}, {2, 2, 2}}}, "no"}};
  offer.between = {kNoWay};

  const auto read = std::get<Offer>(crossed(ToAuctioneer(offer)));

  EXPECT_EQ(read.energy, offer.energy);
  EXPECT_EQ(read.abilities, 9U);
  EXPECT_EQ(read.legs.at(0).energy, 3);
  EXPECT_EQ(read.items.at(0).item, TaskNumber(11));
  EXPECT_EQ(read.items.at(0).gaps.at(0).out.cost, 2);
  EXPECT_EQ(read.items.at(0).objection, "no");
  EXPECT_EQ(read.between.at(0).seconds, kNoWay.seconds);
}

TEST(Team, AnAnswerCrossesTheWireWithItsRefusal) {
  Answer answer;
  answer.sale = SaleNumber(7);
  answer.refusal = "not any more";
  answer.legs = {{1, 2, 3}};
  answer.energy = -2;

  const auto read = std::get<Answer>(crossed(ToAuctioneer(answer)));

  EXPECT_EQ(read.refusal, "not any more");
  EXPECT_EQ(read.energy, -2);
  EXPECT_EQ(read.legs.at(0).seconds, 1);
}

// ---- what makes no sense ----

wire::TeamSale call() {
  const auto lot = std::make_shared<const Catalogue>(Lot{{task(11), task(12)}, {}});
  return std::get<wire::TeamSale>(to_wire(TeamMessage(
      ToMember(Call{SaleNumber(7), 2, lot, {TaskNumber(11)}, 1, {TaskNumber(12)}, 0, false}))));
}

TEST(Team, ACallAboutTasksThatAreNotInItsLotIsRefused) {
  wire::TeamSale unknown = call();
  unknown.items = {99};
  wire::TeamSale twice = call();
  twice.items = {11};
  wire::TeamSale fixed = call();
  fixed.fixed_tasks = 2;
  wire::TeamSale number = call();
  number.tasks[1].number = 11;

  EXPECT_EQ(from_wire(unknown).error().field, "items");
  EXPECT_EQ(from_wire(twice).error().field, "items");
  EXPECT_EQ(from_wire(fixed).error().field, "fixed_tasks");
  EXPECT_EQ(from_wire(number).error().field, "tasks[1].number");
}

TEST(Team, ALedgerWithATaskTwiceOrWithOrdersThatMakeNoSenseIsRefused) {
  auto sample = std::get<wire::TeamMessage>(to_wire(TeamMessage(Beat{3, 7, ledger()})));
  wire::TeamMessage twice = sample, order = sample, pinned = sample, several = sample;
  twice.ledger[0].entries.push_back(twice.ledger[0].entries[0]);
  order.ledger[0].entries[0].task.work[0].arguments[0].name = "colour";
  pinned.ledger[0].entries[0].task.pinned = {1, 2};
  several.ledger.push_back(several.ledger[0]);

  EXPECT_EQ(from_wire(twice).error().field, "ledger[0].entries[1].task.number");
  EXPECT_EQ(from_wire(order).error().field, "ledger[0].entries[0].task.work[0].arguments[0]");
  EXPECT_EQ(from_wire(pinned).error().field, "ledger[0].entries[0].task.pinned");
  EXPECT_EQ(from_wire(several).error().field, "ledger");
}

}  // namespace
}  // namespace skein::translation
