// SPDX-License-Identifier: Apache-2.0
// Samples as JSON and as text for people.
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "field_types.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::wire {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const FieldType& type, const void* value);

void put_fields(Json& object, const FieldType& type, const void* record) {
  for (const Field& field : type.fields)
    object[field.name] = json_of(*field.type, at(record, field.offset));
}

Json json_of_record(const FieldType& type, const void* record) {
  Json object = Json::object();
  put_fields(object, type, record);
  return object;
}

Json json_of_sequence(const FieldType& type, const void* values) {
  Json array = Json::array();
  const std::size_t count = type.count(values);
  for (std::size_t i = 0; i < count; ++i)
    array.push_back(json_of(*type.element, at(type.elements(values), i * type.element->size)));
  return array;
}

Json json_of_enumerator(const FieldType& type, std::uint32_t value) {
  return std::string(value < type.names.size() ? type.names[value] : "?");
}

template <class Byte, class Half, class Word, class Long>
Json json_of_number(const FieldType& type, const void* value) {
  switch (type.size) {
    case 1:
      return loaded<Byte>(value);
    case 2:
      return loaded<Half>(value);
    case 4:
      return loaded<Word>(value);
    default:
      return loaded<Long>(value);
  }
}

/// The number that is written with the same few digits: 0.85, not 0.8500000238.
double as_written(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return number;
}

Json json_of(const FieldType& type, const void* value) {
  switch (type.kind) {
    case FieldKind::kBoolean:
      return loaded<bool>(value);
    case FieldKind::kUnsigned:
      return json_of_number<std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t>(type, value);
    case FieldKind::kSigned:
      return json_of_number<std::int8_t, std::int16_t, std::int32_t, std::int64_t>(type, value);
    case FieldKind::kReal:
      return type.size == sizeof(float) ? as_written(loaded<float>(value)) : loaded<double>(value);
    case FieldKind::kText:
      return text_at(value);
    case FieldKind::kEnumeration:
      return json_of_enumerator(type, loaded<std::uint32_t>(value));
    case FieldKind::kRecord:
      return json_of_record(type, value);
    case FieldKind::kSequence:
      return json_of_sequence(type, value);
  }
  return nullptr;
}

/// Never throws: what is not UTF-8 becomes U+FFFD.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const Sample& sample) {
  Json object = {{"slot", slot_name(slot_of(sample))}};
  put_fields(object, type_of(slot_of(sample)), record_of(sample));
  return dump(object);
}

std::string to_text(const Sample& sample) {
  const SampleHeader& header = header_of(sample);
  std::string line = std::string(slot_name(slot_of(sample))) + " " + std::to_string(header.origin) +
                     ">" + (header.destination == 0 ? "*" : std::to_string(header.destination)) +
                     " #" + std::to_string(header.sequence_number);
  for (const Field& field : type_of(slot_of(sample)).fields) {
    if (field.type == &type_of_header()) continue;
    line += std::string(" ") + field.name + "=" +
            dump(json_of(*field.type, at(record_of(sample), field.offset)));
  }
  return line;
}

}  // namespace skein::wire
