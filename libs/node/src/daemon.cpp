// SPDX-License-Identifier: Apache-2.0
#include "skein/node/daemon.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>

#include "job_runner.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/handshakes.hpp"
#include "skein/blackboard/programs.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/node/agreement.hpp"
#include "skein/node/heartbeat.hpp"
#include "skein/node/mission_clock.hpp"
#include "skein/node/wakeful_time.hpp"
#include "skein/node/waker.hpp"

namespace skein::node {

namespace {

using blackboard::Now;

constexpr Duration kClockPeriod = Duration::milliseconds(100);
/// After the mission's end: the leader stays so that everybody hears of it.
constexpr Duration kLinger = Duration::milliseconds(1500);
/// A leader that comes back listens to the others for two of their heartbeats, at least this long.
constexpr Duration kListens = Duration::milliseconds(500);
/// What others may say of mission time: they stand still soon after their leader falls silent.
constexpr Duration kMostAhead = Duration::milliseconds(3'600'000);
/// Of a radio's capacity over DDS; its heartbeats, acknowledgements and discovery take the rest.
constexpr double kShareOfSamples = 0.75;
constexpr Duration kToldWaiting = Duration::milliseconds(5'000);
constexpr double kAfterFinish = 2.0;  ///< mission seconds between the end and the clock's end

std::uint64_t incarnation_of_now() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count());
}

class Daemon {
 public:
  Daemon(const Roster& roster, const Member& self, const DaemonConfig& config)
      : roster_(roster),
        self_(self),
        config_(config),
        agreement_(roster, self_, config.scenario,
                   [programs = programs_](const std::string& node) {
                     return programs->description_of(node);
                   }),
        transport_(blackboard::make_dds_transport(
            {config.domain, self.name, config.network, config.on_middleware_log, roster.names(),
             false, handshakes_, config.scenario.empty() ? "" : config.scenario.text(),
             programs_})),
        follower_(config.world ? MissionClock::kSilence : Duration::max()),
        leader_(config.rate),
        heartbeat_(steady_heartbeat(config.heartbeat, config.rate)),
        wakeful_(heartbeat_),
        jobs_([this] { waker_.notify(); }),
        awaited_(config.awaited.begin(), config.awaited.end()) {
    if (!config.world) awaited_.clear();  // nobody says that he is ready: to be heard is enough
    awaited_.erase(self.name);  // it does not hear itself, and waits for itself in any case
    not_there_ = awaited_;
  }

  Result<DaemonEnd, OpenFailure> run(std::unique_ptr<Node> node) {
    transport_->on_arrival([this] { waker_.notify(); });
    HostConfig host_config;
    host_config.world = config_.world;
    host_config.guesses_incarnation = config_.incarnation == 0;
    host_config.incarnation = config_.incarnation > 0 ? config_.incarnation : incarnation_of_now();
    host_config.heartbeat_period = heartbeat_;
    host_config.told = config_.told;
    host_config.rate = config_.rate;
    host_config.capacity = config_.capacity;
    host_config.share_of_samples = kShareOfSamples;
    host_config.seed = config_.seed;
    host_config.memory = config_.memory;
    host_config.leads_clock = config_.leads_clock;
    host_config.forgets = config_.forgets;
    auto host = Host::open(roster_, self_, std::move(node), *transport_, host_config, ports());
    if (!host) return tl::unexpected(host.error());
    host_ = std::move(*host);
    if (config_.companion != nullptr) config_.companion->attach([this] { waker_.notify(); });
    if (config_.leads_clock) hold_where_it_was();
    introduce();
    const DaemonEnd end = loop();
    if (config_.companion != nullptr) config_.companion->detach();
    return end;
  }

 private:
  DaemonEnd loop() {
    while (!waker_.stop_requested()) {
      turn();
      if (config_.on_turn) config_.on_turn(phase());
      tell_what_is_wrong();
      if (over()) return DaemonEnd::kFinished;
      if (is_unmet()) return DaemonEnd::kUnmet;
      if (is_refused()) return DaemonEnd::kOtherScenario;
      waker_.wait(until_next_wakeup());
    }
    return DaemonEnd::kStopped;
  }

