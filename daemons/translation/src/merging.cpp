// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/merging.hpp"

#include <cmath>
#include <optional>

namespace skein::translation {

namespace {

using merging::Volume;
using merging::Volumes;
using world::Vector2;

constexpr double kSame = 1e-9;              // [m] between pieces of one length, as they are summed
constexpr std::uint32_t kMostPieces = 100;  // of a row

wire::AirPlace place_of(const Vector2& at) { return {at.x(), at.y()}; }
Vector2 from_wire(const wire::AirPlace& at) { return {at.x, at.y}; }

bool is_same(double one, double other) { return std::abs(one - other) < kSame; }

wire::AirRow row_of(const Volume& volume, const Volume* before) {
  wire::AirRow row{volume.radius, volume.floor, volume.ceiling, 0, 1, {}};
  const bool stays = volume.from == volume.to;
  const bool begins_there = before != nullptr && volume.from == before->to;
  const bool begins_nowhere_else = begins_there || (before == nullptr && stays);
  if (!begins_nowhere_else) row.line.push_back(place_of(volume.from));
  if (!begins_there || !stays) row.line.push_back(place_of(volume.to));
  return row;
}

/// Makes the row longer by its next piece. `first`, `before`: its first and its last one so far.
/// False: the next is none of this row.
bool goes_on(wire::AirRow& row, const Volume& first, const Volume& before, const Volume& next) {
  const Vector2 step = first.to - first.from;
  const double rise = row.pieces == 1 ? next.floor - before.floor : row.rise;
  const bool continues = !step.isZero() && next.from == before.to && next.radius == before.radius &&
                         (next.to - next.from - step).norm() < kSame &&
                         is_same(next.floor, before.floor + rise) &&
                         is_same(next.ceiling, before.ceiling + rise);
  if (!continues || row.pieces == kMostPieces) return false;
  ++row.pieces;
  row.rise = rise;
  row.line.back() = place_of(next.to);
  return true;
}

std::vector<wire::AirRow> to_wire(const Volumes& volumes) {
  std::vector<wire::AirRow> rows;
  const Volume *first = nullptr, *before = nullptr;  // of the row, of all
  for (const Volume& one : volumes) {
    if (before == nullptr || !goes_on(rows.back(), *first, *before, one)) {
      rows.push_back(row_of(one, before));
      first = &one;
    }
    before = &one;
  }
  return rows;
}

/// Nothing, or what is wrong with the row: with its field.
std::optional<wire::Violation> problem_of(const wire::AirRow& row, bool is_first) {
  if (row.radius <= 0) return wire::Violation{"radius", "not greater than 0"};
  if (row.ceiling_z <= row.floor_z) return wire::Violation{"ceiling_z", "not above the floor"};
  if (row.pieces < 1 || row.pieces > kMostPieces)
    return wire::Violation{"pieces", "not from 1 to " + std::to_string(kMostPieces)};
  if (row.line.size() > 2) return wire::Violation{"line", "more than two places"};
  if (is_first && row.line.empty()) return wire::Violation{"line", "nowhere"};
  return std::nullopt;
}

void add_pieces(const wire::AirRow& row, Volumes& volumes) {
  const Vector2 to = row.line.empty() ? volumes.back().to : from_wire(row.line.back());
  const bool from_there = row.line.size() == 2 || volumes.empty();
  const Vector2 from = from_there ? from_wire(row.line.front()) : volumes.back().to;
  Vector2 begins = from;
  for (std::uint32_t piece = 1; piece <= row.pieces; ++piece) {
    const Vector2 ends =
        piece == row.pieces ? to : Vector2(from + piece * (to - from) / row.pieces);
    const double above = (piece - 1) * row.rise;
    volumes.push_back({begins, ends, row.radius, row.floor_z + above, row.ceiling_z + above});
    begins = ends;
  }
}

Read<Volumes> from_wire(const std::vector<wire::AirRow>& rows, const std::string& field) {
  Volumes volumes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (auto problem = problem_of(rows[i], i == 0))
      return tl::unexpected(
          wire::Violation{field + "[" + std::to_string(i) + "]." + problem->field, problem->why});
    add_pieces(rows[i], volumes);
  }
  return volumes;
}

}  // namespace

wire::MergeMessage to_wire(const merging::Message& message) {
  wire::MergeMessage sample;
  sample.number = message.number;
  sample.held = to_wire(message.claim.held);
  sample.request = message.claim.request;
  sample.wanted = to_wire(message.claim.wanted);
  sample.waits_for = message.claim.waits_for;
  sample.keeps = message.claim.keeps;
  sample.cannot_ask = message.claim.cannot_ask;
  sample.answered = message.answered;
  sample.granted = message.granted;
  sample.asks = message.asks;
  sample.of = message.of;
  sample.version = message.version;
  sample.known = message.known;
  sample.brief = message.brief;
  sample.lacks = message.lacks;
  return sample;
}

Read<merging::Message> from_wire(const wire::MergeMessage& sample) {
  auto held = from_wire(sample.held, "held");
  if (!held) return tl::unexpected(held.error());
  auto wanted = from_wire(sample.wanted, "wanted");
  if (!wanted) return tl::unexpected(wanted.error());
  merging::Message message;
  message.number = sample.number;
  message.claim = {std::move(*held), sample.request, std::move(*wanted), sample.waits_for,
                   sample.keeps, sample.cannot_ask};
  message.answered = sample.answered;
  message.granted = sample.granted;
  message.asks = sample.asks;
  message.of = sample.of;
  message.version = sample.version;
  message.known = sample.known;
  message.brief = sample.brief;
  message.lacks = sample.lacks;
  return message;
}

}  // namespace skein::translation
