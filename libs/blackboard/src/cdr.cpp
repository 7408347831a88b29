// SPDX-License-Identifier: Apache-2.0
// CDR version 1 of the wire types. Source: OMG RTPS 2.3, 10.2 (encapsulation); CORBA 3.3 part
// 2, 9.3.
//
// The generated readers are not used for what comes in: they name no field, and fastcdr lets an
// exception out on a boolean that is neither 0 nor 1. A test compares this with the code that
// fastddsgen and idlc generate, for every type.
#include "skein/blackboard/cdr.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "field_types.hpp"
#include "skein/foundation/cdr_writer.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

constexpr std::size_t kEncapsulation = kCdrEncapsulation.size();

/// Writes the value at `value`, or counts its bytes.
void put(CdrWriter& writer, const wire::FieldType& type, const void* value);

/// As its bits: a real goes like a number of its size.
void put_number(CdrWriter& writer, std::size_t size, const void* value) {
  switch (size) {
    case 1:
      return writer("", wire::loaded<std::uint8_t>(value));
    case 2:
      return writer("", wire::loaded<std::uint16_t>(value));
    case 4:
      return writer("", wire::loaded<std::uint32_t>(value));
    default:
      return writer("", wire::loaded<std::uint64_t>(value));
  }
}

void put_sequence(CdrWriter& writer, const wire::FieldType& type, const void* values) {
  const std::size_t count = type.count(values);
  writer("", static_cast<std::uint32_t>(count));
  const void* const elements = type.elements(values);
  for (std::size_t i = 0; i < count; ++i)
    put(writer, *type.element, wire::at(elements, i * type.element->size));
}

void put(CdrWriter& writer, const wire::FieldType& type, const void* value) {
  switch (type.kind) {
    case wire::FieldKind::kBoolean:
      return writer("", wire::loaded<bool>(value));
    case wire::FieldKind::kText:
      return writer("", wire::text_at(value));
    case wire::FieldKind::kSequence:
      return put_sequence(writer, type, value);
    case wire::FieldKind::kRecord:
      for (const wire::Field& field : type.fields)
        put(writer, *field.type, wire::at(value, field.offset));
      return;
    default:
      return put_number(writer, type.size, value);
  }
}

/// Reads value after value until one is wrong; the path of that one is put together on the way out.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, bool reverse) : bytes_(bytes), reverse_(reverse) {}
  std::optional<wire::Violation> take_violation() { return std::move(violation_); }

  void get(const wire::FieldType& type, void* value) {
    switch (type.kind) {
      case wire::FieldKind::kBoolean:
        return get(*static_cast<bool*>(value));
      case wire::FieldKind::kText:
        return get(*static_cast<std::string*>(value));
      case wire::FieldKind::kSequence:
        return get_sequence(type, value);
      case wire::FieldKind::kRecord:
        return get_record(type, value);
      default:
        return get_number(type.size, value);
    }
  }

 private:
  void fail(std::string why) { violation_ = wire::Violation{"", std::move(why)}; }
  void prepend(const std::string& name) {
    std::string& field = violation_->field;
    field = field.empty() || field.front() == '[' ? name + field : name + "." + field;
  }
  std::size_t left() const { return bytes_.size() - at_; }

  /// An enumerator out of range stays as it came: for find_violation.
  void get_number(std::size_t size, void* value) {
    const std::size_t padding = (size - at_ % size) % size;
    if (left() < padding + size) return fail("cut short");
    at_ += padding;
    auto* const to = static_cast<std::uint8_t*>(value);
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
    if (reverse_) std::reverse(to, to + size);
  }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get_number(sizeof(byte), &byte);
    if (!violation_ && byte > 1) return fail(std::to_string(byte) + " is not a truth value");
    value = byte == 1;
  }
  void get(std::string& value) {
    std::uint32_t length = 0;
    get_number(sizeof(length), &length);
    if (violation_) return;
    if (length > wire::kMaximumString + 1) return fail("too long");
    if (length > left()) return fail("cut short");
    // The standard counts the terminating zero; some write an empty string as length 0.
    if (length == 0) return value.clear();
    if (bytes_[at_ + length - 1] != 0) return fail("not terminated");
    value.resize(length - 1);
    std::memcpy(value.data(), bytes_.data() + at_, length - 1);
    at_ += length;
  }
  void get_sequence(const wire::FieldType& type, void* values) {
    std::uint32_t count = 0;
    get_number(sizeof(count), &count);
    if (violation_) return;
    if (count > wire::kMaximumSequence) return fail("too many elements");
    if (count > left()) return fail("cut short");  // no element takes less than a byte
    type.resize(values, count);
    // As writable as the sequence is.
    auto* const elements = const_cast<void*>(type.elements(values));
    for (std::size_t i = 0; i < count; ++i) {
      get(*type.element, wire::at(elements, i * type.element->size));
      if (violation_) return prepend("[" + std::to_string(i) + "]");
    }
  }
  void get_record(const wire::FieldType& type, void* record) {
    for (const wire::Field& field : type.fields) {
      get(*field.type, wire::at(record, field.offset));
      if (violation_) return prepend(field.name);
    }
  }

  std::span<const std::uint8_t> bytes_;
  bool reverse_;
  std::size_t at_ = 0;
  std::optional<wire::Violation> violation_;
};

template <std::size_t... I>
wire::Sample empty_sample(wire::Slot slot, std::index_sequence<I...>) {
  wire::Sample sample;
  const auto index = static_cast<std::size_t>(slot);
  static_cast<void>(((I == index && (sample.emplace<I>(), true)) || ...));
  return sample;
}

}  // namespace

std::size_t encoded_size(const wire::Sample& sample) {
  CdrWriter counter;
  put(counter, type_of(slot_of(sample)), record_of(sample));
  return kEncapsulation + counter.used();
}

std::size_t encode(const wire::Sample& sample, std::span<std::uint8_t> out) {
  SKEIN_EXPECTS(out.size() >= kEncapsulation);
  std::ranges::copy(kCdrEncapsulation, out.begin());
  CdrWriter writer(out.subspan(kEncapsulation));
  put(writer, type_of(slot_of(sample)), record_of(sample));
  return kEncapsulation + writer.used();
}

std::vector<std::uint8_t> in_cdr(const wire::Sample& sample) {
  std::vector<std::uint8_t> bytes(encoded_size(sample));
  const std::size_t used = encode(sample, bytes);
  SKEIN_ENSURES(used == bytes.size());
  return bytes;
}

std::variant<wire::Sample, Malformed> decode(wire::Slot slot, std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kEncapsulation || bytes[0] != 0 || bytes[1] > 1) {
    return Malformed{slot, {}, {"", "not CDR version 1"}};
  }
  const bool little = bytes[1] == 1;
  Reader reader(bytes.subspan(kEncapsulation),
                little != (std::endian::native == std::endian::little));
  wire::Sample sample = empty_sample(slot, std::make_index_sequence<wire::kSlotCount>{});
  reader.get(wire::type_of(slot), wire::record_of(sample));
  if (auto violation = reader.take_violation()) {
    return Malformed{slot, wire::header_of(sample), std::move(*violation)};
  }
  return sample;
}

}  // namespace skein::blackboard
