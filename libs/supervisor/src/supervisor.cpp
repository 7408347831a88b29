// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/supervisor.hpp"

#include <algorithm>
#include <utility>

#include "book/past.hpp"
#include "core.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

Supervisor::Supervisor(Config config) : core_(std::make_unique<Core>(std::move(config))) {}
Supervisor::~Supervisor() = default;
Supervisor::Supervisor(Supervisor&&) noexcept = default;
Supervisor& Supervisor::operator=(Supervisor&&) noexcept = default;

Effects Supervisor::handle(const Input& input, MissionTime now) {
  return core_->handle(input, now);
}
std::optional<MissionTime> Supervisor::next_wakeup() const { return core_->next_wakeup(); }
bool Supervisor::engaged() const { return core_->engaged(); }
const mission::PlanReport& Supervisor::report() const { return core_->report(); }
std::shared_ptr<const world::World> Supervisor::world() const { return core_->world(); }
bool Supervisor::loses_sight_of(const std::string& place, const world::Vector3& now) const {
  return core_->loses_sight_of(place, now);
}
bool Supervisor::has_given_up(executive::TaskId task) const { return core_->has_given_up(task); }
std::optional<mission::HighLevelTask> Supervisor::goal(mission::GoalId id) const {
  return core_->goal(id);
}

namespace {

/// So many numbers a second are more than are used, however often all is planned anew.
constexpr std::int64_t kNumbersInSecond = 100;

/// Of those that are settled, for reports and for what a long cut of the radio hid.
constexpr Kept kKept = {64, 16};

Config checked(Config config) {
  SKEIN_EXPECTS(config.knowledge != nullptr);
  SKEIN_EXPECTS(config.world != nullptr);
  return config;
}

}  // namespace

Supervisor::Core::Core(Config config)
    : config_(checked(std::move(config))),
      beliefs_(*config_.knowledge, config_.world),
      out_(book_),
      own_goals_(*config_.knowledge, book_, out_),
      dates_(book_, config_.grace),
      agenda_(out_),
      committer_(config_.knowledge->vehicle, config_.horizon, agenda_, dates_, out_, book_),
      contingencies_({config_.grace, config_.refinements},
                     {beliefs_, dates_, committer_, agenda_, out_, book_}),
      safe_mode_(config_.horizon, beliefs_, agenda_, committer_, out_, book_),
      air_(beliefs_, own_goals_, committer_, agenda_, out_, book_),
      energy_(beliefs_, safe_mode_, committer_, agenda_, out_, book_),
      situations_(config_.knowledge, beliefs_, book_),
      true_goals_(situations_, beliefs_, contingencies_, agenda_, out_, book_),
      results_({beliefs_, own_goals_, true_goals_, dates_, committer_, agenda_, out_, book_}),
      jobs_({situations_, beliefs_, own_goals_, committer_, results_, agenda_, out_, book_}),
      hand_over_(safe_mode_, committer_, agenda_, out_, book_),
      observer_({hand_over_, safe_mode_, contingencies_, committer_, dates_, beliefs_, agenda_,
                 out_, book_},
                config_.grace),
      requests_({beliefs_, hand_over_, contingencies_, committer_, agenda_, out_, book_}) {
  book_.next_id = config_.first_id;
}

// First what the input says, then what follows from it: contingencies, jobs, commitment, safety.
// What keeps the UAV safe while its plan is repaired is numbered before the plan that is made.
Effects Supervisor::Core::handle(const Input& input, MissionTime now) {
  out_.begin(now);
  std::visit([this](const auto& one) { on(one); }, input);
  if (engaged()) {
    hand_over_.time_passes();
    contingencies_.check_slips();
    true_goals_.settle();
    air_.watch();
    agenda_.give_way();
    if (agenda_.repair_is_due()) safe_mode_.keep();
    jobs_.start();
    committer_.commit();
    safe_mode_.keep();
  }
  if (book_.more_settled && !agenda_.job()) {
    let_go_of_the_past(book_, kKept);
    book_.more_settled = false;
  }
  tell_frontier();
  return out_.close();
}

void Supervisor::Core::tell_frontier() {
  const std::uint64_t version = engaged() ? dates_.version() : 0;
  if (version == told_version_) return;
  told_version_ = version;
  temporal::Frontier frontier =
      engaged() ? dates_.frontier(config_.tells_all) : temporal::Frontier();
  if (frontier == told_) return;
  told_ = frontier;
  out_.add(FrontierChanged{std::move(frontier)});
}

void Supervisor::Core::on(const PartnersSeen& input) {
  if (book_.meetings.of == input.meetings) return;
  book_.meetings.of = input.meetings;
  if (engaged()) contingencies_.check_meetings();
}

void Supervisor::Core::on(const OrdersSeen& input) {
  if (book_.meetings.air == input.orders) return;
  book_.meetings.air = input.orders;
  if (engaged()) contingencies_.check_meetings();
}

void Supervisor::Core::on(const LivesAgain&) {
  const std::int64_t passed = std::max<std::int64_t>(now().count(), 0);
  const auto used =
      static_cast<std::uint64_t>(passed / (Duration::seconds(1).count() / kNumbersInSecond));
  book_.next_id = std::max(book_.next_id, TaskId(config_.first_id.value() + used));
  own_goals_.number_beyond(used);
}

void Supervisor::Core::on(const Engage& input) {
  committer_.joint_tasks().begin_anew();
  hand_over_.take(input);
  air_.check(input.cause);
}

void Supervisor::Core::on(const WorldChanged& input) {
  const bool closed = requests_.change_world(input.change);
  if (closed && engaged()) air_.check(to_text(input.change));
}

void Supervisor::Core::on(const VehicleSeen& input) {
  const std::set<std::string> newly = observer_.see(input);
  if (!engaged()) return;
  if (!newly.empty()) contingencies_.check_devices(newly);
  energy_.check();
  air_.look();
}

void Supervisor::Core::on(const JointTaskAnswered& input) {
  const bool agreed = committer_.joint_tasks().answered(input);
  Entry* entry = book_.find(input.task);
  if (entry == nullptr || entry->seen.started || !entry->live()) return;
  if (!agreed) {
    // One that the executive has says so when it is due.
    if (!entry->given()) contingencies_.fail_goal(entry->task.origin, input.why);
    return;
  }
  committer_.reschedule();
  if (entry->given()) committer_.send_preconditions(*entry);
  contingencies_.absorb_or_shift("joint task " + to_text(input.task) + " agreed");
}

// What is past has been dealt with.
std::optional<MissionTime> Supervisor::Core::next_wakeup() const {
  if (!engaged()) return std::nullopt;
  std::optional<MissionTime> next;
  const auto count = [&](std::optional<MissionTime> at) {
    if (at && *at > now() && *at != MissionTime::max()) next = earliest(next, at);
  };
  count(hand_over_.next_wakeup());
  count(safe_mode_.paused_until());
  count(safe_mode_.tells_at());
  count(committer_.end_of_safe_wait());
  if (agenda_.needed()) count(agenda_.needed()->not_before);
  count(air_.next_closing());
  count(dates_.next_slip(now()));
  if (const auto goal = committer_.next_to_give()) count(committer_.due(*goal));
  return next;
}

}  // namespace skein::supervisor
