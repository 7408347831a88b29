// SPDX-License-Identifier: Apache-2.0
#include "play_dds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include "deaths.hpp"
#include "ears.hpp"
#include "fleet.hpp"
#include "roll_call.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/journal/lines/truth.hpp"
#include "skein/node/mission_clock.hpp"
#include "skein/node/waker.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::run_tool {

namespace {

namespace lines = journal::lines;

using blackboard::Now;

constexpr const char* kRunner = "runner";
constexpr Duration kLook = Duration::milliseconds(100);  ///< between two looks at everything
/// For all daemons to become ready: of hearing nothing new from any of them, and in all.
constexpr Duration kStartLimit = Duration::milliseconds(45'000);
constexpr Duration kStartAtMost = Duration::milliseconds(180'000);
constexpr Duration kClockLimit =
    Duration::milliseconds(15'000);  ///< of silence of the mission clock
/// For the clock's end to be heard, once a daemon has ended by itself.
constexpr Duration kLeaveLimit = Duration::milliseconds(5'000);
constexpr Duration kEndLimit = Duration::milliseconds(15'000);  ///< for the daemons to exit

// ", the machine's load being 9.2 on 2 processors"; why a daemon may have had no turn.
std::string load_of_machine() {
  std::array<double, 1> load{};
  if (getloadavg(load.data(), 1) != 1) return "";
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), ", the machine's load being %.1f on %u processors",
                load[0], std::thread::hardware_concurrency());
  return text.data();
}

blackboard::NetworkConfig network_of(const scenario::Scenario& scenario,
                                     const DdsOptions& options) {
  blackboard::NetworkConfig network;
  network.dds =
      blackboard::dds_from_name(scenario.dds_of(kRunner)).value_or(blackboard::DdsVendor::kFastDds);
  if (!options.keys.empty()) network.keys = options.keys + "/" + kRunner;
  if (!options.interfaces.empty()) network.interfaces = options.interfaces;
  return network;
}

class DdsRun {
 public:
  DdsRun(const scenario::Scenario& scenario, const DdsOptions& options, std::uint32_t domain,
         Progress& progress)
      : progress_(progress),
        roster_(scenario_setup::roster_of(scenario)),
        ears_({domain, kRunner, network_of(scenario, options), {}, roster_.names()}, roster_,
              [this] { waker_.notify(); }),
        fleet_(scenario, options, domain),
        deaths_(scenario.faults.kills, scenario.rate) {}

  Played run() {
    if (auto opened = open(); !opened) return fail(opened.error().why);
    for (const std::string& name : fleet_.names()) {
      if (auto started = start(name); !started) return fail(started.error().why);
    }
    follow();
    wind_up();
    std::stable_sort(played_.records.begin(), played_.records.end(),
                     [](const auto& a, const auto& b) { return a.at() < b.at(); });
    return std::move(played_);
  }

 private:
  struct Left {
    Duration at;  ///< steady
    std::string why;
  };
  struct Introduction {
    std::uint64_t incarnation = 0;
    bool ready = false;
    bool operator==(const Introduction&) const = default;
  };

  Result<void, Failure> open() {
    started_ = heard_news_ = heard_clock_ = node::Waker::steady_now();
    return ears_.open(now());
  }

  Result<void, Failure> start(const std::string& name) {
    const auto started = fleet_.start(name);
    if (started) {
      log(lines::Process{.name = name, .state = "started"});
      roll_call_.started(name, node::Waker::steady_now());
    }
    return started;
  }

  // Until the mission is over, something failed, or the user wants no more.
  void follow() {
    while (true) {
      take_all();
      if (waker_.stop_requested()) return end(Played::End::kInterrupted);
      if (clock_.phase() == wire::ClockPhase::kFinished) {
        return end(time_limit_ ? Played::End::kTimeLimit : Played::End::kFinished);
      }
      if (look_at_processes(false) || look_at_time() || look_at_silent()) return;
      play_faults();
      progress_.show(now().mission);
      waker_.wait(kLook);
    }
  }

  void end(Played::End end) { played_.end = end; }

  Played fail(const std::string& why, bool timed_out = false) {
    played_.end = Played::End::kFailed;
    played_.why = why;
    played_.timed_out = timed_out;
    return played_;
  }

  Now now() {
    const Duration steady = node::Waker::steady_now();
    return {clock_.now(steady), steady};
  }

  void take_all() {
    for (const auto& incoming : ears_.listen(now())) {
      if (const auto* received = std::get_if<blackboard::Received>(&incoming)) take(*received);
      if (const auto* dropped = std::get_if<blackboard::Dropped>(&incoming)) note(*dropped);
    }
  }

  void note(const blackboard::Dropped& dropped) {
    if (!dropped.first) return;
    log(lines::Dropped{.slot = wire::slot_name(dropped.slot),
                       .origin = roster_.name_of(dropped.origin),
                       .field = dropped.field,
                       .why = dropped.why});
  }

  void take(const blackboard::Received& received) {
    if (const auto* clock = std::get_if<wire::Clock>(&received.sample)) {
      if (clock_.phase() == wire::ClockPhase::kHolding &&
          clock->phase == wire::ClockPhase::kRunning) {
        progress_.say("all nodes are ready; the mission starts");
      }
      heard_clock_ = node::Waker::steady_now();
      clock_.update(*clock, heard_clock_);
      if (clock->phase != wire::ClockPhase::kHolding) roll_call_.runs(heard_clock_);
    } else if (const auto* entry = std::get_if<wire::DirectoryEntry>(&received.sample)) {
      const Introduction said{entry->header.incarnation, entry->ready};
      roll_call_.heard(entry->name);
      if (std::exchange(introduced_[entry->name], said) != said)
        heard_news_ = node::Waker::steady_now();
      if (entry->ready && ready_.insert(entry->name).second) {
        log(lines::Process{.name = entry->name, .state = "ready"});
        if (entry->name == "ground") say_console();
      }
    } else if (const auto* line = std::get_if<wire::JournalEntry>(&received.sample)) {
      auto parsed = journal::parse_record(line->record);
      if (!parsed) return;
      time_limit_ =
          time_limit_ || (parsed->kind() == "mission" && parsed->text("state") == "time-limit");
      add(std::move(*parsed));
    }
  }

  void say_console() {
    if (const std::string url = fleet_.console_url(); !url.empty())
      progress_.say("console at " + url);
  }

  void add(journal::Record record) {
    progress_.see(record);
    played_.records.push_back(std::move(record));
  }

  template <class Line>
  void log(Line line) {
    add(journal::record_of(now().mission, kRunner, std::move(line)));
  }

  // Notes the daemons that ended; true if one should not have, or not that way. During the
  // mission none may end but by a scripted kill; after it, all should, with exit code 0, or, told
  // to stop before they could listen to signals, by the signal.
  bool look_at_processes(bool winding_up) {
    for (const Fleet::Ended& ended : fleet_.take_ended()) {
      const bool stopped = told_to_stop_ && ended.status.signal == SIGTERM;
      log(lines::Process{.name = ended.name,
                         .state = ended.crashed() && !stopped ? "crashed" : "exited",
                         .why = to_text(ended.status),
                         .cpu = journal::rounded(ended.status.cpu),
                         .memory = journal::rounded(ended.status.peak_memory)});
      const bool right = ended.killed || stopped || (winding_up && !ended.crashed());
      if (right || played_.end == Played::End::kFailed) continue;
      const std::string why = ended.name + " (" + ended.program +
                              ") died: " + to_text(ended.status) + "; its last lines:\n" +
                              tail_of(ended.log, 5);
      if (!ended.crashed()) {  // it heard that the mission is over before this runner did
        if (!left_) left_ = Left{node::Waker::steady_now(), why};
        continue;
      }
      fail(why);
      return true;
    }
    return false;
  }

  // Each waits for all, so those of whom nothing is heard are to blame.
  std::string not_ready() const {
    const std::vector<std::string> silent = roll_call_.unheard();
    std::vector<std::string> waiting;
    for (const std::string& name : fleet_.names())
      if (ready_.count(name) == 0 && std::count(silent.begin(), silent.end(), name) == 0)
        waiting.push_back(name);
    if (silent.empty()) return joined(waiting, ", ");
    const std::string others = waiting.empty() ? "" : "; waiting: " + joined(waiting, ", ");
    return joined(silent, ", ") + ", of whom nothing is heard" + others;
  }

  bool look_at_time() {
    const Duration steady = node::Waker::steady_now();
    if (clock_.phase() == wire::ClockPhase::kHolding) {
      const bool waits = steady - heard_news_ < kStartLimit && steady - started_ < kStartAtMost;
      if (waits) return false;
      const Duration waited = steady - started_;
      fail("not ready after " + std::to_string(std::lround(waited.to_seconds())) +
               " s: " + not_ready() + load_of_machine(),
           true);
      return true;
    }
    if (left_ && steady - left_->at > kLeaveLimit) {
      fail(left_->why);
      return true;
    }
    if (deaths_.awaits_restart())
      heard_clock_ = steady;  // the leader may be dead because it is to be
    if (steady - heard_clock_ < kClockLimit) return false;
    fail("the mission clock was not heard for " + to_text(kClockLimit) + " s" + load_of_machine(),
         true);
    return true;
  }

  // Of whom nothing is heard though the mission goes on: true if it is given up for that.
  bool look_at_silent() {
    const Duration steady = node::Waker::steady_now();
    const RollCall::Verdict verdict = roll_call_.verdict(steady);
    if (verdict == RollCall::Verdict::kGoOn) return false;
    const std::string names = joined(roll_call_.missing(steady), ", ");
    if (verdict == RollCall::Verdict::kGiveUp) {
      fail("nothing is heard of " + names +
               ", who take part in the mission: records of theirs would be missing" +
               load_of_machine(),
           true);
      return true;
    }
    progress_.say("nothing is heard of " + names + "; listening anew");
    roll_call_.listens_anew(steady);
    if (auto opened = ears_.open(now()); !opened) progress_.say(opened.error().why);
    return false;
  }

  void play_faults() {
    if (clock_.phase() != wire::ClockPhase::kRunning) return;
    const auto stage_of = [this](const std::string& name) { return fleet_.stage_of(name); };
    while (const auto deed = deaths_.next(now().mission, node::Waker::steady_now(), stage_of)) {
      deed->kills ? kill(deed->node) : start_again(*deed);
    }
  }

  void kill(const std::string& name) {
    log(lines::Fault{.what = "kill", .target = name});
    fleet_.kill(name);
    ready_.erase(name);
    roll_call_.killed(name);
  }

  void start_again(const Deaths::Deed& deed) {
    log(lines::Fault{.what = deed.forgets ? "restart" : "resume", .target = deed.node});
    if (deed.forgets) fleet_.forget(deed.node);
    (void)start(deed.node);
  }

  // Lets the daemons end by themselves if the mission is over, asks them to otherwise, and makes
  // them.
  void wind_up() {
    const bool over =
        played_.end == Played::End::kFinished || played_.end == Played::End::kTimeLimit;
    told_to_stop_ = !over;
    if (told_to_stop_) fleet_.signal_all(SIGTERM);
    const Duration limit = node::Waker::steady_now() + kEndLimit;
    while (fleet_.any_running() && node::Waker::steady_now() < limit) {
      waker_.wait(kLook);
      take_all();
      (void)look_at_processes(true);
    }
    if (fleet_.any_running() && over) {
      fail("still running " + to_text(kEndLimit) + " s after the end: " + fleet_.running_names(),
           true);
    }
    fleet_.kill_all();
    take_all();
    const auto missing = roll_call_.missing(node::Waker::steady_now());
    if (over && played_.end != Played::End::kFailed && !missing.empty())
      fail("nothing was heard of " + joined(missing, ", ") + ": records of theirs are missing",
           true);
  }

  Progress& progress_;
  node::Roster roster_;
  node::Waker waker_;  // before the transport: it blocks signals for the middleware's threads too
  Ears ears_;
  RollCall roll_call_;
  node::MissionClock clock_;
  Fleet fleet_;
  Deaths deaths_;
  std::optional<Left> left_;  ///< the first daemon that ended by itself before the clock did here
  std::set<std::string> ready_;
  std::map<std::string, Introduction> introduced_;  ///< by name, the last
  Duration started_;
  Duration heard_news_;  ///< of a daemon that starts
  Duration heard_clock_;
  bool time_limit_ = false;
  bool told_to_stop_ = false;  ///< the daemons, by a signal
  Played played_;
};

}  // namespace

Played play_dds(const scenario::Scenario& scenario, const DdsOptions& options, Progress& progress) {
  std::optional<blackboard::DomainLease> lease;
  std::uint32_t domain = options.domain.value_or(0);
  if (!options.domain) {
    auto claimed = blackboard::claim_domain();
    if (!claimed) {
      Played failed;
      failed.end = Played::End::kFailed;
      failed.why = claimed.error().why;
      return failed;
    }
    lease.emplace(std::move(*claimed));
    domain = lease->domain();
  }
  const std::size_t daemons = Fleet(scenario, options, domain).names().size();
  progress.say("starting " + std::to_string(daemons) + " daemons on DDS domain " +
               std::to_string(domain));
  return DdsRun(scenario, options, domain, progress).run();
}

}  // namespace skein::run_tool
