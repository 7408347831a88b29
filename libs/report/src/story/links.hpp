// SPDX-License-Identifier: Apache-2.0
// Pairs what was sent with what was received, and link truth with belief.
#pragma once

#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// One flight per (slot, from, to, sequence), in the order of the first record; of repeated records
/// the earliest counts.
std::vector<Flight> pair_messages(const std::vector<MessageRecord>& records);

/// A synchronisation has no sequence number: the n-th received goes with the n-th sent.
std::vector<Flight> pair_syncs(const std::vector<SyncRecord>& records);

/// One story per pair of nodes that a link record names (without any link record: that a reach
/// record names), in the order of the names; a node's link to itself is none. A span that no record
/// closes lasts until `end`.
std::vector<LinkStory> tell_links(const Journal& journal, double end);

/// The total length of spans [s].
double total(const std::vector<Span>& spans);

/// How long exactly one of two sets of spans holds [s]. Each set: in order, without overlap.
double disagreement(const std::vector<Span>& a, const std::vector<Span>& b);

}  // namespace skein::report
