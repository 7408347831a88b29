// SPDX-License-Identifier: Apache-2.0
// Negotiation modalities: the format of offers, and the result that follows from all offers.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/negotiation/terms.hpp"
#include "skein/world/geometry.hpp"

namespace skein::world {
struct World;
}

namespace skein::interaction {

/// The offer of each member, by its name.
using Offers = std::map<std::string, Rows>;

/// A negotiation modality. The protocol is run by the NegotiationManager; a modality is a pure
/// function, so that all members compute the same result from the same offers, in whatever order
/// these arrived. Source: T def. V.6.
class NegotiationModality {
 public:
  NegotiationModality() = default;
  NegotiationModality(const NegotiationModality&) = delete;
  NegotiationModality& operator=(const NegotiationModality&) = delete;
  virtual ~NegotiationModality() = default;

  /// The name used in coordination actions.
  virtual std::string_view name() const = 0;
  /// Why the parameters of a session, or an offer under valid parameters, are invalid; absent: they
  /// are valid.
  std::optional<std::string> problem_of(const Terms& terms) const { return do_check(terms); }
  std::optional<std::string> problem_of(const Terms& terms, const Rows& offer) const;
  /// settle() is too slow for the node's loop: the manager has it run as a job (ReckonResult).
  virtual bool is_long() const { return false; }
  /// The result of the negotiation. Precondition: the terms and all offers are valid, and all
  /// members have offered.
  Result<Rows, Failure> settle(const Terms& terms, const Offers& offers) const;

 private:
  virtual std::optional<std::string> do_check(const Terms& terms) const = 0;
  virtual std::optional<std::string> do_check_offer(const Terms& terms,
                                                    const Rows& offer) const = 0;
  virtual Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const = 0;
};

struct Sweeper;
/// Duration of the flight of `sweeper` to `part` and over it, above level ground [s]; absent:
/// unknown. Must be the same at all members for the same arguments.
using FlownSweep = std::function<std::optional<double>(
    const Sweeper& sweeper, const world::Polygon& part, const world::World& ground)>;

/// The result for ReckonResult, by the standard modality that the terms name. With `flown`, areas
/// are divided by the durations that it gives. Any thread.
Result<Rows, Failure> reckon(const Terms& terms, const Offers& offers,
                             const FlownSweep& flown = {});

/// Modalities by name.
using Modalities = std::map<std::string, std::shared_ptr<const NegotiationModality>, std::less<>>;

/// Role allocation, time interval, area sharing, perception positions, relay chain.
Modalities standard_modalities(const FlownSweep& flown = {});

}  // namespace skein::interaction
