// SPDX-License-Identifier: Apache-2.0
#include "skein/air/run_air.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>

#include "carrier.hpp"
#include "report.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/waker.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/scenario_text/fault_scripts.hpp"
#include "skein/scenario_text/scenario_text.hpp"

namespace skein::air {

namespace {

namespace fs = std::filesystem;
using node::Waker;

/// Who is on the air, in its order.
std::vector<node::Member> nodes_of(const scenario::Scenario& scenario) {
  const node::Roster roster(scenario.uav_names(), scenario.functional_layers());
  std::vector<node::Member> nodes;
  for (const node::Member& member : roster.members())
    if (member.role == wire::Role::kGround || member.role == wire::Role::kDdn)
      nodes.push_back(member);
  return nodes;
}

std::string text_in(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int write_scenario(const AirOptions& options, std::ostream& err) {
  std::vector<scenario_text::NamedText> files{{options.scenario, text_in(options.scenario)}};
  for (const std::string& file : options.faults) files.push_back({file, text_in(file)});
  if (const auto problems = scenario_text::problems_of(files); !problems.empty()) {
    err << to_text(problems);
    return kExitBadInput;
  }
  std::string text = files[0].text;
  for (std::size_t i = 1; i < files.size(); ++i) {
    auto changed = scenario_text::with_radio(text, files[i].text);
    if (!changed) {
      err << files[i].file << ": " << changed.error().why << '\n';
      return kExitBadInput;
    }
    text = std::move(*changed);
  }
  text = scenario_text::moved(text, fs::absolute(options.scenario).parent_path().string(),
                              fs::absolute(options.write).parent_path().string());
  if (const auto read = scenario::read_scenario_text(text, options.write); !read) {
    err << to_text(scenario_text::as_written(read.error(), options.write, files));
    return kExitBadInput;
  }
  std::ofstream out(options.write, std::ios::binary);
  out << text;
  out.close();
  if (out) return kExitOk;
  err << options.write << ": cannot be written\n";
  return kExitSystem;
}

/// An open descriptor, closed with it.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }
  int number() const { return number_; }

 private:
  int number_;
};

/// SIGINT and SIGTERM, as something to read; no thread that is made after it gets them.
int signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

/// Of no node: nothing is sent to it, and it says nothing.
constexpr blackboard::NodeNumber kSelf(4'000'000'002), kNobody(4'000'000'001);

/// The simulator's words, in the middleware's threads and then here.
class Simulator {
 public:
  explicit Simulator(const AirOptions& options)
      : bell_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
        transport_(
            blackboard::make_dds_transport({options.domain, "air", options.network, {}, {}, {}})) {}

  Result<void, Failure> open() {
    transport_->on_arrival([this] { (void)eventfd_write(bell_.number(), 1); });
    blackboard::ChannelConfig world;
    world.from = kNobody;
    world.to = kSelf;
    world.kind = blackboard::ChannelKind::kRadio;  // one that is only listened to
    world.partition = blackboard::world_channel().partition;
    world.slots = {wire::Slot::kClock, wire::Slot::kLinkState};
    blackboard::TransportPlan plan;
    plan.self = kSelf;
    plan.channels.push_back(std::move(world));
    return transport_->open(plan);
  }
  int bell() const { return bell_.number(); }
  void tell(Weather& weather) {
    eventfd_t ignored = 0;
    (void)eventfd_read(bell_.number(), &ignored);
    for (const blackboard::Arrival& arrival : transport_->take())
      if (const auto* sample = std::get_if<wire::Sample>(&arrival.content)) weather.hear(*sample);
  }

 private:
  Descriptor bell_;  // rung by threads of the transport, which ends first
  std::unique_ptr<blackboard::Transport> transport_;
};

timespec until(std::optional<Duration> next, Duration now) {
  const std::int64_t left = next ? std::max<std::int64_t>((*next - now).count(), 0) : 1'000'000'000;
  return {static_cast<time_t>(left / 1'000'000'000), static_cast<long>(left % 1'000'000'000)};
}

/// Until a signal comes.
void carry(Carrier& carrier, Simulator& simulator, Weather& weather, int signal) {
  std::vector<pollfd> waits{{signal, POLLIN, 0}, {simulator.bell(), POLLIN, 0}};
  for (const Tunnel& tunnel : carrier.tunnels()) waits.push_back({tunnel.descriptor(), POLLIN, 0});
  while (true) {
    const timespec time = until(carrier.next(), Waker::steady_now());
    ppoll(waits.data(), waits.size(), &time, nullptr);
    if ((waits[0].revents & POLLIN) != 0) return;
    if ((waits[1].revents & POLLIN) != 0) simulator.tell(weather);
    for (std::size_t i = 2; i < waits.size(); ++i)
      if ((waits[i].revents & POLLIN) != 0) carrier.take_from(i - 2, Waker::steady_now());
    carrier.deliver(Waker::steady_now());
  }
}

Result<std::vector<Tunnel>, Failure> open_tunnels(const AirOptions& options,
                                                  const std::vector<std::string>& names) {
  std::vector<Tunnel> tunnels;
  for (const std::string& name : names) {
    auto tunnel = Tunnel::open((fs::path(options.spaces) / name).string(), options.interface);
    if (!tunnel) return tl::unexpected(tunnel.error());
    tunnels.push_back(std::move(*tunnel));
  }
  return tunnels;
}

int carry_all(const AirOptions& options, const std::vector<node::Member>& nodes, std::ostream& out,
              std::ostream& err) {
  std::vector<std::string> names;
  std::vector<std::uint32_t> numbers;
  for (const node::Member& node : nodes) {
    names.push_back(node.name);
    numbers.push_back(node.number.value());
  }
  const Descriptor signal(signals());
  auto tunnels = open_tunnels(options, names);
  Simulator simulator(options);
  const auto opened = tunnels ? simulator.open() : tl::unexpected(tunnels.error());
  if (!opened) {
    err << "skein-air: " << opened.error().why << '\n';
    return kExitSystem;
  }
  Air air(names.size(), options.seed, Duration::seconds(options.longest_queue));
  Weather weather(numbers, options.everywhere, air);
  Carrier carrier(air, std::move(*tunnels));
  out << "ready\n" << std::flush;
  const Duration begun = Waker::steady_now();
  carry(carrier, simulator, weather, signal.number());
  if (options.report.empty()) return kExitOk;
  std::ofstream report(options.report);
  report << report_of(air, names, (Waker::steady_now() - begun).to_seconds());
  report.close();
  return report ? kExitOk : kExitSystem;
}

}  // namespace

int run_air(const AirOptions& options, std::ostream& out, std::ostream& err) {
  if (!options.write.empty()) return write_scenario(options, err);
  const auto scenario = scenario::read_scenario(options.scenario);
  if (!scenario) {
    err << to_text(scenario.error());
    return kExitBadInput;
  }
  const std::vector<node::Member> nodes = nodes_of(*scenario);
  if (options.list) {
    for (const node::Member& node : nodes) out << node.name << '\n';
    return kExitOk;
  }
  return carry_all(options, nodes, out, err);
}

}  // namespace skein::air
