// SPDX-License-Identifier: Apache-2.0
// Members that merge over a radio that delays, loses, repeats and is cut.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/merging/merger.hpp"

namespace skein::merging::testing {

struct Radio {
  double delay = 0.02, jitter = 0;  ///< [s]
  double loss = 0, repeats = 0;     ///< shares of messages
};

class Net {
 public:
  Net(std::vector<std::string> names, Radio radio = {}, std::uint64_t seed = 1)
      : names_(std::move(names)), radio_(radio), random_(seed) {
    for (const std::string& name : names_) members_.emplace(name, Merger(names_, name));
    for (const std::string& name : names_) {
      for (const std::string& peer : names_) {
        if (peer != name) give(name, InReach{peer, true});
      }
    }
  }

  void give(const std::string& name, const Input& input) {
    for (const Effect& effect : members_.at(name).handle(input, now())) {
      if (const auto* tell = std::get_if<Tell>(&effect)) send(name, *tell);
      if (const auto* granted = std::get_if<Granted>(&effect)) granted_[name] = granted->choice;
      if (const auto* aside = std::get_if<MoveAside>(&effect)) {
        asked_aside_.push_back(name);
        asides_.push_back(*aside);
      }
      if (const auto* waits = std::get_if<Waits>(&effect)) whys_[name] = waits->whys;
    }
  }

  /// From a place that nobody else has.
  void stands(const std::string& name, const Volume& stay) { give(name, Hold{{stay}}); }
  void wants(const std::string& name, std::vector<Volumes> choices) {
    granted_.erase(name);
    whys_.erase(name);
    give(name, Want{std::move(choices)});
  }

  void forget_grant(const std::string& name) { granted_.erase(name); }

  void cut(const std::string& one, const std::string& other, bool is_cut = true) {
    const auto link = std::minmax(one, other);
    if (is_cut)
      cuts_.insert(link);
    else
      cuts_.erase(link);
    give(one, InReach{other, !is_cut});
    give(other, InReach{one, !is_cut});
  }

  void set_radio(Radio radio) { radio_ = radio; }

  /// It comes back with nothing it knew.
  void forget(const std::string& name) {
    members_.erase(name);
    members_.emplace(name, Merger(names_, name));
    granted_.erase(name);
    for (const std::string& peer : names_) {
      if (peer != name) give(name, InReach{peer, !cuts_.contains(std::minmax(name, peer))});
    }
  }

  void run_for(double seconds) {
    for (const double until = now_ + seconds; now_ < until;) step();
  }

  /// A hundredth of a second.
  void step() {
    now_ += 0.01;
    while (!under_way_.empty() && under_way_.begin()->first <= now_) {
      const auto [from, tell] = under_way_.begin()->second;
      under_way_.erase(under_way_.begin());
      if (!cuts_.contains(std::minmax(from, tell.to))) give(tell.to, Heard{from, tell.message});
    }
    for (const std::string& name : names_) {
      const auto next = members_.at(name).next_wakeup();
      if (next && *next <= now()) give(name, Tick{});
    }
  }

  const Merger& member(const std::string& name) const { return members_.at(name); }
  bool has_what_it_wanted(const std::string& name) const { return granted_.contains(name); }
  std::size_t choice_of(const std::string& name) const { return granted_.at(name); }
  const std::vector<std::string>& asked_aside() const { return asked_aside_; }
  const std::vector<MoveAside>& asides() const { return asides_; }
  std::vector<Waits::Why> whys(const std::string& name) const {
    return whys_.contains(name) ? whys_.at(name) : std::vector<Waits::Why>();
  }
  /// "uav1 and uav2" where both hold the same air; empty: nobody does.
  std::string both() const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      for (std::size_t j = i + 1; j < names_.size(); ++j) {
        if (overlap(member(names_[i]).held(), member(names_[j]).held()))
          return names_[i] + " and " + names_[j];
      }
    }
    return "";
  }
  MissionTime now() const { return MissionTime::seconds(now_); }
  std::size_t messages() const { return messages_; }
  /// For whom one waits, as it told another last.
  const std::vector<std::string>& told_to_wait_for(const std::string& one,
                                                   const std::string& other) const {
    return waits_told_.at({one, other});
  }
  /// That were told, over all messages.
  std::size_t volumes() const { return volumes_; }

 private:
  void send(const std::string& from, const Tell& tell) {
    ++messages_;
    if (!tell.message.brief) waits_told_[{from, tell.to}] = tell.message.claim.waits_for;
    volumes_ += tell.message.claim.held.size() + tell.message.claim.wanted.size();
    const auto once = [&] {
      if (random_.chance(radio_.loss)) return;
      under_way_.emplace(now_ + radio_.delay + random_.uniform(0, radio_.jitter),
                         std::pair(from, tell));
    };
    once();
    if (random_.chance(radio_.repeats)) once();
  }

  std::vector<std::string> names_;
  Radio radio_;
  Random random_;
  double now_ = 0;
  std::map<std::string, Merger> members_;
  std::map<std::string, std::size_t> granted_;
  std::map<std::string, std::vector<Waits::Why>> whys_;
  std::vector<std::string> asked_aside_;
  std::vector<MoveAside> asides_;
  std::set<std::pair<std::string, std::string>> cuts_;
  std::multimap<double, std::pair<std::string, Tell>> under_way_;
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> waits_told_;
  std::size_t messages_ = 0, volumes_ = 0;
};

}  // namespace skein::merging::testing
