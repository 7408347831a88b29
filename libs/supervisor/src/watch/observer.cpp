// SPDX-License-Identifier: Apache-2.0
#include "watch/observer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "book/progress.hpp"
#include "skein/foundation/rounded_seconds.hpp"
#include "skein/functional/steering_ids.hpp"

namespace skein::supervisor {

namespace {

constexpr Duration kWaitRetry = Duration::milliseconds(5000);
// At the most, of the last landing.
constexpr Duration kLandRetry = Duration::milliseconds(10'000);
// A time that was asked is kept when it is missed by no more.
constexpr Duration kKept = Duration::milliseconds(500);
// As long as it may take to hear of a beginning, and that part of the whole.
constexpr Duration kUnseenMost = Duration::milliseconds(3'000);
constexpr std::int64_t kUnseenPart = 20;  // one of so many
/// Who is in closed air waits no longer until it tries again to leave: six times a minute.
constexpr Duration kLeavesAgain = Duration::milliseconds(10'000);

// "ended early by 12 s: it was to end after 100 s"; empty when it is in its time.
std::string beside(MissionTime at, std::optional<MissionTime> after,
                   std::optional<MissionTime> before, bool ends) {
  const std::string did = ends ? "ended " : "began ", asked = ends ? "end " : "start ";
  const auto say = [&](const char* how, Duration by, const char* side, MissionTime bound) {
    return did + how + in_seconds(by) + ": it was to " + asked + side + in_seconds(bound);
  };
  if (after && at + kKept < *after) return say("early by ", *after - at, "after ", *after);
  if (before && at > *before + kKept) return say("late by ", at - *before, "before ", *before);
  return "";
}

// What begins, or ends, now beside the times that were asked, for the one told of it.
std::vector<std::string> beside_its_times(const mission::ElementaryTask& task,
                                          const GoalBounds& bounds, MissionTime now, bool ends) {
  const mission::TimeConstraints& time = task.time;
  std::vector<std::string> all{beside(now, ends ? time.end_after : time.start_after,
                                      ends ? time.end_before : time.start_before, ends)};
  const auto own = bounds.of.find(task.origin);
  if (own != bounds.of.end()) {
    for (const mission::GoalBound& one : own->second) {
      const auto over = bounds.over.find(one.goal);
      if (one.on_end != ends || over == bounds.over.end()) continue;
      const auto most =
          one.most == Duration::max() ? std::nullopt : std::optional(over->second + one.most);
      all.push_back(beside(now, over->second + one.least, most, ends));
      if (!all.back().empty()) all.back() += ", counted from goal " + to_text(one.goal);
    }
  }
  all.erase(std::remove(all.begin(), all.end(), std::string()), all.end());
  return all;
}

}  // namespace

// ---- tasks ----

Observer::Observer(const Rooms& rooms, Duration grace)
    : hand_over_(rooms.hand_over),
      safe_mode_(rooms.safe_mode),
      contingencies_(rooms.contingencies),
      committer_(rooms.committer),
      dates_(rooms.dates),
      beliefs_(rooms.beliefs),
      agenda_(rooms.agenda),
      out_(rooms.out),
      book_(rooms.book),
      grace_(grace),
      ways_(rooms.beliefs, rooms.book) {}

void Observer::see(const TaskSeen& seen) {
  const executive::TaskEvent& event = seen.event;
  if (event.id >= executive::kFirstBackgroundId) return;
  if (event.state == TaskState::kEnded) beliefs_.see_end(event, now());
  const bool is_here = event.state == TaskState::kScheduled || is_terminal(event.state);
  const bool came_back = is_here && book_.elsewhere.erase(event.id) > 0;
  Entry* entry = book_.find(event.id);
  if (entry == nullptr) {
    see_loose(event, came_back);
    if (seen.gives_way) note_who_gives_way(event.id);
    return;
  }
  entry->over_elsewhere = came_back && is_terminal(event.state);
  see(*entry, event);
  if (is_here) hand_over_.came_back(event.id);
}

// Safe waits, and tasks of others. New tasks are numbered beyond theirs, unless theirs are in a
// range of their own.
void Observer::see_loose(const executive::TaskEvent& event, bool came_back) {
  if (event.id < functional::kFirstRoleId && !functional::is_of_steering(event.id)) {
    book_.next_id = std::max(book_.next_id, TaskId(event.id.value() + 1));
  }
  const auto known = book_.loose.find(event.id);
  if (!is_terminal(event.state)) {
    const functional::TaskType& type = functional::TaskTypes::shipped().of(event.type);
    Loose& one = known != book_.loose.end() ? known->second : book_.loose[event.id];
    if (known == book_.loose.end()) {
      const bool ours = book_.forgotten.of(event.id.value()) == kOursElsewhere;
      one = {.type = event.type, .ours = ours, .holds_vehicle = type.holds_vehicle()};
      one.leads_away =
          event.id < functional::kFirstPlayedId && type.motion == functional::Motion::kMoves;
    }
    one.begun = one.begun || event.state != TaskState::kScheduled;
    one.ran = one.ran || event.state == TaskState::kRunning;
    moved_by_others_ =
        moved_by_others_ || (one.ran && type.motion == functional::Motion::kMoves && !one.ours);
    return;
  }
  if (known == book_.loose.end()) return;
  if (known->second.ours && !known->second.stopping)
    safe_mode_.pause_until(now() + retry_after(known->second, event.reason));
  led_away_ = led_away_ || (known->second.leads_away && known->second.begun);
  if (!came_back) book_.forgotten.set(event.id.value(), 1);
  book_.loose.erase(known);
  if (!led_away_ || book_.is_led_away()) return;
  led_away_ = false;
  if (!book_.free_goals().empty())
    agenda_.plan_anew(std::nullopt, false, "task " + to_text(event.id) + " of an operator is over");
}

// What was given behind it waits for it no longer.
void Observer::note_who_gives_way(TaskId id) {
  const auto known = book_.loose.find(id);
  if (known == book_.loose.end() || known->second.ours || !known->second.begun) return;
  if (!std::exchange(known->second.gives_way, true) && engaged()) committer_.renew_motions();
}

// Of what keeps it safe: sooner where it did run, and something else took its place; and of the
// last landing, since energy does not wait.
Duration Observer::retry_after(const Loose& loose, const std::string& why) {
  if (loose.ran) return kWaitRetry;
  const Duration pause = pause_after(refusals_.count(loose.type, why, now()));
  return std::max(kWaitRetry, loose.type == "land" ? std::min(pause, kLandRetry) : pause);
}

// The second time it comes back from another executive, with the conditions that it was handed over
// with: what it was held for may have come true meanwhile, when nobody here could say so.
void Observer::see_scheduled(Entry& entry) {
  const bool came_back = std::exchange(entry.scheduled, true);
  if (engaged() && came_back && entry.was_held && !entry.seen.started && !entry.by_others) {
    committer_.send_preconditions(entry);
  }
}

void Observer::see(Entry& entry, const executive::TaskEvent& event) {
  if (entry.over()) {
    // Given up for lost, it comes back from another executive all the same.
    const bool late = entry.unseen && event.state == TaskState::kScheduled;
    if (late && engaged()) out_.send(executive::Abort{entry.task.id});
    return;
  }
  if (!entry.given()) {
    entry.by_others = true;
    entry.advance(Step::kGive);
  }
  if (event.state == TaskState::kRunning && !entry.running) {
    entry.running = now();
    entry.seen_at = beliefs_.vehicle().position;
  }
  switch (event.state) {
    case TaskState::kScheduled:
      see_scheduled(entry);
      return;
    case TaskState::kStarted:
    case TaskState::kRunning:
      if (!entry.task.way.empty()) moved_by_others_ = false;
      see_started(entry);
      if (engaged() && begins_elsewhere(entry))
        return contingencies_.fail_goal(
            entry.task.origin, "task " + to_text(entry.task.id) +
                                   " begins far from where it was planned: another task has moved "
                                   "the vehicle meanwhile");
      break;
    case TaskState::kAborting:
      entry.why = event.reason;
      entry.cause = event.cause;
      return;
    case TaskState::kEnded:
      see_ended(entry);
      break;
    case TaskState::kAborted:
      if (entry.why.empty()) entry.why = event.reason;
      if (entry.cause == executive::AbortCause::kOther) entry.cause = event.cause;
      see_aborted(entry);
      return;
  }
  if (!engaged()) return committer_.reschedule();
  contingencies_.check_network("task " + to_text(event.id) + " " +
                               std::string(to_text(event.state)));
}

// Its way there was flown, also at the ground's order, and something else led the vehicle away.
bool Observer::begins_elsewhere(const Entry& look) const {
  constexpr double kFar = 25;  // [m]
  if (!moved_by_others_ || !look.live() || look.task.parameters.find("target") == nullptr)
    return false;
  const Entry* way = nullptr;
  for (const Entry* one : book_.of(look.task.origin)) {
    if (one == &look) break;
    if (!one->task.way.empty()) way = one;
  }
  if (way == nullptr || way->under_way()) return false;
  const world::VehicleModel& model = beliefs_.model();
  const double circles = model.hovers ? 0 : 2 * model.orbit_radius;
  const world::Vector3 off = beliefs_.vehicle().position - way->task.way.back();
  return off.head<2>().norm() > kFar + circles;
}

// A goal that was handed over is the ground's, but when all of it is with the executive.
void Observer::see_started(Entry& entry) {
  if (!entry.seen.started) tell_beside_its_times(entry, false);
  if (!entry.seen.started) entry.seen.started = now();
  const GoalId id = entry.task.origin;
  Goal& goal = book_.goals.at(id);
  const bool whole = book_.is_wholly_given(id) && !book_.has_lost(id);
  if (entry.live() && (whole || goal.state != GoalState::kHandedOver))
    out_.set_state(goal, GoalState::kUnderWay);
}

void Observer::tell_beside_its_times(const Entry& entry, bool ends) {
  if (!engaged() || !entry.live()) return;
  for (const std::string& how : beside_its_times(entry.task, book_.bounds(), now(), ends)) {
    out_.notice("goal " + to_text(entry.task.origin) + ": " + entry.task.type + " " +
                to_text(entry.task.id) + " " + how);
  }
}

void Observer::see_ended(Entry& entry) {
  tell_beside_its_times(entry, true);
  entry.seen.over = now();
  entry.advance(Step::kEnd);
  tell_progress(entry.task.origin);
  if (!entry.live()) return;
  settle_done(entry);
  if (!engaged() || ends_by_order(entry.task)) return;
  const Duration took = now() - entry.seen.started.value_or(now());
  if (took + grace_ < entry.task.duration.least) {
    committer_.reschedule();
    const Duration early = entry.task.duration.least - took;
    return contingencies_.absorb_or_shift("task " + to_text(entry.task.id) + " early by " +
                                          in_seconds(early));
  }
  if (entry.told == Tardiness::kOverdue) {
    committer_.reschedule();
    if (dates_.controllable()) dates_.promise();
  }
}

// Over as it should be: the goal is achieved when all its tasks are.
void Observer::settle_done(Entry& entry) {
  refusals_.did(entry.task.type);
  if (entry.task.type == "wait") safe_mode_.hurry();
  const GoalId id = entry.task.origin;
  Goal& goal = book_.goals.at(id);
  if (is_settled(goal.state)) return;
  const auto all = book_.of(id);
  if (std::all_of(all.begin(), all.end(), [](const Entry* one) { return one->done(); })) {
    out_.set_state(goal, GoalState::kAchieved);
  }
}

// What ends when others do was stopped as it should be, if those have ended well.
bool Observer::was_stopped_in_time(const Entry& entry) const {
  const auto& stop = entry.task.stop;
  return !stop.empty() && entry.seen.started &&
         std::all_of(stop.begin(), stop.end(), [this](const mission::Dependence& one) {
           const Entry* other = book_.find(one.task);
           return other == nullptr || other->done() ||
                  (one.kind == mission::DependenceKind::kOver && other->over());
         });
}

// It failed for want of another, not of itself. What was begun with had not to wait any more for
// what it was planned behind: that may well be what was lost before it.
bool Observer::follows_lost_task(const Entry& entry) const {
  const auto is_lost = [this](const mission::Dependence& one) {
    const Entry* other = book_.find(one.task);
    return other != nullptr && other->over() && !other->done();
  };
  const auto& before = entry.task.dependences;
  return (!entry.seen.started && std::any_of(before.begin(), before.end(), is_lost)) ||
         std::any_of(entry.task.stop.begin(), entry.task.stop.end(), is_lost);
}

// What was stopped as it should be, since what it was begun with is over, may yet have done little
// of it: in a sentence, or empty.
std::string Observer::missed(const Entry& entry) const {
  const Entry* with = companion_of(book_, entry);
  if (with == nullptr || entry.task.parameters.find("device") == nullptr) return {};
  const Duration missed = missed_beside(entry, *with);
  const std::int64_t part = with->task.duration.least.count() / kUnseenPart;
  const Duration most = entry.running ? kUnseenMost + Duration::nanoseconds(part) : Duration();
  if (missed <= most) return {};
  return "task " + to_text(entry.task.id) + " missed " + in_seconds(missed) + " of " +
         with->task.type + " " + to_text(with->task.id);
}

void Observer::see_aborted(Entry& entry) {
  const bool ordered = entry.ordered();
  entry.abort(now());
  tell_progress(entry.task.origin);
  if (!entry.live()) return;
  const bool asked = entry.cause == executive::AbortCause::kRequested && !ordered;
  const bool stopped = was_stopped_in_time(entry) && !asked;
  if (stopped && engaged()) {
    if (const std::string why = missed(entry); !why.empty())
      return contingencies_.fail_goal(entry.task.origin, why);
  }
  if (ordered || stopped) {
    entry.advance(Step::kExcuse);
    settle_done(entry);
    return committer_.reschedule();
  }
  if (!engaged()) {
    out_.set_state(book_.goals.at(entry.task.origin), GoalState::kHandedOver);
    return;
  }
  if (asked) {
    return contingencies_.cancel_goal(entry.task.origin,
                                      "task " + to_text(entry.task.id) + " aborted on request");
  }
  const std::string what = "task " + to_text(entry.task.id) + " aborted: " + entry.why;
  if (follows_lost_task(entry))
    return contingencies_.fail_goal(entry.task.origin, what + " (it follows a lost one)");
  refused(entry, what);
}

bool Observer::leaves_closed_air(const Entry& entry) const {
  return book_.goals.at(entry.task.origin).task.name == kLeaveClosedAir;
}

// What was refused alike before is planned again after a pause; whatever else happens ends it.
void Observer::pause_need(const Entry& entry, int refused) {
  const Duration most = leaves_closed_air(entry) ? kLeavesAgain : Duration::max();
  const Duration pause = std::min(pause_after(refused), most);
  if (pause <= Duration()) return;
  agenda_.pause_until(now() + pause);
  out_.notice(book_.named(entry.task.origin) + ": its " + entry.task.type + " was refused " +
              std::to_string(refused) + " times alike (" + entry.why +
              "); it is planned again in " + to_text(pause) + " s");
}

// Others were in its way than before: it is a queue that moves, not one who stays for good.
void Observer::excuse_if_others_fly_by(const Entry& entry) {
  Goal& goal = book_.goals.at(entry.task.origin);
  const std::string before = std::exchange(goal.no_air, entry.why);
  if (!before.empty() && before != entry.why) goal.refined = std::max(0, goal.refined - 1);
}

// By the vehicle, or by the executive. The goal is planned again, at once or after a pause.
void Observer::refused(const Entry& entry, const std::string& what) {
  const int times = refusals_.count(entry.task.type, entry.why, now());
  const auto before = agenda_.needed() ? std::optional(agenda_.needed()->not_before) : std::nullopt;
  // Nothing is better to do in closed air: its vehicle does not use up its attempts to leave.
  if (entry.cause != executive::AbortCause::kNoAir && leaves_closed_air(entry))
    book_.goals.at(entry.task.origin).refined = 0;
  if (entry.cause == executive::AbortCause::kNoAir) excuse_if_others_fly_by(entry);
  contingencies_.fail_goal(
      entry.task.origin, times > 1 ? what + " (" + std::to_string(times) + " times alike)" : what);
  if (!agenda_.needed()) return;
  if (entry.cause == executive::AbortCause::kNoAir && agenda_.needed()->failed == entry.task.origin)
    agenda_.put_behind();
  if (before)
    agenda_.pause_until(std::max(*before, now()));
  else if (agenda_.needed()->refine)
    pause_need(entry, times);
}

void Observer::see(const executive::Reply& reply) {
  if (reply.accepted || !reply.id) return;
  const std::string what = std::string(to_text(reply.request)) + " of task " + to_text(*reply.id) +
                           " refused: " + reply.why;
  out_.notice(what);
  if (reply.request == executive::RequestKind::kAbort) return;
  if (const auto loose = book_.loose.find(*reply.id); loose != book_.loose.end()) {
    if (!loose->second.ours) return;
    safe_mode_.pause_until(now() + retry_after(loose->second, reply.why));
    book_.loose.erase(loose);
    return;
  }
  Entry* entry = book_.find(*reply.id);
  if (entry == nullptr || entry->over()) return;
  // Its start crossed new preconditions, as when the first of two updates let it begin.
  if (reply.request == executive::RequestKind::kUpdateConditions && entry->seen.started) return;
  if (reply.request == executive::RequestKind::kStart) entry->abort(now());
  entry->why = reply.why;
  if (entry->live() && engaged()) refused(*entry, what);
}

// ---- the vehicle ----

void Observer::tell_progress(GoalId id) {
  book_.goals.at(id).done = mission::to_text(progress_of(book_, id, std::nullopt));
}

std::set<std::string> Observer::see(const VehicleSeen& seen) {
  ways_.see(seen.state, now());
  std::set<std::string> newly = beliefs_.see(seen.state, seen.failed, now());
  if (const auto wind = beliefs_.feel_wind()) {
    const auto figure = [](double value) {
      return to_text(Duration::seconds(std::round(10 * value) / 10));
    };
    out_.notice("the wind is felt to be " + figure(wind->speed) + " m/s towards " +
                figure(wind->toward * 180 / M_PI) + " degrees north of east");
  }
  return newly;
}

}  // namespace skein::supervisor
