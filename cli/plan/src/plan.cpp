// SPDX-License-Identifier: Apache-2.0
#include "skein/plan_tool/plan.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <new>
#include <ostream>

#include "library.hpp"
#include "mission_host.hpp"
#include "progress.hpp"
#include "repair.hpp"
#include "report.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn_tools/plan_graph.hpp"
#include "skein/htn_tools/plan_json.hpp"
#include "skein/htn_tools/search_text.hpp"
#include "skein/supervisor/plan_reader.hpp"
#include "validate.hpp"

namespace skein::plan_tool {

namespace {

using htn::Outcome;
using htn::Verdict;

const htn::TextStyle& style_of(bool colour) {
  return colour ? htn::kTerminalText : htn::kPlainText;
}

double asked(const std::function<double()>& question) { return question ? question() : 0; }

/// What the files of a mission come to, as long as the command lasts.
struct Mission {
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::unique_ptr<supervisor::PlannerHost> host;
};

/// Registers the functions of the host; what is wrong is blamed in the library.
Mission mission_of(const PlanOptions& options, Library& library, std::istream& in) {
  Mission mission;
  const MissionFiles& files = options.mission;
  Diagnostics errors;
  mission.knowledge = knowledge_of(files, in, errors);
  const auto world = world_of(files, in, errors);
  if (files.world.empty() != files.vehicle.empty()) {
    Diagnostic one;
    one.message = files.world.empty() ? "a vehicle without a world" : "a world without a vehicle";
    one.expected = "both --world and --vehicle";
    errors.add(one);
  }
  library.blame(errors);
  if (!mission.knowledge || !world) {
    // The names at least, so that the domain is not blamed for what the files are wrong in.
    if (!errors.empty()) supervisor::PlannerHost::declare(library.functions());
    return mission;
  }
  mission.host = std::make_unique<supervisor::PlannerHost>(mission.knowledge, world, MissionTime(),
                                                           std::uint64_t{1});
  mission.host->offer(library.functions());
  return mission;
}

// How much the limit that cut a search allows.
std::string bound_text(const std::string& limit, const htn::Limits& limits) {
  const auto number = [](double value) { return htn::to_text(htn::real(value)); };
  if (limit == "time" && limits.seconds) return " of " + number(*limits.seconds) + " s";
  if (limit == "memory" && limits.memory_bytes) {
    return " of " + number(std::round(static_cast<double>(*limits.memory_bytes) * 1e-6)) + " MB";
  }
  const auto count = limit == "expansions"   ? limits.expansions
                     : limit == "inferences" ? limits.inferences
                     : limit == "depth"      ? limits.depth
                                             : std::nullopt;
  return count ? " of " + std::to_string(*count) : "";
}

/// Plans problem by problem and reports each as soon as it is done.
class Session {
 public:
  Session(Library& library, const Mission& mission, const PlanOptions& options,
          const Surroundings& surroundings, std::ostream& out, std::ostream& err)
      : library_(library),
        mission_(mission),
        options_(options),
        surroundings_(surroundings),
        out_(out),
        err_(err),
        progress_(err, surroundings.cpu_seconds, surroundings.progress && !options.quiet),
        reading_seconds_(asked(surroundings.cpu_seconds)) {}

  void plan(const ChosenProblem& chosen) {
    const htn::Problem problem = htn::make_problem(*chosen.problem, library_.store());
    htn::PlanningReport report;
    report.problem = chosen.problem->name;
    report.domain = chosen.domain->name;
    report.reading_seconds = reading_seconds_;
    progress_.begin(report.problem);
    const double began = asked(surroundings_.cpu_seconds);
    const Outcome outcome =
        htn::plan(*library_.compiled(*chosen.domain), problem, search_options(), host());
    report.seconds = asked(surroundings_.cpu_seconds) - began;
    report.memory_mb = asked(surroundings_.memory_mb);
    progress_.end();
    note(outcome);
    show(report, outcome);
  }

  bool interrupted() const { return surroundings_.interrupted && surroundings_.interrupted(); }

  /// Nothing more can be planned.
  bool out_of_memory() const { return out_of_memory_; }

  /// Whether all graphs could be written.
  bool write_graphs() {
    if (options_.dot.empty()) return true;
    if (options_.dot == "-") {
      out_ << graphs_;
      return true;
    }
    std::ofstream file(options_.dot, std::ios::binary);
    file << graphs_ << std::flush;
    if (!file) err_ << options_.dot << ": cannot be written\n";
    return bool(file);
  }

  int exit_code(bool graphs_written) const {
    if (interrupted()) return kExitInterrupted;
    if (any_error_) return kExitBadInput;
    if (!graphs_written) return kExitSystem;
    if (any_limit_) return kExitTimeout;
    return any_without_plan_ ? kExitNegative : kExitOk;
  }

 private:
  htn::Options search_options() const {
    htn::Options search = options_.search;
    search.trees = options_.tree || !options_.dot.empty();
    search.explain_failure = options_.why_not;
    search.states = options_.states;
    return search;
  }

