// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink/frame.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::mavlink {

namespace {

template <std::size_t size>
using Unsigned = std::conditional_t<size == 1, std::uint8_t,
                                    std::conditional_t<size == 2, std::uint16_t, std::uint32_t>>;

template <class Element>
void write_element(Element element, Bytes& out) {
  auto bits = std::bit_cast<Unsigned<sizeof(Element)>>(element);
  for (std::size_t i = 0; i < sizeof(Element); ++i) {
    out.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(bits) >> (8U * i)));
  }
}

/// Takes elements from a payload; zeros stand behind its end.
class PayloadReader {
 public:
  explicit PayloadReader(const Bytes& payload) : payload_(payload) {}

  template <class Element>
  void read(Element& element) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Element); ++i, ++next_) {
      const std::uint32_t byte = next_ < payload_.size() ? payload_[next_] : 0;
      bits |= byte << (8U * i);
    }
    using Bits = Unsigned<sizeof(Element)>;
    element = std::bit_cast<Element>(static_cast<Bits>(bits));
  }
  template <class Element, std::size_t count>
  void read(std::array<Element, count>& elements) {
    for (Element& one : elements) read(one);
  }

 private:
  const Bytes& payload_;
  std::size_t next_ = 0;
};

template <std::size_t... index>
constexpr auto table_of(std::index_sequence<index...>) {
  return std::array{Known{std::variant_alternative_t<index, Message>::kId,
                          layout_of<std::variant_alternative_t<index, Message>>()}...};
}
constexpr auto kKnown = table_of(std::make_index_sequence<std::variant_size_v<Message>>());
static_assert(std::all_of(kKnown.begin(), kKnown.end(),
                          [](const Known& one) { return one.layout.is_ordered; }));

template <std::size_t index = 0>
std::optional<Message> read_as(const Frame& frame) {
  if constexpr (index < std::variant_size_v<Message>) {
    using Type = std::variant_alternative_t<index, Message>;
    if (frame.message != Type::kId) return read_as<index + 1>(frame);
    Type message;
    PayloadReader reader(frame.payload);
    visit_fields(message, [&](std::string_view, auto& value) { reader.read(value); });
    return message;
  }
  return std::nullopt;
}

}  // namespace

const Known* find_known(std::uint32_t message) {
  const auto found = std::find_if(kKnown.begin(), kKnown.end(),
                                  [&](const Known& one) { return one.message == message; });
  return found == kKnown.end() ? nullptr : &*found;
}

Bytes to_bytes(const Frame& frame) {
  const Known* known = find_known(frame.message);
  SKEIN_EXPECTS(known != nullptr && frame.payload.size() <= 255);
  Bytes bytes{kMagic,
              static_cast<std::uint8_t>(frame.payload.size()),
              0,
              0,
              frame.sequence,
              frame.from.system,
              frame.from.component,
              static_cast<std::uint8_t>(frame.message),
              static_cast<std::uint8_t>(frame.message >> 8U),
              static_cast<std::uint8_t>(frame.message >> 16U)};
  bytes.insert(bytes.end(), frame.payload.begin(), frame.payload.end());
  Checksum crc;
  std::for_each(bytes.begin() + 1, bytes.end(), [&](std::uint8_t byte) { crc.add(byte); });
  crc.add(known->layout.crc_extra);
  write_element(crc.value(), bytes);
  return bytes;
}

Frame to_frame(const Message& message, Address from, std::uint8_t sequence) {
  Frame frame{from, sequence};
  std::visit(
      [&](const auto& one) {
        frame.message = one.kId;
        visit_fields(one, [&]<class Value>(std::string_view, const Value& value) {
          if constexpr (ValueTraits<Value>::kIsArray) {
            for (const auto element : value) write_element(element, frame.payload);
          } else {
            write_element(value, frame.payload);
          }
        });
      },
      message);
  while (frame.payload.size() > 1 && frame.payload.back() == 0) frame.payload.pop_back();
  return frame;
}

std::optional<Message> to_message(const Frame& frame) { return read_as(frame); }

std::string text_of(const StatusText& status) {
  const auto end = std::find(status.text.begin(), status.text.end(), '\0');
  std::string text(status.text.begin(), end);
  const auto is_strange = [](char c) { return c < ' ' || c > '~'; };
  std::replace_if(text.begin(), text.end(), is_strange, '?');
  return text;
}

}  // namespace skein::mavlink
