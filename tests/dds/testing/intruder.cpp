// SPDX-License-Identifier: Apache-2.0
// A member of a team that negotiates nonsense.
//
//   skein_dds_intruder DOMAIN RATE SELF UAV,UAV… DDS FOREIGN SCENARIO
//
// It is the decision node of SELF on one DDS, as far as the others see it: it is there, keeps time,
// and its events arrive. What it is told in a negotiation it answers with an offer of a role that
// there is not; if it is none of those who negotiate, it tells every other UAV each of kNonsense
// every mission second. Beside it a writer of its own on another DDS (FOREIGN) writes samples in
// its name that are no samples.
//
// Exit: 0 the mission is over, 10 stopped, 3 failure.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <future>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "skein/node/daemon.hpp"
#include "skein/scenario/scenario_print.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "testing/foreign_writer.hpp"

namespace {

using namespace skein;        // NOLINT(google-build-using-namespace): a program of one file
using namespace skein::node;  // NOLINT(google-build-using-namespace)
using Message = wire::NegotiationMessage;

constexpr std::uint32_t kMission = 1;  // every system's
constexpr const char* kSubject =
    "monitoring-with-relay(fire-front fire-center control-center 900) of uav1, uav2";

/// What a UAV says of a session that it opens with others, now, for half a minute.
Message session(const std::string& self, const std::vector<std::string>& others, MissionTime now) {
  Message message;
  message.from = self;
  message.subject = std::string(kSubject) + "/roles";
  message.mission_id = kMission;
  message.modality = "role-allocation";
  message.members = others;
  message.members.push_back(self);  // whose name is the last
  message.opener = self;
  message.opened = now.count();
  message.deadline = (now + Duration::seconds(30)).count();
  for (const std::string& uav : message.members)
    message.entries.push_back({uav, false, {}, wire::NegotiationVow::kNone, 0, "", false});
  return message;
}

/// Of others, of another mission, over, of others' session: each is well formed on the wire.
const std::vector<std::function<void(Message&)>> kNonsense{
    [](Message&) {},  // about what the others negotiate, with one more member
    [](Message& m) { m.opened = 0; },
    [](Message& m) { m.mission_id = 7; },
    [](Message& m) { m.opened -= 900'000'000, m.deadline = m.opened + 100'000'000; },
    [](Message& m) {
      m.members = {m.from, m.from + "x"};
    },
    [](Message& m) {
      m.members.pop_back();
      m.entries.pop_back();
      m.opener = m.members.front();
    },
    [](Message& m) { m.from = m.members.front(); },
    [](Message& m) { m.entries[0].vow = wire::NegotiationVow::kPromised; },
    [](Message& m) { m.subject = "nothing that anybody knows"; },
};

class Intruder final : public Node {
 public:
  Intruder(std::string self, std::vector<std::string> others, const Roster& roster)
      : self_(std::move(self)), others_(std::move(others)), roster_(roster) {}

  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* received = std::get_if<Received>(&input)) return answer(*received);
    if (!std::holds_alternative<Wakeup>(input)) return {};
    next_ = now + Duration::seconds(1);
    if (std::string(kSubject).find(self_) != std::string::npos) return {};
    Effects effects;
    for (const std::string& uav : others_) {
      for (const auto& make : kNonsense) {
        Message message = session(self_, others_, now);
        make(message);
        effects.push_back(to(uav, std::move(message)));
      }
    }
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override { return next_; }

 private:
  Effects answer(const Received& received) const {
    const auto* told = std::get_if<Message>(&received.sample);
    if (told == nullptr || told->opener == self_) return {};
    Message message = *told;
    message.header = {};
    message.from = self_;
    for (wire::NegotiationEntry& entry : message.entries) {
      if (entry.uav != self_) continue;
      entry.offered = true;
      entry.offer = {{"fly-to-the-moon", "", {1}}};
    }
    return {to(told->from, std::move(message))};
  }
  Effect to(const std::string& uav, Message message) const {
    message.to = uav;
    return Send{roster_.find(uav)->number, std::move(message)};
  }

  std::string self_;
  std::vector<std::string> others_;
  const Roster& roster_;
  MissionTime next_ = MissionTime::seconds(1);
};

/// Cut short, and with an enumerator that there is not.
void write_garbage(blackboard::DdsVendor vendor, std::uint32_t domain, const Roster& roster,
                   const std::string& self, const std::string& to,
                   const std::shared_future<void>& over) {
  const auto writer = blackboard::testing::make_foreign_writer(
      vendor, {domain, wire::Slot::kNegotiationMessage, wire::Slot::kNegotiationMessage,
               "radio/" + self + ">" + to});
  Message message = session(self, {to}, {});
  message.header.origin = roster.find(self)->number.value();
  message.header.destination = roster.find(to)->number.value();
  message.header.incarnation = 1;
  message.header.sequence_number = 1;
  message.header.expires = wire::kNever;
  const auto whole = blackboard::testing::bytes_of(message);
  message.entries[0].vow = static_cast<wire::NegotiationVow>(17);
  const auto wrong = blackboard::testing::bytes_of(message);
  constexpr auto kPause = std::chrono::milliseconds(100);
  while (over.wait_for(kPause) == std::future_status::timeout) {
    writer->write({whole.begin(), whole.end() - static_cast<long>(whole.size() / 2)});
    writer->write(wrong);
  }
}

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> all;
  std::istringstream in(names);
  for (std::string name; std::getline(in, name, ',');) all.push_back(name);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) return 2;
  const std::string self = argv[3];
  std::vector<std::string> others = split(argv[4]), all = others;
  all.push_back(self);
  const Roster roster(all);
  DaemonConfig config;
  config.domain = static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
  config.rate = std::strtod(argv[2], nullptr);  // latencies are of mission time
  config.network.dds = blackboard::dds_from_name(argv[5]).value();
  const auto foreign = blackboard::dds_from_name(argv[6]).value();
  const auto scenario = scenario_setup::load_scenario(argv[7], {}, {});
  if (!scenario) std::fprintf(stderr, "%s\n", to_text(scenario.error()).c_str());
  if (!scenario) return 3;
  config.scenario = scenario::print_of(*scenario);

  std::promise<void> end_of_mission;
  const std::shared_future<void> over = end_of_mission.get_future().share();
  std::vector<std::thread> writers;
  for (const std::string& uav : others) {
    writers.emplace_back(
        [&, uav] { write_garbage(foreign, config.domain, roster, self, uav, over); });
  }
  const auto end = run_daemon(roster, *roster.find(self),
                              std::make_unique<Intruder>(self, others, roster), config);
  end_of_mission.set_value();
  for (std::thread& one : writers) one.join();
  if (!end) std::fprintf(stderr, "%s: %s\n", self.c_str(), end.error().why.c_str());
  if (!end) return 3;
  return *end == DaemonEnd::kFinished ? 0 : 10;
}
