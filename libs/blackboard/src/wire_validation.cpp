// SPDX-License-Identifier: Apache-2.0
// The rules that hold for every wire type.
#include <cmath>
#include <cstring>

#include "field_types.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::wire {
namespace {

/// Length of the well-formed UTF-8 sequence at the start of `rest`; 0 if there is none. Overlong
/// forms, surrogates and values above U+10FFFF are not well-formed.
std::size_t utf8_sequence(std::string_view rest) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || rest.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byte(1);
  if (lead == 0xE0 && second < 0xA0) return 0;
  if (lead == 0xED && second >= 0xA0) return 0;
  if (lead == 0xF0 && second < 0x90) return 0;
  if (lead == 0xF4 && second >= 0x90) return 0;
  return length;
}

const char* violation_of_text(std::string_view text) {
  if (text.size() > kMaximumString) return "too long";
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\0') return "holds a zero byte";
    const std::size_t length = utf8_sequence(text.substr(i));
    if (length == 0) return "not UTF-8";
    i += length;
  }
  return nullptr;
}

/// Looks at every value until one is wrong; the path is put together on the way out.
class Checker {
 public:
  void check(const FieldType& type, const void* value) {
    switch (type.kind) {
      case FieldKind::kBoolean:
      case FieldKind::kUnsigned:
      case FieldKind::kSigned:
        return;
      case FieldKind::kReal:
        return check_real(type.size == sizeof(float) ? loaded<float>(value)
                                                     : loaded<double>(value));
      case FieldKind::kText:
        if (const char* why = violation_of_text(text_at(value))) fail(why);
        return;
      case FieldKind::kEnumeration:
        return check_enumeration(type, loaded<std::uint32_t>(value));
      case FieldKind::kRecord:
        return check_record(type, value);
      case FieldKind::kSequence:
        return check_sequence(type, value);
    }
  }

  std::optional<Violation> take() { return std::move(violation_); }

 private:
  void fail(std::string why) { violation_ = Violation{"", std::move(why)}; }
  void prepend(const std::string& name) {
    std::string& field = violation_->field;
    field = field.empty() || field.front() == '[' ? name + field : name + "." + field;
  }

  void check_real(double value) {
    if (!std::isfinite(value)) fail("not a finite number");
  }
  void check_enumeration(const FieldType& type, std::uint32_t value) {
    if (value >= type.names.size())
      fail(std::to_string(value) + " is not a value of the enumeration");
  }
  void check_record(const FieldType& type, const void* record) {
    for (const Field& field : type.fields) {
      check(*field.type, at(record, field.offset));
      if (violation_) return prepend(field.name);
    }
  }
  void check_sequence(const FieldType& type, const void* values) {
    const std::size_t count = type.count(values);
    if (count > kMaximumSequence) return fail("too many elements");
    const void* const elements = type.elements(values);
    for (std::size_t i = 0; i < count; ++i) {
      check(*type.element, at(elements, i * type.element->size));
      if (violation_) return prepend("[" + std::to_string(i) + "]");
    }
  }

  std::optional<Violation> violation_;
};

}  // namespace

std::optional<Violation> find_violation(const Sample& sample) {
  Checker checker;
  checker.check(type_of(slot_of(sample)), record_of(sample));
  return checker.take();
}

}  // namespace skein::wire