  void turn() {
    const bool mute = is_mute();
    wakeful_.run(Waker::steady_now(), mute ? std::nullopt : host_->next_steady_wakeup());
    for (JobDone& done : jobs_.take_done()) host_->job_done(std::move(done), now());
    if (jobs_aside_)
      for (JobDone& done : jobs_aside_->take_done()) host_->job_done(std::move(done), now());
    mute ? host_->listen(now()) : static_cast<void>(host_->step(now()));
    if (!config_.world && !config_.leads_clock) take_time_of_peers();
    if (config_.companion != nullptr) hear_companion();
    if (listening_ && listening_->is_over(Waker::steady_now(), hears_followers())) lead_again();
    // A daemon that is restarted in mid-mission must not live at mission time zero.
    const bool has_time = config_.leads_clock ? !listening_ : clock_heard_;
    if (!host_->started() && has_time) host_->start(now(), is_first_life());
    if (!introduced_as_ready_ && is_ready()) introduce();
    if (config_.leads_clock && !listening_) lead();
    flush_journal();
    host_->lines_have_left();
    if (config_.companion != nullptr) {
      const double rate = config_.leads_clock ? config_.rate : follower_.rate();
      config_.companion->turn({now(), rate, phase()});
    }
  }

  void tell_what_is_wrong() {
    const Duration steady = Waker::steady_now();
    if (steady < next_told_) return;
    const bool holds = phase() == wire::ClockPhase::kHolding;
    if (holds && config_.on_waiting && next_told_ != Duration()) tell_what_it_waits_for();
    if (!holds) tell_who_differs();
    next_told_ = steady + kToldWaiting;
  }

  // Who starts the daemons by hand may have forgotten one.
  void tell_what_it_waits_for() {
    const std::string text = what_it_waits_for();
    if (text != told_waiting_) config_.on_waiting(text);
    told_waiting_ = text;
  }

  // Of a node that was refused, say, while others wonder where it is.
  void tell_who_differs() {
    const std::string text = agreement_.differences();
    if (text == std::exchange(told_differing_, text) || text.empty()) return;
    note(text);
    flush_journal();
  }

  // While somebody differs nobody is ready.
  std::string what_it_waits_for() const {
    const std::string differing = agreement_.differences();
    if (differing.empty()) return whom_it_waits_for();
    if (!config_.leads_clock) return "waits for the mission to start: " + differing;
    return (not_there_.empty() ? "the mission waits: " : whom_it_waits_for() + "; ") + differing;
  }

  std::string whom_it_waits_for() const {
    if (!config_.leads_clock)
      return clock_heard_ ? "waits for the mission to start: not all are ready"
                          : "waits for the mission to start: its clock is not heard";
    if (awaited_.empty()) return "the mission waits until this node hears all of its peers";
    const bool all_there = not_there_.empty();
    std::string names;
    for (const std::string& name : all_there ? awaited_ : not_there_)
      names += (names.empty() ? "" : ", ") + name;
    return "the mission waits for " + names + (all_there ? ", not ready" : ", not heard of");
  }

  /// The clock does not begin before everybody hears it, so that all lives begin with it.
  bool is_ready() const { return host_->started() && host_->all_peers_heard(); }

  bool is_first_life() {
    return config_.first_life || (config_.world && now().mission == MissionTime());
  }

  void hear_companion() {
    const Member* from = roster_.find(config_.companion->speaks_as());
    for (wire::Sample& sample : config_.companion->take()) {
      if (from != nullptr) host_->say(*from, std::move(sample), now());
    }
  }

  Now now() {
    const Duration steady = Waker::steady_now();
    return {config_.leads_clock ? leader_.now(steady) : follower_.now(steady), wakeful_.at(steady)};
  }

  // Before the start theirs is zero.
  void take_time_of_peers() {
    const MissionTime theirs = agreement_.latest(host_->latest_heard());
    if (theirs <= time_of_peers_) return;
    time_of_peers_ = theirs;
    clock_heard_ = true;
    wire::Clock clock;
    clock.time = theirs.count();
    clock.rate = config_.rate;
    clock.phase = wire::ClockPhase::kRunning;
    follower_.update(clock, Waker::steady_now());
  }

  wire::ClockPhase phase() const {
    return config_.leads_clock ? leader_.phase() : follower_.phase();
  }

  bool over() const {
    const Duration steady = Waker::steady_now();
    if (config_.leads_clock) return finished_at_ && steady >= *finished_at_ + kLinger;
    return follower_.phase() == wire::ClockPhase::kFinished;
  }

