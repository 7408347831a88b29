// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/wire_layout.hpp"

#include "field_types.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/foundation/fingerprint.hpp"

namespace skein::wire {
namespace {

std::string layout_of(const FieldType& type);

std::string enumerators(std::span<const std::string_view> all) {
  std::string names;
  for (const std::string_view name : all) names += (names.empty() ? "" : "|") + std::string(name);
  return "enum(" + names + ")";
}

std::string fields(std::span<const Field> all) {
  std::string text = "{";
  for (const Field& field : all)
    text += std::string(field.name) + " " + layout_of(*field.type) + "; ";
  return text + "}";
}

std::string bits(char kind, std::size_t size) { return kind + std::to_string(8 * size); }

std::string layout_of(const FieldType& type) {
  switch (type.kind) {
    case FieldKind::kBoolean:
      return "bool";
    case FieldKind::kUnsigned:
      return bits('u', type.size);
    case FieldKind::kSigned:
      return bits('i', type.size);
    case FieldKind::kReal:
      return bits('f', type.size);
    case FieldKind::kText:
      return "string";
    case FieldKind::kEnumeration:
      return enumerators(type.names);
    case FieldKind::kRecord:
      return fields(type.fields);
    case FieldKind::kSequence:
      return layout_of(*type.element) + "[]";
  }
  return "";
}

}  // namespace

std::string layout() {
  std::string text;
  for (std::size_t i = 0; i < kSlotCount; ++i) {
    const auto slot = static_cast<Slot>(i);
    text += std::string(slot_name(slot)) + " " + layout_of(type_of(slot)) + "\n";
  }
  return text;
}

const std::string& layout_mark() {
  static const std::string mark = fingerprint_text(Fingerprint().put(layout()).value());
  return mark;
}

}  // namespace skein::wire
