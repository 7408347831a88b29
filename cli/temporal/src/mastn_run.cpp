// SPDX-License-Identifier: Apache-2.0
// `skein mastn run`.
#include <algorithm>
#include <fstream>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/random.hpp"
#include "skein/mastn_experiment/mastn_experiment.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_lab/mastn_simulation.hpp"
#include "skein/temporal_tool/mastn.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::Algorithm;
using temporal::Mastn;
using temporal::MastnSimulation;
using temporal::Step;
using temporal::Ticks;

// No correct play comes near.
constexpr std::size_t kMostMessages = 100'000'000;
constexpr double kCutChance = 0.2;   // of a cut, at each step
constexpr double kHealChance = 0.3;  // of a return, at each step

std::optional<std::string> read_all(const std::string& name, std::istream& standard_input) {
  try {
    if (name == "-") return std::string(std::istreambuf_iterator<char>(standard_input), {});
    std::ifstream file(name, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
  } catch (const std::ios_base::failure&) {
    return std::nullopt;
  }
}

std::optional<Algorithm> algorithm_named(const std::string& name) {
  for (const Algorithm algorithm : temporal::kAllAlgorithms) {
    if (to_text(algorithm) == name) return algorithm;
  }
  return std::nullopt;
}

// Twice the mean time between steps, so that disturbances meet others still under way.
Ticks longest_delay(const std::vector<Step>& steps) {
  if (steps.size() < 2) return temporal::kTicksPerSecond;
  const Ticks span = steps.back().at / 2 - steps.front().at / 2;
  const Ticks mean = 2 * (span / static_cast<Ticks>(steps.size() - 1));
  return std::max(temporal::kTicksPerSecond, std::min(2 * mean, temporal::kLargest));
}

/// The steps of a file, one after the other, with cuts between them if so asked.
class Play {
 public:
  Play(MastnSimulation simulation, const MastnRunOptions& options)
      : simulation_(std::move(simulation)),
        random_(options.seed, "mastn/cuts"),
        cuts_(options.cuts) {}

  // What went wrong, if anything.
  std::optional<std::string> run(const std::vector<Step>& steps) {
    for (std::size_t number = 0; number < steps.size(); ++number) {
      const Step& step = steps[number];
      if (!simulation_.run_until(MissionTime::nanoseconds(step.at), kMostMessages)) {
        return "the agents do not come to rest before step " + std::to_string(number);
      }
      if (cuts_) cut_or_heal();
      const temporal::ArcUpdate change{step.arc, step.min, step.max};
      if (const auto refusal = simulation_.disturb({&change, 1})) {
        return "steps[" + std::to_string(number) + "]: " + to_text(refusal->error);
      }
    }
    simulation_.heal_all();
    if (!simulation_.settle(kMostMessages)) return "the agents do not come to rest";
    return std::nullopt;
  }

  const MastnSimulation& simulation() const { return simulation_; }

 private:
  void cut_or_heal() {
    const auto links = simulation_.links();
    if (links.empty()) return;
    if (random_.chance(kCutChance)) {
      const auto& [one, other] = links[random_.below(links.size())];
      simulation_.cut(one, other);
      down_.emplace_back(one, other);
    }
    if (!down_.empty() && random_.chance(kHealChance)) {
      const auto chosen = down_.begin() + static_cast<std::ptrdiff_t>(random_.below(down_.size()));
      simulation_.heal(chosen->first, chosen->second);
      down_.erase(chosen);
    }
  }

  MastnSimulation simulation_;
  Random random_;
  bool cuts_;
  std::vector<std::pair<temporal::AgentIndex, temporal::AgentIndex>> down_;
};

std::string seconds(Ticks ticks) {
  if (ticks == temporal::kInfinite || ticks == temporal::kMinusInfinite) return "null";
  return to_text(Duration::nanoseconds(ticks));
}

// By hand, because seconds are exact decimals here.
std::string bounds_json(const Mastn& mastn, const MastnSimulation& simulation) {
  std::string text = "{";
  for (temporal::NodeIndex node = 1; node < mastn.nodes.size(); ++node) {
    text += (node > 1 ? "," : "") + nlohmann::json(mastn.nodes[node]).dump() + ":[" +
            seconds(simulation.earliest(node)) + "," + seconds(simulation.latest(node)) + "]";
  }
  return text + "}";
}

std::string result_json(const Mastn& mastn, const MastnSimulation& simulation) {
  const bool consistent = simulation.consistent() == true;
  const temporal::Traffic& sent = simulation.traffic();
  const nlohmann::ordered_json messages = {{"data", sent.data()},
                                           {"consistency", sent.consistency},
                                           {"disturbances", sent.disturbances},
                                           {"node_updates", sent.node_updates},
                                           {"updates", sent.updates},
                                           {"relaxations", sent.relaxations},
                                           {"macro_packs", sent.macro_packs},
                                           {"macro_arcs", sent.macro_arcs},
                                           {"macro_bounds", sent.macro_bounds},
                                           {"hellos", sent.hellos},
                                           {"lost", sent.lost}};
  const nlohmann::ordered_json checks = {{"total", simulation.checks()},
                                         {"eliminations", simulation.elimination_checks()}};
  return std::string("{\"consistent\":") + (consistent ? "true" : "false") +
         ",\"bounds\":" + (consistent ? bounds_json(mastn, simulation) : "{}") +
         ",\"messages\":" + messages.dump() + ",\"checks\":" + checks.dump() + "}\n";
}

// The network of a file whose steps can be played; what is wrong is told on `err`.
std::optional<Mastn> read_playable(const MastnRunOptions& options, std::istream& in,
                                   std::ostream& err) {
  const std::string name = options.file == "-" ? "standard input" : options.file;
  const std::optional<std::string> text = read_all(options.file, in);
  if (!text) {
    err << name << ": cannot be read\n";
    return std::nullopt;
  }
  Result<Mastn, Diagnostics> mastn = temporal::read_mastn(*text, name);
  if (!mastn) {
    err << to_text(mastn.error());
    return std::nullopt;
  }
  bool playable = true;
  for (std::size_t step = 0; step < mastn->steps.size(); ++step) {
    if (!is_external(*mastn, mastn->arcs[mastn->steps[step].arc])) continue;
    err << name << ": steps[" << step << "]: arc " << mastn->steps[step].arc
        << " is between two agents; such arcs do not change during a mission\n";
    playable = false;
  }
  if (!playable) return std::nullopt;
  return std::move(*mastn);
}

}  // namespace

