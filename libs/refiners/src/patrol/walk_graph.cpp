// SPDX-License-Identifier: Apache-2.0
#include "patrol/walk_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace skein::refiners {
namespace {

using world::Vector2;

/// Part of the footprint that lanes count on, as for pieces of lanes; and that turns do, which are
/// seldom flown one as the other.
constexpr double kCounted = 0.97, kCountedInTurns = 0.995;
/// Turns are pushed outwards by as many parts of a cell at a time.
constexpr double kPush = 1.0 / 32;
/// About what it takes to see whether a cell is perceived in a turn [ns].
constexpr std::uint32_t kCellSeen = 30;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Columns, or rows, that have cells, in strips of about the same width.
struct Strips {
  std::size_t first = std::numeric_limits<std::size_t>::max(), end = 0, count = 0;

  void take(std::size_t i) {
    first = std::min(first, i);
    end = std::max(end, i + 1);
  }
  void divide(std::size_t width) { count = (end - first + width - 1) / width; }
  std::size_t begin_of(std::size_t strip) const { return first + strip * (end - first) / count; }
  std::size_t strip_of(std::size_t i) const {
    std::size_t strip = (i - first) * count / (end - first);
    while (strip + 1 < count && begin_of(strip + 1) <= i) ++strip;
    while (begin_of(strip) > i) --strip;
    return strip;
  }
  /// In cells.
  double middle(std::size_t strip) const {
    return (static_cast<double>(begin_of(strip)) + static_cast<double>(begin_of(strip + 1))) / 2;
  }
};

class GraphMaker {
 public:
  GraphMaker(const PatrolField& field, const PatrolSpace& space, const PatrolSight& sight)
      : field_(field), space_(space), sight_(sight), grid_(sight.grid()) {}

  std::optional<WalkGraph> graph() {
    if (field_.cells.empty()) return std::nullopt;
    divide();
    if (!place_all()) return std::nullopt;
    link_all();
    for (std::uint32_t place = 0; place < graph_.places.size(); ++place)
      if (!lay_passes(place)) return std::nullopt;
    if (!is_connected()) return std::nullopt;
    return std::move(graph_);
  }

 private:
  std::size_t column_of(std::uint32_t cell) const { return field_.cells[cell] % grid_.columns; }
  std::size_t row_of(std::uint32_t cell) const { return field_.cells[cell] / grid_.columns; }

  void divide() {
    for (std::uint32_t cell = 0; cell < field_.cells.size(); ++cell) {
      columns_.take(column_of(cell));
      rows_.take(row_of(cell));
    }
    const auto width = static_cast<std::size_t>(2 * kCounted * sight_.footprint() / grid_.cell) + 1;
    columns_.divide(width);
    rows_.divide(width);
    reach_ = static_cast<double>(width) * grid_.cell / 2;
  }

  /// Where there are cells, in the middle of its columns and rows. False: it is closed there.
  bool place_all() {
    of_strip_.assign(columns_.count * rows_.count, kNone);
    for (std::uint32_t cell = 0; cell < field_.cells.size(); ++cell) {
      const std::size_t column = columns_.strip_of(column_of(cell));
      const std::size_t row = rows_.strip_of(row_of(cell));
      std::uint32_t& place = of_strip_[row * columns_.count + column];
      if (place == kNone) {
        place = static_cast<std::uint32_t>(graph_.places.size());
        const Vector2 local(columns_.middle(column), rows_.middle(row));
        graph_.places.emplace_back().at = Vector2(grid_.west, grid_.south) + grid_.cell * local;
        cells_.emplace_back();
        if (!space_.is_open(graph_.places.back().at)) return false;
      }
      graph_.places[place].risk += field_.risk[cell];
      graph_.places[place].top = std::max(graph_.places[place].top, field_.risk[cell]);
      cells_[place].push_back(cell);
    }
    graph_.total_risk = field_.total_risk;
    return true;
  }

