// SPDX-License-Identifier: Apache-2.0
#include "stn_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "skein/foundation/time.hpp"
#include "skein/temporal_files/drawing.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::LinkKind;
using temporal::Stnu;

/// A link of either kind.
struct LinkFacts {
  temporal::Arc arc;
  bool contingent = false;
};

LinkFacts facts_of(const Stnu& network, const temporal::LinkRef& link) {
  if (link.kind == LinkKind::kRequirement) return {network.arcs[link.index], false};
  const temporal::ContingentLink& one = network.contingent[link.index];
  return {{one.activation, one.contingent, one.min, one.max}, true};
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::size_t characters_in(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string ends_text(const Stnu& network, const LinkFacts& link) {
  return network.nodes[link.arc.from] + " → " + network.nodes[link.arc.to];
}

std::string interval_text(const LinkFacts& link) {
  return temporal::bounds_text(link.arc.min, link.arc.max) +
         (link.contingent ? ", contingent" : "");
}

std::string link_fields(const Stnu& network, const temporal::LinkRef& ref) {
  const LinkFacts link = facts_of(network, ref);
  return R"("from": )" + json_text(network.nodes[link.arc.from]) + R"(, "to": )" +
         json_text(network.nodes[link.arc.to]) + R"(, "min": )" + json_seconds(link.arc.min) +
         R"(, "max": )" + json_seconds(link.arc.max) + R"(, "contingent": )" +
         (link.contingent ? "true" : "false");
}

const char* bound_word(LinkBound bound) { return bound == LinkBound::kMin ? "min" : "max"; }

}  // namespace

std::string Paint::painted(const char* code, const std::string& text) const {
  return on_ ? code + text + "\033[0m" : text;
}

std::string table_text(const std::vector<std::vector<std::string>>& rows,
                       const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], characters_in(row[i]));
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line += std::string(widths[i] - characters_in(row[i]) + 2, ' ');
    }
    text += line + "\n";
  }
  return text;
}

std::string summary_text(const temporal::ReadNetwork& read) {
  const Stnu& network = read.network;
  std::string text = network.contingent.empty() ? "STN, " : "STNU, ";
  text +=
      counted(network.nodes.size(), "node") + ", " + counted(network.arcs.size(), "requirement");
  if (!network.contingent.empty()) {
    text += ", " + counted(network.contingent.size(), "contingent link");
  }
  return text + " (" + std::string(temporal::name_of(read.format)) + ")";
}

std::string conflict_text(const Stnu& network, const std::vector<ConflictPart>& conflict,
                          const Paint& paint) {
  std::vector<std::vector<std::string>> rows;
  for (const ConflictPart& part : conflict) {
    const LinkFacts link = facts_of(network, part.link);
    const temporal::Ticks bound = part.bound == LinkBound::kMin ? link.arc.min : link.arc.max;
    rows.push_back({ends_text(network, link),
                    std::string(bound_word(part.bound)) + " " + seconds_or_infinite(bound),
                    paint.quiet("of " + interval_text(link))});
  }
  return table_text(rows, "  ");
}

std::string links_text(const Stnu& network, const std::vector<temporal::LinkRef>& links) {
  std::vector<std::vector<std::string>> rows;
  for (const temporal::LinkRef& ref : links) {
    const LinkFacts link = facts_of(network, ref);
    rows.push_back({ends_text(network, link), interval_text(link)});
  }
  return table_text(rows, "  ");
}

std::string conflict_json(const Stnu& network, const std::vector<ConflictPart>& conflict) {
  std::string text = "[";
  for (const ConflictPart& part : conflict) {
    text += (text.size() > 1 ? ", {" : "{") + link_fields(network, part.link) + R"(, "bound": ")" +
            bound_word(part.bound) + R"("})";
  }
  return text + "]";
}

std::string links_json(const Stnu& network, const std::vector<temporal::LinkRef>& links) {
  std::string text = "[";
  for (const temporal::LinkRef& ref : links) {
    text += (text.size() > 1 ? ", {" : "{") + link_fields(network, ref) + "}";
  }
  return text + "]";
}

std::string duration_text(double seconds) {
  if (seconds < 1e-3) return formatted("%.0f µs", seconds * 1e6);
  if (seconds < 1) return formatted("%.1f ms", seconds * 1e3);
  return formatted("%.2f s", seconds);
}

std::string verdict_json(const Stnu& network, const Verdict& verdict) {
  const std::string controllable =
      !verdict.controllable ? "null" : (*verdict.controllable ? "true" : "false");
  return std::string(R"({"consistent": )") + (verdict.consistent ? "true" : "false") +
         R"(, "controllable": )" + controllable + R"(, "conflict": )" +
         conflict_json(network, verdict.conflict) + R"(, "seconds": )" +
         formatted("%.6f", verdict.seconds) + "}";
}

std::string json_text(const std::string& text) { return nlohmann::json(text).dump(); }

std::string json_seconds(temporal::Ticks ticks) {
  const bool infinite = ticks == temporal::kInfinite || ticks == temporal::kMinusInfinite;
  return infinite ? "null" : to_text(Duration::nanoseconds(ticks));
}

std::string seconds_or_infinite(temporal::Ticks ticks) {
  if (ticks == temporal::kInfinite) return "∞";
  return ticks == temporal::kMinusInfinite ? "-∞" : to_text(Duration::nanoseconds(ticks));
}

}  // namespace skein::temporal_tool