int run_mastn(const MastnRunOptions& options, std::istream& in, std::ostream& out,
              std::ostream& err) {
  const std::optional<Algorithm> algorithm = algorithm_named(options.algorithm);
  if (!algorithm) {
    err << "unknown algorithm '" << options.algorithm << "'; expected cip, dip-g, dip-l or dip-m\n";
    return kExitBadInput;
  }
  const std::optional<Mastn> mastn = read_playable(options, in, err);
  if (!mastn) return kExitBadInput;
  temporal::TransportOptions transport;
  transport.seed = options.seed;
  if (options.delays) transport.longest_delay = longest_delay(mastn->steps);
  Result<MastnSimulation, temporal::AgentRefusal> simulation =
      MastnSimulation::make(*algorithm, *mastn, transport);
  if (!simulation) {
    err << options.file << ": " << to_text(simulation.error().error) << " ("
        << simulation.error().where << ")\n";
    return kExitBadInput;
  }
  Play play(std::move(*simulation), options);
  if (const std::optional<std::string> wrong = play.run(mastn->steps)) {
    err << options.file << ": " << *wrong << '\n';
    return play.simulation().refusal() ? kExitInternal : kExitBadInput;
  }
  out << result_json(*mastn, play.simulation());
  return kExitOk;
}

}  // namespace skein::temporal_tool
