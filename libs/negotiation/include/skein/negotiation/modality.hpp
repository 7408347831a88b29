// SPDX-License-Identifier: Apache-2.0
// What is negotiated: what members offer, and the result that follows from all offers.
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

/// What each member offered, by its name.
using Offers = std::map<std::string, Rows>;

/// A negotiation modality. The protocol is the manager's; a modality is pure, so that all members
/// reckon the same result from the same offers, in whatever order they came. Source: T def. V.6.
class NegotiationModality {
 public:
  NegotiationModality() = default;
  NegotiationModality(const NegotiationModality&) = delete;
  NegotiationModality& operator=(const NegotiationModality&) = delete;
  virtual ~NegotiationModality() = default;

  /// As coordination actions name it.
  virtual std::string_view name() const = 0;
  /// What is wrong with the parameters of a session, or with an offer under sound ones.
  std::optional<std::string> problem_of(const Terms& terms) const { return do_check(terms); }
  std::optional<std::string> problem_of(const Terms& terms, const Rows& offer) const;
  /// To settle takes longer than a node may be deaf: it is a job, which the manager asks for.
  virtual bool is_long() const { return false; }
  /// The result. Precondition: no problem of the terms, nor of any offer; all members offered.
  Result<Rows, Failure> settle(const Terms& terms, const Offers& offers) const;

 private:
  virtual std::optional<std::string> do_check(const Terms& terms) const = 0;
  virtual std::optional<std::string> do_check_offer(const Terms& terms,
                                                    const Rows& offer) const = 0;
  virtual Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const = 0;
};

struct Sweeper;
/// Seconds from when it sets out until it has swept that part of an area, over level ground, as it
/// flies that; nothing: unknown. The same at all members for the same arguments.
using FlownSweep = std::function<std::optional<double>(
    const Sweeper& sweeper, const world::Polygon& part, const world::World& ground)>;

/// The answer to ReckonResult, by the standard modality that the terms name; areas are shared by
/// what is flown, if that is given. Any thread.
Result<Rows, Failure> reckon(const Terms& terms, const Offers& offers,
                             const FlownSweep& flown = {});

/// By name.
using Modalities = std::map<std::string, std::shared_ptr<const NegotiationModality>, std::less<>>;

/// Role allocation, time interval, area sharing, perception positions, relay chain.
Modalities standard_modalities(const FlownSweep& flown = {});

}  // namespace skein::interaction
