// SPDX-License-Identifier: Apache-2.0
#include "schedule/conflicts.hpp"

#include <algorithm>
#include <string>

#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

namespace {

using temporal::Ticks;

std::string seconds(Ticks ticks) { return in_seconds(Duration::nanoseconds(ticks)); }
std::string seconds(MissionTime instant) { return in_seconds(instant); }

bool is_upper_constraint(BoundKind kind) {
  return kind == BoundKind::kStartBefore || kind == BoundKind::kEndBefore ||
         kind == BoundKind::kAfterGoal || kind == BoundKind::kNeeded;
}
bool is_constraint(BoundKind kind) {
  return is_upper_constraint(kind) || kind == BoundKind::kStartAfter ||
         kind == BoundKind::kEndAfter;
}

class Sentences {
 public:
  Sentences(bool consistent, const ForeseenOf& foreseen, MissionTime now)
      : consistent_(consistent), foreseen_(foreseen), now_(now) {}

  std::string of(const BrokenBound& broken) const {
    const Cause& cause = broken.link->cause;
    const std::string other = "task " + to_text(cause.other);
    switch (cause.kind) {
      case BoundKind::kNow:
        return "is not over at " + seconds(now_);
      case BoundKind::kFact:
        return "was seen at " + seconds(cause.instant);
      case BoundKind::kDuration:
        return duration(broken);
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
        return upper(cause, "start", start_of(cause.task));
      case BoundKind::kEndBefore:
        return upper(cause, "end", end_of(cause.task));
      case BoundKind::kAfterGoal:
        return after_goal(broken);
      case BoundKind::kPartner:
        return "waits for '" + cause.who + "'";
      case BoundKind::kNeeded:
        return upper(cause, "start", start_of(cause.task)) + ", which '" + cause.who + "' needs";
    }
    return "";
  }

 private:
  static std::string duration(const BrokenBound& broken) {
    const temporal::LiveLink& link = broken.link->link;
    const bool least = broken.bound == temporal::LinkBound::kMin;
    return (link.contingent ? "may take " : "takes ") +
           std::string(least ? "as little as " : "as long as ") +
           seconds(least ? link.min : link.max);
  }

  // "starts no earlier than 240 s, must start between 0 and 60 s after goal 701, which ended at 120
  // s"
  std::string after_goal(const BrokenBound& broken) const {
    const Cause& cause = broken.link->cause;
    const temporal::LiveLink& link = broken.link->link;
    const bool over = cause.other == executive::TaskId(), starts = link.to == start_of(cause.task);
    const Ticks origin = over ? ticks_of(cause.instant) : 0;
    const std::string verb = starts ? "start" : "end";
    const bool open = link.max == temporal::kInfinite;
    std::string text = "must " + verb + (open ? " " : " between ") +
                       to_text(Duration::nanoseconds(link.min - origin));
    text += open ? " s or more" : " and " + seconds(link.max - origin);
    text += " after the end of goal " + to_text(cause.goal);
    if (over) text += ", which was at " + seconds(cause.instant);
    const auto dates = foreseen_(link.to);
    if (!dates) return text;
    return verb + "s no earlier than " + in_seconds(dates->least) + ", " + text;
  }

  // "ends no earlier than 431 s, must end before 400 s"
  std::string upper(const Cause& cause, const std::string& verb,
                    const temporal::NodeName& node) const {
    const std::string must = "must " + verb + " before " + seconds(cause.instant);
    if (const auto dates = foreseen_(node)) {
      const Duration limit = cause.instant - MissionTime();
      if (dates->least > limit)
        return verb + "s no earlier than " + in_seconds(dates->least) + ", " + must;
      if (consistent_ && dates->most > limit && dates->most != Duration::max())
        return "may " + verb + " as late as " + in_seconds(dates->most) + ", " + must;
    }
    return must + ", which what must come before or with it does not allow";
  }

  bool consistent_;
  const ForeseenOf& foreseen_;
  MissionTime now_;
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
                       [&](const BrokenBound& one) { return wanted(one.link->cause); });
  };
  const bool constrained = any([](const Cause& one) { return is_upper_constraint(one.kind); });
  const bool tied = any(tie);
  return [=](const Cause& cause) {
    if (constrained) return is_constraint(cause.kind);
    return !tied || tie(cause) || is_constraint(cause.kind);
  };
}

// "; 'heliv' comes between 40 s and 70 s", or leaves the air that is waited for
std::string who_is_late(const std::vector<BrokenBound>& bounds) {
  for (const BrokenBound& broken : bounds) {
    const PlanLink& one = *broken.link;
    const bool comes =
        one.link.to == others_at(one.cause.task) || one.link.to == start_of(one.cause.task);
    if (one.cause.kind != BoundKind::kPartner || !comes) continue;
    if (one.link.min >= ticks_of(MissionTime::max()))
      return "; '" + one.cause.who + "' waits for it in turn, so that neither ever comes";
    const bool bounded = one.link.max != temporal::kInfinite;
    const char* does = one.cause.part == kAirPart ? "' leaves its air " : "' comes ";
    return "; '" + one.cause.who + does + (bounded ? "between " : "from ") + seconds(one.link.min) +
           (bounded ? " and " + seconds(one.link.max) : " on");
  }
  return "";
}

}  // namespace

std::vector<Conflict> explain(const std::vector<BrokenBound>& bounds, bool consistent,
                              const ForeseenOf& foreseen, MissionTime now) {
  const auto wanted = telling(bounds);
  const Sentences sentences(consistent, foreseen, now);
  std::vector<Conflict> conflicts;
  for (const BrokenBound& broken : bounds) {
    const Cause& cause = broken.link->cause;
    if (!wanted(cause)) continue;
    const std::string text = sentences.of(broken);
    const auto same = std::find_if(conflicts.begin(), conflicts.end(),
                                   [&](const Conflict& one) { return one.task == cause.task; });
    if (same == conflicts.end()) {
      conflicts.push_back({cause.task, text});
    } else if (same->why.find(text) == std::string::npos) {
      same->why += "; " + text;
    }
  }
  const std::string late = who_is_late(bounds);
  if (!conflicts.empty() && !late.empty()) conflicts.front().why += late;
  return conflicts;
}

}  // namespace skein::supervisor
