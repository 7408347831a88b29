// SPDX-License-Identifier: Apache-2.0
// Prints one line for each of many random messages: type, CRC_EXTRA, length, fields as JSON, and
// the frame's bytes; for another implementation to read, compare and write again (check_peer.js).
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "skein/foundation/random.hpp"
#include "skein/mavlink/frame.hpp"
#include "testing/hex.hpp"

namespace skein::mavlink {
namespace {

constexpr int kOfEach = 200;

template <class Value>
void draw(Value& value, Random& random) {
  if constexpr (std::is_same_v<Value, float>) {
    value = static_cast<float>(random.uniform(-1e6, 1e6));
  } else if constexpr (std::is_same_v<Value, char>) {
    value = static_cast<char>('a' + random.below(26));
  } else {
    value = static_cast<Value>(random.chance(0.3) ? 0 : random.bits());
  }
}

template <class Value>
void print(const Value& value, std::ostream& out) {
  if constexpr (std::is_same_v<Value, float>) {
    out << std::setprecision(9) << value;
  } else {
    out << static_cast<std::int64_t>(value);
  }
}

template <class Type>
void say(Random& random, std::uint8_t sequence) {
  Type message;
  std::ostringstream fields;
  visit_fields(message, [&]<class Value>(std::string_view name, Value& value) {
    fields << (fields.tellp() == 0 ? "" : ",") << '"' << name << "\":";
    if constexpr (ValueTraits<Value>::kIsArray) {
      fields << '[';
      for (std::size_t i = 0; i < value.size(); ++i) {
        draw(value[i], random);
        fields << (i == 0 ? "" : ",");
        print(value[i], fields);
      }
      fields << ']';
    } else {
      draw(value, random);
      print(value, fields);
    }
  });
  const Known& known = *find_known(Type::kId);
  std::cout << "{\"id\":" << Type::kId << ",\"name\":\"" << Type::kName
            << "\",\"crc_extra\":" << int{known.layout.crc_extra}
            << ",\"length\":" << int{known.layout.length} << ",\"sequence\":" << int{sequence}
            << ",\"fields\":{" << fields.str() << "},\"frame\":\""
            << hex(to_bytes(to_frame(message, {7, 191}, sequence))) << "\"}\n";
}

template <class... Types>
void say_all(Random& random, std::variant<Types...>*) {
  for (int i = 0; i < kOfEach; ++i) (say<Types>(random, static_cast<std::uint8_t>(i)), ...);
}

}  // namespace
}  // namespace skein::mavlink

int main() {
  skein::Random random(1);
  skein::mavlink::say_all(random, static_cast<skein::mavlink::Message*>(nullptr));
  return 0;
}
