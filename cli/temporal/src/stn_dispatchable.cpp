// SPDX-License-Identifier: Apache-2.0
// `skein stn dispatchable`.
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_files/dispatchable_text.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_analysis.hpp"
#include "stn_file.hpp"
#include "stn_report.hpp"

namespace skein::temporal_tool {

namespace {

// Says why there is no form, on `err`: the form alone goes to `out`.
int refuse(const StnOptions& options, const temporal::Stnu& network,
           const temporal::StnuError& error, std::ostream& err) {
  err << input_name(options) << ": ";
  if (error.fault != temporal::StnuFault::kNotControllable) {
    err << to_text(error, network) << '\n';
    return kExitBadInput;
  }
  const Result<Controllability, Failure> answer = analyse_controllability(network);
  if (answer && answer->controllable) {
    err << "no dispatchable form: a node must come before '" << network.nodes[network.origin]
        << "', with which an execution begins\n";
  } else {
    err << "no dispatchable form: not dynamically controllable\n";
    if (answer) err << conflict_text(network, answer->conflict, Paint(false));
  }
  return kExitNegative;
}

}  // namespace

int write_stn_dispatchable(const StnDispatchableOptions& options, std::istream& in,
                           std::ostream& out, std::ostream& err) {
  const std::optional<temporal::Format> format = format_option(options.to, err);
  if (!format) return kExitBadInput;
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const auto form = temporal::make_dispatchable(read->network);
  if (!form) return refuse(options.common, read->network, form.error(), err);
  const Result<std::string, Failure> text = temporal::write_dispatchable(*form, *format);
  if (!text) {
    err << input_name(options.common) << ": cannot be written as " << options.to << ": "
        << text.error().why << '\n';
    return kExitBadInput;
  }
  return save_text(options.output, *text, out, err);
}

}  // namespace skein::temporal_tool
