// SPDX-License-Identifier: Apache-2.0
// What a planning domain names, and what it was refused.
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

/// Within which a vehicle counts as being at a place [m]: what it wavers and, when it cannot hover,
/// its circle.
double vicinity(const Gazetteer& gazetteer);

/// The gazetteer for terms; a name that it does not have is refused in words. Thread rule: one
/// thread at a time.
class HostNames {
 public:
  explicit HostNames(Gazetteer gazetteer) : gazetteer_(std::move(gazetteer)) {}

  const Gazetteer& gazetteer() const { return gazetteer_; }
  std::optional<world::Vector3> place(const htn::TermStore& store, htn::Term term);
  /// nil, and the sentence is kept.
  htn::Term refuse(const std::string& why);
  /// Each once, in the order they came.
  const std::vector<std::string>& refusals() const { return refusals_; }
  /// Each time it was said, since the last begin().
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
