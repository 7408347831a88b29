// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/planning.hpp"

#include <algorithm>

#include "book/wording.hpp"
#include "flight/retreat.hpp"
#include "planning/domain_book.hpp"
#include "planning/partners.hpp"
#include "planning/plans.hpp"
#include "planning/problem.hpp"
#include "planning/terms.hpp"
#include "skein/htn/planner.hpp"
#include "skein/supervisor/plan_reader.hpp"
#include "skein/supervisor/planner_host.hpp"

namespace skein::supervisor {

namespace {

using mission::GoalId;

tl::unexpected<PlanningFailure> fail(std::vector<std::string> reasons) {
  return tl::unexpected<PlanningFailure>(PlanningFailure{std::nullopt, std::move(reasons)});
}

const mission::HighLevelTask* find(const PlanningRequest& request, GoalId id) {
  const auto found = std::find_if(request.tasks.begin(), request.tasks.end(),
                                  [&](const auto& one) { return one.id == id; });
  return found == request.tasks.end() ? nullptr : &*found;
}

/// The high-level task that the search came to and not beyond: its last argument is its number.
std::optional<GoalId> culprit_of(const htn::TermStore& store, const htn::Outcome& outcome) {
  if (!outcome.failure || outcome.failure->open_tasks.empty()) return std::nullopt;
  const htn::Term top = outcome.failure->open_tasks.front();
  if (!store.is_list(top) || store.items(top).size() < 2) return std::nullopt;
  const auto number = number_of(store, store.items(top).back());
  if (!number) return std::nullopt;
  return GoalId(static_cast<std::uint64_t>(*number));
}

/// Devices that would serve a use: not on board, or broken.
std::string lacking(const PlanningRequest& request, const std::string& use) {
  const Knowledge& knowledge = *request.knowledge;
  std::string broken, serving;
  for (const auto& [device, what] : knowledge.vocabulary.serves) {
    if (what != use) continue;
    serving += (serving.empty() ? "" : ", ") + device;
    if (world::find_sensor(knowledge.vehicle, device) == nullptr) continue;
    if (!request.situation.broken.contains(device)) return {};
    broken += (broken.empty() ? "" : ", ") + device;
  }
  if (!broken.empty()) return "what serves " + use + " on board does not work: " + broken;
  return "no device on board serves " + use + (serving.empty() ? "" : "; these would: " + serving);
}

/// Everything that is known of a plan that was not found.
PlanningFailure explain(const PlanningRequest& request, const htn::TermStore& store,
                        const htn::Outcome& outcome, const PlannerHost& host) {
  PlanningFailure failure{culprit_of(store, outcome), host.refusals()};
  if (outcome.verdict == htn::Verdict::kError || outcome.verdict == htn::Verdict::kLimit)
    failure.reasons.push_back("planning ended early: " + outcome.why);
  const auto* task = failure.culprit ? find(request, *failure.culprit) : nullptr;
  if (task == nullptr) return failure;
  const auto signature = request.knowledge->vocabulary.tasks.find(task->name);
  if (signature != request.knowledge->vocabulary.tasks.end())
    for (const std::string& use : signature->second.uses)
      if (std::string why = lacking(request, use); !why.empty())
        failure.reasons.push_back(std::move(why));
  if (!failure.reasons.empty()) return failure;
  failure.reasons.push_back("no way to do " + mission::to_text(*task));
  for (const htn::Attempt& attempt : outcome.failure->attempts)
    failure.reasons.push_back(store.to_text(attempt.task) + " needs " + attempt.condition);
  return failure;
}

/// The task with which the energy comes to an end; a plan that ends in the air leaves the way home.
std::optional<PlanningFailure> energy_problem(const mission::ElementaryPlan& plan,
                                              const PlanningRequest& request) {
  const Situation& situation = request.situation;
  const Retreat retreat(*request.knowledge, *request.world, situation.origin);
  const Whereabouts end = after({situation.position, situation.airborne}, plan.tasks);
  const double home = retreat.after(end);
  const double left = situation.energy - request.knowledge->vehicle.energy.reserve;
  if (plan.tasks.empty() || plan.energy + home <= left) return std::nullopt;
  double used = home;
  for (const mission::ElementaryTask& task : plan.tasks) {
    used += task.energy;
    if (used <= left) continue;
    const std::string back = home > 0 ? " and " + percent(home) + " to come home and land" : "";
    return PlanningFailure{
        task.origin,
        {"the plan needs " + percent(plan.energy) + " of the energy held when full" + back + ", " +
         percent(std::max(left, 0.0)) + " are left above the reserve: it would last up to " +
         in_words(task)}};
  }
  return std::nullopt;
}

std::vector<std::string> sentences(const Diagnostics& errors) {
  std::vector<std::string> all;
  for (const Diagnostic& one : errors.all()) all.push_back(to_text(one));
  return all;
}

constexpr std::uint64_t kRefinerSteps = 50'000'000;  // of one call; far beyond what any takes

/// The counts are far beyond what any plan takes, so that a domain that never ends does.
htn::Options search_options(const PlanningBudget& budget) {
  htn::Options options;
  options.trees = true;
  options.explain_failure = true;
  options.limits.expansions = budget.expansions;
  options.limits.inferences = budget.inferences;
  options.limits.memory_bytes = budget.memory_bytes;
  options.limits.depth = 20'000;
  return options;
}

}  // namespace

/// A domain with the desk that its functions ask. Terms of all that is planned with it are its own.
class Plans::Shelf {
 public:
  explicit Shelf(const DomainText& text) : text_(text) {
    desk_.offer(functions_);
    book_ = std::make_unique<DomainBook>(text_, functions_);
  }

