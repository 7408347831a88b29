// SPDX-License-Identifier: Apache-2.0
#include "patrol/ring.hpp"

#include <algorithm>
#include <limits>

namespace skein::refiners {
namespace {

constexpr double kNoise = 1e-4;  ///< [m] costs are kept as floats
constexpr int kPasses = 8;
constexpr std::size_t kLongestMoved = 3;
constexpr std::size_t kStarts = 32;
/// About what it takes to compare two places of a ring [ns]; the first time it takes more.
constexpr std::uint32_t kCompared = 50;

using Ring = std::vector<Visit>;

Ring::iterator at(Ring& ring, std::size_t i) {
  return ring.begin() + static_cast<std::ptrdiff_t>(i);
}

void turn_round(Ring::iterator first, Ring::iterator end) {
  std::reverse(first, end);
  for (auto visit = first; visit != end; ++visit) *visit ^= 1U;
}

bool reverse_parts(Ring& ring, const PatrolLinks& links, Deadline& deadline) {
  const std::size_t n = ring.size();
  bool better = false;
  for (std::size_t i = 0; i + 2 < n; ++i) {
    double out = links.cost(ring[i], ring[i + 1]);
    for (std::size_t j = i + 1; j < n; ++j) {
      if (deadline.passed_after(kCompared)) return better;
      const Visit last = ring[j], next = ring[j + 1 < n ? j + 1 : 0];
      const double now = out + links.cost(last, next);
      const double then = links.cost(ring[i], last ^ 1U) + links.cost(ring[i + 1] ^ 1U, next);
      if (!(then < now - kNoise)) continue;
      turn_round(at(ring, i + 1), at(ring, j + 1));
      out = links.cost(ring[i], ring[i + 1]);
      better = true;
    }
  }
  return better;
}

/// Moves ring[i, i + length) to behind ring[j], turned round or not, if that is shorter.
bool move_part(Ring& ring, const PatrolLinks& links, std::size_t i, std::size_t length,
               Deadline& deadline) {
  const std::size_t n = ring.size();
  const Visit first = ring[i], last = ring[i + length - 1];
  const Visit before = ring[i - 1], behind = ring[(i + length) % n];
  const double saved =
      links.cost(before, first) + links.cost(last, behind) - links.cost(before, behind);
  if (!(saved > kNoise)) return false;
  for (std::size_t j = 0; j + 1 < n; ++j) {
    if (deadline.passed_after(kCompared)) return false;
    if (j + 1 >= i && j < i + length) continue;
    const double gap = links.cost(ring[j], ring[j + 1]);
    const double same = links.cost(ring[j], first) + links.cost(last, ring[j + 1]) - gap;
    const double turned =
        links.cost(ring[j], last ^ 1U) + links.cost(first ^ 1U, ring[j + 1]) - gap;
    if (!(std::min(same, turned) < saved - kNoise)) continue;
    if (turned < same) turn_round(at(ring, i), at(ring, i + length));
    if (j < i)
      std::rotate(at(ring, j + 1), at(ring, i), at(ring, i + length));
    else
      std::rotate(at(ring, i), at(ring, i + length), at(ring, j + 1));
    return true;
  }
  return false;
}

bool move_parts(Ring& ring, const PatrolLinks& links, Deadline& deadline) {
  bool better = false;
  for (std::size_t length = 1; length <= kLongestMoved; ++length)
    for (std::size_t i = 1; i + length < ring.size(); ++i)
      better = move_part(ring, links, i, length, deadline) || better;
  return better;
}

/// Lanes there and back in turn; with `comb`, the first block of each is left for the way back.
Ring lanes_of(const std::vector<PatrolBlock>& blocks, bool comb) {
  Ring ring, back;
  bool forwards = true;
  for (std::size_t first = 0; first < blocks.size();) {
    std::size_t end = first;
    while (end < blocks.size() && blocks[end].lane == blocks[first].lane) ++end;
    if (comb) back.push_back(static_cast<Visit>(2 * first));
    const std::size_t from = first + (comb ? 1 : 0);
    for (std::size_t i = from; i < end; ++i)
      ring.push_back(static_cast<Visit>(forwards ? 2 * i : 2 * (end - 1 - (i - from)) + 1));
    forwards = !forwards;
    first = end;
  }
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return ring;
}

/// Greatest risk × idleness met on the round begun at ring[i].
double worst_met(const Ring& ring, std::size_t i, const PatrolLinks& links,
                 const RoundStart& start) {
  double along = 0, worst = 0;
  Visit from = start.after;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Visit to = ring[i + k < ring.size() ? i + k : i + k - ring.size()];
    along += links.cost(from, to);
    worst = std::max(worst, start.risk[to / 2] * (start.idle[to / 2] + along / start.speed));
    along += links.length(to);
    from = to;
  }
  return worst;
}

}  // namespace

double round_length(const Ring& ring, const PatrolLinks& links) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    length += links.length(ring[i]) + links.cost(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  return length;
}

void shorten(Ring& ring, const PatrolLinks& links, Deadline& deadline) {
  if (ring.size() < 4) return;
  for (int pass = 0; pass < kPasses; ++pass) {
    const bool reversed = reverse_parts(ring, links, deadline);
    const bool moved = move_parts(ring, links, deadline);
    if (!reversed && !moved) return;
  }
}

Ring lanes_in_turn(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links) {
  Ring plain = lanes_of(blocks, false), comb = lanes_of(blocks, true);
  return round_length(comb, links) < round_length(plain, links) ? comb : plain;
}

Ring round_over_all(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links,
                    Deadline& deadline) {
  Ring plain = lanes_of(blocks, false), comb = lanes_of(blocks, true);
  shorten(plain, links, deadline);
  shorten(comb, links, deadline);
  return round_length(comb, links) < round_length(plain, links) ? comb : plain;
}

Ring begun_best(const Ring& ring, const PatrolLinks& links, const RoundStart& start) {
  const std::size_t n = ring.size(), stride = 1 + n / kStarts;
  Ring best = ring;
  double least = std::numeric_limits<double>::infinity();
  Ring way = ring;
  for (int sense = 0; sense < 2; ++sense) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (links.cost(start.after, way[i]) < links.cost(start.after, way[nearest])) nearest = i;
    for (std::size_t k = 0; k < n; k += stride) {
      const std::size_t i = (nearest + k) % n;
      const double detour =
          links.cost(start.after, way[i]) - links.cost(way[i > 0 ? i - 1 : n - 1], way[i]);
      const double score = worst_met(way, i, links, start) + start.most_risk * detour / start.speed;
      if (!(score < least)) continue;
      least = score;
      best.assign(at(way, i), way.end());
      best.insert(best.end(), way.begin(), at(way, i));
    }
    turn_round(way.begin(), way.end());
  }
  return best;
}

}  // namespace skein::refiners
