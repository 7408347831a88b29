// SPDX-License-Identifier: Apache-2.0
// A peer that says anything in parts: fair pieces of its long events beside foul ones, in any
// order, and restarts. What goes through is what was said, whole, and once.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sessions/incoming_parts.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/cdr.hpp"

namespace {

using namespace skein::blackboard;
using skein::wire::Part;
using skein::wire::Slot;

void demand(bool holds) {
  if (!holds) std::abort();
}

/// Numbers drawn from the input; zeros behind its end.
class Draw {
 public:
  explicit Draw(std::span<const std::uint8_t> input) : input_(input) {}
  bool empty() const { return input_.empty(); }
  std::uint8_t byte() {
    if (input_.empty()) return 0;
    const std::uint8_t first = input_.front();
    input_ = input_.subspan(1);
    return first;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8U | byte();
    return value;
  }
  std::vector<std::uint8_t> bytes(std::size_t count) {
    const auto some = input_.first(std::min(count, input_.size()));
    input_ = input_.subspan(some.size());
    return {some.begin(), some.end()};
  }

 private:
  std::span<const std::uint8_t> input_;
};

/// The same in all lives of its sender.
skein::wire::HandOver event_of(std::uint64_t number) {
  skein::wire::HandOver event;
  event.header.origin = 2;
  event.header.sequence_number = number;
  event.uav = std::string(100 * (number - kFirstLongEvent), 'a');
  return event;
}

Part fair(Draw& draw, std::uint32_t there) {
  Part part;
  part.header.incarnation = 1 + draw.byte() % 3;
  part.number = kFirstLongEvent + draw.byte() % 4;
  part.of_slot = static_cast<std::uint8_t>(Slot::kHandOver);
  const auto bytes = in_cdr(event_of(part.number));
  part.total = static_cast<std::uint32_t>(bytes.size());
  const std::uint8_t where = draw.byte();
  part.offset = where < 128 && there < part.total ? there : where % part.total;
  const std::size_t most = part.total - part.offset;
  const auto begin = bytes.begin() + part.offset;
  part.content.assign(begin, begin + static_cast<std::ptrdiff_t>(
                                         std::min<std::size_t>(most, 1U + 2U * draw.byte())));
  return part;
}

Part foul(Draw& draw) {
  Part part;
  part.header.incarnation = draw.byte() % 5;
  part.number = draw.byte() < 128 ? kFirstLongEvent + draw.byte() % 4 : draw.number();
  part.of_slot = draw.byte();
  part.total = draw.byte() < 128 ? draw.byte() : draw.number();
  part.offset = draw.byte() < 128 ? draw.byte() : draw.number();
  part.content = draw.bytes(draw.byte());
  return part;
}

/// A receiver, and what must be true of all that it lets through.
class Receiver {
 public:
  void take(const Part& part, bool is_fair) {
    if (!is_fair) fouled_.insert({part.header.incarnation, part.number});
    const auto event = parts_.take(part);
    if (parts_.ack_incarnation() != life_) over_ = 0;
    life_ = parts_.ack_incarnation();
    demand(parts_.ack_bytes() <= IncomingParts::kLongest);
    if (event) let_through(part, *event);
  }
  /// [byte] Of the event that is coming.
  std::uint32_t there() const { return parts_.ack_bytes() % IncomingParts::kLongest; }
  /// It knows what it had handled.
  void restart() {
    parts_ = IncomingParts();
    parts_.recall(life_, over_);
  }

 private:
  void let_through(const Part& last, const std::variant<skein::wire::Sample, Malformed>& event) {
    demand(last.header.incarnation == life_ && last.number > over_);
    over_ = last.number;
    const auto* sample = std::get_if<skein::wire::Sample>(&event);
    if (!fouled_.contains({life_, last.number}))
      demand(sample != nullptr && *sample == skein::wire::Sample(event_of(last.number)));
    if (sample != nullptr) demand(skein::wire::slot_of(*sample) == Slot(last.of_slot));
    parts_.commit();
    demand(parts_.owes() && parts_.ack_number() == last.number);
    demand(parts_.ack_bytes() == IncomingParts::kLongest);
  }

  IncomingParts parts_;
  std::uint64_t life_ = 0;                                    ///< of the peer, the latest
  std::uint64_t over_ = 0;                                    ///< its last event that went through
  std::set<std::pair<std::uint64_t, std::uint64_t>> fouled_;  ///< lives and numbers
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Draw draw({data, size});
  Receiver receiver;
  while (!draw.empty()) {
    switch (draw.byte() % 8) {
      case 0:
        receiver.take(foul(draw), false);
        break;
      case 1:
        receiver.restart();
        break;
      default:
        receiver.take(fair(draw, receiver.there()), true);
    }
  }
  return 0;
}
