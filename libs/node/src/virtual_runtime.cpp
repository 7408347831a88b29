// SPDX-License-Identifier: Apache-2.0
#include "skein/node/virtual_runtime.hpp"

#include <algorithm>
#include <map>

#include "skein/blackboard/memory_transport.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/journal/lines/truth.hpp"
#include "virtual_jobs.hpp"

namespace skein::node {

namespace {

using blackboard::Now;
using End = VirtualOutcome::End;

/// More rounds than this at one instant means that nodes answer each other for ever.
constexpr int kMaximumRounds = 100'000;

class VirtualRun {
 public:
  VirtualRun(const Roster& roster, const NodeFactory& make_node, const VirtualConfig& config,
             const std::function<void(const journal::Record&)>& journal)
      : roster_(roster), make_node_(make_node), config_(config), journal_(journal) {
    for (const Member& member : roster.members()) {
      const bool plays = member.role == wire::Role::kOperator ? config.operators
                                                              : member.role != wire::Role::kRunner;
      if (plays) seats_.emplace_back().member = &member;
    }
    for (const Crash& crash : config.crashes) {
      Seat& seat = seat_of(crash.node);
      if (!config.memory_of && (crash.remembers || plays_the_world(*seat.member))) {
        seat.memory = std::make_unique<MemoryInputLog>();
      }
      plan_crash(crash);
    }
  }

  VirtualOutcome run(const std::function<bool(MissionTime)>& keep_going) {
    for (Seat& seat : seats_) start(seat);
    MissionTime next_question;
    while (true) {
      settle();
      const auto next = next_instant();
      if (!next) return outcome(End::kNothingLeftToDo);
      if (*next > stop_at_) return outcome(finished_ ? End::kFinished : End::kTimeLimit);
      now_ = std::max(now_, *next);
      if (keep_going && now_ >= next_question) {
        next_question = now_ + Duration::seconds(1);
        if (!keep_going(now_)) return outcome(End::kStopped);
      }
    }
  }

 private:
  // A node's place in the system; it is empty while the node is dead.
  struct Seat {
    const Member* member = nullptr;
    std::uint64_t incarnation = 0;
    std::unique_ptr<MemoryInputLog> memory;  ///< of a node that will come back with it
    std::unique_ptr<blackboard::MemoryTransport> transport;
    std::unique_ptr<Host> host;
    bool touched = false;  ///< since its last step something came or was done
    std::optional<MissionTime> due;
  };

  Now now() const { return {now_, now_ - MissionTime()}; }

  VirtualOutcome outcome(End end) const {
    return {end, end == End::kTimeLimit ? config_.time_limit : now_, steps_};
  }

  void plan_crash(const Crash& crash) {
    faults_.emplace(crash.at, [this, node = crash.node] { kill(seat_of(node)); });
    if (!crash.restart) return;
    faults_.emplace(*crash.restart,
                    [this, crash] { restart(seat_of(crash.node), crash.remembers); });
  }

  /// Vehicles, and the world they fly in, are where they are, whoever forgets.
  static bool plays_the_world(const Member& member) {
    return member.role == wire::Role::kSim || member.role == wire::Role::kFunctional;
  }

  Seat& seat_of(const std::string& name) {
    const auto found = std::find_if(seats_.begin(), seats_.end(),
                                    [&](const Seat& seat) { return seat.member->name == name; });
    SKEIN_EXPECTS(found != seats_.end());
    return *found;
  }

  void log_fault(const char* what, const std::string& target) {
    journal_(
        journal::record_of(now_, "runner", journal::lines::Fault{.what = what, .target = target}));
  }

  // Crashes may overlap: who is dead cannot die, who lives is not started again.
  void restart(Seat& seat, bool remembers) {
    if (seat.host) return;
    log_fault(remembers ? "resume" : "restart", seat.member->name);
    const bool world = plays_the_world(*seat.member);
    if (seat.memory && !remembers && !world) seat.memory = std::make_unique<MemoryInputLog>();
    start(seat, !remembers && world);
  }

  void kill(Seat& seat) {
    if (!seat.host) return;
    log_fault("kill", seat.member->name);
    seat.host.reset();
    seat.transport.reset();
  }

