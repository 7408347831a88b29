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

#include "skein/foundation/cdr_writer.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

constexpr std::size_t kEncapsulation = kCdrEncapsulation.size();

/// Reads field after field until one is wrong; the path of that one is put together on the way out.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, bool reverse) : bytes_(bytes), reverse_(reverse) {}
  std::optional<wire::Violation> take_violation() { return std::move(violation_); }

  template <class T>
  void operator()(const char* name, T& value) {
    if (violation_) return;
    get(value);
    if (violation_) prepend(name);
  }

 private:
  void fail(std::string why) { violation_ = wire::Violation{"", std::move(why)}; }
  void prepend(const std::string& name) {
    std::string& field = violation_->field;
    field = field.empty() || field.front() == '[' ? name + field : name + "." + field;
  }
  std::size_t left() const { return bytes_.size() - at_; }

  template <CdrScalar T>
  void get(T& value) {
    const std::size_t padding = (sizeof(T) - at_ % sizeof(T)) % sizeof(T);
    if (left() < padding + sizeof(T)) return fail("cut short");
    at_ += padding;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if (reverse_) value = byte_reversed(value);
  }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    if (!violation_ && byte > 1) return fail(std::to_string(byte) + " is not a truth value");
    value = byte == 1;
  }
  /// Out of range stays as it came: for find_violation.
  template <wire::WireEnum E>
  void get(E& value) {
    std::uint32_t number = 0;
    get(number);
    value = static_cast<E>(number);
  }
  void get(std::string& value) {
    std::uint32_t length = 0;
    get(length);
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
  template <class T>
  void get(std::vector<T>& values) {
    std::uint32_t count = 0;
    get(count);
    if (violation_) return;
    if (count > wire::kMaximumSequence) return fail("too many elements");
    if (count > left()) return fail("cut short");  // no element takes less than a byte
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      get(values[i]);
      if (violation_) return prepend("[" + std::to_string(i) + "]");
    }
  }
  template <class T>
  requires wire::kIsRecord<T>
  void get(T& record) { visit_fields(*this, record); }

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
  std::visit([&](const auto& value) { visit_fields(counter, value); }, sample);
  return kEncapsulation + counter.used();
}

std::size_t encode(const wire::Sample& sample, std::span<std::uint8_t> out) {
  SKEIN_EXPECTS(out.size() >= kEncapsulation);
  std::ranges::copy(kCdrEncapsulation, out.begin());
  CdrWriter writer(out.subspan(kEncapsulation));
  std::visit([&](const auto& value) { visit_fields(writer, value); }, sample);
  return kEncapsulation + writer.used();
}

std::variant<wire::Sample, Malformed> decode(wire::Slot slot, std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kEncapsulation || bytes[0] != 0 || bytes[1] > 1) {
    return Malformed{slot, {}, {"", "not CDR version 1"}};
  }
  const bool little = bytes[1] == 1;
  Reader reader(bytes.subspan(kEncapsulation),
                little != (std::endian::native == std::endian::little));
  wire::Sample sample = empty_sample(slot, std::make_index_sequence<wire::kSlotCount>{});
  std::visit([&](auto& value) { visit_fields(reader, value); }, sample);
  if (auto violation = reader.take_violation()) {
    return Malformed{slot, wire::header_of(sample), std::move(*violation)};
  }
  return sample;
}

}  // namespace skein::blackboard
