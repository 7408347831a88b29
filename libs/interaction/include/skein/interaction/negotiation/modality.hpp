// SPDX-License-Identifier: Apache-2.0
// What is negotiated: what members offer, and the result that follows from all offers.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/interaction/negotiation/terms.hpp"

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

/// The answer to ReckonResult, by the standard modality that the terms name. Any thread.
Result<Rows, Failure> reckon(const Terms& terms, const Offers& offers);

/// By name.
using Modalities = std::map<std::string, std::shared_ptr<const NegotiationModality>, std::less<>>;

/// Role allocation, time interval, area sharing, perception positions, relay chain.
Modalities standard_modalities();

}  // namespace skein::interaction
