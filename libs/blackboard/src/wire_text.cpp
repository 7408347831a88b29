// SPDX-License-Identifier: Apache-2.0
// Samples as JSON and as text for people.
#include <nlohmann/json.hpp>

#include "skein/blackboard/wire.hpp"

namespace skein::wire {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json json_of(const T& value);

template <class T>
requires kIsRecord<T>
void put_fields(Json& object, const T& record) {
  visit_fields([&](const char* name, const auto& field) { object[name] = json_of(field); }, record);
}

template <class T>
Json json_of(const T& value) {
  if constexpr (kIsRecord<T>) {
    Json object = Json::object();
    put_fields(object, value);
    return object;
  } else if constexpr (WireEnum<T>) {
    return std::string(name_of(value));
  } else if constexpr (requires { typename T::value_type; } && !std::same_as<T, std::string>) {
    Json array = Json::array();
    for (const auto& element : value) array.push_back(json_of(element));
    return array;
  } else {
    return value;
  }
}

/// Never throws: what is not UTF-8 becomes U+FFFD.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const Sample& sample) {
  Json object = {{"slot", slot_name(slot_of(sample))}};
  std::visit([&](const auto& value) { put_fields(object, value); }, sample);
  return dump(object);
}

std::string to_text(const Sample& sample) {
  const SampleHeader& header = header_of(sample);
  std::string line = std::string(slot_name(slot_of(sample))) + " " + std::to_string(header.origin) +
                     ">" + (header.destination == 0 ? "*" : std::to_string(header.destination)) +
                     " #" + std::to_string(header.sequence_number);
  const auto put = [&]<class T>(const char* name, const T& field) {
    if constexpr (!std::same_as<T, SampleHeader>) {
      line += std::string(" ") + name + "=" + dump(json_of(field));
    }
  };
  std::visit([&](const auto& value) { visit_fields(put, value); }, sample);
  return line;
}

}  // namespace skein::wire
