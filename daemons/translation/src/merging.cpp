// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/merging.hpp"

namespace skein::translation {

namespace {

using merging::Volume;
using merging::Volumes;

std::vector<wire::AirVolume> to_wire(const Volumes& volumes) {
  std::vector<wire::AirVolume> result;
  for (const Volume& one : volumes)
    result.push_back(
        {one.from.x(), one.from.y(), one.to.x(), one.to.y(), one.radius, one.floor, one.ceiling});
  return result;
}

Read<Volumes> from_wire(const std::vector<wire::AirVolume>& sample, const std::string& field) {
  Volumes result;
  for (const wire::AirVolume& one : sample) {
    const std::string path = field + "[" + std::to_string(result.size()) + "]";
    if (one.radius <= 0)
      return tl::unexpected(wire::Violation{path + ".radius", "not greater than 0"});
    if (one.ceiling_z <= one.floor_z)
      return tl::unexpected(wire::Violation{path + ".ceiling_z", "not above the floor"});
    result.push_back(
        {{one.from_x, one.from_y}, {one.to_x, one.to_y}, one.radius, one.floor_z, one.ceiling_z});
  }
  return result;
}

}  // namespace

wire::MergeMessage to_wire(const merging::Message& message) {
  wire::MergeMessage sample;
  sample.number = message.number;
  sample.held = to_wire(message.claim.held);
  sample.request = message.claim.request;
  sample.wanted = to_wire(message.claim.wanted);
  sample.waits_for = message.claim.waits_for;
  sample.keeps = message.claim.keeps;
  sample.answered = message.answered;
  sample.granted = message.granted;
  sample.asks = message.asks;
  sample.of = message.of;
  sample.version = message.version;
  sample.known = message.known;
  sample.brief = message.brief;
  return sample;
}

Read<merging::Message> from_wire(const wire::MergeMessage& sample) {
  auto held = from_wire(sample.held, "held");
  if (!held) return tl::unexpected(held.error());
  auto wanted = from_wire(sample.wanted, "wanted");
  if (!wanted) return tl::unexpected(wanted.error());
  merging::Message message;
  message.number = sample.number;
  message.claim = {std::move(*held), sample.request, std::move(*wanted), sample.waits_for,
                   sample.keeps};
  message.answered = sample.answered;
  message.granted = sample.granted;
  message.asks = sample.asks;
  message.of = sample.of;
  message.version = sample.version;
  message.known = sample.known;
  message.brief = sample.brief;
  return message;
}

}  // namespace skein::translation
