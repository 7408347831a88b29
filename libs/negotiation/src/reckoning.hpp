// SPDX-License-Identifier: Apache-2.0
// What follows from the offers of a session, at one member.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "facts.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::interaction {

/// Judges offers by the modality and comes to a result once: here or, where that takes long, by a
/// job. Not safe to share between threads. Precondition of what is not said otherwise: begun.
class Reckoning {
 public:
  void begin(std::shared_ptr<const NegotiationModality> modality);
  const NegotiationModality& modality() const { return *modality_; }

  /// Why one of the known offers is invalid; absent: none is.
  std::optional<std::string> bad_offer(const Terms& terms, const Facts& facts) const;
  /// Reckons the result, or asks for it once (ReckonResult); no effect if it is known. Returns why
  /// there is none. Precondition: all have offered, and no offer is bad.
  std::optional<std::string> reckon(const Terms& terms, const Facts& facts,
                                    NegotiationEffects& out);
  /// The answer. Returns why there is no result.
  std::optional<std::string> know(Result<Rows, Failure> result);

  /// Whether it was asked for and is not answered. Also before it has begun.
  bool is_under_way() const { return under_way_; }
  /// Also before it has begun.
  const std::optional<Rows>& result() const { return result_; }
  /// By which members compare results. Precondition: result().
  std::uint64_t fingerprint() const;

 private:
  std::shared_ptr<const NegotiationModality> modality_;
  std::optional<Rows> result_;
  bool under_way_ = false;
};

}  // namespace skein::interaction