  void link_all() {
    for (std::size_t row = 0; row < rows_.count; ++row)
      for (std::size_t column = 0; column < columns_.count; ++column) {
        const std::size_t strip = row * columns_.count + column;
        if (column + 1 < columns_.count) link(of_strip_[strip], of_strip_[strip + 1]);
        if (row + 1 < rows_.count) link(of_strip_[strip], of_strip_[strip + columns_.count]);
      }
  }

  void link(std::uint32_t a, std::uint32_t b) {
    if (a == kNone || b == kNone) return;
    WalkGraph::Place &one = graph_.places[a], &other = graph_.places[b];
    if (!space_.is_open(one.at, other.at)) return;
    const double length = (other.at - one.at).norm();
    one.links.push_back({b, length});
    other.links.push_back({a, length});
  }

  bool lay_passes(std::uint32_t at) {
    WalkGraph::Place& place = graph_.places[at];
    for (const WalkGraph::Link& in : place.links)
      for (const WalkGraph::Link& out : place.links) {
        const Vector2 from = (graph_.places[in.to].at + place.at) / 2;
        const Vector2 to = (graph_.places[out.to].at + place.at) / 2;
        const auto pass = pass_between(at, from, to);
        if (!pass) return false;
        place.passes.push_back(*pass);
        place.detours.push_back((*pass - from).norm() + (to - *pass).norm() -
                                (in.length + out.length) / 2);
      }
    return !place.links.empty();
  }

  /// From the middle of one link to that of another, by the place or as little aside as it takes to
  /// perceive all its cells.
  std::optional<Vector2> pass_between(std::uint32_t place, const Vector2& from,
                                      const Vector2& to) const {
    const Vector2& at = graph_.places[place].at;
    Vector2 outwards = (at - from).normalized() + (at - to).normalized();
    if (outwards.norm() > 1e-9) outwards.normalize();
    for (double push = 0; push < reach_; push += kPush * grid_.cell) {
      const Vector2 pass = at + push * outwards;
      if (perceives_all(place, {from, pass, to})) return pass;
      if (outwards.norm() < 0.5 || sight_.deadline().passed_after(0)) break;
    }
    return std::nullopt;
  }

  bool perceives_all(std::uint32_t place, const std::array<Vector2, 3>& way) const {
    if (!space_.is_open(way[0], way[1]) || !space_.is_open(way[1], way[2])) return false;
    if (sight_.deadline().passed_after(kCellSeen *
                                       static_cast<std::uint32_t>(cells_[place].size())))
      return false;
    return std::all_of(cells_[place].begin(), cells_[place].end(), [&](std::uint32_t cell) {
      return is_perceived(field_.cells[cell], way[0], way[1]) ||
             is_perceived(field_.cells[cell], way[1], way[2]);
    });
  }

  bool is_perceived(std::size_t cell, const Vector2& from, const Vector2& to) const {
    const Vector2 step = to - from, centre = grid_.centre(cell);
    const double length2 = step.squaredNorm();
    const double part = length2 > 0 ? std::clamp((centre - from).dot(step) / length2, 0.0, 1.0) : 0;
    const Vector2 nearest = from + part * step;
    return (centre - nearest).norm() <= kCountedInTurns * sight_.footprint() &&
           sight_.is_unhidden(nearest, cell);
  }

  bool is_connected() const {
    std::vector<bool> found(graph_.places.size(), false);
    Walk open = {0};
    found[0] = true;
    for (std::size_t i = 0; i < open.size(); ++i)
      for (const WalkGraph::Link& link : graph_.places[open[i]].links)
        if (!found[link.to]) found[link.to] = true, open.push_back(link.to);
    return open.size() == graph_.places.size();
  }

  const PatrolField& field_;
  const PatrolSpace& space_;
  const PatrolSight& sight_;
  const world::Grid& grid_;
  Strips columns_, rows_;
  double reach_ = 0;                               ///< most that turns are pushed [m]
  std::vector<std::uint32_t> of_strip_;            ///< place, by row and column of strips
  std::vector<std::vector<std::uint32_t>> cells_;  ///< per place
  WalkGraph graph_;
};

/// The least length that passing a place takes.
double least_pass(const WalkGraph::Place& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < place.links.size(); ++i)
    for (std::size_t j = 0; j < place.links.size(); ++j)
      least = std::min(least, (place.links[i].length + place.links[j].length) / 2 +
                                  place.detours[i * place.links.size() + j]);
  return least;
}

}  // namespace

