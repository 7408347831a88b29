// SPDX-License-Identifier: Apache-2.0
// A small daemon for the tests of run_daemon:
// skein_node_test_daemon DOMAIN NAME FINISH FILE DDS ZONES WORLD
// System of ground, sim and UAV "a"; sim leads the clock at rate 10. Every mission second the node
// writes 50 records; at mission second FINISH (0: never) the ground ends the mission and everybody
// writes 1000 at once, a second later, just before they stop.
// FILE: where every record of this daemon goes, one line each; into FILE.waits what it waits for.
// ZONES: those of the scenario that it flies. WORLD: "on", or "off": the ground leads the clock.
// Exit: 0 finished, 10 stopped, 2 of another scenario, 3 failure.
#include <any>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <latch>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "skein/node/daemon.hpp"
#include "testing/fake_node.hpp"

namespace {

using skein::MissionTime;
using namespace skein::node;  // NOLINT(google-build-using-namespace): a test program of one file

constexpr int kBurst = 50;
constexpr std::uint64_t kAside = 1'000'000;
constexpr int kLastBurst = 1000;  // more than a socket takes at once, less than a writer keeps

class Talker final : public Node {
 public:
  Talker(std::string name, MissionTime finish) : name_(std::move(name)), finish_(finish) {}

  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* done = std::get_if<JobDone>(&input)) {
      const auto* beside = std::any_cast<bool>(&done->result);
      return {note(beside != nullptr && *beside ? "beside" : "job", done->id, now)};
    }
    if (const auto* started = std::get_if<Started>(&input))
      return {note(started->first_life ? "first life" : "another life", 0, now)};
    if (!std::holds_alternative<Wakeup>(input)) return {};
    next_ = next_ + skein::Duration::seconds(1);
    Effects effects;
    const bool last = finish_ > MissionTime() && now >= finish_ + skein::Duration::seconds(1) &&
                      !std::exchange(wrote_last_, true);
    for (int i = 0; i < (last ? kLastBurst : kBurst); ++i)
      effects.push_back(note("tick", ++count_, now));
    // The one in the second lane ends by itself if the one that was asked for after it is done.
    const auto done = std::make_shared<std::latch>(1);
    if (count_ == kBurst) {
      const auto waits = [done](const TimeIsUp& time_is_up) {
        while (!done->try_wait() && !time_is_up()) std::this_thread::yield();
        return std::any(done->try_wait());
      };
      effects.push_back(StartJob{kAside, waits, skein::Duration::seconds(30), true});
    }
    effects.push_back(StartJob{count_, [done](const TimeIsUp&) {
                                 done->count_down();
                                 return std::any();
                               }});
    if (name_ == "ground" && finish_ > MissionTime() && now >= finish_) {
      skein::wire::MissionState state;
      state.finished = true;
      effects.push_back(Publish{state});
      effects.push_back(Finish{});
    }
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override { return next_; }

 private:
  Effect note(const char* what, std::uint64_t number, MissionTime now) const {
    return Log{skein::journal::Record(now, name_, "note")
                   .with("what", what)
                   .with("number", number)
                   .with("padding", std::string(200, '.'))};
  }

  std::string name_;
  MissionTime finish_;
  MissionTime next_ = MissionTime::seconds(1);
  std::uint64_t count_ = 0;
  bool wrote_last_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) return 70;
  const std::string name = argv[2];
  std::ofstream file(argv[4]);
  const Roster roster({"a"});
  DaemonConfig config;
  config.domain = static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
  config.network.dds = skein::blackboard::dds_from_name(argv[5]).value();
  config.rate = 10;
  config.scenario.add("places", 1);
  config.scenario.add("zones", std::strtoul(argv[6], nullptr, 10));
  config.world = std::string(argv[7]) == "on";
  config.leads_clock = name == (config.world ? "sim" : "ground");
  if (config.leads_clock) config.awaited = {"ground", "sim", "a"};
  config.time_limit = MissionTime::seconds(60);
  config.on_record = [&](const skein::journal::Record& record, skein::node::LineMark) {
    file << to_json(record) << "\n" << std::flush;
  };
  config.on_waiting = [waits = std::string(argv[4]) + ".waits"](const std::string& text) {
    std::ofstream(waits, std::ios::app) << text << "\n";
  };
  const MissionTime finish = MissionTime::seconds(std::strtod(argv[3], nullptr));
  const auto end =
      run_daemon(roster, *roster.find(name), std::make_unique<Talker>(name, finish), config);
  if (!end) std::fprintf(stderr, "%s: %s\n", name.c_str(), end.error().why.c_str());
  if (!end) return 3;
  if (*end == DaemonEnd::kOtherScenario) return 2;
  return *end == DaemonEnd::kFinished ? 0 : 10;
}
