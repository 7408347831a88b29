// SPDX-License-Identifier: Apache-2.0
#include "schedule_conflicts.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace skein::supervisor {

namespace {

using temporal::kInfinite;
using temporal::NodeIndex;
using temporal::Ticks;

std::string seconds(Ticks ticks) { return to_text(Duration::nanoseconds(ticks)) + " s"; }
std::string seconds(MissionTime instant) { return to_text(instant) + " s"; }

bool is_upper_constraint(BoundKind kind) {
  return kind == BoundKind::kStartBefore || kind == BoundKind::kEndBefore;
}
bool is_constraint(BoundKind kind) {
  return is_upper_constraint(kind) || kind == BoundKind::kStartAfter ||
         kind == BoundKind::kEndAfter;
}

class Sentences {
 public:
  Sentences(const PlanNetwork& plan, bool consistent, const NodeDates* foreseen)
      : plan_(plan), consistent_(consistent), foreseen_(foreseen) {}

  std::string of(const Cause& cause, temporal::LinkRef link, temporal::LinkBound bound) const {
    const std::string other = "task " + to_text(cause.other);
    switch (cause.kind) {
      case BoundKind::kNow:
        return "is not over at " + seconds(cause.instant);
      case BoundKind::kFact:
        return "was seen at " + seconds(cause.instant);
      case BoundKind::kDuration:
        return duration(link, bound);
      case BoundKind::kOrder:
        return "ends after it starts";
      case BoundKind::kAfterEnd:
        return "waits for the end of " + other;
      case BoundKind::kAfterStart:
        return "waits for the start of " + other;
      case BoundKind::kWithin:
        return "must start while " + other + " runs";
      case BoundKind::kBeforeStop:
        return "must start before " + other + " stops it";
      case BoundKind::kStop:
        return "ends with " + other;
      case BoundKind::kStartAfter:
        return "must start after " + seconds(cause.instant);
      case BoundKind::kEndAfter:
        return "must end after " + seconds(cause.instant);
      case BoundKind::kStartBefore:
        return upper(cause, "start", plan_.nodes.at(cause.task).start);
      case BoundKind::kEndBefore:
        return upper(cause, "end", plan_.nodes.at(cause.task).end);
    }
    return "";
  }

 private:
  std::string duration(temporal::LinkRef link, temporal::LinkBound bound) const {
    const bool nature = link.kind == temporal::LinkKind::kContingent;
    const bool least = bound == temporal::LinkBound::kMin;
    const Ticks min =
        nature ? plan_.stnu.contingent[link.index].min : plan_.stnu.arcs[link.index].min;
    const Ticks max =
        nature ? plan_.stnu.contingent[link.index].max : plan_.stnu.arcs[link.index].max;
    return (nature ? "may take " : "takes ") +
           std::string(least ? "as little as " : "as long as ") + seconds(least ? min : max);
  }

  // "ends no earlier than 431 s, must end before 400 s"
  std::string upper(const Cause& cause, const std::string& verb, NodeIndex node) const {
    const std::string must = "must " + verb + " before " + seconds(cause.instant);
    if (foreseen_ != nullptr) {
      const Ticks soonest = foreseen_->earliest[node], latest = foreseen_->latest[node];
      const Ticks limit = cause.instant.count();
      if (soonest > limit) return verb + "s no earlier than " + seconds(soonest) + ", " + must;
      if (consistent_ && latest > limit && latest != kInfinite)
        return "may " + verb + " as late as " + seconds(latest) + ", " + must;
    }
    return must + ", which what must come before or with it does not allow";
  }

  const PlanNetwork& plan_;
  bool consistent_;
  const NodeDates* foreseen_;
};

// The causes that say most: constraints when one of them bounds from above, else what ties tasks to
// each other, else all.
template <class Causes>
auto telling(const Causes& causes) {
  const auto tie = [](const Cause& cause) {
    return !is_constraint(cause.kind) && cause.kind != BoundKind::kDuration &&
           cause.kind != BoundKind::kOrder && cause.kind != BoundKind::kNow &&
           cause.kind != BoundKind::kFact;
  };
  const auto any = [&](auto&& wanted) {
    return std::any_of(causes.begin(), causes.end(),
                       [&](const auto& one) { return wanted(*one.first); });
  };
  const bool constrained = any([](const Cause& one) { return is_upper_constraint(one.kind); });
  const bool tied = any(tie);
  return [=](const Cause& cause) {
    if (constrained) return is_constraint(cause.kind);
    return !tied || tie(cause) || is_constraint(cause.kind);
  };
}

}  // namespace

std::vector<Conflict> explain(const PlanNetwork& plan, const temporal::DcResult& verdict,
                              const NodeDates* foreseen) {
  std::vector<std::pair<const Cause*, const temporal::ConflictTerm*>> causes;
  for (const temporal::ConflictTerm& term : verdict.conflict) {
    causes.emplace_back(&plan.cause_of(term.link), &term);
  }
  const auto wanted = telling(causes);
  const Sentences sentences(plan, verdict.consistent, foreseen);
  std::vector<Conflict> conflicts;
  for (const auto& [cause, term] : causes) {
    if (!wanted(*cause)) continue;
    const std::string text = sentences.of(*cause, term->link, term->bound);
    const auto same = std::find_if(conflicts.begin(), conflicts.end(),
                                   [&](const Conflict& one) { return one.task == cause->task; });
    if (same == conflicts.end()) {
      conflicts.push_back({cause->task, text});
    } else if (same->why.find(text) == std::string::npos) {
      same->why += "; " + text;
    }
  }
  return conflicts;
}

}  // namespace skein::supervisor
