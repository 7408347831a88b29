// SPDX-License-Identifier: Apache-2.0
// `skein stn check` and `skein stn dc`.
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_file.hpp"
#include "stn_report.hpp"

namespace skein::temporal_tool {

namespace {

// What `analyse` gives, and how long that took [s].
template <class Analyse>
auto timed(const StnOptions& options, const Analyse& analyse) {
  const double begin = options.now ? options.now() : 0;
  auto answer = analyse();
  const double end = options.now ? options.now() : 0;
  return std::pair(std::move(answer), end - begin);
}

std::string dates_text(const temporal::Stnu& network, const Consistency& answer,
                       const Paint& paint) {
  std::vector<std::vector<std::string>> rows{{"node", "earliest", "latest"}};
  for (std::size_t i = 0; i < answer.windows.size(); ++i) {
    rows.push_back({network.nodes[i], seconds_or_infinite(answer.windows[i].earliest),
                    seconds_or_infinite(answer.windows[i].latest)});
  }
  return rows.size() > 1 ? paint.quiet("dates [s]") + "\n" + table_text(rows, "  ") : "";
}

// {"a": [0, 12.5], …}; null while inconsistent.
std::string dates_json(const temporal::Stnu& network, const Consistency& answer) {
  if (!answer.consistent) return "null";
  std::string text = "{";
  for (std::size_t i = 0; i < answer.windows.size(); ++i) {
    text += (i > 0 ? ", " : "") + json_text(network.nodes[i]) + ": [" +
            json_seconds(answer.windows[i].earliest) + ", " +
            json_seconds(answer.windows[i].latest) + "]";
  }
  return text + "}";
}

void write_head(const StnOptions& options, const temporal::ReadNetwork& read, std::ostream& out) {
  out << input_name(options) << ": " << summary_text(read) << '\n';
}

int refuse(const StnOptions& options, const std::string& why, std::ostream& err) {
  err << input_name(options) << ": " << why << '\n';
  return kExitBadInput;
}

// The CSTNU Tool lets no node come before Z, whatever the file says: where that decides, its users
// are told. `holds` is what is asked of a network.
template <class Holds>
void note_origin(const StnOptions& options, const temporal::ReadNetwork& read, const Holds& holds,
                 std::ostream& err) {
  const bool theirs =
      read.format == temporal::Format::kGraphml || read.format == temporal::Format::kPlain;
  if (!theirs || options.z_first) return;
  temporal::Stnu network = read.network;
  temporal::put_origin_first(network);
  if (holds(network)) return;
  err << "note: a node must come before '" << network.nodes[network.origin]
      << "'; the CSTNU Tool, which lets none, says no to this network; so does --z-first\n";
}

std::string bounds_head(std::size_t size) {
  return size == 1 ? "this bound" : "these " + std::to_string(size) + " bounds";
}

}  // namespace

int check_stn(const StnCheckOptions& options, std::istream& in, std::ostream& out,
              std::ostream& err) {
  const std::optional<temporal::ReadNetwork> read = load_network(options.common, in, err);
  if (!read) return kExitBadInput;
  const temporal::Stnu& network = read->network;
  const auto [answer, seconds] =
      timed(options.common, [&] { return analyse_consistency(network); });
  if (!answer) return refuse(options.common, answer.error().why, err);
  const int code = answer->consistent ? kExitOk : kExitNegative;
  if (answer->consistent) {
    note_origin(
        options.common, *read,
        [](const temporal::Stnu& other) {
          const Result<Consistency, Failure> again = analyse_consistency(other);
          return !again || again->consistent;
        },
        err);
  }
  if (options.common.json) {
    Verdict verdict{answer->consistent, std::nullopt, answer->conflict, seconds};
    if (!answer->consistent || network.contingent.empty())
      verdict.controllable = answer->consistent;
    std::string text = verdict_json(network, verdict);
    if (options.dates) {
      text.insert(text.size() - 1, R"(, "dates": )" + dates_json(network, *answer));
    }
    out << text << '\n';
    return code;
  }
  const Paint paint(options.common.colour);
  write_head(options.common, *read, out);
  if (answer->consistent) {
    out << paint.good("consistent") << paint.quiet("  " + duration_text(seconds)) << '\n';
    if (options.dates) out << dates_text(network, *answer, paint);
    return code;
  }
  out << paint.bad("inconsistent") << ": " << bounds_head(answer->conflict.size())
      << " cannot be kept together:\n"
      << conflict_text(network, answer->conflict, paint) << paint.quiet(duration_text(seconds))
      << '\n';
  return code;
}

int check_stn_controllability(const StnOptions& options, std::istream& in, std::ostream& out,
                              std::ostream& err) {
  const std::optional<temporal::ReadNetwork> read = load_network(options, in, err);
  if (!read) return kExitBadInput;
  const temporal::Stnu& network = read->network;
  const auto [answer, seconds] = timed(options, [&] { return analyse_controllability(network); });
  if (!answer) return refuse(options, answer.error().why, err);
  const int code = answer->controllable ? kExitOk : kExitNegative;
  if (answer->controllable) {
    note_origin(
        options, *read,
        [](const temporal::Stnu& other) {
          const Result<Controllability, Failure> again = analyse_controllability(other);
          return !again || again->controllable;
        },
        err);
  }
  if (options.json) {
    out << verdict_json(network,
                        {answer->consistent, answer->controllable, answer->conflict, seconds})
        << '\n';
    return code;
  }
  const Paint paint(options.colour);
  write_head(options, *read, out);
  if (answer->controllable) {
    out << paint.good("dynamically controllable") << paint.quiet("  " + duration_text(seconds))
        << '\n';
    return code;
  }
  out << paint.bad(answer->consistent ? "not dynamically controllable" : "inconsistent") << ": "
      << bounds_head(answer->conflict.size())
      << (answer->consistent ? " cannot be kept whatever nature does:\n"
                             : " cannot be kept together:\n")
      << conflict_text(network, answer->conflict, paint) << paint.quiet(duration_text(seconds))
      << '\n';
  return code;
}

}  // namespace skein::temporal_tool
