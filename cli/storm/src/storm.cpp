// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/storm.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/laws/laws.hpp"
#include "skein/mission_lab/generate.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "skein/scenario_text/scenario_text.hpp"
#include "skein/storm_tool/scenario_text.hpp"
#include "skein/storm_tool/series.hpp"
#include "skein/storm_tool/shrink.hpp"
#include "skein/workers/seeds.hpp"
#include "skein/workers/shipped.hpp"
#include "violation_json.hpp"

namespace skein::storm_tool {

namespace {

namespace fs = std::filesystem;
using laws::Violation;

/// A scenario of the user's, and what may happen in it.
struct Base {
  std::string file, yaml, name;
  mission_lab::Stage stage;
};

/// A run that broke laws.
struct Failing {
  Case what;
  std::vector<Violation> violations;
  std::vector<std::string> saved;  ///< files
};

mission_lab::Stage stage_of(const scenario::Scenario& scenario, double until) {
  mission_lab::Stage stage;
  stage.until = until;
  stage.plans = scenario.planning.has_value();
  const node::Roster roster = scenario_setup::roster_of(scenario);
  for (const node::Member& member : roster.members())
    if (member.role != wire::Role::kRunner && member.role != wire::Role::kOperator)
      stage.daemons.push_back(member.name);
  for (const scenario::UavSpec& uav : scenario.uavs) {
    auto& vehicle = stage.vehicles.emplace_back();
    vehicle.name = uav.name;
    for (const auto& sensor : uav.model.sensors) vehicle.devices.push_back(sensor.device);
  }
  return stage;
}

std::string text_of_file(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Storm {
 public:
  Storm(const StormOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err), seeds_(*workers::seeds_of(options.seeds)) {}

  int run() {
    if (const int bad = options_.scenarios.empty() ? find_models() : read_scenarios();
        bad != kExitOk)
      return bad;
    const std::uint64_t each = seeds_.second - seeds_.first + 1;
    all_ = each * std::max<std::size_t>(1, bases_.size());
    judge([this](Case& next) { return draw(next); }, options_.judge,
          [this](const Case& what, const Verdict& verdict) { take(what, verdict); });
    end_progress();
    for (Failing& one : failing_) keep(one);
    options_.json ? tell_json() : tell();
    if (unread_ > 0) return kExitInternal;
    return failing_.empty() ? kExitOk : kExitNegative;
  }

 private:
  // ---- what is played ----

  int find_models() {
    models_ = options_.models.empty() ? workers::shipped_scenarios() : options_.models;
    if (!models_.empty() && fs::exists(fs::path(models_) / "comets" / "models")) return kExitOk;
    err_ << (models_.empty() ? "no models of vehicles found"
                             : models_ + ": no folder comets/models/ in it")
         << "; expected: --models FOLDER, the folder scenarios/ of Skein, or a scenario to play\n";
    return kExitBadInput;
  }

  int read_scenarios() {
    bool good = true;
    for (const std::string& file : options_.scenarios) good = read_scenario(file) && good;
    return good ? kExitOk : kExitBadInput;
  }

  // As it is: how long it takes, and whether it keeps the laws when nothing more goes wrong.
  bool read_scenario(const std::string& file) {
    const auto scenario = assembly::load_scenario(file, {});
    if (!scenario) {
      err_ << to_text(scenario.error());
      return false;
    }
    Base base{file, text_of_file(file), fs::path(file).stem().string(), {}};
    const Case as_it_is{base.name, base.yaml, file};
    const Verdict verdict = judge_one(as_it_is, options_.judge);
    base.stage = stage_of(*scenario, verdict.flown);
    if (!verdict.violations.empty()) failing_.push_back({as_it_is, verdict.violations, {}});
    bases_.push_back(std::move(base));
    return true;
  }

  bool draw(Case& next) {
    if (drawn_ == all_) return false;
    if (bases_.empty()) {
      const std::uint64_t seed = seeds_.first + drawn_++;
      mission_lab::Kinds kinds;
      kinds.deaths = true;
      const auto mission = mission_lab::generate(seed, kinds);
      next = {std::to_string(seed), mission_lab::to_yaml(mission, models_),
              (fs::path(models_) / "drawn.yaml").string()};
      return true;
    }
    const Base& base = bases_[drawn_ % bases_.size()];
    const std::uint64_t seed = seeds_.first + drawn_++ / bases_.size();
    const auto text = with_troubles(base.yaml, seed, mission_lab::draw_troubles(seed, base.stage));
    next = {base.name + "-" + std::to_string(seed), text ? *text : base.yaml, base.file};
    return true;
  }

  void take(const Case& what, const Verdict& verdict) {
    if (!verdict.valid) {
      ++unread_;
      err_ << what.name << " cannot be read: " << verdict.problem << '\n';
      return;
    }
    series_.add(what, verdict);
    if (!verdict.violations.empty()) failing_.push_back({what, verdict.violations, {}});
    show_progress();
  }

  // ---- what is kept ----

  void keep(Failing& failing) {
    if (options_.save.empty()) return;
    std::error_code error;
    fs::create_directories(options_.save, error);
    std::set<std::string> laws;
    for (const Violation& one : failing.violations) {
      if (!laws.insert(one.law).second) continue;
      const fs::path file = fs::path(options_.save) / (one.law + "-" + failing.what.name + ".yaml");
      std::ofstream out(file);
      out << "# " << laws::to_text(one) << '\n' << kept_text(failing.what, one.law);
      if (out.flush()) {
        failing.saved.push_back(file.string());
      } else {
        err_ << file.string() << ": cannot be written\n";
      }
    }
  }

  std::string kept_text(const Case& what, const std::string& law) {
    std::string text = what.yaml;
    if (options_.shrink && !options_.judge.over_dds_at) {
      if (!options_.quiet) err_ << "making " << what.name << " small (" << law << ")\n";
      text = shrunk(text, smaller, [&](const std::string& less) {
        return breaks({what.name, less, what.file}, law);
      });
    }
    return scenario_text::moved(text, fs::absolute(what.file).parent_path().string(),
                                options_.save);
  }

  bool breaks(const Case& less, const std::string& law) const {
    JudgeOptions only = options_.judge;
    only.log.clear();
    only.only = {law == "hang" ? "crash" : law};
    const Verdict verdict = judge_one(less, only);
    return verdict.valid && std::any_of(verdict.violations.begin(), verdict.violations.end(),
                                        [&](const Violation& one) { return one.law == law; });
  }

  // ---- what is told ----

  void show_progress() {
    if (options_.quiet || options_.json) return;
    const auto played = static_cast<std::uint64_t>(series_.missions);
    if (!options_.on_terminal && played % 50 != 0) return;
    const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - began_;
    const double left =
        so_far.count() / static_cast<double>(played) * static_cast<double>(all_ - played);
    err_ << (options_.on_terminal ? "\r" : "") << played << " of " << all_ << " runs, "
         << failing_.size() << " break a law, " << static_cast<long>(left + 0.5) << " s left  "
         << (options_.on_terminal ? "" : "\n") << std::flush;
  }

  void end_progress() {
    if (options_.on_terminal && !options_.quiet && !options_.json) err_ << '\n';
  }

  void tell() {
    print(out_, series_, 3);
    for (const Failing& one : failing_) {
      for (const Violation& violation : one.violations)
        out_ << one.what.name << ": " << laws::to_text(violation) << '\n';
      for (const std::string& file : one.saved) out_ << "  kept: " << file << '\n';
    }
  }

  void tell_json() {
    nlohmann::ordered_json all;
    all["runs"] = series_.missions;
    all["mission_seconds"] = series_.flown;
    all["goals"] = {
        {"all", series_.goals}, {"achieved", series_.achieved}, {"failed", series_.failed}};
    all["failing"] = nlohmann::ordered_json::array();
    for (const Failing& one : failing_) {
      auto& told = all["failing"].emplace_back();
      told["run"] = one.what.name;
      told["violations"] = json_of_violations(one.violations);
      told["kept"] = one.saved;
    }
    out_ << all.dump(2) << '\n';
  }

  const StormOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  const std::pair<std::uint64_t, std::uint64_t> seeds_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::string models_;
  std::vector<Base> bases_;
  std::uint64_t drawn_ = 0, all_ = 0;
  int unread_ = 0;
  Series series_;
  std::vector<Failing> failing_;
};

}  // namespace

int storm(const StormOptions& options, std::ostream& out, std::ostream& err) {
  if (options.list_laws) {
    print_laws(out);
    return kExitOk;
  }
  if (!workers::seeds_of(options.seeds)) {
    err << "--seeds: '" << options.seeds << "', expected A..B, as in 1..300\n";
    return kExitBadInput;
  }
  if (const std::string problem = problem_of_laws(options.judge.only); !problem.empty()) {
    err << problem;
    return kExitBadInput;
  }
  return Storm(options, out, err).run();
}

}  // namespace skein::storm_tool
