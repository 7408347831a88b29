// SPDX-License-Identifier: Apache-2.0
// `skein stn draw` and `skein stn convert`.
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_files/drawing.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_analysis.hpp"
#include "stn_file.hpp"

namespace skein::temporal_tool {

int draw_stn(const StnDrawOptions& options, std::istream& in, std::ostream& out,
             std::ostream& err) {
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const temporal::Stnu& network = read->network;
  const std::optional<Failure> too_large = temporal::too_large_to_draw(network);
  if (!options.dot && too_large) {
    err << input_name(options.common) << ": " << too_large->why << '\n';
    return kExitBadInput;
  }
  temporal::DrawingOptions drawing;
  drawing.title = options.title;
  // A network whose dates overflow is drawn all the same.
  const Result<Consistency, Failure> dates = analyse_consistency(network);
  const Result<Controllability, Failure> control = analyse_controllability(network);
  if (dates) drawing.windows = dates->windows;
  if (control) drawing.conflict = links_of(control->conflict);
  if (options.dot) return save_text(options.output, draw_dot(network, drawing), out, err);
  const Result<std::string, Failure> svg = draw_svg(network, drawing);
  if (!svg) {
    err << input_name(options.common) << ": " << svg.error().why << '\n';
    return kExitBadInput;
  }
  if (network.nodes.size() > temporal::kLegibleNodes) {
    err << "note: " << network.nodes.size()
        << " nodes; the picture is larger than a page; a wide one is folded into strips that are "
           "read from top to bottom\n";
  }
  return save_text(options.output, *svg, out, err);
}

namespace {

// How many bounds are not whole numbers of seconds.
std::size_t fractions_in(const temporal::Stnu& network) {
  std::size_t count = 0;
  const auto look = [&](temporal::Ticks bound) {
    const bool finite = bound != temporal::kInfinite && bound != temporal::kMinusInfinite;
    count += finite && bound % temporal::kTicksPerSecond != 0 ? 1U : 0U;
  };
  for (const temporal::Arc& arc : network.arcs) {
    look(arc.min);
    look(arc.max);
  }
  for (const temporal::ContingentLink& link : network.contingent) {
    look(link.min);
    look(link.max);
  }
  return count;
}

void note_fractions(const temporal::Stnu& network, temporal::Format format, std::ostream& err) {
  if (format != temporal::Format::kGraphml && format != temporal::Format::kPlain) return;
  const std::size_t fractions = fractions_in(network);
  if (fractions == 0) return;
  err << "note: " << fractions
      << (fractions == 1 ? " bound is not a whole number" : " bounds are not whole numbers")
      << " of seconds; the CSTNU Tool reads whole numbers only\n";
}

}  // namespace

int convert_stn(const StnConvertOptions& options, std::istream& in, std::ostream& out,
                std::ostream& err) {
  const std::optional<temporal::Format> format = format_option(options.to, err);
  if (!format) return kExitBadInput;
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const Result<std::string, Failure> text = temporal::write_network(read->network, *format);
  if (!text) {
    err << input_name(options.common) << ": cannot be written as " << options.to << ": "
        << text.error().why << '\n';
    return kExitBadInput;
  }
  note_fractions(read->network, *format, err);
  return save_text(options.output, *text, out, err);
}

}  // namespace skein::temporal_tool
