// SPDX-License-Identifier: Apache-2.0
#include "signature.hpp"

namespace skein::blackboard {
namespace {

/// How many states, streams and world events a life may send: two to the power of this.
constexpr int kBitsOfALife = 40;

/// All but the incarnation.
void fill(wire::SampleHeader& header, const Config& config, NodeNumber to, std::uint64_t number,
          Now now) {
  header.origin = config.self.value();
  header.destination = to.value();
  header.sequence_number = number;
  header.mission_time = now.mission.count();
  header.expires = wire::kNever;
  header.mission = config.mission;
}

}  // namespace

Signature::Signature(const Config& config)
    : config_(config),
      number_(std::uint64_t{config.life} << kBitsOfALife),
      incarnation_(config.incarnation) {}

std::uint64_t Signature::sign(wire::SampleHeader& header, const Peer& to, Now now) {
  fill(header, config_, to.channels().number, ++number_, now);
  header.incarnation = to.self_incarnation();
  return number_;
}

void Signature::sign_event(wire::Sample& event, const Peer& to, MissionTime expires,
                           Now now) const {
  wire::SampleHeader& header = wire::header_of(event);
  fill(header, config_, to.channels().number,
       to.known().next_number(to.line().is_long_event(event)), now);
  header.incarnation = to.self_incarnation();
  header.expires = expiry_of(wire::slot_of(event), config_.lifespans, now.mission, expires).count();
}

std::uint64_t Signature::sign_published(wire::SampleHeader& header, Now now) {
  sign_published(header, ++number_, now);
  return number_;
}

void Signature::sign_published(wire::SampleHeader& header, std::uint64_t number, Now now) const {
  fill(header, config_, kEverybody, number, now);
  header.incarnation = incarnation_;
}

void Signature::renew(wire::SampleHeader& header, std::uint64_t incarnation) {
  header.incarnation = incarnation;
  header.sequence_number = ++number_;
}

bool Signature::become(std::uint64_t incarnation) {
  if (incarnation <= incarnation_) return false;
  incarnation_ = incarnation;
  return true;
}

}  // namespace skein::blackboard
