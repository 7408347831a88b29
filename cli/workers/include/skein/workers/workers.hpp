// SPDX-License-Identifier: Apache-2.0
// Runs jobs in separate processes, several at once, so that a crash or hang affects only one job.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace skein::workers {

/// Done in a process of its own, which is a copy of this one; gives what it has to say.
using Work = std::function<std::string()>;

struct Outcome {
  enum class End { kDone, kDied, kHung };
  End end = End::kDone;
  std::string said;
  std::string why;  ///< kDied, kHung: for people
};

struct Limits {
  int jobs = 1;       ///< at once, from 1
  int patience = 60;  ///< [s] of processor time for one
};

/// Does what `next` gives, until it gives nothing, and tells of each by its number, from 0 in the
/// order given; in the order in which they are done. Precondition: one thread.
void do_apart(const std::function<std::optional<Work>()>& next, const Limits& limits,
              const std::function<void(std::uint64_t number, const Outcome&)>& tell);
Outcome do_apart(const Work& work, const Limits& limits);

}  // namespace skein::workers
