// SPDX-License-Identifier: Apache-2.0
// Every format gives back what was written in it.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <map>
#include <set>

#include "diagnostics_text.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {
namespace {

Ticks any_ticks() {
  return *rc::gen::oneOf(
      rc::gen::inRange<Ticks>(-1000 * kTicksPerSecond, 1000 * kTicksPerSecond),
      rc::gen::map(rc::gen::inRange<Ticks>(-100, 100), [](Ticks s) { return s * kTicksPerSecond; }),
      rc::gen::inRange<Ticks>(-kLargest, kLargest + 1));
}

// Names that need escaping somewhere, all different by their numbers.
std::string any_name(std::size_t number) {
  static const std::vector<std::string> stems{"n", "a b", "<&>\"", "é∞→", "\\", "#x", "0", "]]>"};
  return *rc::gen::elementOf(stems) + std::to_string(number + 1);
}

void add_arcs(Stnu& network) {
  std::set<std::pair<NodeIndex, NodeIndex>> joined;
  const auto count = static_cast<NodeIndex>(network.nodes.size());
  const int arcs = *rc::gen::inRange(0, 12);
  for (int i = 0; i < arcs; ++i) {
    const NodeIndex from = *rc::gen::inRange<NodeIndex>(0, count);
    const NodeIndex to = *rc::gen::inRange<NodeIndex>(0, count);
    if (from == to || !joined.emplace(from, to).second) continue;
    const std::pair<Ticks, Ticks> bounds = std::minmax({any_ticks(), any_ticks()});
    const int open = *rc::gen::inRange(0, 5);
    network.arcs.push_back({from, to, open == 1 ? kMinusInfinite : bounds.first,
                            open == 2 ? kInfinite : bounds.second});
  }
}

void add_contingent(Stnu& network) {
  const auto count = static_cast<NodeIndex>(network.nodes.size());
  for (NodeIndex end = 0; end < count; ++end) {
    const NodeIndex activation = *rc::gen::inRange<NodeIndex>(0, count);
    if (end == network.origin || activation == end || *rc::gen::inRange(0, 3) != 0) continue;
    const Ticks min = *rc::gen::inRange<Ticks>(1, 1000 * kTicksPerSecond);
    network.contingent.push_back(
        {activation, end, min, min + *rc::gen::inRange<Ticks>(1, kLargest / 2)});
  }
}

Stnu any_network() {
  Stnu network;
  const auto count = *rc::gen::inRange<std::size_t>(1, 8);
  for (std::size_t i = 0; i < count; ++i) network.nodes.push_back(any_name(i));
  network.origin = *rc::gen::inRange<NodeIndex>(0, static_cast<NodeIndex>(count));
  add_arcs(network);
  add_contingent(network);
  return network;
}

/// What a network says, without the order of its links and the orientation of its arcs, and with
/// the origin named "origin".
struct Meaning {
  using Pair = std::pair<std::string, std::string>;
  std::set<std::string> nodes;
  std::map<Pair, Ticks> edges;  ///< tightest to - from <= weight
  std::map<Pair, std::pair<Ticks, Ticks>> contingent;
  bool operator==(const Meaning&) const = default;
};

Meaning meaning_of(Stnu network) {
  network.nodes[network.origin] = "origin";
  const std::vector<std::string>& names = network.nodes;
  Meaning meaning;
  meaning.nodes = {names.begin(), names.end()};
  const auto tighten = [&](NodeIndex from, NodeIndex to, Ticks weight) {
    if (weight == kInfinite) return;
    const auto [found, added] = meaning.edges.emplace(std::pair(names[from], names[to]), weight);
    if (!added) found->second = std::min(found->second, weight);
  };
  for (const Arc& arc : network.arcs) {
    tighten(arc.from, arc.to, arc.max);
    tighten(arc.to, arc.from, -arc.min);
  }
  for (const ContingentLink& link : network.contingent) {
    meaning.contingent[{names[link.activation], names[link.contingent]}] = {link.min, link.max};
  }
  return meaning;
}

void check_foreign(Format format) {
  const Stnu network = any_network();

  const Result<std::string, Failure> text = write_network(network, format);
  RC_ASSERT(text.has_value());
  const Result<ReadNetwork, Diagnostics> read = read_network(*text);

  RC_LOG() << *text << errors_of(read);
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->format == format);
  RC_ASSERT((meaning_of(read->network) == meaning_of(network)));
}

RC_GTEST_PROP(OwnJson, GivesBackTheSameNetwork, ()) {
  const Stnu network = any_network();

  const Result<ReadNetwork, Diagnostics> read =
      read_network(write_network(network, Format::kJson).value());

  RC_ASSERT(errors_of(read) == "");
  RC_ASSERT((*read == ReadNetwork{network, Format::kJson}));
}

RC_GTEST_PROP(Graphml, GivesBackTheSameConstraints, ()) { check_foreign(Format::kGraphml); }
RC_GTEST_PROP(PlainText, GivesBackTheSameConstraints, ()) { check_foreign(Format::kPlain); }
RC_GTEST_PROP(Heatlab, GivesBackTheSameConstraints, ()) { check_foreign(Format::kHeatlab); }

// Whatever is cut out of a text, reading it ends with a network or with errors.
RC_GTEST_PROP(ReadNetwork, SurvivesDamage, ()) {
  const Format format = *rc::gen::element(Format::kJson, Format::kGraphml, Format::kPlain);
  std::string text = write_network(any_network(), format).value();
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  const auto length = *rc::gen::inRange<std::size_t>(1, 20);

  text.erase(at, length);
  const Result<ReadNetwork, Diagnostics> read = read_network(text);

  RC_ASSERT(read.has_value() || !read.error().empty());
}

}  // namespace
}  // namespace skein::temporal