  // Fast DDS 2.9 goes on with a handshake that was disturbed for ever, and in vain
  // (docs/threats.md).
  bool is_unmet() {
    const bool gives_up =
        !config_.network.keys.empty() && config_.handshake_limit != Duration::max();
    if (!gives_up || phase() != wire::ClockPhase::kHolding) return false;
    for (const auto& [name, lasts] : handshakes_->open(Waker::steady_now())) {
      if (roster_.find(name) == nullptr || name == self_.name) continue;
      const Duration limit = config_.handshake_limit;
      if (lasts < (self_.name > name ? limit : limit + limit)) continue;
      note("the handshake with " + name + " does not end: it takes part anew");
      flush_journal();
      return true;
    }
    return false;
  }

  // Whoever has begun to live did so by the time of those that agree, or leads them.
  bool lives() const {
    if (!config_.leads_clock) return host_->started();
    return listening_ || leader_.phase() != wire::ClockPhase::kHolding;
  }

  // Those with another scenario that fly must not take this node for one that has come back without
  // its memory: it listens until it knows whether they fly.
  bool is_mute() const {
    return !lives() && !agreement_.differences().empty() &&
           agreement_.latest(host_->latest_heard()) == MissionTime();
  }

  bool is_refused() {
    if (lives()) return false;
    const auto why = agreement_.refusal(host_->latest_heard());
    if (!why) return false;
    note(*why);
    flush_journal();
    return true;
  }

  std::optional<Duration> until_next_wakeup() const {
    std::optional<Duration> next;
    const auto sooner = [&](std::optional<Duration> at) {
      if (at && (!next || *at < *next)) next = at;
    };
    const auto due = host_->next_steady_wakeup();
    if (due) sooner(is_mute() ? Waker::steady_now() + kClockPeriod : wakeful_.steady_at(*due));
    if (const auto at = host_->next_mission_wakeup()) {
      sooner(config_.leads_clock ? leader_.steady_at(*at)
                                 : follower_.steady_at(*at, Waker::steady_now()));
    }
    if (config_.leads_clock)
      sooner(listening_ ? listening_->next(Waker::steady_now()) : next_clock_);
    if (!next) return std::nullopt;
    return *next - Waker::steady_now();
  }

  HostPorts ports() {
    HostPorts ports;
    ports.journal = [this](const journal::Record& record, LineMark mark) {
      unsent_records_.push_back({record, mark});
    };
    ports.start_job = [this](StartJob job) { lane_of(job).submit(std::move(job)); };
    ports.stop_job = [this](StopJob job) {
      jobs_.stop(job.id);
      if (jobs_aside_) jobs_aside_->stop(job.id);
    };
    // The leader sees the mission state that another node publishes, or its own says so.
    ports.finish = [this] { finish(); };
    ports.world = [this](const wire::Sample& sample) { take_world(sample); };
    if (config_.companion != nullptr) {
      ports.witness = [this](const wire::Sample& sample) { config_.companion->sees(sample); };
    }
    return ports;
  }

  JobRunner& lane_of(const StartJob& job) {
    if (!job.aside) return jobs_;
    if (!jobs_aside_) jobs_aside_.emplace([this] { waker_.notify(); });
    return *jobs_aside_;
  }

  void take_world(const wire::Sample& sample) {
    const bool is_link = std::holds_alternative<wire::LinkState>(sample);
    if (config_.companion != nullptr && is_link) config_.companion->sees(sample);
    if (const auto* clock = std::get_if<wire::Clock>(&sample)) {
      if (!agreement_.agrees(NodeNumber(clock->header.origin))) return;
      follower_.update(*clock, Waker::steady_now());
      clock_heard_ = true;
    } else if (const auto* entry = std::get_if<wire::DirectoryEntry>(&sample)) {
      not_there_.erase(entry->name);
      if (entry->ready) awaited_.erase(entry->name);
    } else if (const auto* state = std::get_if<wire::MissionState>(&sample)) {
      if (state->finished) finish();
    }
  }

  void finish() {
    if (!finish_at_) finish_at_ = now().mission + Duration::seconds(kAfterFinish);
  }

  // Says who this is, and whether it has heard everybody it must talk with.
  void introduce() {
    wire::DirectoryEntry entry;
    entry.name = self_.name;
    entry.role = self_.role;
    entry.vendor = blackboard::name_of(config_.network.dds);
    entry.ready = introduced_as_ready_ = is_ready();
    entry.process = static_cast<std::uint32_t>(getpid());
    host_->publish(entry, now());
  }

