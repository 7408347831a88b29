// SPDX-License-Identifier: Apache-2.0
// How Cyclone DDS sees the type of a slot.
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::cyclonedds {

/// The DDS type "skein::idl::<slot>", of which Cyclone sees the bytes that cdr.hpp writes and reads
/// and the key in front of them: its serialised-type interface (docs/decisions/0022). No type
/// information goes out. Made for dds_create_topic_sertype(), which then owns it.
ddsi_sertype* make_sample_type(wire::Slot slot);

/// The same type with its XTypes description, which goes out with each of its endpoints.
ddsi_sertype* make_described_type(wire::Slot slot);

/// An outgoing sample with one reference, which the writer takes over (dds_writecdr).
ddsi_serdata* make_outgoing(const ddsi_sertype& type, const wire::Sample& sample);

/// The CDR of a received sample, behind its 4-byte header; empty if only the key was received. Up
/// to three bytes of padding may follow the last field.
std::span<const std::uint8_t> bytes_of(const ddsi_serdata& data);

/// origin, instance and destination, big-endian, filled up with zeros. Source: RTPS 2.3, 9.6.3.8.
using Key = std::array<std::uint8_t, 16>;
Key key_of(const wire::SampleHeader& header);

}  // namespace skein::blackboard::cyclonedds