  bool serves(const DomainText& text) const {
    return text_.text == text.text && text_.file == text.file;
  }
  /// Of terms [bytes].
  std::size_t memory_bytes() const { return book_->store().memory_bytes(); }
  DomainBook& book() { return *book_; }
  PlannerHost::Desk& desk() { return desk_; }

 private:
  const DomainText text_;
  PlannerHost::Desk desk_;
  htn::Functions functions_;
  std::unique_ptr<DomainBook> book_;
};

/// Planner and refiners for requests from one origin in one world.
class Plans::Workplace {
 public:
  explicit Workplace(const PlanningRequest& request)
      : world_(request.world),
        knowledge_(request.knowledge),
        origin_(request.situation.origin),
        seed_(request.seed),
        flight_(flight_of(request.situation)),
        stand_(stand_of(request.situation)),
        host_(request.knowledge, request.world, origin_, seed_,
              {[budget = request.budget] { return budget.over(); }, kRefinerSteps}) {
    if (flight_) host_.flies_on(flight_->first, flight_->second);
    if (stand_) host_.stands_at(*stand_);
  }

  bool serves(const PlanningRequest& request) const {
    return request.knowledge == knowledge_ && request.world == world_ &&
           request.situation.origin == origin_ && request.seed == seed_ &&
           flight_of(request.situation) == flight_ && stand_of(request.situation) == stand_;
  }

  Result<mission::ElementaryPlan, PlanningFailure> plan(const PlanningRequest& request,
                                                        Shelf& shelf, PlanningEffort& effort) {
    DomainBook& book = shelf.book();
    if (book.compiled() == nullptr) return fail(sentences(book.errors()));
    const htn::Problem problem = problem_of(request, book.store());
    shelf.desk().seat(host_);
    host_.begin();
    htn::Host search_host;
    search_host.cancelled = [&budget = request.budget] { return budget.over(); };
    const htn::Outcome outcome =
        htn::plan(*book.compiled(), problem, search_options(request.budget), search_host);
    effort = {outcome.statistics.expansions, outcome.statistics.inferences, host_.refinements()};
    if (outcome.plans.empty())
      return tl::unexpected<PlanningFailure>(explain(request, book.store(), outcome, host_));
    auto plan = read_plan(book.store(), outcome.plans.front(), *knowledge_, origin_);
    if (!plan) return fail({plan.error().why});
    know_partners(*plan, *world_, knowledge_->team.values());
    if (auto problem_with_energy = energy_problem(*plan, request))
      return tl::unexpected<PlanningFailure>(std::move(*problem_with_energy));
    return std::move(*plan);
  }

 private:
  using Flight = std::optional<std::pair<world::Vector3, double>>;
  static Flight flight_of(const Situation& from) {
    return from.flies_on ? Flight({from.position, from.heading}) : std::nullopt;
  }
  using Stand = std::optional<world::Vector3>;
  static Stand stand_of(const Situation& from) {
    return from.stands ? Stand(from.position) : std::nullopt;
  }

  std::shared_ptr<const world::World> world_;
  std::shared_ptr<const Knowledge> knowledge_;
  MissionTime origin_;
  std::uint64_t seed_;
  Flight flight_;
  Stand stand_;
  PlannerHost host_;
};

Plans::Plans() = default;
Plans::~Plans() = default;

Result<mission::ElementaryPlan, PlanningFailure> Plans::plan(const PlanningRequest& request,
                                                             PlanningEffort* effort) {
  if (effort_of_job_ > kMostEffort) end_job();
  Shelf& shelf = shelf_for(request.knowledge->domain);
  PlanningEffort spent;
  auto plan = workplace_for(request).plan(request, shelf, spent);
  effort_of_job_ += spent.inferences;
  if (effort != nullptr) *effort = spent;
  return plan;
}

void Plans::end_job() {
  workplaces_.clear();
  const bool full = shelf_ && (effort_of_job_ > kMostEffort || shelf_->memory_bytes() > kMostKept);
  if (full) shelf_.reset();
  if (shelf_) shelf_->desk().leave();
  effort_of_job_ = 0;
}

// What refiners answered is in terms of the shelf: it goes with it.
Plans::Shelf& Plans::shelf_for(const DomainText& domain) {
  if (!shelf_ || !shelf_->serves(domain)) {
    workplaces_.clear();
    shelf_ = std::make_unique<Shelf>(domain);
  }
  return *shelf_;
}

Plans::Workplace& Plans::workplace_for(const PlanningRequest& request) {
  for (const auto& one : workplaces_)
    if (one->serves(request)) return *one;
  workplaces_.push_back(std::make_unique<Workplace>(request));
  return *workplaces_.back();
}

Result<mission::ElementaryPlan, PlanningFailure> plan_tasks(const PlanningRequest& request,
                                                            PlanningEffort* effort) {
  return Plans().plan(request, effort);
}

}  // namespace skein::supervisor
