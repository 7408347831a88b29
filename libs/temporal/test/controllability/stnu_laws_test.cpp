// SPDX-License-Identifier: Apache-2.0
// Laws of dynamic controllability: what a change of bounds, units, names or format may do to a
// verdict.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "random_stnu.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "skein/temporal/stnu_controllability.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {
namespace {

/// Of full size from the first example on, so that conflicts are as frequent as in the last.
template <class T>
T between(T low, T end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(low, end));
}

/// As random_stnu, with at most one arc from a node to another and no contingent link of one
/// duration: our format would not take the first, and make a requirement of the second.
Stnu any_network() {
  Random random(between<std::uint64_t>(0, 1'000'000'000));
  testing::RandomStnuOptions options;
  options.nodes = between(3U, 10U);
  options.contingent = between(1U, 5U);
  options.arcs = between(0U, 16U);
  Stnu network = testing::random_stnu(options, random);
  std::set<std::pair<NodeIndex, NodeIndex>> seen;
  std::erase_if(network.arcs,
                [&](const Arc& arc) { return !seen.emplace(arc.from, arc.to).second; });
  std::erase_if(network.contingent,
                [](const ContingentLink& link) { return link.min == link.max; });
  return network;
}

DcResult verdict_of(const Stnu& network) { return check_dynamic_controllability(network).value(); }

std::size_t any_place(std::size_t size) { return between<std::size_t>(0, size); }

/// Tighter in one bound, so far as an interval is left.
Arc tightened(Arc arc) {
  const Ticks by = between<Ticks>(1, 6);
  if (*rc::gen::arbitrary<bool>()) {
    arc.min = arc.min == kMinusInfinite ? std::min<Ticks>(0, arc.max) : arc.min + by;
  } else {
    arc.max = arc.max == kInfinite ? std::max<Ticks>(0, arc.min) : arc.max - by;
  }
  RC_PRE(arc.min <= arc.max);
  return arc;
}

RC_GTEST_PROP(ControllabilityLaws, ATighterRequirementNeverMakesANetworkControllable, ()) {
  const Stnu network = any_network();
  RC_PRE(!network.arcs.empty());
  Stnu tighter = network;
  Arc& arc = tighter.arcs[any_place(network.arcs.size())];
  arc = tightened(arc);

  const DcResult before = verdict_of(network);
  const DcResult after = verdict_of(tighter);

  RC_CLASSIFY(before.controllable, "controllable");
  RC_ASSERT(before.controllable || !after.controllable);
  RC_ASSERT(before.consistent || !after.consistent);
}

RC_GTEST_PROP(ControllabilityLaws, AWiderContingentLinkNeverMakesANetworkControllable, ()) {
  const Stnu network = any_network();
  RC_PRE(!network.contingent.empty());
  Stnu wider = network;
  ContingentLink& link = wider.contingent[any_place(network.contingent.size())];
  link.max += between<Ticks>(0, 5);
  link.min = std::max<Ticks>(1, link.min - between<Ticks>(0, 5));

  const DcResult before = verdict_of(network);
  const DcResult after = verdict_of(wider);

  RC_ASSERT(before.controllable || !after.controllable);
  // As a requirement it is looser.
  RC_ASSERT(after.consistent || !before.consistent);
}

RC_GTEST_PROP(ControllabilityLaws, ControllableIsConsistentAndWithoutLinksTheyAreTheSame, ()) {
  Stnu network = any_network();
  const DcResult uncertain = verdict_of(network);
  RC_ASSERT(uncertain.consistent || !uncertain.controllable);

  network.contingent.clear();
  const DcResult certain = verdict_of(network);

  RC_ASSERT(certain.consistent == certain.controllable);
  const Stn stn{network.nodes, network.origin, network.arcs};
  RC_ASSERT(certain.consistent == StnEngine::make(stn).value().consistent());
}

RC_GTEST_PROP(ControllabilityLaws, TheUnitOfTimeDoesNotMatter, ()) {
  const Stnu network = any_network();
  const Ticks unit = between<Ticks>(2, kTicksPerSecond);
  Stnu scaled = network;
  for (Arc& arc : scaled.arcs) {
    if (arc.min != kMinusInfinite) arc.min *= unit;
    if (arc.max != kInfinite) arc.max *= unit;
  }
  for (ContingentLink& link : scaled.contingent) {
    link.min *= unit;
    link.max *= unit;
  }

  const DcResult one = verdict_of(network);
  const DcResult other = verdict_of(scaled);

  RC_ASSERT(one.controllable == other.controllable);
  RC_ASSERT(one.consistent == other.consistent);
}

RC_GTEST_PROP(ControllabilityLaws, TheNumbersOfNodesAndTheOrderOfLinksDoNotMatter, ()) {
  const Stnu network = any_network();
  std::vector<NodeIndex> number(network.nodes.size());
  std::iota(number.begin(), number.end(), NodeIndex{0});
  std::rotate(number.begin(),
              number.begin() + static_cast<std::ptrdiff_t>(any_place(number.size())), number.end());
  Stnu renamed = network;
  renamed.origin = number[network.origin];
  for (Arc& arc : renamed.arcs) arc = {number[arc.from], number[arc.to], arc.min, arc.max};
  for (ContingentLink& link : renamed.contingent) {
    link = {number[link.activation], number[link.contingent], link.min, link.max};
  }
  std::reverse(renamed.arcs.begin(), renamed.arcs.end());
  std::reverse(renamed.contingent.begin(), renamed.contingent.end());

  const DcResult one = verdict_of(network);
  const DcResult other = verdict_of(renamed);

  RC_ASSERT(one.controllable == other.controllable);
  RC_ASSERT(one.consistent == other.consistent);
}

RC_GTEST_PROP(ControllabilityLaws, ARequirementThatNatureKeepsAnywayChangesNothing, ()) {
  const Stnu network = any_network();
  RC_PRE(!network.contingent.empty());
  Stnu more = network;
  const ContingentLink& link = network.contingent[any_place(network.contingent.size())];
  more.arcs.push_back({link.activation, link.contingent, link.min, link.max});

  RC_ASSERT(verdict_of(more).controllable == verdict_of(network).controllable);

  more.arcs.back().max -= 1;
  RC_ASSERT(!verdict_of(more).controllable);  // one less is asking nature
}

RC_GTEST_PROP(ControllabilityLaws, LooseningWhatTheConflictDoesNotNameDoesNotHelp, ()) {
  const Stnu network = any_network();
  const DcResult result = verdict_of(network);
  RC_PRE(!result.controllable);
  const auto named = [&](LinkKind kind, std::uint32_t index, LinkBound bound) {
    return std::find(result.conflict.begin(), result.conflict.end(),
                     ConflictTerm{{kind, index}, bound}) != result.conflict.end();
  };
  Stnu looser = network;
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    if (!named(LinkKind::kRequirement, i, LinkBound::kMin)) looser.arcs[i].min = kMinusInfinite;
    if (!named(LinkKind::kRequirement, i, LinkBound::kMax)) looser.arcs[i].max = kInfinite;
  }

  RC_ASSERT(!verdict_of(looser).controllable);
  RC_ASSERT(verdict_of(looser).consistent || !result.consistent);
}

/// Date windows by the name of the node, the origin under one name.
std::map<std::string, std::pair<Ticks, Ticks>> windows_by_name(const Stnu& network) {
  std::map<std::string, std::pair<Ticks, Ticks>> windows;
  // Arcs may come twice in this view; joined into the tightest first.
  std::map<std::pair<NodeIndex, NodeIndex>, Arc> joined;
  for (const Arc& arc : without_uncertainty(network).arcs) {
    const auto [found, added] = joined.emplace(std::pair(arc.from, arc.to), arc);
    if (added) continue;
    found->second.min = std::max(found->second.min, arc.min);
    found->second.max = std::min(found->second.max, arc.max);
  }
  Stn stn{network.nodes, network.origin, {}};
  for (const auto& [pair, arc] : joined) stn.arcs.push_back(arc);
  const auto engine = StnEngine::make(stn);
  if (!engine || !engine->consistent()) return windows;
  for (NodeIndex node = 0; node < network.nodes.size(); ++node) {
    windows[node == network.origin ? "origin" : network.nodes[node]] = {engine->earliest(node),
                                                                        engine->latest(node)};
  }
  return windows;
}

RC_GTEST_PROP(FormatLaws, AVerdictAndAllDatesSurviveAChainOfFormats, ()) {
  const Stnu network = any_network();
  const DcResult expected = verdict_of(network);
  const auto expected_windows = windows_by_name(network);
  Stnu carried = network;

  const int hops = between(1, 5);
  for (int hop = 0; hop < hops; ++hop) {
    const Format format =
        *rc::gen::element(Format::kJson, Format::kGraphml, Format::kPlain, Format::kHeatlab);
    const auto text = write_network(carried, format);
    RC_ASSERT(text.has_value());
    const auto read = read_network(*text);
    RC_LOG() << *text << (read ? std::string() : to_text(read.error()));
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->format == format);
    carried = read->network;
  }

  const DcResult result = verdict_of(carried);
  RC_ASSERT(result.controllable == expected.controllable);
  RC_ASSERT(result.consistent == expected.consistent);
  RC_ASSERT(windows_by_name(carried) == expected_windows);
}

