// SPDX-License-Identifier: Apache-2.0
// Prints one line for each of many random messages: its type, its fields in their order as JSON,
// and its bytes; for another implementation to read by the published definitions (check_peer.js).
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include "skein/ros2/cdr.hpp"
#include "testing/random_message.hpp"

namespace skein::ros2 {
namespace {

constexpr int kOfEach = 100;

/// Texts are letters alone (RandomMessage).
class Json {
 public:
  explicit Json(std::ostream& out) : out_(out) {}

  void say(const std::string& text) { out_ << '"' << text << '"'; }
  void say(bool value) { out_ << (value ? "true" : "false"); }
  template <class T>
  requires std::is_arithmetic_v<T>
  void say(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      out_ << std::setprecision(std::numeric_limits<T>::max_digits10) << value;
    } else {
      out_ << static_cast<std::int64_t>(value);
    }
  }
  template <class T, std::size_t N>
  void say(const std::array<T, N>& values) {
    say_all(values);
  }
  template <class T>
  void say(const std::vector<T>& values) {
    say_all(values);
  }
  template <class T>
  requires requires(const T& message) { message.fields(); }
  void say(const T& message) {
    bool first = true;
    out_ << '[';
    const auto one = [&](const auto& field) {
      if (!std::exchange(first, false)) out_ << ',';
      say(field);
    };
    std::apply([&](const auto&... field) { (one(field), ...); }, message.fields());
    out_ << ']';
  }

 private:
  template <class Values>
  void say_all(const Values& values) {
    out_ << '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) out_ << ',';
      say(values[i]);
    }
    out_ << ']';
  }

  std::ostream& out_;
};

template <class M>
void print(Random& random) {
  const M message = testing::random_message<M>(random);
  std::ostringstream fields;
  Json(fields).say(message);
  std::cout << R"({"type":")" << type_name<M>() << R"(","fields":)" << fields.str()
            << R"(,"bytes":")" << std::hex << std::setfill('0');
  for (const std::uint8_t byte : to_cdr(message)) std::cout << std::setw(2) << int{byte};
  std::cout << std::dec << "\"}\n";
}

template <class... Types>
void print_all(Random& random, std::variant<Types...>*) {
  for (int i = 0; i < kOfEach; ++i) (print<Types>(random), ...);
}

}  // namespace
}  // namespace skein::ros2

int main() {
  skein::Random random(1);
  skein::ros2::print_all(random, static_cast<skein::ros2::Message*>(nullptr));
  return 0;
}