  htn::Host host() {
    htn::Host host;
    host.cpu_seconds = surroundings_.cpu_seconds;
    host.cancelled = [this] {
      progress_.tick();
      return interrupted();
    };
    host.plan_found = [this](const htn::Plan& plan) { progress_.see(plan); };
    if (options_.trace) {
      host.trace = [this](const htn::TraceEvent& event) {
        const bool aside = options_.json || options_.dot == "-";
        const bool colour = aside ? surroundings_.colour_err : surroundings_.colour_out;
        (aside ? err_ : out_) << htn::to_text(event, library_.store(), style_of(colour));
      };
    }
    return host;
  }

  void note(const Outcome& outcome) {
    out_of_memory_ |= outcome.out_of_memory;
    any_error_ |= outcome.verdict == Verdict::kError;
    any_limit_ |= outcome.verdict == Verdict::kLimit;
    any_without_plan_ |= outcome.verdict == Verdict::kNoPlan;
  }

  void show(const htn::PlanningReport& report, const Outcome& outcome) {
    if (!options_.dot.empty()) draw(report, outcome);
    if (options_.dot == "-") return;
    if (options_.json) {
      const htn::PlanJsonOptions shown{!options_.no_internal, options_.tree, options_.states};
      out_ << htn::to_json(report, outcome, library_.store(), shown) << '\n' << std::flush;
      return;
    }
    if (options_.mission.taskreq && mission_.knowledge && !outcome.plans.empty())
      return show_tasks(outcome);
    const ReportOptions shown{!options_.no_internal, options_.tree, options_.states,
                              style_of(surroundings_.colour_out),
                              bound_text(outcome.why, options_.search.limits)};
    out_ << report_text(report, outcome, library_.store(), shown) << std::flush;
    if (outcome.plans.empty()) show_refusals();
  }

  void show_tasks(const Outcome& outcome) {
    for (const htn::Plan& plan : outcome.plans) {
      const auto tasks =
          supervisor::read_plan(library_.store(), plan, *mission_.knowledge, MissionTime());
      any_error_ |= !tasks.has_value();
      if (tasks)
        out_ << mission::to_taskreq(*tasks) << std::flush;
      else
        err_ << tasks.error().why << '\n';
    }
  }

  void show_refusals() {
    if (!mission_.host) return;
    for (const std::string& why : mission_.host->refusals()) out_ << "  refused: " << why << '\n';
    out_ << std::flush;
  }

  void draw(const htn::PlanningReport& report, const Outcome& outcome) {
    for (const htn::Plan& plan : outcome.plans) {
      const std::string title = report.problem + ", cost " + to_text(plan.cost);
      graphs_ += htn::to_dot(plan, library_.store(), {!options_.no_internal, title});
    }
  }

  Library& library_;
  const Mission& mission_;
  const PlanOptions& options_;
  const Surroundings& surroundings_;
  std::ostream& out_;
  std::ostream& err_;
  Progress progress_;
  double reading_seconds_;
  std::string graphs_;
  bool out_of_memory_ = false;
  bool any_error_ = false;
  bool any_limit_ = false;
  bool any_without_plan_ = false;
};

int plan_all(Session& session, const std::vector<ChosenProblem>& problems) {
  for (const ChosenProblem& problem : problems) {
    session.plan(problem);
    if (session.interrupted() || session.out_of_memory()) break;
  }
  const bool written = session.write_graphs();
  return session.exit_code(written);
}

// Taking apart what was read costs as much as a small plan; the system takes memory back at once.
void leave_to_process(std::unique_ptr<Library> library) {
  static Library* left = nullptr;
  left = library.release();
  (void)left;
}

}  // namespace

int run_plan(const PlanOptions& options, const Surroundings& surroundings, std::istream& in,
             std::ostream& out, std::ostream& err) try {
  auto kept = std::make_unique<Library>(!options.quiet, options.problems);
  Library& library = *kept;
  if (surroundings.process_ends) leave_to_process(std::move(kept));
  library.read(options.files, in);
  const Mission mission = mission_of(options, library, in);
  const std::vector<ChosenProblem> problems = library.choose(options.problems);
  if (options.validate.empty()) library.compile(problems);
  library.check_tasks(options.search.traced_tasks);
  const htn::TextStyle& style = style_of(surroundings.colour_err);
  if (!options.quiet) {
    show(library.warnings(), Severity::kWarning, library.definitions(), style, err);
  }
  show(library.errors(), Severity::kError, library.definitions(), style, err);
  if (!library.errors().empty()) {
    if (options.json) out << to_json_line(library.errors());
    return kExitBadInput;
  }
  if (!options.validate.empty()) {
    return validate_plans(library, problems, options, surroundings, {in, out, err});
  }
  if (!options.repair.empty()) {
    return repair_plan(library, problems, options, surroundings, {in, out, err});
  }
  Session session(library, mission, options, surroundings, out, err);
  return plan_all(session, problems);
} catch (const std::bad_alloc&) {
  Diagnostics errors;
  errors.add({"", 0, 0, "", "out of memory: the system gives no more", "", ""});
  show(errors, Severity::kError, {}, style_of(surroundings.colour_err), err);
  if (options.json) out << to_json_line(errors);
  return kExitTimeout;
}

}  // namespace skein::plan_tool
