// SPDX-License-Identifier: Apache-2.0
// "heliv", or another partner, who answers in sessions that others open.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node::testing {

/// Takes part in each session to which it is invited.
class NegotiatingPartner {
 public:
  using Offer = Result<interaction::Rows, Failure>;

  /// With the same offer in each.
  explicit NegotiatingPartner(Offer offer)
      : NegotiatingPartner(
            [offer = std::move(offer)](const interaction::Terms&) { return offer; }) {}
  explicit NegotiatingPartner(std::function<Offer(const interaction::Terms&)> offer,
                              const std::string& name = "heliv")
      : offer_(std::move(offer)), manager_(name, 1, interaction::standard_modalities(), {}, {}) {}

  std::vector<interaction::SessionMessage> answers(const interaction::NegotiationInput& input,
                                                   MissionTime now) {
    std::vector<interaction::SessionMessage> sent;
    const auto effects = manager_.handle(input, now);
    for (const interaction::NegotiationEffect& effect : effects.value()) {
      std::vector<interaction::SessionMessage> more;
      if (const auto* send = std::get_if<interaction::SendSessionMessage>(&effect)) {
        more = {send->message};
      } else if (const auto* invited = std::get_if<interaction::InvitedToNegotiate>(&effect)) {
        const interaction::Terms& terms = invited->terms;
        more = answers(interaction::BeginNegotiation{terms.subject, terms.modality, terms.members,
                                                     terms.model, terms.parameters},
                       now);
      } else if (const auto* asked = std::get_if<interaction::PrepareOffer>(&effect)) {
        more = answers(interaction::OfferPrepared{asked->terms.id(), offer_(asked->terms)}, now);
      }
      sent.insert(sent.end(), more.begin(), more.end());
    }
    return sent;
  }

 private:
  std::function<Offer(const interaction::Terms&)> offer_;
  interaction::NegotiationManager manager_;
};

}  // namespace skein::decision_node::testing
