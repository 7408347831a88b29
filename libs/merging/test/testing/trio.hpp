// SPDX-License-Identifier: Apache-2.0
// Members and witnesses over a radio of which each delivery is somebody's choice.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/merging/merger.hpp"
#include "skein/merging/witness.hpp"

namespace skein::merging::testing {

inline Volume street(double from, double to) { return {{from, 0}, {to, 0}, 5, 30, 50}; }

/// A value: what would happen is tried on copies. Nothing is delivered by itself, so a message that
/// is not delivered is one that is lost or late, and a node that nothing is delivered to is dead.
class Trio {
 public:
  struct Packet {
    std::string from, to;
    Message message;
  };

  /// Of each member, by whom it is witnessed.
  explicit Trio(const std::vector<std::pair<std::string, std::string>>& witnessed) {
    for (const auto& [name, witness] : witnessed) names_.push_back(name);
    for (const auto& [name, witness] : witnessed) {
      witness_of_[name] = witness;
      members_.emplace(name, Merger(names_, name, {}, witness));
      witnesses_.emplace(witness, Witness(names_)).first->second.begin(true, now_);
      give(name, FirstLife{});
    }
  }

  void give(const std::string& name, const Input& input) {
    for (Effect& effect : members_.at(name).handle(input, now_)) {
      if (auto* tell = std::get_if<Tell>(&effect))
        under_way_.push_back({name, tell->to, std::move(tell->message)});
      if (std::holds_alternative<Granted>(effect)) ++granted_[name];
      if (const auto* waits = std::get_if<Waits>(&effect)) whys_[name] = waits->whys;
    }
  }

  void deliver(std::size_t which) {
    const Packet packet = under_way_.at(which);
    under_way_.erase(under_way_.begin() + static_cast<std::ptrdiff_t>(which));
    const auto witness = witnesses_.find(packet.to);
    if (witness == witnesses_.end()) return give(packet.to, Heard{packet.from, packet.message});
    for (auto& answer : witness->second.hear(packet.from, packet.message, now_))
      under_way_.push_back({packet.to, answer.to, std::move(answer.message)});
  }

  void pass(double seconds) {
    now_ = now_ + Duration::seconds(seconds);
    for (const std::string& name : names_) give(name, Tick{});
  }

  /// It comes back a second later with nothing that it knew, where it was.
  void forget(const std::string& name) {
    now_ = now_ + Duration::seconds(1);
    const Volumes held = members_.at(name).held();
    members_.erase(name);
    members_.emplace(name, Merger(names_, name, {}, witness_of_.at(name)));
    if (!held.empty()) give(name, Hold{held});
  }
  /// Likewise; what is under way to it expires before it hears.
  void witness_forgets(const std::string& name) {
    witnesses_.at(name) = Witness(names_);
    witnesses_.at(name).begin(false, now_);
    std::erase_if(under_way_, [&](const Packet& one) { return one.to == name; });
    pass(3);
  }

  /// It believes that it can speak to nobody, or to all again.
  void is_alone(const std::string& name, bool alone = true) {
    for (const std::string& peer : names_)
      if (peer != name) give(name, InReach{peer, !alone});
    give(name, InReach{witness_of_.at(name), !alone});
    alone ? void(alone_.insert(name)) : void(alone_.erase(name));
  }
  bool is_alone_now(const std::string& name) const { return alone_.contains(name); }

  /// All that is under way, and what follows from it, but what is for these or of them.
  void deliver_all_but(const std::vector<std::string>& silent) {
    const auto is_silent = [&](const std::string& name) {
      return std::find(silent.begin(), silent.end(), name) != silent.end();
    };
    for (std::size_t i = 0; i < under_way_.size();) {
      if (is_silent(under_way_[i].from) || is_silent(under_way_[i].to)) {
        ++i;
      } else {
        deliver(i);
        i = 0;
      }
    }
  }
  void run_for(double seconds, const std::vector<std::string>& silent = {}) {
    for (double t = 0; t < seconds; t += 0.1) {
      deliver_all_but(silent);
      pass(0.1);
    }
  }

  const Merger& member(const std::string& name) const { return members_.at(name); }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<Packet>& under_way() const { return under_way_; }
  int granted(const std::string& name) const {
    return granted_.contains(name) ? granted_.at(name) : 0;
  }
  std::vector<Waits::Why> whys(const std::string& name) const {
    return whys_.contains(name) ? whys_.at(name) : std::vector<Waits::Why>();
  }
  bool two_have_the_same() const {
    for (auto a = members_.begin(); a != members_.end(); ++a)
      for (auto b = std::next(a); b != members_.end(); ++b)
        if (overlap(a->second.held(), b->second.held())) return true;
    return false;
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::string> witness_of_;
  std::map<std::string, Merger> members_;
  std::map<std::string, Witness> witnesses_;
  std::vector<Packet> under_way_;
  std::map<std::string, int> granted_;
  std::set<std::string> alone_;
  std::map<std::string, std::vector<Waits::Why>> whys_;
  MissionTime now_ = MissionTime::seconds(10);
};

inline const std::string kAnna = "a", kBert = "b", kCarl = "c", kGround = "ground";

inline Trio two() { return Trio({{kAnna, kGround}, {kBert, kGround}}); }
inline Trio three() { return Trio({{kAnna, kGround}, {kBert, kGround}, {kCarl, kGround}}); }

}  // namespace skein::merging::testing
