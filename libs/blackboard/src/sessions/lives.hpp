// SPDX-License-Identifier: Apache-2.0
// The lives of one peer: the one that is taken for it, and a rival.
#pragma once

#include <cstdint>
#include <memory>

#include "novelty.hpp"
#include "sessions/life.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Decides which incarnation is the peer, where two are heard at the same time. Durations are
/// steady; `silence` is how long a life may say nothing before it is over.
class Lives {
 public:
  /// The configuration outlives them.
  explicit Lives(const Config& config)
      : config_(&config),
        self_incarnation_(config.incarnation),
        present_(config.self, config.incarnation) {}

  /// The life that is taken for the peer.
  Life& present() { return present_; }
  const Life& present() const { return present_; }
  /// Whether this is the life before the present one, which may still be alive.
  bool is_former(std::uint64_t incarnation) const;
  /// Whether samples of this incarnation were refused until the earlier one was silent.
  bool was_refused(std::uint64_t incarnation) const;
  /// A sample of a refused incarnation came.
  void refused(Duration now) { rival_->life.last_heard = now; }
  /// Whether the heartbeat is new in its incarnation, which is at least the present one or that
  /// before it; then it is the newest.
  Novelty note(const wire::Heartbeat& heartbeat);
  /// The life with this incarnation; while the present one is `reachable` a later one is kept apart
  /// until its first heartbeat. Null: there is none.
  Life* with(std::uint64_t incarnation, bool reachable, Duration now);
  /// That incarnation is the present life from now on.
  void follow(std::uint64_t incarnation, bool reachable, Duration now);
  /// The former life has said something new. Whether it is the present one again.
  bool former_goes_on(Duration silence, Duration now);
  void forget_silent_rival(Duration silence, Duration now);
  /// While the present life is silent, a heartbeat of an older one came, which is none of the
  /// lives: it is the former life from now on, and has still to show that it is alive.
  void consider_older(std::uint64_t incarnation, Duration silence, Duration now);
  /// A heartbeat of the present incarnation came; `restarted`: it is another one than before.
  void heard_present(bool restarted);
  /// A heartbeat of an older incarnation came, which is none of the lives.
  void heard_older();
  /// Whether the present incarnation and an older one were repeatedly heard by turns: both are
  /// alive.
  bool has_older_rival() const { return turns_ >= kTurns; }

  /// The incarnation of this node towards the peer.
  std::uint64_t self_incarnation() const { return self_incarnation_; }
  /// This node has that incarnation from now on.
  void become(std::uint64_t self_incarnation);
  /// All delivered events count as handled.
  void commit();

 private:
  /// After one, an old heartbeat may only be late.
  static constexpr int kTurns = 3;

  const Config* config_;
  std::uint64_t self_incarnation_;
  Life present_;
  std::unique_ptr<Rival> rival_;
  bool heard_present_ = false;  ///< since the last heartbeat of an older incarnation
  int turns_ = 0;               ///< changes from the present incarnation to an older one
};

}  // namespace skein::blackboard
