// SPDX-License-Identifier: Apache-2.0
// scenarios/slots.yaml and what scenarios put in its place.
#include <algorithm>
#include <array>
#include <optional>

#include "skein/blackboard/slot_table.hpp"
#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::blackboard {
namespace {

using config::Reader;

/// Rounding of what people write.
constexpr double kAllOfAChannel = 1 + 1e-9;

/// Of mission time [s].
constexpr double kLeastLifespan = 0.05, kGreatestLifespan = 86'400;

bool is_radio(Party from, Party to) {
  const auto has_radio = [](Party one) { return one == Party::kGround || one == Party::kUav; };
  return has_radio(from) && has_radio(to) && (from == Party::kUav || to == Party::kUav);
}

bool is_possible(Party from, Party to) {
  if (from == Party::kWorld || to == Party::kWorld) return from != to;
  const bool onboard = (from == Party::kUav && to == Party::kFunctional) ||
                       (from == Party::kFunctional && to == Party::kUav);
  return onboard || is_radio(from, to);
}

std::vector<std::string> slot_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i)
    names.emplace_back(wire::slot_name(static_cast<wire::Slot>(i)));
  return names;
}

/// "uav>ground", "uav<>uav".
struct Arrow {
  std::string from, to;
  bool both = false;
};
std::optional<Arrow> arrow_of(const std::string& text) {
  const std::size_t at = text.find('>');
  if (at == std::string::npos || at == 0) return std::nullopt;
  const bool both = text[at - 1] == '<';
  return Arrow{text.substr(0, both ? at - 1 : at), text.substr(at + 1), both};
}

}  // namespace

class SlotTableReader {
 public:
  explicit SlotTableReader(const SlotTable& base) : table_(base) {}

  void read(const Reader& root) {
    root.keys({"slots"});
    const Reader slots = root.required("slots");
    for (const auto& [name, row] : slots.entries()) {
      if (const auto slot = wire::slot_from_name(name)) {
        read_row(*slot, row);
      } else {
        row.error("no slot '" + name + "'", "the name of a struct of idl/",
                  nearest_name(name, slot_names()));
      }
    }
    check_channels(slots);
  }
  SlotTable take() { return std::move(table_); }

 private:
  void read_row(wire::Slot slot, const Reader& row) {
    const auto i = static_cast<std::size_t>(slot);
    if (!row.keys({"class", "flows", "relayed", "share", "priority", "lifespan"})) return;
    const Reader which = row.optional("class");
    const auto is = static_cast<std::size_t>(wire::slot_class(slot));
    if (which.present() && which.choice({"state", "event", "stream"}, is) != is)
      which.error("its class is another one", std::string(kClasses[is]) + ", as its IDL says");
    if (const Reader flows = row.optional("flows"); flows.present()) read_flows(i, flows);
    table_.relayed_[i] = row.optional("relayed").boolean(table_.relayed_[i]);
    SlotShare& share = table_.shares_[i];
    share.fraction = row.optional("share").number(share.fraction, {0, 1, "of the channel"});
    share.priority =
        static_cast<std::uint8_t>(row.optional("priority").integer(share.priority, 0, 255));
    read_lifespan(slot, row.optional("lifespan"));
    const bool on_radio = std::ranges::any_of(
        table_.flows_[i], [](const auto& flow) { return is_radio(flow.first, flow.second); });
    if (table_.relayed_[i] && !on_radio)
      row.error("relays pass on what goes over radio, and this does not",
                "a flow like uav>ground, or no 'relayed'");
  }

  void read_lifespan(wire::Slot slot, const Reader& lifespan) {
    if (!lifespan.present()) return;
    if (wire::slot_class(slot) != wire::SlotClass::kEvent) {
      lifespan.error(
          "only events have a lifespan, and " + std::string(wire::slot_name(slot)) + " is none",
          "no 'lifespan': a newer value takes the place of an older one");
      return;
    }
    const double seconds = lifespan.number(1, {kLeastLifespan, kGreatestLifespan, "s"});
    table_.lifespans_[static_cast<std::size_t>(slot)] = Duration::seconds(seconds);
  }

  void read_flows(std::size_t slot, const Reader& flows) {
    auto& all = table_.flows_[slot];
    all.clear();
    for (const Reader& item : flows.items()) {
      const auto arrow = arrow_of(item.text());
      if (!arrow) {
        item.error("'" + item.text() + "' is no flow", "WHO>WHOM or WHO<>WHOM");
        continue;
      }
      const auto from = party(arrow->from, item);
      const auto to = party(arrow->to, item);
      if (!from || !to) continue;
      if (!is_possible(*from, *to)) {
        item.error("there is no channel " + item.text(),
                   "ground and uav by radio, uav and functional on board, or the world");
        continue;
      }
      all.insert({*from, *to});
      if (arrow->both) all.insert({*to, *from});
    }
  }

  static std::optional<Party> party(const std::string& name, const Reader& item) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kParties; ++i) {
      names.emplace_back(name_of(static_cast<Party>(i)));
      if (names.back() == name) return static_cast<Party>(i);
    }
    item.error("no node '" + name + "'", "ground, uav, functional, sim, operator, others or world",
               nearest_name(name, names));
    return std::nullopt;
  }

  /// A channel between relays carries all that goes over radio.
  void check_channels(const Reader& slots) {
    check_sum(slots, "past relays", [this](std::size_t i) { return table_.relayed_[i]; });
    for (const auto& [from, to] :
         {std::pair(Party::kGround, Party::kUav), std::pair(Party::kUav, Party::kGround),
          std::pair(Party::kUav, Party::kUav)}) {
      const std::string name = std::string(name_of(from)) + ">" + std::string(name_of(to));
      check_sum(slots, name, [&, flow = std::pair(from, to)](std::size_t i) {
        return table_.flows_[i].contains(flow);
      });
    }
  }

  template <class Carried>
  void check_sum(const Reader& slots, const std::string& channel, const Carried& carried) {
    double sum = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
      if (!carried(i)) continue;
      sum += table_.shares_[i].fraction;
      if (table_.shares_[i].fraction > table_.shares_[most].fraction) most = i;
    }
    if (sum <= kAllOfAChannel) return;
    const auto percent = [](double share) {
      return std::to_string(static_cast<int>(share * 100 + 0.5)) + " %";
    };
    slots.error("the shares of a channel " + channel + " add up to " + percent(sum),
                "at most 100 %; most has " +
                    std::string(wire::slot_name(static_cast<wire::Slot>(most))) + " with " +
                    percent(table_.shares_[most].fraction));
  }

  static constexpr std::array<std::string_view, 3> kClasses{"state", "event", "stream"};
  SlotTable table_;
};

Result<SlotTable, Diagnostics> read_slot_table(std::string_view text, const std::string& file,
                                               const SlotTable& base) {
  const auto value = config::parse_yaml(text, file);
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  return read_slot_table(*value, file, base);
}

Result<SlotTable, Diagnostics> read_slot_table(const config::Value& document,
                                               const std::string& file, const SlotTable& base) {
  Diagnostics problems;
  SlotTableReader reader(base);
  reader.read(Reader(document, file, problems));
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  return reader.take();
}

}  // namespace skein::blackboard
