// SPDX-License-Identifier: Apache-2.0
// The rules that hold for every wire type.
#include <cmath>
#include <cstring>

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

/// Looks at every field until one is wrong; the path is put together on the way out.
class Checker {
 public:
  template <class T>
  void operator()(const char* name, const T& value) {
    if (violation_) return;
    check(value);
    if (violation_) prepend(name);
  }

  std::optional<Violation> take() { return std::move(violation_); }

 private:
  void fail(std::string why) { violation_ = Violation{"", std::move(why)}; }
  void prepend(const std::string& name) {
    std::string& field = violation_->field;
    field = field.empty() || field.front() == '[' ? name + field : name + "." + field;
  }

  template <class T>
  requires std::is_integral_v<T>
  void check(T) {}
  void check(double value) {
    if (!std::isfinite(value)) fail("not a finite number");
  }
  void check(const std::string& value) {
    if (const char* why = violation_of_text(value)) fail(why);
  }
  template <WireEnum E>
  void check(E value) {
    if (value >= E::kCount) {
      fail(std::to_string(static_cast<std::uint32_t>(value)) +
           " is not a value of the enumeration");
    }
  }
  template <class T>
  void check(const std::vector<T>& values) {
    if (values.size() > kMaximumSequence) return fail("too many elements");
    for (std::size_t i = 0; i < values.size(); ++i) {
      check(values[i]);
      if (violation_) return prepend("[" + std::to_string(i) + "]");
    }
  }
  template <class T>
  requires kIsRecord<T>
  void check(const T& record) { visit_fields(*this, record); }

  std::optional<Violation> violation_;
};

}  // namespace

std::optional<Violation> find_violation(const Sample& sample) {
  Checker checker;
  std::visit([&](const auto& value) { visit_fields(checker, value); }, sample);
  return checker.take();
}

}  // namespace skein::wire
