// SPDX-License-Identifier: Apache-2.0
#include "random_missions/command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/laws/laws.hpp"
#include "skein/mission_lab/generate.hpp"
#include "skein/mission_lab/rough_ground.hpp"
#include "skein/mission_lab/troubles.hpp"
#include "skein/storm_tool/series.hpp"
#include "skein/storm_tool/shrink.hpp"
#include "skein/storm_tool/storm.hpp"
#include "skein/workers/seeds.hpp"

namespace skein::mission_lab {

namespace {

using laws::Violation;
using storm_tool::Case;
using storm_tool::judge_one;
using storm_tool::JudgeOptions;
using storm_tool::Series;
using storm_tool::Verdict;

struct Options {
  bool laws = false, show = false;
  std::string seeds = "1..100";
  std::vector<std::string> files, without;
  std::string save, consistency;
  bool clean = false, deaths = false, team = false, crossing = false, merged = false,
       unmerged = false, sweeps = false, meetings = false, orders = false, gatherings = false,
       robots = false, relays = false, partners = false, sharing = false, fires = false,
       hands = false, mixed = false, anything = false, minds = false, busy = false,
       sweepers = false, closures = false, escorts = false, long_deaths = false, json = false,
       minimise = false, rough = false, verbose = false;
  std::size_t examples = 3;
  std::int64_t capacity = 0;
  double planning_takes = 0;
  JudgeOptions judge;
};

Kinds kinds_of(const Options& options) {
  Kinds kinds = options.clean ? kClean : Kinds{};
  kinds.deaths = options.deaths;
  kinds.merged = !options.unmerged;
  if (!options.consistency.empty()) kinds.consistency = options.consistency;
  kinds.gatherings = options.gatherings;
  kinds.orders = options.orders;
  kinds.sweeps = options.sweeps;
  kinds.minds = options.minds;
  kinds.busy = options.busy;
  for (const std::string& name : options.without) {
    if (name == "faults") kinds.faults = false;
    if (name == "air") kinds.air = false;
    if (name == "deadlines") kinds.deadlines = false;
    if (name == "changes") kinds.changes = false;
    if (name == "degrees") kinds.degrees = false;
    if (name == "radio") kinds.radio = false;
    if (name == "energy") kinds.energy = false;
    if (name == "alarms") kinds.alarms = false;
    if (name == "questions") kinds.questions = false;
  }
  return kinds;
}

Mission drawn_as_kind(std::uint64_t seed, const Options& options) {
  if (options.meetings) return generate_meetings(seed, kinds_of(options));
  if (options.partners) return generate_partners(seed, kinds_of(options));
  if (options.closures) return generate_closures(seed, kinds_of(options));
  if (options.sharing) return generate_sharing(seed, kinds_of(options));
  if (options.escorts) return generate_escorts(seed, kinds_of(options));
  if (options.relays) return generate_relays(seed, kinds_of(options));
  if (options.fires) return generate_fires(seed, kinds_of(options));
  if (options.hands) return generate_orders(seed, kinds_of(options));
  if (options.anything) return generate_anything(seed, kinds_of(options));
  if (options.mixed) return generate_mixed(seed, kinds_of(options));
  if (options.robots) return generate_robots(seed, kinds_of(options));
  if (options.sweepers) return generate_sweeps(seed, kinds_of(options));
  if (options.crossing) return generate_crossing(seed, kinds_of(options));
  return options.team ? generate_team(seed, kinds_of(options)) : generate(seed, kinds_of(options));
}

Mission drawn(std::uint64_t seed, const Options& options) {
  Mission mission = drawn_as_kind(seed, options);
  if (options.merged) mission.separation = "{merge: true}";
  if (options.unmerged) mission.separation = "{merge: false}";
  if (options.rough) roughen(mission);
  if (options.long_deaths) let_die_for_long(mission);
  mission.planning_takes = options.planning_takes;
  if (options.capacity > 0) {
    std::erase_if(mission.radio, [](const auto& one) { return one.starts_with("capacity:"); });
    mission.radio.push_back("capacity: " + std::to_string(options.capacity));
  }
  return mission;
}

// The models as seen from where the scenario stands.
std::string scenarios_from(const std::string& folder) {
  namespace fs = std::filesystem;
  return fs::proximate(fs::path(SKEIN_SOURCE_DIR) / "scenarios", fs::absolute(folder)).string();
}

Case case_of(const Mission& mission) {
  const std::string folder = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets";
  return {std::to_string(mission.seed), to_yaml(mission, ".."), folder + "/random.yaml"};
}

bool breaks(const Mission& mission, const std::string& law, JudgeOptions options) {
  if (law != "hang") options.only = {law};
  if (law == "crash" || law == "hang") options.only = {"crash"};
  const Verdict verdict = judge_one(case_of(mission), options);
  return verdict.valid && std::any_of(verdict.violations.begin(), verdict.violations.end(),
                                      [&](const Violation& one) { return one.law == law; });
}

Mission minimised(const Mission& mission, const std::string& law, const JudgeOptions& options) {
  return storm_tool::shrunk(mission, smaller,
                            [&](const Mission& less) { return breaks(less, law, options); });
}

void save(const Options& options, const Mission& mission, const Verdict& verdict) {
  std::filesystem::create_directories(options.save);
  std::set<std::string> laws;
  for (const Violation& one : verdict.violations) {
    if (!laws.insert(one.law).second) continue;
    const Mission kept = options.minimise && !options.judge.over_dds_at
                             ? minimised(mission, one.law, options.judge)
                             : mission;
    std::ofstream out(options.save + "/" + one.law + "-" + std::to_string(mission.seed) + ".yaml");
    out << "# " << laws::to_text(one) << '\n' << to_yaml(kept, scenarios_from(options.save));
  }
}

int run_seeds(const Options& options, std::uint64_t first, std::uint64_t last) {
  Series series;
  std::uint64_t seed = first;
  const auto next = [&](Case& one) {
    if (seed > last) return false;
    one = case_of(drawn(seed++, options));
    return true;
  };
  judge(next, options.judge, [&](const Case& what, const Verdict& verdict) {
    if (!verdict.valid) {
      std::cerr << "mission " << what.name << " cannot be read: " << verdict.problem << '\n';
      std::exit(kExitInternal);
    }
    series.add(what, verdict);
    if (options.verbose && !options.json) {
      for (const Violation& one : verdict.violations)
        std::cout << what.name << ": " << laws::to_text(one) << '\n';
    }
    if (options.json) print_json(std::cout, what, verdict);
    if (!options.save.empty() && !verdict.violations.empty()) {
      save(options, drawn(std::stoull(what.name), options), verdict);
    }
    if (series.missions % 50 == 0) {
      std::cerr << series.missions << " of " << last - first + 1 << ", " << series.broken
                << " break a law\n";
    }
  });
  if (!options.json) print(std::cout, series, options.examples);
  return series.broken == 0 ? kExitOk : kExitNegative;
}

int run_files(const Options& options) {
  Series series;
  std::size_t i = 0, unreadable = 0;
  const auto refuse = [&](const std::string& file, const std::string& problem) {
    std::cerr << file << ": " << problem << '\n';
    ++unreadable;
  };
  const auto next = [&](Case& one) {
    for (; i < options.files.size(); ++i) {
      const std::string& file = options.files[i];
      std::ifstream in(file);
      one = {file, std::string(std::istreambuf_iterator<char>(in), {}), file};
      if (in.is_open() && !in.bad()) return ++i, true;
      refuse(file, "cannot be read");
    }
    return false;
  };
  judge(next, options.judge, [&](const Case& what, const Verdict& verdict) {
    if (!verdict.valid) return refuse(what.name, verdict.problem);
    series.add(what, verdict);
    if (options.json) return print_json(std::cout, what, verdict);
    for (const Violation& one : verdict.violations)
      std::cout << what.name << ": " << laws::to_text(one) << '\n';
  });
  if (!options.json && series.missions > 0) print(std::cout, series, options.examples);
  if (unreadable == 0) return series.broken == 0 ? kExitOk : kExitNegative;
  std::cerr << unreadable << " of " << options.files.size() << " scenarios were not played\n";
  return kExitBadInput;
}

void declare_kinds(CLI::App& app, Options& options) {
  auto* team = app.add_flag("--team", options.team, "teams at degree 5 with a global mission");
  auto* crossing =
      app.add_flag("--crossing", options.crossing, "teams at degree 4 whose ways cross");
  app.add_flag("--sweeps", options.sweeps, "with --crossing: some map or search what lies between")
      ->needs(crossing);
  auto* merged = app.add_flag("--merged", options.merged, "UAVs of any kind merge their ways");
  app.add_flag("--unmerged", options.unmerged, "nobody asks for his air, and it is judged")
      ->excludes(merged);
  auto* meetings =
      app.add_flag("--meetings", options.meetings, "UAVs at degree 4 that meet each other");
  app.add_option("--consistency", options.consistency,
                 "with --meetings: how plans are kept consistent in time between UAVs")
      ->check(CLI::IsMember({"dip-m", "dip-l", "dip-g", "cip", "none"}));
  app.add_flag("--gatherings", options.gatherings, "with --meetings: and joint tasks of two")
      ->needs("--meetings");
  app.add_flag("--orders", options.orders, "with --meetings: at one height, ways are merged")
      ->needs("--meetings");
  auto* sweepers = app.add_flag("--sweepers", options.sweepers,
                                "UAVs search and map areas beside and over each other");
  auto* robots =
      app.add_flag("--robots", options.robots, "some of the vehicles keep to the ground");
  auto* relays =
      app.add_flag("--relays", options.relays, "some of the UAVs are heard past relays alone");
  auto* apart = app.add_flag("--partners", options.partners,
                             "partners of joint tasks and synchronisations die or are cut off");
  auto* sharing = app.add_flag("--sharing", options.sharing,
                               "UAVs map areas together, of which somebody leaves or comes late");
  auto* escorts = app.add_flag("--escorts", options.escorts,
                               "UAVs watch, escort or pursue together what moves; for some the "
                               "ground station plays");
  auto* closures = app.add_flag("--closures", options.closures,
                                "air closes over places, pads and areas, and opens again");
  auto* fires =
      app.add_flag("--fires", options.fires, "fires spread, and their fronts are followed");
  auto* hands = app.add_flag("--hands", options.hands,
                             "operators give elementary tasks, wrong ones too, at degrees 1 to 3");
  auto* mixed =
      app.add_flag("--mixed", options.mixed,
                   "all of it in one mission: a team, others at degree 4, vehicles on the "
                   "ground, relays, fires, operators");
  auto* anything = app.add_flag("--anything", options.anything,
                                "as an outsider writes them: all kinds of vehicles at degrees 2 to "
                                "5, and whatever the format of scenarios offers");
  app.add_flag(
         "--minds", options.minds,
         "with --anything: people change theirs: missions are cancelled and given again, UAVs "
         "taken in hand in every order, places moved")
      ->needs(anything);
  app.add_flag("--busy", options.busy,
               "with --anything: an operator flies UAVs by hand in the middle of their tasks, "
               "stops them to think, aborts all, closes and opens air")
      ->needs(anything);
  const std::vector<CLI::Option*> all{team,   crossing, sweepers, meetings, robots,
                                      relays, apart,    sharing,  closures, fires,
                                      hands,  mixed,    anything, escorts};
  for (auto* one : all)
    for (auto* other : all)
      if (one != other) one->excludes(other);
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--seeds", options.seeds, "A..B: one mission each");
  app.add_option("--law", options.judge.only, "only this law (crash is one); may be repeated")
      ->allow_extra_args(false);
  app.add_option("--capacity", options.capacity,
                 "of every link in each direction, in bit/s; as drawn without it")
      ->check(CLI::Range(std::int64_t{1'000}, std::int64_t{1'000'000'000}));
  app.add_option("--planning-takes", options.planning_takes,
                 "each job of planning takes 0.05 s to so many seconds; 0.05 s without it")
      ->check(CLI::Range(0.05, 60.0));
  app.add_flag("--rough", options.rough, "over mountains, of whatever kind they are");
  app.add_flag("--clean", options.clean, "missions in which nothing goes wrong");
  app.add_flag("--deaths", options.deaths,
               "daemons die in them, up to three times, and come back with what they knew");
  app.add_flag("--long-deaths", options.long_deaths,
               "one or two decision nodes die for minutes, and come back with what they knew")
      ->excludes("--deaths");
  declare_kinds(app, options);
  app.add_option("--without", options.without,
                 "leave out: faults air deadlines changes degrees radio energy alarms questions")
      ->check(CLI::IsMember({"faults", "air", "deadlines", "changes", "degrees", "radio", "energy",
                             "alarms", "questions"}));
  app.add_option("--save", options.save, "keep missions that break a law in this folder");
  app.add_flag("--minimise", options.minimise, "with --save: leave out what can be left out");
  app.add_option("--log", options.judge.log, "keep the event log of each mission in this folder");
  app.add_option("--jobs", options.judge.jobs, "how many at once")->check(CLI::Range(1, 64));
  app.add_option("--over-dds", options.judge.over_dds_at,
                 "by daemons over DDS, at so many mission seconds a second")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--patience", options.judge.patience, "seconds of processor time for one")
      ->check(CLI::Range(1, 3600));
  app.add_option("--examples", options.examples, "seeds to name for each law");
  app.add_flag("--laws", options.laws, "list the laws");
  app.add_flag("--show", options.show, "write the missions drawn instead of playing them");
  app.add_flag("--json", options.json, "a line for each violation");
  app.add_flag("--verbose", options.verbose, "each violation as a sentence");
  app.add_option("files", options.files, "judge these scenario files instead of drawing missions");
}

}  // namespace

int command(int argc, char** argv) {
  CLI::App app(
      "Draws missions, plays them in virtual time and judges them by the laws of libs/laws.");
  Options options;
  declare(app, options);
  CLI11_PARSE(app, argc, argv);
  if (options.laws) {
    storm_tool::print_laws(std::cout);
    return kExitOk;
  }
  if (const auto problem = storm_tool::problem_of_laws(options.judge.only); !problem.empty()) {
    std::cerr << problem;
    return kExitBadInput;
  }
  if (!options.files.empty()) return run_files(options);
  const auto seeds = workers::seeds_of(options.seeds);
  if (!seeds) {
    std::cerr << "--seeds: '" << options.seeds << "', expected A..B, as in 1..300\n";
    return kExitBadInput;
  }
  if (options.show) {
    for (auto seed = seeds->first; seed <= seeds->second; ++seed) {
      std::cout << to_yaml(drawn(seed, options), scenarios_from("."));
    }
    return kExitOk;
  }
  return run_seeds(options, seeds->first, seeds->second);
}

}  // namespace skein::mission_lab