TEST(StnuFaults, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const StnuFault fault :
       {StnuFault::kUnknownLink, StnuFault::kUnknownNode, StnuFault::kEmptyInterval,
        StnuFault::kContingentNotPositive, StnuFault::kContingentUnbounded,
        StnuFault::kContingentLoop, StnuFault::kSharedContingentEnd, StnuFault::kOverflow,
        StnuFault::kContingentOrigin, StnuFault::kNotControllable}) {
    names.insert(to_text(fault));
  }

  EXPECT_EQ(names.size(), 10U);
  EXPECT_FALSE(names.contains("unknown fault"));
}

TEST(StnuFaults, TheFirstInTheOrderOfLinksIsNamed) {
  Stnu network{{"z", "a", "b"}, 0, {{0, 1, 0, 1}, {1, 2, 3, 2}}, {{1, 2, 0, 5}, {1, 2, 1, 5}}};
  const auto fault = [&] { return find_fault(network).value_or(StnuError{}); };

  EXPECT_EQ(fault(), (StnuError{StnuFault::kEmptyInterval, LinkRef{LinkKind::kRequirement, 1}}));
  network.arcs[1].max = 3;
  EXPECT_EQ(fault(),
            (StnuError{StnuFault::kContingentNotPositive, LinkRef{LinkKind::kContingent, 0}}));
  network.contingent[0].min = 5;
  EXPECT_EQ(fault(),
            (StnuError{StnuFault::kSharedContingentEnd, LinkRef{LinkKind::kContingent, 1}}));
  network.contingent.pop_back();
  EXPECT_EQ(find_fault(network), std::nullopt);
  network.contingent[0].max = kLargest + 1;
  EXPECT_EQ(fault(), (StnuError{StnuFault::kOverflow, LinkRef{LinkKind::kContingent, 0}}));
  network.contingent[0] = {1, 9, 1, 2};
  EXPECT_EQ(to_text(fault(), network), "contingent link a -> #9: unknown node");
}

}  // namespace
}  // namespace skein::temporal
