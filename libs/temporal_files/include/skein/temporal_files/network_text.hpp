// SPDX-License-Identifier: Apache-2.0
// Networks as text: readers and writers of our own format and of those of others
// (docs/temporal.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Source: spec 5.2, 5.5; section 1 of the notes.
enum class Format {
  kJson,     ///< our own; STN and STNU
  kHeatlab,  ///< JSON with `constraints`, of MIT's and Harvey Mudd's tools
  kGraphml,  ///< `.stnu` of the CSTNU Tool
  kPlain,    ///< `.plainStnu` of the CSTNU Tool
  kMastn,    ///< our own; multi-agent networks
};

/// "json", "heatlab", "graphml", "plain", "mastn".
std::string_view name_of(Format format);
std::optional<Format> format_named(std::string_view name);
/// In the order of `Format`.
const std::vector<std::string>& format_names();

struct ReadNetwork {
  Stnu network;  ///< without contingent links: an STN
  Format format = Format::kJson;
  /// What was read otherwise than it is written, each with its place: contingent minima that are
  /// not positive, edges from a node to itself that say nothing.
  Diagnostics warnings{};
  bool operator==(const ReadNetwork& other) const {
    return network == other.network && format == other.format &&
           warnings.all() == other.warnings.all();
  }
};

/// Longest text that is read [bytes].
inline constexpr std::size_t kLongestText = std::size_t{64} << 20U;

/// Reads a network in whichever format the text is in. Of a multi-agent network the agents and
/// steps are left out. All errors are collected (at most a hundred); `file` is only named in them.
/// Numbers are seconds, exact; a number below the nanosecond is an error in our formats and rounded
/// in the others. The text is UTF-8, or UTF-16 with or without its mark. Any bytes are safe. Cost:
/// O(n log n) in the length of the text.
Result<ReadNetwork, Diagnostics> read_network(std::string_view text, const std::string& file = "");

/// Writes a network that read_network() gives back: equal in our own format; in the others the same
/// constraints on nodes of the same names, except that the origin takes the name that the format
/// has for it ("Z", "0") and that arcs without bounds are left out. Fails when the format cannot
/// hold the network, and says why; kMastn never can. Precondition: the indices are positions.
Result<std::string, Failure> write_network(const Stnu& network, Format format);

/// No node comes before the origin, as the CSTNU Tool takes every network. Arcs between the same
/// two nodes are made tighter where there are some.
void put_origin_first(Stnu& network);

/// Reads the multi-agent format of spec 5.5; steps are put in the order of `at`, those of one
/// instant stay as they are.
Result<Mastn, Diagnostics> read_mastn(std::string_view text, const std::string& file = "");

/// Writes a network that read_mastn() gives back. Preconditions: the indices are positions,
/// nodes[0] is v0 and the steps are in the order of `at`.
std::string write_mastn(const Mastn& network);

/// Without agents and steps, v0 as the origin.
Stnu without_agents(const Mastn& network);

/// As if all durations could be chosen: after the arcs comes one more for each contingent link, in
/// their order.
Stn without_uncertainty(const Stnu& network);

}  // namespace skein::temporal
