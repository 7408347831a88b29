// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/repair.hpp"

#include <algorithm>

#include "repair/repaired_plan.hpp"
#include "repair/searches.hpp"
#include "skein/htn/aftermath.hpp"

namespace skein::htn {

namespace {

/// One repair: looks at the plan, lists the ways of repairing it, and has them searched.
class Repairing {
 public:
  Repairing(const Domain& domain, const Problem& problem, const RepairRequest& request,
            const RepairOptions& options, const Host& host)
      : domain_(domain),
        problem_(problem),
        request_(request),
        options_(options),
        host_(host),
        store_(domain.store()) {}

  Repair run() {
    if (std::string wrong = wrong_request(); !wrong.empty()) return error(std::move(wrong));
    OldTree cautious(*request_.plan, request_.executed, store_);
    if (!cautious.fault().empty()) return error(cautious.fault());
    if (host_.cpu_seconds) began_ = host_.cpu_seconds();
    now_ = problem_;
    const std::vector<Event> past = events(request_.executed);
    now_.past.insert(now_.past.end(), past.begin(), past.end());
    const Aftermath present(domain_, now_, options_.limits, host_);
    if (present.cut()) return stopped(RepairVerdict::kLimit, present.why());
    if (present.events() < now_.past.size()) return error(not_executed(present));
    const Problem earlier = before();
    const Aftermath unharmed(domain_, earlier, options_.limits, host_);
    if (same_facts(unharmed, present)) return unchanged();
    return repair(std::move(cautious), earlier,
                  [&](Term fact) { return holds(unharmed, fact) && !holds(present, fact); });
  }

 private:
  Repair repair(OldTree cautious, const Problem& earlier, const OldTree::Gone& gone) {
    OldTree lenient = cautious;
    cautious.settle(gone, true);
    lenient.settle(gone, false);
    const auto clobbered = cautious.first_clobbered(gone);
    const StepIndex doubtful = first_impossible();
    const bool applies = !clobbered && doubtful == request_.plan->steps.size();
    list_attempts(cautious, lenient,
                  clobbered ? clobbered->first : node_in_doubt(cautious, doubtful));
    Repair made = RepairSearches(domain_, now_, request_, options_, host_).run(attempts_, applies);
    const bool stands = made.verdict == RepairVerdict::kStands;
    if (applies && !stands && made.verdict != RepairVerdict::kLimit &&
        !shows_the_change(cautious, earlier, made.statistics)) {
      return unchanged();
    }
    if (clobbered) {
      made.clobbered = {clobbered->second, request_.plan->tree[clobbered->first].task};
    }
    return made;
  }

  static Repair stopped(RepairVerdict verdict, std::string why) {
    Repair repair;
    repair.verdict = verdict;
    repair.why = std::move(why);
    return repair;
  }
  static Repair error(std::string why) { return stopped(RepairVerdict::kError, std::move(why)); }

  std::string wrong_request() const {
    if (request_.plan == nullptr) return "there is no plan";
    if (request_.executed > request_.plan->steps.size()) {
      return "more steps are said to be executed than the plan has: " +
             std::to_string(request_.executed) + " of " +
             std::to_string(request_.plan->steps.size());
    }
    StepIndex before = 0;
    for (const Divergence& divergence : request_.divergences) {
      if (divergence.after > request_.executed || divergence.after < before) {
        return "the divergences are not in the order of the executed steps";
      }
      before = divergence.after;
      for (const Change& change : divergence.changes) {
        if (!is_fact(change.fact)) return store_.to_text(change.fact) + " is no ground fact";
      }
    }
    return "";
  }

  bool is_fact(Term fact) const {
    return fact.is(TermKind::kPair) && store_.car(fact).is(TermKind::kSymbol) &&
           store_.ground(fact) && store_.is_list(fact);
  }

  // The first `steps` steps with all divergences between and behind them.
  std::vector<Event> events(StepIndex steps) const {
    std::vector<Event> out;
    auto divergence = request_.divergences.begin();
    for (StepIndex step = 0; step <= steps; ++step) {
      for (; divergence != request_.divergences.end() && divergence->after == step; ++divergence) {
        for (const Change& change : divergence->changes) {
          out.push_back({change.added ? Event::Kind::kAdded : Event::Kind::kDeleted, change.fact});
        }
      }
      if (step < steps) out.push_back({Event::Kind::kStep, request_.plan->steps[step].action});
    }
    return out;
  }

