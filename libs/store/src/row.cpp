// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

#include <array>
#include <string_view>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::store {

namespace {

using node::JobClock;
using node::LoggedInput;
using node::NodeNumber;

/// In the order of LoggedInput's alternatives.
constexpr std::array<std::string_view, std::variant_size_v<LoggedInput>> kKinds = {
    "started", "received", "reachability", "undelivered", "delivered",    "wakeup",
    "job",     "resumed",  "unsent",       "skipped",     "acknowledged", "restarted"};
constexpr std::int64_t kFirst = 1, kSecond = 2;  // flags

std::int64_t to_signed(std::uint64_t value) { return static_cast<std::int64_t>(value); }
std::uint64_t to_unsigned(std::int64_t value) { return static_cast<std::uint64_t>(value); }

std::string name_of(wire::Slot slot) { return std::string(wire::slot_name(slot)); }

std::vector<std::uint8_t> bytes_of(const wire::Sample& sample) {
  std::vector<std::uint8_t> bytes(blackboard::encoded_size(sample));
  bytes.resize(blackboard::encode(sample, bytes));
  return bytes;
}

std::int64_t flags_of(bool first, bool second) {
  return (first ? kFirst : 0) | (second ? kSecond : 0);
}

void fill(Row& row, const node::Started& one) {
  row.value = to_signed(one.incarnation);
  row.flags = flags_of(one.first_life, false);
}
void fill(Row& row, const node::Received& one) {
  row.peer = one.from.value();
  row.slot = name_of(wire::slot_of(one.sample));
  row.body = bytes_of(one.sample);
}
void fill(Row& row, const node::Reachability& one) {
  row.peer = one.peer.value();
  row.flags = flags_of(one.reachable, one.restarted);
}
void fill(Row& row, const node::Undelivered& one) {
  row.peer = one.to.value();
  row.slot = name_of(one.slot);
  row.value = to_signed(one.sequence);
  row.extra = to_signed(one.receipt);
  row.flags = flags_of(one.may_have_arrived, false);
}
void fill(Row& row, const node::Delivered& one) {
  row.peer = one.to.value();
  row.value = to_signed(one.receipt);
}
void fill(Row& row, const node::JobEnded& one) {
  row.value = to_signed(one.id);
  row.extra = to_signed(one.clock.questions);
  row.flags = flags_of(one.clock.given, one.clock.ran_out);
}
void fill(Row& row, const node::Unsent& one) { row.value = to_signed(one.send); }
void fill(Row& row, const node::Skipped& one) {
  row.peer = one.header.origin;
  row.slot = name_of(one.slot);
  row.value = to_signed(one.header.sequence_number);
  row.extra = to_signed(one.header.incarnation);
}
void fill(Row& row, const node::Acknowledged& one) {
  row.peer = one.peer.value();
  row.value = to_signed(one.sequence);
}
void fill(Row&, const node::Wakeup&) {}
void fill(Row&, const node::Resumed&) {}
void fill(Row&, const node::Restarted&) {}

Result<NodeNumber, Failure> peer_of(const Row& row) {
  if (row.peer <= 0 || row.peer > 0xffffffffLL)
    return failure("no node has the number " + std::to_string(row.peer));
  return NodeNumber(static_cast<std::uint32_t>(row.peer));
}

Result<wire::Slot, Failure> slot_of(const Row& row) {
  const auto slot = wire::slot_from_name(row.slot);
  if (!slot) return failure("there is no slot '" + row.slot + "'");
  return *slot;
}

Result<LoggedInput, Failure> received(const Row& row, NodeNumber peer, wire::Slot slot) {
  auto read = blackboard::decode(slot, row.body);
  if (const auto* malformed = std::get_if<blackboard::Malformed>(&read))
    return failure("malformed " + row.slot + ": " + malformed->violation.field + ": " +
                   malformed->violation.why);
  auto& sample = std::get<wire::Sample>(read);
  if (const auto violation = wire::find_violation(sample))
    return failure("malformed " + row.slot + ": " + violation->field + ": " + violation->why);
  return node::Received{peer, std::move(sample)};
}

Result<LoggedInput, Failure> of_a_peer(const Row& row, bool first, bool second) {
  const auto peer = peer_of(row);
  if (!peer) return tl::unexpected(peer.error());
  if (row.kind == "reachability") return node::Reachability{*peer, first, second};
  if (row.kind == "delivered") return node::Delivered{*peer, to_unsigned(row.value)};
  if (row.kind == "acknowledged") return node::Acknowledged{*peer, to_unsigned(row.value)};
  const auto slot = slot_of(row);
  if (!slot) return tl::unexpected(slot.error());
  if (row.kind == "received") return received(row, *peer, *slot);
  if (row.kind == "undelivered")
    return node::Undelivered{*peer, *slot, to_unsigned(row.value), to_unsigned(row.extra), first};
  node::Skipped skipped{*slot, {}};
  skipped.header.origin = peer->value();
  skipped.header.sequence_number = to_unsigned(row.value);
  skipped.header.incarnation = to_unsigned(row.extra);
  return skipped;
}

Result<LoggedInput, Failure> input_of(const Row& row) {
  const bool first = (row.flags & kFirst) != 0, second = (row.flags & kSecond) != 0;
  if (row.kind == "started") return node::Started{to_unsigned(row.value), first};
  if (row.kind == "wakeup") return node::Wakeup{};
  if (row.kind == "resumed") return node::Resumed{};
  if (row.kind == "restarted") return node::Restarted{};
  if (row.kind == "unsent") return node::Unsent{to_unsigned(row.value)};
  if (row.kind == "job")
    return node::JobEnded{to_unsigned(row.value), JobClock{first, second, to_unsigned(row.extra)}};
  if (std::find(kKinds.begin(), kKinds.end(), row.kind) == kKinds.end())
    return failure("there is no input of kind '" + row.kind + "'");
  return of_a_peer(row, first, second);
}

}  // namespace

Row row_of(const node::LogEntry& entry) {
  Row row;
  row.at = entry.at.count();
  row.kind = kKinds[entry.input.index()];
  std::visit([&](const auto& one) { fill(row, one); }, entry.input);
  return row;
}

std::vector<std::string> kinds_of_lives() {
  std::vector<std::string> kinds;
  for (const LoggedInput& one :
       {LoggedInput(node::Started{}), LoggedInput(node::Resumed{}), LoggedInput(node::Unsent{})})
    kinds.emplace_back(kKinds[one.index()]);
  return kinds;
}

Result<node::LogEntry, Failure> entry_of(const Row& row) {
  auto input = input_of(row);
  if (!input) return tl::unexpected(input.error());
  return node::LogEntry{MissionTime::nanoseconds(row.at), std::move(*input)};
}

}  // namespace skein::store
