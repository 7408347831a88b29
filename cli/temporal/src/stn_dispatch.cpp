// SPDX-License-Identifier: Apache-2.0
// `skein stn dispatch`.
#include <algorithm>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_file.hpp"
#include "stn_report.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::Execution;
using temporal::ExecutionEvent;
using temporal::Stnu;

temporal::StartPolicy policy_of(StnStarts starts) {
  switch (starts) {
    case StnStarts::kEarliest:
      return temporal::StartPolicy::kEarliest;
    case StnStarts::kLatest:
      return temporal::StartPolicy::kLatest;
    case StnStarts::kRandom:
      break;
  }
  return temporal::StartPolicy::kRandom;
}

Execution play(const StnDispatchOptions& options, const temporal::DispatchableNetwork& network) {
  Random durations(options.seed, "durations");
  Random starts(options.seed, "starts");
  return temporal::execute(network, temporal::draw_durations(network.plan, durations),
                           policy_of(options.starts), starts);
}

bool went_well(const Execution& execution) {
  return execution.complete && execution.violated.empty() && execution.contingencies.empty();
}

std::string events_text(const Stnu& network, const Execution& execution, const Paint& paint) {
  std::vector<std::vector<std::string>> rows;
  for (const ExecutionEvent& event : execution.events) {
    const char* how = event.node == network.origin ? "origin"
                      : event.observed             ? "observed"
                                                   : "executed";
    rows.push_back(
        {to_text(event.at), network.nodes[event.node], event.observed ? paint.quiet(how) : how});
  }
  return table_text(rows, "  ");
}

std::string events_json(const Stnu& network, const Execution& execution) {
  std::string text = "[";
  for (const ExecutionEvent& event : execution.events) {
    text += (text.size() > 1 ? ", " : "") + std::string(R"({"at": )") + to_text(event.at) +
            R"(, "node": )" + json_text(network.nodes[event.node]) + R"(, "observed": )" +
            (event.observed ? "true" : "false") + "}";
  }
  return text + "]";
}

void write_execution(const StnDispatchOptions& options, const Stnu& network,
                     const Execution& execution, std::ostream& out) {
  const Paint paint(options.common.colour);
  if (options.common.json) {
    out << R"({"controllable": true, "seed": )" << options.seed << R"(, "complete": )"
        << (execution.complete ? "true" : "false") << R"(, "violated": )"
        << links_json(network, execution.violated) << R"(, "events": )"
        << events_json(network, execution) << "}\n";
    return;
  }
  out << events_text(network, execution, paint);
  if (went_well(execution)) {
    out << paint.good("all requirements kept")
        << paint.quiet("  seed " + std::to_string(options.seed)) << '\n';
  } else {
    out << paint.bad(execution.complete ? "requirements broken:" : "not completed") << '\n'
        << links_text(network, execution.violated);
  }
}

// A controllable network has no dispatchable form when a node must come before the origin, with
// which an execution begins.
int refuse_early_node(const StnDispatchOptions& options, const Stnu& network, std::ostream& out) {
  if (options.common.json) {
    out << R"({"controllable": true, "seed": )" << options.seed
        << R"(, "complete": false, "violated": [], "events": []})" << '\n';
    return kExitNegative;
  }
  const Paint paint(options.common.colour);
  out << paint.bad("not executable") << ": a node must come before '"
      << network.nodes[network.origin] << "', with which an execution begins\n";
  return kExitNegative;
}

// Says what breaks a network that has no dispatchable form.
int refuse(const StnDispatchOptions& options, const Stnu& network, std::ostream& out,
           std::ostream& err) {
  const Result<Controllability, Failure> answer = analyse_controllability(network);
  if (!answer) {
    err << input_name(options.common) << ": " << answer.error().why << '\n';
    return kExitBadInput;
  }
  if (answer->controllable) return refuse_early_node(options, network, out);
  if (options.common.json) {
    out << R"({"controllable": false, "conflict": )" << conflict_json(network, answer->conflict)
        << "}\n";
    return kExitNegative;
  }
  const Paint paint(options.common.colour);
  out << paint.bad("not dynamically controllable") << ": nobody can execute it whatever happens\n"
      << conflict_text(network, answer->conflict, paint);
  return kExitNegative;
}

}  // namespace

int dispatch_stn(const StnDispatchOptions& options, std::istream& in, std::ostream& out,
                 std::ostream& err) {
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const auto network = temporal::make_dispatchable(read->network);
  if (!network && network.error().fault == temporal::StnuFault::kNotControllable) {
    return refuse(options, read->network, out, err);
  }
  if (!network) {
    err << input_name(options.common) << ": " << to_text(network.error(), read->network) << '\n';
    return kExitBadInput;
  }
  const Execution execution = play(options, *network);
  if (!options.common.json) {
    out << input_name(options.common) << ": " << summary_text(*read) << '\n';
  }
  write_execution(options, read->network, execution, out);
  return went_well(execution) ? kExitOk : kExitNegative;
}

}  // namespace skein::temporal_tool
