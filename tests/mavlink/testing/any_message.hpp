// SPDX-License-Identifier: Apache-2.0
// Messages of every type with any values.
#pragma once

#include <rapidcheck.h>

#include <utility>

#include "skein/mavlink/messages.hpp"

namespace skein::mavlink {

/// Within rapidcheck. Floats are finite, so that equal messages are equal.
template <std::size_t index = 0>
Message any_message_from(std::size_t chosen) {
  if constexpr (index + 1 < std::variant_size_v<Message>) {
    if (chosen != index) return any_message_from<index + 1>(chosen);
  }
  std::variant_alternative_t<index, Message> message;
  visit_fields(message, []<class Value>(std::string_view, Value& value) {
    using Element = typename ValueTraits<Value>::Element;
    const auto any = [] {
      if constexpr (std::is_same_v<Element, float>) {
        return static_cast<float>(*rc::gen::inRange(-1000000, 1000000)) / 64.0F;
      } else {
        return *rc::gen::arbitrary<Element>();
      }
    };
    if constexpr (ValueTraits<Value>::kIsArray) {
      for (Element& one : value) one = any();
    } else {
      value = any();
    }
  });
  return message;
}

inline Message any_message() {
  return any_message_from(*rc::gen::inRange<std::size_t>(0, std::variant_size_v<Message>));
}

}  // namespace skein::mavlink
