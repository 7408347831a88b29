// SPDX-License-Identifier: Apache-2.0
#include "team/team.hpp"

#include <algorithm>

#include "core.hpp"
#include "skein/mission/degree.hpp"
#include "skein/supervisor/visit.hpp"
#include "skein/team/global_mission.hpp"
#include "team/team_craft.hpp"

namespace skein::decision_node {

namespace {

using auction::Stage;

/// Beyond what operators number their missions with; within a life of the node.
constexpr std::uint64_t kFirstMission = 1'000'000'000;
/// A task that comes back to the UAV is another goal.
constexpr std::uint64_t kNextAttempt = 10'000'000'000;
/// In the air without anything to do before it goes home; with a task that nobody resumes before it
/// puts that back.
constexpr Duration kRest = Duration::milliseconds(10'000);

/// Who stands still is taken to fly so many times more slowly than it would.
constexpr double kMostSlowly = 10;

std::string why_aside(int degree) {
  if (mission::allocates(degree)) return "it has carried out its contact-loss policy";
  return "degree " + std::to_string(degree);
}

/// Of what is planned for a goal: the ends of the last of it. None: nothing is.
std::optional<mission::TaskDates> dates_of(const mission::PlanReport& report,
                                           mission::GoalId goal) {
  std::optional<mission::TaskDates> last;
  for (const mission::PlannedTask& planned : report.tasks) {
    if (planned.task.origin != goal) continue;
    if (!last) last = planned.dates;
    last->earliest_end = std::max(last->earliest_end, planned.dates.earliest_end);
    last->latest_end = std::max(last->latest_end, planned.dates.latest_end);
  }
  return last;
}

bool is_to_be_done_by(auction::MemberNumber uav, const auction::LedgerEntry& entry) {
  const bool open = entry.stage == Stage::kOwned || entry.stage == Stage::kGranted;
  return open && std::ranges::count(entry.owners, uav) > 0;
}

}  // namespace

Team::Team(Core& core) : core_(core) {
  const Config& config = core.config();
  if (!config.team || config.knowledge == nullptr) return;
  auction::TeamSetup setup = setup_of(*config.team, config.uav);
  setup.craft = [this](const auto& catalogue, MissionTime since) {
    return craft_for(catalogue->lot(), since);
  };
  member_.emplace(std::move(setup));
}

void Team::start() {
  if (!member_) return;
  bids_ = false;
  give(auction::Bids{false});
}

// ---- what comes in ----

void Team::hear(const TeamTold& told) {
  if (!member_) return;
  const auto from = core_.config().team->roster.number_of(told.from);
  if (from) give(auction::Heard{*from, told.message});
}

void Team::contact(const Contact& contact) {
  if (contact.reachable) {
    out_of_reach_.erase(contact.peer);
  } else {
    out_of_reach_.insert(contact.peer);
  }
  if (member_) see_whether_apart();
}

void Team::see_whether_apart() {
  const team::Roster& roster = core_.config().team->roster;
  std::set<auction::MemberNumber> reached;
  for (const std::string& name : roster.names())
    if (!out_of_reach_.contains(name)) reached.insert(*roster.number_of(name));
  if (member_->are_most(reached)) {
    apart_since_.reset();
  } else if (!apart_since_) {
    apart_since_ = core_.bus().now();
  }
}

void Team::detours_planned(const DetoursPlanned& done) {
  if (!member_) return;
  detours_.planned(done);
  give(auction::Tick{});
}

void Team::time_passes() {
  if (!member_) return;
  if (bids_until_ && core_.bus().now() >= *bids_until_) bids_until_.reset();
  give(auction::Tick{});
}

std::optional<MissionTime> Team::next_wakeup() const {
  if (!member_) return std::nullopt;
  const auto home = idle_since_ ? std::optional(*idle_since_ + kRest) : std::nullopt;
  const auto left = left_since_ ? std::optional(*left_since_ + kRest) : std::nullopt;
  const auto late = job_ && bids_ && !job_->handed_over ? lateness_.due() : std::nullopt;
  const bool hopes = apart_since_ && telemetry_.state.airborne && !idle_since_;
  const auto out = hopes && may_be_given_work() ? left_out_at() : std::nullopt;
  const auto sooner = earliest(bids_until_, earliest(late, out));
  return earliest(member_->next_wakeup(), earliest(sooner, earliest(home, left)));
}

void Team::mission_answered(mission::MissionId mission, bool accepted, const std::string& why) {
  if (job_ && job_->mission == mission && !accepted) put_back(why, true);
}

void Team::goal_changed(const mission::GoalStatus& status) {
  if (!job_ || job_->goal != status.id) return;
  job_->handed_over = status.state == mission::GoalState::kHandedOver;
  switch (status.state) {
    case mission::GoalState::kUnderWay:
      job_->begun = true;
      return;
    case mission::GoalState::kAchieved: {
      note("done", "");
      const auction::TaskNumber task = job_->claim.task;
      job_.reset();
      return give(auction::TaskDone{task});
    }
    case mission::GoalState::kFailed:
      return put_back(status.why, true);
    case mission::GoalState::kCancelled:
      if (!job_->withdrawn.empty()) return put_back(std::string(job_->withdrawn), false);
      return put_back(status.why.empty() ? "cancelled" : status.why, true);
    case mission::GoalState::kHandedOver:
      if (job_->begun) note("kept", "begun: the operator decides");
      return;
    default:
      return;
  }
}

// ---- what it does of its own ----

void Team::settle() {
  if (!member_) return;
  const bool bids = mission::allocates(core_.degree()) && core_.deliberation().engaged();
  if (bids != bids_) {
    bids_ = bids;
    give(auction::Bids{bids});
    // What has begun ends, or stays in the hands of the operator.
    if (!bids && job_ && !job_->begun) withdraw(why_aside(core_.degree()));
  }
  if (!bids_) put_back_what_waits(why_aside(core_.degree()));
  look_at_the_time();
  look_at_what_was_handed_over();
  if (!is_idle()) {
    idle_since_.reset();
  } else if (!idle_since_) {
    idle_since_ = core_.bus().now();
  } else if (core_.bus().now() >= *idle_since_ + kRest) {
    go_home();
  }
}

void Team::withdraw(const std::string& why) {
  job_->withdrawn = why;
  core_.deliberation().cancel_for_team(job_->goal,
                                       core_.config().uav + " itself, for the team: " + why);
}

// Its degree stayed, or is 5 again, and it does not go on with it: it has carried out its
// contact-loss policy, or was not to resume. Below degree 5 the operator decides.
void Team::look_at_what_was_handed_over() {
  const bool left = job_ && job_->handed_over && mission::allocates(core_.degree());
  if (!left) return left_since_.reset();
  if (!left_since_) left_since_ = core_.bus().now();
  if (core_.bus().now() < *left_since_ + kRest || !job_->withdrawn.empty()) return;
  withdraw(bids_ ? "it was not to resume it" : why_aside(core_.degree()));
}

// Of what it has not begun another may do some sooner; the sale says whether.
void Team::look_at_the_time() {
  if (!bids_ || !job_ || job_->handed_over) return;
  if (const auto dates = dates_of(core_.deliberation().report(), job_->goal))
    lateness_.planned(dates->earliest_end, dates->latest_end);
  const MissionTime now = core_.bus().now();
  const auto behind = lateness_.behind(now);
  if (!behind) return;
  lateness_.renew(now);
  put_back_what_waits("it is " + to_text(*behind) + " s behind with task " +
                      to_text(job_->claim.task));
}

void Team::put_back_what_waits(const std::string& why) {
  const auto self = core_.config().team->roster.number_of(core_.config().uav);
  std::vector<auction::TaskNumber> waiting;
  for (const auto& [task, entry] : member_->ledger().entries) {
    if (!is_to_be_done_by(*self, entry) || member_->has_ended({task, entry.sale})) continue;
    if (!job_ || job_->claim.task != task) waiting.push_back(task);
  }
  for (const auction::TaskNumber task : waiting) give(auction::TaskPutBack{task, why});
}

bool Team::is_idle() const {
  if (!bids_ || job_ || !telemetry_.state.airborne || may_be_given_work()) return false;
  const auto& goals = core_.deliberation().report().goals;
  return std::all_of(goals.begin(), goals.end(),
                     [](const auto& goal) { return is_settled(goal.state); });
}

std::optional<MissionTime> Team::left_out_at() const {
  return apart_since_ ? std::optional(*apart_since_ + core_.config().contact_after) : std::nullopt;
}

bool Team::is_left_out() const {
  const auto at = left_out_at();
  return at && core_.bus().now() >= *at;
}

// By what it knows of the book, for as long as there may be a word of it.
bool Team::may_be_given_work() const {
  if (is_left_out()) return false;
  const auto self = core_.config().team->roster.number_of(core_.config().uav);
  const auto& entries = member_->ledger().entries;
  return std::any_of(entries.begin(), entries.end(), [&](const auto& each) {
    return each.second.stage == Stage::kForSale || is_to_be_done_by(*self, each.second);
  });
}

void Team::go_home() {
  idle_since_.reset();
  const std::string land(supervisor::kComeDown);
  if (!core_.config().knowledge->vocabulary.tasks.contains(land)) return;
  mission::UnitMission mission;
  mission.id = next_mission();
  mission.tasks.push_back({mission::GoalId(mission.id.value()), land, {}, {}});
  mission.asked_by =
      core_.config().uav + (is_left_out() ? " itself: most of the team are out of reach since " +
                                                to_text(*apart_since_) + " s"
                                          : " itself: the team has nothing for it");
  core_.deliberation().take_for_team(mission);
}

// ---- what the team asks for ----

void Team::give(auction::TeamInput input) {
  core_.bus().post([this, input = std::move(input)] {
    for (const auction::TeamEffect& effect : member_->handle(input, core_.bus().now())) {
      std::visit([this](const auto& one) { carry_out(one); }, effect);
    }
    see_whether_apart();  // somebody may have been declared lost
  });
}

void Team::carry_out(const auction::Tell& effect) {
  std::string to = core_.config().team->roster.name_of(effect.to);
  if (out_of_reach_.contains(to)) return;
  core_.bus().emit(SendTeam{std::move(to), effect.message});
}

// A sensor may have failed since it bid. Empty: it does.
std::string Team::why_not_begin(const team::Order* order) const {
  if (order == nullptr) return "it was not told what that is";
  if (!bids_) return why_aside(core_.degree());
  return lacks_now(order->needs, core_.config().knowledge->vehicle, telemetry_);
}

void Team::carry_out(const auction::BeginTask& effect) {
  const auto entry = member_->ledger().entries.find(effect.claim.task);
  const team::Order* order =
      entry == member_->ledger().entries.end() ? nullptr : team::order_of(entry->second.task);
  const std::string why = why_not_begin(order);
  if (why.empty()) return begin(effect.claim, *order);
  give(auction::TaskPutBack{effect.claim.task, why});
}

void Team::begin(const auction::Claim& claim, const team::Order& order) {
  const std::uint64_t attempt = attempts_[claim.task]++;
  std::vector<std::string> members;
  for (const auction::MemberNumber owner : member_->ledger().entries.at(claim.task).owners)
    members.push_back(core_.config().team->roster.name_of(owner));
  mission::UnitMission mission;
  mission.id = next_mission();
  const auction::Task& sold = member_->ledger().entries.at(claim.task).task;
  mission.tasks = {team::for_members(team::in_time(order.task, sold), members)};
  mission::HighLevelTask& task = mission.tasks.front();
  task.id = mission::GoalId(claim.task.value() + attempt * kNextAttempt);
  mission.asked_by = order.asked_by + ", by the team";
  lateness_.begun();
  job_ = Job{claim, task.id, mission.id, to_text(task), false, {}, false};
  note("begun", "");
  core_.deliberation().take_for_team(mission);
}

void Team::carry_out(const auction::TokenTaken& effect) {
  core_.bus().emit(TokenNoted{true, effect.term});
}

void Team::carry_out(const auction::TokenLost&) { core_.bus().emit(TokenNoted{false, 0}); }

void Team::carry_out(const auction::SaleTold& effect) { core_.bus().emit(SaleNoted{effect.what}); }

void Team::carry_out(const auction::Offered& effect) {
  const auction::Offer& offer = effect.offer;
  for (const auction::ItemPrice& price : offer.items) {
    BidNoted bid{{price.item, offer.sale.value()}, std::nullopt, price.objection};
    for (const auction::GapPrice& gap : price.gaps) {
      const double added = gap.in.seconds + gap.out.seconds - offer.legs[gap.gap].seconds;
      if (!bid.added || added < *bid.added) bid.added = added;
    }
    core_.bus().emit(std::move(bid));
  }
}

// ---- ends ----

void Team::put_back(const std::string& why, bool failed) {
  const auction::TaskNumber task = job_->claim.task;
  if (failed) failed_[task] = why;
  note("put-back", why);
  job_.reset();
  give(auction::TaskPutBack{task, why});
}

void Team::note(const std::string& state, const std::string& why) {
  core_.bus().emit(TeamTaskNoted{job_->claim, state, job_->goal, job_->statement, why});
}

mission::MissionId Team::next_mission() { return mission::MissionId(kFirstMission + ++missions_); }

// ---- what bids are made of ----

// With some of the team: who they will be the sale says.
mission::HighLevelTask Team::as_bid_for(const mission::HighLevelTask& task,
                                        std::uint32_t members) const {
  std::vector<std::string> some = {core_.config().uav};
  for (const std::string& uav : core_.config().knowledge->team)
    if (uav != some.front() && some.size() < members) some.push_back(uav);
  return team::for_members(task, some);
}

// None: the ways around what straight flights go through are not known yet, and are waited for.
std::unique_ptr<const auction::Craft> Team::craft_for(const auction::Lot& lot, MissionTime since) {
  Vantage at = vantage();
  detours_.want(at, lot);
  bids_until_.reset();
  if (!detours_.complete() && core_.bus().now() < since + TeamDetours::kPatience) {
    bids_until_ = since + TeamDetours::kPatience;
    if (auto job = detours_.next_job(at)) core_.bus().emit(std::move(*job));
    return nullptr;
  }
  at.detours = detours_.known();
  return std::make_unique<const TeamCraft>(std::move(at));
}

Vantage Team::vantage() {
  Vantage vantage;
  vantage.knowledge = core_.config().knowledge;
  vantage.world = core_.deliberation().world();
  vantage.telemetry = telemetry_;
  vantage.now = core_.bus().now();
  vantage.failed = failed_;
  if (visited_ != vantage.world) visits_.clear();
  visited_ = vantage.world;
  for (const auto& [number, entry] : member_->ledger().entries) {
    const team::Order* order = team::order_of(entry.task);
    if (order == nullptr) continue;
    const mission::HighLevelTask task = as_bid_for(order->task, entry.task.least_members);
    vantage.tasks.emplace(number, task);
    if (!order->needs.empty()) vantage.needs.emplace(number, order->needs);
    if (visits_.contains(number)) continue;
    const auto gates = supervisor::visits_of(task, vantage.knowledge, vantage.world, vantage.now);
    visits_[number] = gates.empty() ? std::nullopt : std::optional(gates.front());
  }
  vantage.visits = visits_;
  const mission::PlanReport& report = core_.deliberation().report();
  // A later ledger may be without the task that is under way: then it is work of the UAV's own.
  const auto& entries = member_->ledger().entries;
  const auto job = job_ ? entries.find(job_->claim.task) : entries.end();
  const bool is_the_teams = job != entries.end();
  if (const auto dates = is_the_teams ? dates_of(report, job_->goal) : std::nullopt) {
    const double lasts = job->second.task.duration;
    const Duration left = dates->earliest_end - vantage.now - Duration::seconds(lasts);
    const double cruise = vantage.knowledge->vehicle.cruise_speed;
    const double speed = std::max(telemetry_.state.velocity.norm(), cruise / kMostSlowly);
    vantage.begun = Vantage::Begun{job_->claim.task, std::max(left, Duration()),
                                   lateness_.told() ? std::max(1.0, cruise / speed) : 1};
  }
  for (const mission::PlannedTask& planned : report.tasks) {
    if (is_the_teams && planned.task.origin == job_->goal) continue;
    const Duration left = planned.dates.earliest_end - vantage.now;
    vantage.busy = std::max(vantage.busy, left);
  }
  return vantage;
}

}  // namespace skein::decision_node
