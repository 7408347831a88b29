// SPDX-License-Identifier: Apache-2.0
#include "skein/functional_tool/functional.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "check_node.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/node/daemon.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "skein/scenario/scenario_print.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::functional_tool {

namespace {

/// How long the whole check may take, in mission time.
constexpr Duration kLongest = Duration::milliseconds(3'600'000);
/// In virtual time the layer is killed at this instant, whatever waits for it, and is back after.
constexpr Duration kKilledAt = Duration::milliseconds(1'500'000);
constexpr Duration kAway = Duration::milliseconds(5'000);
/// Over DDS somebody kills it.
constexpr Duration kPatience = Duration::milliseconds(300'000);

conformance::Config config_for(const FunctionalOptions& options, const scenario::UavSpec& uav) {
  conformance::Config config;
  config.height = std::min(options.height, uav.model.ceiling);
  config.reach = options.reach;
  config.near = uav.model.hovers ? options.near : std::max(options.near, 40.0);
  config.hovers = uav.model.hovers;
  if (options.virtual_time) {
    config.restart_within = kKilledAt + kAway;
  } else if (options.restarts) {
    config.restart_within = kPatience;
  }
  if (!uav.model.sensors.empty()) config.device = uav.model.sensors.front().device;
  return config;
}

/// Null, and said why, when there is no such UAV.
const scenario::UavSpec* uav_of(const scenario::Scenario& scenario, const std::string& name,
                                std::ostream& err) {
  if (name.empty() && scenario.uavs.size() == 1) return &scenario.uavs.front();
  if (const scenario::UavSpec* found = scenario.find_uav(name)) return found;
  err << scenario.file << ": "
      << (name.empty() ? "several UAVs: name one by --uav" : "no UAV '" + name + "'")
      << did_you_mean(nearest_name(name, scenario.uav_names())) << '\n';
  return nullptr;
}

class Check {
 public:
  Check(const FunctionalOptions& options, const scenario::Scenario& scenario,
        const scenario::UavSpec& uav, std::ostream& out)
      : options_(options),
        scenario_(scenario),
        uav_(uav),
        whole_(scenario_setup::roster_of(scenario)),
        layer_(uav.functional.empty() ? "sim" : uav.functional),
        roster_(whole_.only({uav.name, layer_})),
        out_(out) {}

  void run_virtually() {
    node::VirtualConfig config = assembly::virtual_config(scenario_);
    config.time_limit = MissionTime() + kLongest;
    config.crashes = {
        {MissionTime() + kKilledAt, layer_, MissionTime() + kKilledAt + kAway, false}};
    const auto make = [this](const std::string& name) {
      return name == uav_.name ? check_node() : assembly::make_node(scenario_, name);
    };
    node::run_virtual(roster_, make, config, [](const journal::Record&) {});
  }

  Result<node::DaemonEnd, node::OpenFailure> run_over_dds() {
    node::DaemonConfig config;
    config.scenario = scenario::print_of(scenario_);
    config.domain = options_.domain;
    config.network = options_.network;
    config.rate = options_.rate;
    config.leads_clock = true;
    config.time_limit = MissionTime() + kLongest;
    return node::run_daemon(roster_, *roster_.find(uav_.name), check_node(), config);
  }

  int conclude() const {
    const auto kept =
        std::count_if(verdicts_.begin(), verdicts_.end(), [](const auto& one) { return one.kept; });
    const bool all = kept == static_cast<std::ptrdiff_t>(verdicts_.size()) && !verdicts_.empty();
    if (options_.json) {
      nlohmann::ordered_json points = nlohmann::ordered_json::array();
      for (const conformance::Verdict& one : verdicts_) {
        points.push_back({{"point", one.point}, {"kept", one.kept}, {"seen", one.seen}});
      }
      out_ << nlohmann::ordered_json{{"uav", uav_.name},
                                     {"layer", layer_},
                                     {"kept", all},
                                     {"points", points}}
                  .dump(2)
           << '\n';
    } else {
      out_ << kept << " of " << verdicts_.size() << " points kept by '" << layer_ << "' for "
           << uav_.name << '\n';
    }
    return all ? kExitOk : kExitNegative;
  }

 private:
  std::unique_ptr<node::Node> check_node() {
    const CheckNode::Place place{uav_.name, whole_.functional_of(whole_.find(uav_.name)->number)};
    return std::make_unique<CheckNode>(
        place, config_for(options_, uav_), [this](const auto& verdict) { tell(verdict); },
        [this] { call_for_restart(); });
  }
  void call_for_restart() {
    if (options_.virtual_time || options_.json) return;
    out_ << "Now kill '" << layer_ << "' and start it again." << std::endl;
  }
  void tell(const conformance::Verdict& one) {
    verdicts_.push_back(one);
    if (options_.json) return;
    out_ << (one.kept ? "kept  " : "NOT   ") << one.point << (one.kept ? "" : ": " + one.seen)
         << std::endl;
  }

  const FunctionalOptions& options_;
  const scenario::Scenario& scenario_;
  const scenario::UavSpec& uav_;
  node::Roster whole_;
  std::string layer_;
  node::Roster roster_;
  std::ostream& out_;
  std::vector<conformance::Verdict> verdicts_;
};

}  // namespace

int check(const FunctionalOptions& options, std::ostream& out, std::ostream& err) {
  const auto scenario = assembly::load_scenario(options.scenario, {});
  if (!scenario) {
    err << to_text(scenario.error());
    return kExitBadInput;
  }
  const scenario::UavSpec* uav = uav_of(*scenario, options.uav, err);
  if (uav == nullptr) return kExitBadInput;
  if (!options.virtual_time && uav->functional.empty()) {
    err << options.scenario << ": '" << uav->name
        << "' is played by the simulator, which leads the clock itself; name a functional layer "
           "of "
           "its own (uavs: "
        << uav->name << ": functional: NAME) or use --virtual\n";
    return kExitBadInput;
  }
  Check check(options, *scenario, *uav, out);
  if (options.virtual_time) {
    check.run_virtually();
    return check.conclude();
  }
  const auto end = check.run_over_dds();
  if (!end) {
    err << "skein: " << end.error().why << '\n';
    return kExitSystem;
  }
  const int code = check.conclude();
  return *end == node::DaemonEnd::kStopped ? kExitInterrupted : code;
}

}  // namespace skein::functional_tool