  // A former life had started the clock: the others may have gone on a little, and know best.
  void hold_where_it_was() {
    const auto was = host_->resumed_from();
    if (!was || *was == MissionTime()) return;
    leader_.set(*was, Waker::steady_now());
    listening_.emplace(Waker::steady_now(), std::max(kListens, heartbeat_ + heartbeat_));
  }

  bool hears_followers() const {
    return agreement_.latest(host_->latest_heard()) > *host_->resumed_from();
  }

  void lead_again() {
    const MissionTime was = *host_->resumed_from();
    const MissionTime theirs = agreement_.latest(host_->latest_heard());
    const bool credible = theirs > was && theirs < was + kMostAhead;
    leader_.set(credible ? theirs : was, Waker::steady_now());
    leader_.run(Waker::steady_now());
    listening_.reset();
    record_mission("resumed");
  }

  void lead() {
    const Duration steady = Waker::steady_now();
    const wire::ClockPhase before = leader_.phase();
    const bool may_begin =
        awaited_.empty() && introduced_as_ready_ && agreement_.differences().empty();
    if (before == wire::ClockPhase::kHolding && may_begin) {
      leader_.run(steady);
      record_mission("started");
    } else if (before == wire::ClockPhase::kRunning) {
      const MissionTime at = leader_.now(steady);
      if (at >= config_.time_limit) record_mission("time-limit");
      if (at >= std::min(config_.time_limit, finish_at_.value_or(MissionTime::max()))) {
        leader_.finish(steady);
        finished_at_ = steady;
      }
    }
    if (steady < next_clock_ && leader_.phase() == before) return;
    host_->publish(leader_.sample(steady), now());
    next_clock_ = steady + kClockPeriod;
  }

  void note(const std::string& text) {
    unsent_records_.push_back(
        {journal::record_of(now().mission, self_.name, journal::lines::Notice{.text = text}), {}});
  }

  void record_mission(const char* state) {
    unsent_records_.push_back(
        {journal::record_of(now().mission, self_.name, journal::lines::Mission{state}), {}});
  }

  // Records wait for the end of a turn: publishing one is not part of what it tells of.
  void flush_journal() {
    for (const auto& [record, mark] : std::exchange(unsent_records_, {})) {
      if (config_.on_record) config_.on_record(record, mark);
      if (config_.companion != nullptr) config_.companion->sees(record);
      if (!config_.world) continue;
      wire::JournalEntry entry;
      entry.record = journal::to_json(record);
      entry.line = mark.number;
      host_->publish(entry, now());
    }
  }

  const Roster& roster_;
  const Member self_;
  const DaemonConfig& config_;
  Waker waker_;  // first: it blocks the signals before the middleware makes its threads
  const std::shared_ptr<blackboard::Handshakes> handshakes_ =
      std::make_shared<blackboard::Handshakes>();
  const std::shared_ptr<blackboard::Programs> programs_ = std::make_shared<blackboard::Programs>();
  const Agreement agreement_;
  std::unique_ptr<blackboard::Transport> transport_;
  MissionClock follower_;
  ClockLeader leader_;
  const Duration heartbeat_;  ///< steady
  WakefulTime wakeful_;
  JobRunner jobs_;
  std::optional<JobRunner> jobs_aside_;  ///< made for the first job of the second lane
  std::unique_ptr<Host> host_;
  std::vector<std::pair<journal::Record, LineMark>> unsent_records_;
  bool introduced_as_ready_ = false;
  bool clock_heard_ = false;
  MissionTime time_of_peers_;        ///< the latest, if there is no world
  std::set<std::string> awaited_;    ///< not ready
  std::set<std::string> not_there_;  ///< of them
  Duration next_clock_;
  Duration next_told_;          ///< steady: when to say what it waits for; zero: not yet waited
  std::string told_waiting_;    ///< what was said last
  std::string told_differing_;  ///< likewise, while the mission runs
  std::optional<LeaderListening> listening_;  ///< leader that comes back: then it leads again
  std::optional<MissionTime> finish_at_;
  std::optional<Duration> finished_at_;
};

}  // namespace

Result<DaemonEnd, OpenFailure> run_daemon(const Roster& roster, const Member& self,
                                          std::unique_ptr<Node> node, const DaemonConfig& config) {
  Daemon daemon(roster, self, config);
  return daemon.run(std::move(node));
}

}  // namespace skein::node