  std::string not_executed(const Aftermath& present) const {
    if (present.failed()) return present.why();
    return "the step " + store_.to_text(now_.past[present.events()].term) +
           ", said to be executed, does not apply";
  }

  bool holds(const Aftermath& state, Term fact) const {
    const bool negated = store_.car(fact) == store_.symbol("not");
    return negated ? !state.holds(store_.car(store_.cdr(fact))) : state.holds(fact);
  }

  // The first remaining step that cannot be done when the others are done as planned.
  StepIndex first_impossible() const {
    Problem whole = now_;
    const std::vector<Step>& steps = request_.plan->steps;
    for (std::size_t step = request_.executed; step < steps.size(); ++step) {
      whole.past.push_back({Event::Kind::kStep, steps[step].action});
    }
    const std::size_t relived = Aftermath(domain_, whole, options_.limits, host_).events();
    const std::size_t applied = std::max(relived, now_.past.size()) - now_.past.size();
    return request_.executed + static_cast<StepIndex>(applied);
  }

  // The problem as it was when the last step had been executed.
  Problem before() const {
    Problem before = now_;
    while (!before.past.empty() && before.past.back().kind != Event::Kind::kStep) {
      before.past.pop_back();
    }
    return before;
  }

  static bool same_facts(const Aftermath& left, const Aftermath& right) {
    const std::vector<Term> facts = left.facts();
    return facts.size() == right.facts().size() &&
           std::all_of(facts.begin(), facts.end(), [&](Term fact) { return right.holds(fact); });
  }

  // That the remaining tasks do not come out the same speaks against the plan only if they did
  // before the change: the preferences cannot bring every search back to its plan.
  bool shows_the_change(const OldTree& tree, const Problem& earlier, const Statistics& used) const {
    RepairOptions left = options_;
    Limits& limits = left.limits;
    if (limits.expansions) *limits.expansions -= std::min(*limits.expansions, used.expansions);
    if (limits.inferences) *limits.inferences -= std::min(*limits.inferences, used.inferences);
    if (limits.seconds && host_.cpu_seconds) {
      limits.seconds = std::max(0.0, *limits.seconds - (host_.cpu_seconds() - began_));
    }
    const std::vector<RepairAttempt> same{{&tree, {}, false}};
    const Repair made = RepairSearches(domain_, earlier, request_, left, host_).run(same, true);
    return made.verdict == RepairVerdict::kStands;
  }

  Repair unchanged() const {
    Repair repair = stopped(RepairVerdict::kStands, "");
    repair.plan = *request_.plan;
    compare_steps(repair.plan, request_.executed, store_, repair);
    return repair;
  }

  // Where to repair when the links know of nothing lost: at that step, or at the next one.
  TreeIndex node_in_doubt(const OldTree& tree, StepIndex impossible) const {
    const std::size_t steps = request_.plan->steps.size();
    if (request_.executed == steps) return 0;
    return tree.leaf_of(impossible < steps ? impossible : request_.executed);
  }

  void list_attempts(const OldTree& cautious, const OldTree& lenient, TreeIndex failing) {
    attempts_ = {{&cautious, {}, false}};
    const auto first = cautious.remaining({});
    const auto other = lenient.remaining({});
    if (first && other && first->leaves != other->leaves)
      attempts_.push_back({&lenient, {}, false});
    for (const TreeIndex task : cautious.begun_above(failing)) {
      attempts_.push_back({&cautious, {task}, false});
    }
    std::vector<TreeIndex> tops = cautious.top_tasks();
    std::erase_if(tops, [&](TreeIndex task) { return !cautious.in_progress(task); });
    attempts_.push_back({&cautious, std::move(tops), true});
  }

  const Domain& domain_;
  const Problem& problem_;
  const RepairRequest& request_;
  const RepairOptions& options_;
  const Host& host_;
  TermStore& store_;
  double began_ = 0;
  Problem now_;  // with what has happened
  std::vector<RepairAttempt> attempts_;
};

}  // namespace

Repair repair(const Domain& domain, const Problem& problem, const RepairRequest& request,
              const RepairOptions& options, const Host& host) {
  return Repairing(domain, problem, request, options, host).run();
}

}  // namespace skein::htn
