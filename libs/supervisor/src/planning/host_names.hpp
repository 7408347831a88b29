// SPDX-License-Identifier: Apache-2.0
// Name look-ups of a planning domain, and the refusals that it was given.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "planning/gazetteer.hpp"
#include "skein/foundation/result.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::supervisor {

using HostArguments = std::span<const htn::Term>;
using HostValue = Result<htn::Term, Failure>;

/// Distance within which a vehicle counts as being at a place [m]: its tracking error and, if it
/// cannot hover, its waiting circle.
double vicinity(const Gazetteer& gazetteer);

/// The gazetteer, with a record of refusals; an unknown name is refused in words. Thread rule: one
/// thread at a time.
class HostNames {
 public:
  explicit HostNames(Gazetteer gazetteer) : gazetteer_(std::move(gazetteer)) {}

  const Gazetteer& gazetteer() const { return gazetteer_; }
  std::optional<world::Vector3> place(const htn::TermStore& store, htn::Term term);
  /// Records the sentence; returns nil.
  htn::Term refuse(const std::string& why);
  /// The refusals since begin(), each sentence once, in order.
  const std::vector<std::string>& refusals() const { return refusals_; }
  /// The refusals since begin(), with repetitions.
  const std::vector<std::string>& said() const { return said_; }
  void begin() {
    refusals_.clear();
    said_.clear();
  }

 private:
  Gazetteer gazetteer_;
  std::vector<std::string> refusals_, said_;
};

}  // namespace skein::supervisor
