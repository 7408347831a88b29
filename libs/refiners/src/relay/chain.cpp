// SPDX-License-Identifier: Apache-2.0
// Chains of relays: hop by hop from one end, the widest way to each place with so many hops.
#include <algorithm>
#include <cmath>
#include <limits>

#include "relay/space.hpp"

namespace skein::refiners::relay {
namespace {

constexpr std::int32_t kVoxels = 8;  // that are looked at in a unit of work
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

struct Station {
  Vector3 position = Vector3::Zero();
  double width = 0;              ///< margin of the weakest link from a
  std::size_t before = kNobody;  ///< the station it hears a through; kNobody: a itself
};

/// The open voxels of a lattice, every `stride`-th along each axis; not all of them when there are
/// more than `most`, or the time is up.
std::vector<Station> lattice(const Space& space, std::int32_t stride, std::size_t most,
                             Meter& meter) {
  std::vector<Station> stations;
  const auto& size = space.grid().size;
  const auto first = [&](std::size_t axis) { return std::min(stride, size[axis]) / 2; };
  for (std::int32_t z = first(2); z < size[2]; z += stride)
    for (std::int32_t y = first(1); y < size[1]; y += stride) {
      if (!meter.work(static_cast<std::uint32_t>(size[0] / stride / kVoxels + 1))) return stations;
      for (std::int32_t x = first(0); x < size[0]; x += stride) {
        if (!space.is_open({x, y, z})) continue;
        stations.push_back({space.centre({x, y, z}), 0, kNobody});
        if (stations.size() > most) return stations;
      }
    }
  return stations;
}

class ChainSearch {
 public:
  ChainSearch(const Space& space, const RelayQuery& query, Meter& meter)
      : space_(space), query_(query), meter_(meter) {}

  std::optional<Chain> run() {
    std::int32_t stride = 1;
    while ((stations_ = lattice(space_, stride, kMostRelayPlaces, meter_)).size() >
           kMostRelayPlaces)
      if (++stride, !meter_.work(64)) return std::nullopt;
    if (meter_.over()) return std::nullopt;
    for (std::size_t i = 0; i < stations_.size(); ++i) unreached_.push_back(i);
    if (!first_hop()) return std::nullopt;
    for (std::size_t relays = 2; relays <= query_.most; ++relays) {
      if (!next_hop(query_.most - relays)) return std::nullopt;
      if (auto last = widest(query_.b)) {
        if (meter_.over()) return std::nullopt;
        Chain chain = traced(last->before);
        chain.margin = last->width;
        chain.spacing = stride * space_.grid().voxel;
        if (stride > 1) settle(chain);
        return chain;
      }
    }
    return std::nullopt;
  }

 private:
  struct Option {
    double width;
    std::size_t before;
    bool operator<(const Option& other) const {
      return width != other.width ? width < other.width : before > other.before;
    }
  };

  bool links(double margin) const { return margin >= space_.least_margin(); }

  bool first_hop() {
    reach([&](const Vector3& position) -> std::optional<Option> {
      const double margin = space_.margin((position - query_.a).norm());
      if (!links(margin) || !meter_.link() || !space_.is_in_sight(query_.a, position))
        return std::nullopt;
      return Option{margin, kNobody};
    });
    return !meter_.over() && !layer_.empty();
  }

  /// `to_come`: relays that may follow the ones of this hop.
  bool next_hop(std::size_t to_come) {
    const double most = static_cast<double>(to_come + 1) * space_.longest_link() * (1 + 1e-9);
    reach([&](const Vector3& position) -> std::optional<Option> {
      if ((position - query_.b).norm() > most) return std::nullopt;
      return widest(position);
    });
    return !meter_.over() && !layer_.empty();
  }

  /// The stations not yet reached that `way_to` finds a way to are the next layer.
  template <class WayTo>
  void reach(const WayTo& way_to) {
    std::vector<std::size_t> next, left;
    for (const std::size_t i : unreached_) {
      const auto option = meter_.over() ? std::nullopt : way_to(stations_[i].position);
      (option ? next : left).push_back(i);
      if (!option) continue;
      stations_[i].width = option->width;
      stations_[i].before = option->before;
    }
    layer_ = std::move(next);
    unreached_ = std::move(left);
  }

  /// The widest way to a place through the last layer: what would be widest in sight is looked at
  /// first, so the first in sight is the widest.
  std::optional<Option> widest(const Vector3& position) {
    options_.clear();
    for (const std::size_t i : layer_) {
      const double margin = space_.margin((position - stations_[i].position).norm());
      if (links(margin)) options_.push_back({std::min(margin, stations_[i].width), i});
    }
    if (!meter_.work(static_cast<std::uint32_t>(layer_.size()))) return std::nullopt;
    std::make_heap(options_.begin(), options_.end());
    for (auto end = options_.end(); end != options_.begin(); --end) {
      std::pop_heap(options_.begin(), end);
      const Option& best = *(end - 1);
      if (!meter_.link()) return std::nullopt;
      if (space_.is_in_sight(stations_[best.before].position, position)) return best;
    }
    return std::nullopt;
  }

  Chain traced(std::size_t last) const {
    Chain chain;
    for (std::size_t i = last; i != kNobody; i = stations_[i].before)
      chain.positions.push_back(stations_[i].position);
    std::reverse(chain.positions.begin(), chain.positions.end());
    return chain;
  }

  /// Moves each relay to the best voxel between its neighbours, as long as that helps.
  void settle(Chain& chain) {
    const auto at = [&](std::size_t i) -> const Vector3& {
      return i == 0 ? query_.a : i > chain.positions.size() ? query_.b : chain.positions[i - 1];
    };
    for (int pass = 0; pass < kPasses && !meter_.over(); ++pass)
      for (std::size_t i = 1; i <= chain.positions.size(); ++i)
        if (const auto place = best_between(space_, at(i - 1), at(i + 1), meter_))
          chain.positions[i - 1] = place->position;
    chain.margin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= chain.positions.size(); ++i)
      chain.margin = std::min(chain.margin, space_.margin((at(i + 1) - at(i)).norm()));
  }

  static constexpr int kPasses = 3;
  const Space& space_;
  const RelayQuery& query_;
  Meter& meter_;
  std::vector<Station> stations_;
  std::vector<std::size_t> unreached_, layer_;
  std::vector<Option> options_;
};

}  // namespace

std::optional<Chain> best_chain(const Space& space, const RelayQuery& query, Meter& meter) {
  if (query.most < 2) return std::nullopt;
  return ChainSearch(space, query, meter).run();
}

}  // namespace skein::refiners::relay
