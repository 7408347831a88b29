// SPDX-License-Identifier: Apache-2.0
// `skein stn draw` and `skein stn convert`.
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/temporal/drawing.hpp"
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
        << " nodes; the picture is larger than a page, look at it in a viewer that zooms\n";
  }
  return save_text(options.output, *svg, out, err);
}

int convert_stn(const StnConvertOptions& options, std::istream& in, std::ostream& out,
                std::ostream& err) {
  const std::optional<temporal::Format> format = temporal::format_named(options.to);
  if (!format) {
    const std::string nearest = nearest_name(options.to, temporal::format_names());
    err << "--to: unknown format '" << options.to << "'"
        << (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") << '\n';
    return kExitBadInput;
  }
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const Result<std::string, Failure> text = temporal::write_network(read->network, *format);
  if (!text) {
    err << input_name(options.common) << ": cannot be written as " << options.to << ": "
        << text.error().why << '\n';
    return kExitBadInput;
  }
  return save_text(options.output, *text, out, err);
}

}  // namespace skein::temporal_tool
