// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/peers.hpp"

#include <algorithm>

#include "names.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::merging {

namespace {

void add(Volumes& all, const Volumes& more) { all.insert(all.end(), more.begin(), more.end()); }

}  // namespace

Peers::Peers(const std::vector<std::string>& members, const std::string& self, bool with_witness) {
  const auto own = std::find(members.begin(), members.end(), self);
  SKEIN_EXPECTS(own != members.end());
  for (auto one = members.begin(); one != members.end(); ++one) {
    if (one == own) continue;
    Peer& peer = all_[*one];
    peer.earlier = one < own;
    peer.needed = peer.earlier || with_witness;
  }
}

Peer* Peers::find(const std::string& name) {
  const auto found = all_.find(name);
  return found == all_.end() ? nullptr : &found->second;
}

const Peer* Peers::find(const std::string& name) const {
  const auto found = all_.find(name);
  return found == all_.end() ? nullptr : &found->second;
}

Volumes Peers::others() const {
  Volumes all;
  for (const auto& [name, peer] : all_) {
    add(all, peer.claim().held);
    add(all, peer.claim().wanted);
  }
  return all;
}

Volumes Peers::taken(const std::vector<std::string>& wanting) const {
  Volumes all;
  for (const auto& [name, peer] : all_) {
    add(all, peer.claim().held);
    if (peer.claim().request != 0 || is_among(wanting, name)) add(all, peer.claim().wanted);
  }
  return all;
}

Volumes Peers::ends() const {
  Volumes all;
  for (const auto& [name, peer] : all_) {
    const bool stays = peer.claim().wanted.empty() || !peer.reachable;
    const Volumes& last = stays ? peer.claim().held : peer.claim().wanted;
    if (!last.empty()) all.push_back(last.back());
  }
  return all;
}

Duration Peers::slowest() const {
  Duration slowest;
  for (const auto& [name, peer] : all_)
    if (peer.reachable && !peer.agreed) slowest = std::max(slowest, peer.exchange.round_trip());
  return slowest;
}

bool Peers::flies(const std::string& name) const {
  const Peer* peer = find(name);
  return peer != nullptr && peer->reachable && peer->flies();
}

}  // namespace skein::merging