std::optional<WalkGraph> make_walk_graph(const PatrolField& field, const PatrolSpace& space,
                                         const PatrolSight& sight) {
  return GraphMaker(field, space, sight).graph();
}

double least_mean_of_walks(const WalkGraph& graph) {
  double roots = 0;
  for (const WalkGraph::Place& place : graph.places)
    roots += std::sqrt(place.risk * least_pass(place));
  return roots * roots / (2 * graph.total_risk);
}

double least_worst_of_walks(const WalkGraph& graph) {
  double worst = 0;
  for (const WalkGraph::Place& place : graph.places) worst += place.top * least_pass(place);
  return worst;
}

// The visits a metre that are best, max(top / worst, λ √(R / c)), fill the metre: λ by halving.
double least_mean_of_walks(const WalkGraph& graph, double worst) {
  if (worst < least_worst_of_walks(graph)) return std::numeric_limits<double>::infinity();
  const auto visits = [&](const WalkGraph::Place& place, double lambda) {
    return std::max(place.top / worst, lambda * std::sqrt(place.risk / least_pass(place)));
  };
  double least = 0, most = 0;
  for (const WalkGraph::Place& place : graph.places)
    most = std::max(most, 1 / std::sqrt(place.risk * least_pass(place)));
  for (int halving = 0; halving < 60; ++halving) {
    const double lambda = (least + most) / 2;
    double filled = 0;
    for (const WalkGraph::Place& place : graph.places)
      filled += visits(place, lambda) * least_pass(place);
    (filled > 1 ? most : least) = lambda;
  }
  double mean = 0;
  for (const WalkGraph::Place& place : graph.places) mean += place.risk / visits(place, most);
  return mean / (2 * graph.total_risk);
}

bool append_shortest(const WalkGraph& graph, std::uint32_t from, std::uint32_t to, Walk& walk) {
  // From the end, so that the links followed lead forwards.
  std::vector<std::uint32_t> next(graph.places.size(), kNone);
  Walk open = {to};
  next[to] = to;
  for (std::size_t i = 0; i < open.size() && next[from] == kNone; ++i)
    for (const WalkGraph::Link& link : graph.places[open[i]].links)
      if (next[link.to] == kNone) next[link.to] = open[i], open.push_back(link.to);
  if (next[from] == kNone) return false;
  for (std::uint32_t at = from; at != to && next[at] != to; at = next[at]) walk.push_back(next[at]);
  return true;
}

Walk walk_in_turn(const WalkGraph& graph) {
  std::vector<std::uint32_t> order(graph.places.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) order[place] = place;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vector2 &one = graph.places[a].at, &other = graph.places[b].at;
    return one.y() != other.y() ? one.y() < other.y() : one.x() < other.x();
  });
  for (std::size_t i = 0, lane = 0; i < order.size(); ++lane) {
    std::size_t end = i;
    const double y = graph.places[order[i]].at.y();
    while (end < order.size() && graph.places[order[end]].at.y() == y) ++end;
    if (lane % 2 == 1)
      std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                   order.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
  Walk walk;
  for (std::size_t i = 0; i < order.size(); ++i) {
    walk.push_back(order[i]);
    if (order.size() > 1) append_shortest(graph, order[i], order[(i + 1) % order.size()], walk);
  }
  return walk;
}

std::vector<Vector2> track_of(const WalkGraph& graph, const Walk& walk) {
  std::vector<Vector2> track;
  for (std::size_t i = 0; i < walk.size(); ++i)
    track.push_back(graph.passed_at(walk[(i + walk.size() - 1) % walk.size()], walk[i],
                                    walk[(i + 1) % walk.size()]));
  return track;
}

}  // namespace skein::refiners
