// SPDX-License-Identifier: Apache-2.0
#include "radio_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skein::sim {

namespace {

constexpr world::RadioLink kDown{false, {}, 1, 0};

/// All pairs of places no further apart than `distance`, which is above 0. Cost: proportional to
/// the pairs in neighbouring squares of that side (of a metre at least).
std::vector<std::pair<std::size_t, std::size_t>> pairs_within(
    const std::vector<world::Vector3>& places, double distance) {
  using Square = std::pair<double, double>;
  const double side = std::max(distance, 1.0);
  std::map<Square, std::vector<std::size_t>> squares;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double x = std::floor(places[i].x() / side), y = std::floor(places[i].y() / side);
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto others = squares.find({x + dx, y + dy});
        if (others == squares.end()) continue;
        for (const std::size_t other : others->second)
          if ((places[i] - places[other]).norm() <= distance) pairs.emplace_back(other, i);
      }
    }
    squares[{x, y}].push_back(i);
  }
  return pairs;
}

/// Whether it says something of this direction now.
template <class Scripted>
bool holds(const Scripted& one, const std::string& from, const std::string& to, MissionTime now) {
  const bool there = one.a == from && one.b == to;
  const bool back = one.a == to && one.b == from;
  return (there || (back && !one.one_way)) && now >= one.from && now < one.until;
}

}  // namespace

const RadioNetwork::Pair RadioNetwork::kBothDown{false, {kDown, kDown}};

RadioNetwork::RadioNetwork(const SimulatorConfig& config, std::vector<std::string> nodes)
    : model_(config.radio),
      cuts_(config.cuts),
      scripts_(config.links),
      period_(config.radio_period),
      nodes_(std::move(nodes)),
      next_(config.start),
      next_look_(config.start) {
  std::map<std::string, std::size_t> indices;
  for (const std::string& node : nodes_) indices.emplace(node, indices.size());
  const auto note = [&](const auto& scripted) {
    for (const auto& one : scripted) {
      const auto a = indices.find(one.a), b = indices.find(one.b);
      if (a != indices.end() && b != indices.end())
        scripted_.insert(std::minmax(a->second, b->second));
    }
  };
  note(cuts_);
  note(scripts_);
}

void RadioNetwork::update(const std::vector<world::Vector3>& positions,
                          const world::Terrain& terrain, MissionTime now,
                          std::vector<Effect>& effects) {
  if (now >= next_look_) {
    next_look_ = now + period_;
    look(positions, terrain);
  }
  for (auto& [ends, pair] : pairs_) {
    for (const std::size_t way : {0U, 1U}) {
      const std::size_t from = way == 0 ? ends.first : ends.second;
      const std::size_t to = way == 0 ? ends.second : ends.first;
      const world::RadioLink is = pair.in_contact ? link(ends, from, to, now) : kDown;
      if (!first_ && is != pair.links[way]) tell(from, to, is, now, effects);
      pair.links[way] = is;
    }
  }
  if (std::exchange(first_, false)) tell_all(now, effects);
  std::erase_if(pairs_, [](const auto& one) { return !one.second.in_contact; });
  next_ = next_after(now);
}

void RadioNetwork::look(const std::vector<world::Vector3>& positions,
                        const world::Terrain& terrain) {
  for (const Ends& ends : pairs_within(positions, model_.reach()))
    pairs_.try_emplace(ends, kBothDown);
  for (auto& [ends, pair] : pairs_)
    pair.in_contact =
        model_.link(positions[ends.first], positions[ends.second], terrain, pair.in_contact).up;
}

void RadioNetwork::tell_all(MissionTime now, std::vector<Effect>& effects) const {
  std::size_t up = 0;
  for (const auto& [ends, pair] : pairs_)
    up += static_cast<std::size_t>(std::ranges::count(pair.links, true, &world::RadioLink::up));
  const bool are_most_down = 2 * up < nodes_.size() * (nodes_.size() - 1);
  if (are_most_down)
    effects.push_back(LinkChange{kEveryLink, kEveryLink, false, {}, kDown.loss, now, 0});
  const auto tell_pair = [&](const Ends& ends, const Pair& pair) {
    for (const std::size_t way : {0U, 1U}) {
      const std::size_t from = way == 0 ? ends.first : ends.second;
      const std::size_t to = way == 0 ? ends.second : ends.first;
      if (!are_most_down || pair.links[way].up) tell(from, to, pair.links[way], now, effects);
    }
  };
  if (are_most_down) {
    for (const auto& [ends, pair] : pairs_) tell_pair(ends, pair);
    return;
  }
  for (std::size_t a = 0; a < nodes_.size(); ++a) {
    for (std::size_t b = a + 1; b < nodes_.size(); ++b) {
      const auto pair = pairs_.find({a, b});
      tell_pair({a, b}, pair == pairs_.end() ? kBothDown : pair->second);
    }
  }
}

void RadioNetwork::tell(std::size_t from, std::size_t to, const world::RadioLink& is,
                        MissionTime now, std::vector<Effect>& effects) const {
  effects.push_back(
      LinkChange{nodes_[from], nodes_[to], is.up, is.latency, is.loss, now, is.capacity});
}

world::RadioLink RadioNetwork::link(const Ends& ends, std::size_t from, std::size_t to,
                                    MissionTime now) const {
  world::RadioLink link{true, model_.latency, model_.loss, model_.capacity};
  if (!scripted_.contains(ends)) return link;
  const std::string &a = nodes_[from], &b = nodes_[to];
  if (std::ranges::any_of(cuts_, [&](const RadioCut& cut) { return holds(cut, a, b, now); }))
    return kDown;
  for (const RadioScript& script : scripts_) {
    if (!holds(script, a, b, now)) continue;
    link.latency = script.latency.value_or(link.latency);
    link.loss = script.loss.value_or(link.loss);
    link.capacity = script.capacity.value_or(link.capacity);
  }
  return link;
}

MissionTime RadioNetwork::next_after(MissionTime now) const {
  MissionTime next = next_look_;
  const auto consider = [&](const auto& scripted) {
    for (const auto& one : scripted)
      for (const MissionTime at : {one.from, one.until})
        if (at > now) next = std::min(next, at);
  };
  consider(cuts_);
  consider(scripts_);
  return next;
}

}  // namespace skein::sim
