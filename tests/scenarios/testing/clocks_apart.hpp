// SPDX-License-Identifier: Apache-2.0
// Laws of the event log where it was written by processes, each with a clock of its own.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::testing {

/// What nodes' clocks, which follow the simulator's over a network, and the logs of several
/// processes may be apart on the wall [s]: lines closer than this may come in either order
/// (docs/journal.md).
inline constexpr double kClocksApart = 0.3;
/// The same where their leader dies: who does not hear it goes on for half a second before its
/// clock stands still, and each has heard it last at another instant.
inline constexpr double kClocksApartWithoutLeader = 0.9;

/// Breaches of the protocol (laws::broken_protocol) that lie further apart than that at this rate:
/// a little later counts all that is not sent, and a link that is cut later still. One a line.
std::string breaches_beyond_clocks(const std::vector<journal::Record>& records, double rate,
                                   double apart = kClocksApart);

/// The same records, with a line for each message that came and of which the sender's line is
/// missing because it was killed in the turn in which it sent it: of those that it numbered between
/// its last line before a scripted death and its first after, if they are few; or after its last,
/// if nothing follows, that came before it was back. Its next life sends them, and writes the
/// node's own lines again, but not the host's of that turn.
std::vector<journal::Record> with_last_messages(std::vector<journal::Record> records, double rate,
                                                double apart = kClocksApart);

}  // namespace skein::testing