  void start(Seat& seat, bool forgets = false) {
    ++seat.incarnation;
    seat.transport = std::make_unique<blackboard::MemoryTransport>(hub_);
    seat.transport->on_arrival([&seat] { seat.touched = true; });
    HostConfig config;
    config.incarnation = seat.incarnation;
    config.heartbeat_period = config_.heartbeat_period;
    config.seed = config_.seed;
    config.memory = config_.memory_of ? config_.memory_of(seat.member->name) : seat.memory.get();
    config.forgets = forgets;
    if (config_.silent_cuts) config.told = ToldOfLinks::kNotOfCuts;
    config.capacity = config_.capacity;
    config.meets_when_told = config_.meets_when_told && !config_.silent_cuts;
    auto host = Host::open(roster_, *seat.member, make_node_(seat.member->name), *seat.transport,
                           config, ports_of(seat));
    SKEIN_ENSURES(host.has_value());
    seat.host = std::move(*host);
    seat.host->start(now(), seat.incarnation == 1);
    seat.host->lines_have_left();
    seat.touched = true;
  }

  HostPorts ports_of(const Seat& seat) {
    HostPorts ports;
    ports.journal = [this](const journal::Record& record, LineMark) { journal_(record); };
    ports.finish = [this] { finish(); };
    if (config_.silent_cuts) {
      ports.witness = [this](const wire::Sample& sample) {
        const auto* link = std::get_if<wire::LinkState>(&sample);
        if (link == nullptr) return;
        const bool is_of_one = link->from != 0 && link->to != 0;
        if (!is_of_one) return hub_.carry_others(link->up);
        hub_.carry(NodeNumber(link->from), NodeNumber(link->to), link->up);
      };
    }
    const VirtualJobs::Owner owner{seat.member->name, seat.incarnation};
    ports.start_job = [this, owner](StartJob job) { jobs_.submit(owner, std::move(job), now_); };
    ports.stop_job = [this, owner](StopJob job) { jobs_.stop(owner, job.id, now_); };
    return ports;
  }

  void finish() {
    if (finished_) return;
    finished_ = true;
    stop_at_ = std::min(stop_at_, now_ + config_.after_finish);
  }

  // Everything that happens at this instant: faults, then job results, then hosts until all are
  // quiet.
  void settle() {
    for (; !faults_.empty() && faults_.begin()->first <= now_; faults_.erase(faults_.begin())) {
      const auto fault = faults_.begin()->second;
      fault();
    }
    while (auto job = jobs_.take_done(now_)) {
      Seat& seat = seat_of(job->owner.node);
      if (!seat.host || seat.incarnation != job->owner.incarnation) continue;
      seat.host->job_done(std::move(job->done), now());
      seat.host->lines_have_left();
      seat.touched = true;
    }
    int rounds = 0;
    for (bool busy = true; busy; SKEIN_ENSURES(++rounds < kMaximumRounds)) {
      busy = false;
      for (Seat& seat : seats_) busy = (is_due(seat) && step(seat)) || busy;
    }
  }

  // A step in between does nothing.
  bool is_due(const Seat& seat) const {
    return seat.host && (seat.touched || (seat.due && *seat.due <= now_));
  }

  // What was given counts as handled at the next step: after one that gave something comes another.
  bool step(Seat& seat) {
    ++steps_;
    seat.touched = false;
    const bool busy = seat.host->step(now());
    seat.host->lines_have_left();
    seat.touched = seat.touched || busy;
    seat.due = seat.host->next_mission_wakeup();
    if (const auto steady = seat.host->next_steady_wakeup())
      seat.due = earliest(seat.due, MissionTime() + *steady);
    return busy;
  }

  std::optional<MissionTime> next_instant() const {
    std::optional<MissionTime> next;
    for (const Seat& seat : seats_) {
      if (seat.host) next = earliest(next, seat.due);
    }
    if (!faults_.empty()) next = earliest(next, faults_.begin()->first);
    if (const auto done = jobs_.next()) next = earliest(next, *done);
    return next;
  }

  const Roster& roster_;
  const NodeFactory& make_node_;
  const VirtualConfig& config_;
  const std::function<void(const journal::Record&)>& journal_;
  blackboard::MemoryHub hub_;
  std::vector<Seat> seats_;
  std::multimap<MissionTime, std::function<void()>> faults_;
  VirtualJobs jobs_{config_.jobs, config_.seed};
  MissionTime now_;
  MissionTime stop_at_ = config_.time_limit;
  bool finished_ = false;
  std::uint64_t steps_ = 0;
};

}  // namespace

VirtualOutcome run_virtual(const Roster& roster, const NodeFactory& make_node,
                           const VirtualConfig& config,
                           const std::function<void(const journal::Record&)>& journal,
                           const std::function<bool(MissionTime)>& keep_going) {
  return VirtualRun(roster, make_node, config, journal).run(keep_going);
}

}  // namespace skein::node
