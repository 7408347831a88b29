// SPDX-License-Identifier: Apache-2.0
// Messages with every field drawn at random.
#pragma once

#include "skein/foundation/random.hpp"
#include "skein/ros2/messages.hpp"

namespace skein::ros2::testing {

class RandomMessage {
 public:
  explicit RandomMessage(Random& random) : random_(random) {}

  void fill(bool& value) { value = random_.chance(0.5); }
  void fill(double& value) { value = random_.uniform(-1e6, 1e6); }
  void fill(float& value) { value = static_cast<float>(random_.uniform(-1e3, 1e3)); }
  template <class T>
  requires std::is_integral_v<T>
  void fill(T& value) { value = static_cast<T>(random_.below(1ULL << 62)); }
  void fill(std::string& value) {
    value.clear();
    for (std::uint64_t left = random_.below(9); left > 0; --left) {
      value += static_cast<char>('a' + random_.below(26));
    }
  }
  template <class T, std::size_t N>
  void fill(std::array<T, N>& values) {
    for (T& value : values) fill(value);
  }
  template <class T>
  void fill(std::vector<T>& values) {
    values.resize(random_.below(4));
    for (T& value : values) fill(value);
  }
  template <class T>
  requires requires(T& message) { message.fields(); }
  void fill(T& message) {
    std::apply([this](auto&... field) { (fill(field), ...); }, message.fields());
  }

 private:
  Random& random_;
};

template <class M>
M random_message(Random& random) {
  M message;
  RandomMessage(random).fill(message);
  return message;
}

}  // namespace skein::ros2::testing
