// SPDX-License-Identifier: Apache-2.0
// `skein stn dc --changes`: the incremental check, as a command.
#include <algorithm>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal/incremental_controllability.hpp"
#include "skein/temporal_files/drawing.hpp"
#include "skein/temporal_files/link_changes.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_analysis.hpp"
#include "stn_file.hpp"
#include "stn_report.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::Arc;
using temporal::DcResult;
using temporal::IncrementalDc;
using temporal::Stnu;
using temporal::StnuError;

// Bounds of a contingent link between these nodes, or of the arc between them in either direction,
// or of one more arc.
Result<DcResult, StnuError> apply(IncrementalDc& kept, const Arc& change) {
  const Stnu& network = kept.network();
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const temporal::ContingentLink& link = network.contingent[i];
    if (link.activation == change.from && link.contingent == change.to) {
      return kept.change_contingent(i, change.min, change.max);
    }
  }
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (arc.from == change.from && arc.to == change.to) {
      return kept.change_arc(i, change.min, change.max);
    }
  }
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (arc.from == change.to && arc.to == change.from) {
      return kept.change_arc(i, -change.max, -change.min);
    }
  }
  return kept.add_arc(change);
}

/// Plays the changes and says what comes of each.
class Changes {
 public:
  Changes(const StnChangesOptions& options, IncrementalDc kept, std::ostream& out)
      : options_(options), kept_(std::move(kept)), out_(out), paint_(options.common.colour) {}

  // What is wrong with a change, if anything.
  std::optional<std::string> play(const std::vector<Arc>& changes) {
    say("as it is", kept_.result(), 0);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const double begin = now();
      const Result<DcResult, StnuError> result = apply(kept_, changes[i]);
      const double seconds = now() - begin;
      if (!result)
        return "[" + std::to_string(i) + "]: " + to_text(result.error(), kept_.network());
      total_ += seconds;
      say(what(changes[i]), *result, seconds);
      if (options_.compare) compare(*result);
    }
    finish(changes.size());
    return std::nullopt;
  }

  bool controllable() const { return kept_.result().controllable; }
  bool agree() const { return disagreements_ == 0; }

 private:
  double now() const { return options_.common.now ? options_.common.now() : 0; }

  std::string what(const Arc& change) const {
    const std::vector<std::string>& names = kept_.network().nodes;
    return names[change.from] + " → " + names[change.to] + " " +
           temporal::bounds_text(change.min, change.max);
  }

  void say(const std::string& change, const DcResult& result, double seconds) {
    std::vector<ConflictPart> conflict;
    for (const temporal::ConflictTerm& term : result.conflict) {
      const bool min = term.bound == decltype(term.bound)::kMin;
      conflict.push_back({term.link, min ? LinkBound::kMin : LinkBound::kMax});
    }
    if (options_.common.json) {
      std::string text = verdict_json(kept_.network(),
                                      {result.consistent, result.controllable, conflict, seconds});
      out_ << text.insert(1, "\"change\": " + json_text(change) + ", ") << '\n';
      return;
    }
    const std::string word =
        result.controllable ? paint_.good("controllable")
                            : paint_.bad(result.consistent ? "not controllable" : "inconsistent");
    out_ << change << ": " << word << paint_.quiet("  " + duration_text(seconds)) << '\n'
         << conflict_text(kept_.network(), conflict, paint_);
  }

  void compare(const DcResult& kept) {
    const double begin = now();
    const auto anew = temporal::check_dynamic_controllability(kept_.network());
    from_scratch_ += now() - begin;
    const bool same =
        anew && anew->controllable == kept.controllable && anew->consistent == kept.consistent;
    disagreements_ += same ? 0U : 1U;
  }

  void finish(std::size_t count) {
    if (options_.common.json) return;
    out_ << count << (count == 1 ? " change in " : " changes in ") << duration_text(total_);
    if (options_.compare) {
      out_ << "; from scratch each time " << duration_text(from_scratch_) << ", "
           << (agree() ? "the same verdicts" : std::to_string(disagreements_) + " OTHER VERDICTS");
    }
    out_ << '\n';
  }

  const StnChangesOptions& options_;
  IncrementalDc kept_;
  std::ostream& out_;
  Paint paint_;
  double total_ = 0;
  double from_scratch_ = 0;
  std::size_t disagreements_ = 0;
};

}  // namespace

int follow_stn_changes(const StnChangesOptions& options, std::istream& in, std::ostream& out,
                       std::ostream& err) {
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const std::optional<std::string> text = text_of_file(options.changes);
  if (!text) {
    err << options.changes << ": cannot be read\n";
    return kExitBadInput;
  }
  const auto changes = temporal::read_changes(*text, read->network, options.changes);
  if (!changes) {
    err << to_text(changes.error());
    return kExitBadInput;
  }
  Result<IncrementalDc, StnuError> kept = IncrementalDc::create(read->network);
  if (!kept) {
    err << input_name(options.common) << ": " << to_text(kept.error(), read->network) << '\n';
    return kExitBadInput;
  }
  Changes player(options, std::move(*kept), out);
  if (const std::optional<std::string> wrong = player.play(*changes)) {
    err << options.changes << ": " << *wrong << '\n';
    return kExitBadInput;
  }
  if (!player.agree()) return kExitInternal;
  return player.controllable() ? kExitOk : kExitNegative;
}

}  // namespace skein::temporal_tool
