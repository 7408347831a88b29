// SPDX-License-Identifier: Apache-2.0
// The part of a scenario about the radio, and what its script does to it.
#include <algorithm>
#include <utility>

#include "reading.hpp"
#include "skein/world/radio_reader.hpp"

namespace skein::scenario {

namespace {

using config::Reader;

/// Of one script line; a link that flaps for a mission.
constexpr std::size_t kMostCuts = 100'000;

/// Who is at the two ends of what a script line says.
struct Ends {
  bool one_way = false;
  std::vector<std::pair<std::string, std::string>> pairs;
};

/// A node, several, or all.
std::vector<std::string> read_end(const Reader& reader, const Names& names) {
  const auto name = [&](const Reader& one) {
    return one.name_among(names.nodes, "a UAV or ground");
  };
  if (!reader.is_sequence()) {
    if (reader.text() == "all") return names.nodes;
    return {name(reader)};
  }
  std::vector<std::string> several;
  for (const Reader& one : reader.items()) several.push_back(name(one));
  return several;
}

// Between a node and all others nobody means itself; otherwise it is a slip.
std::vector<std::pair<std::string, std::string>> pairs_of(const Reader& reader,
                                                          const std::string& what,
                                                          const std::vector<Reader>& ends,
                                                          const Names& names) {
  const std::vector<std::string> first = read_end(ends[0], names), last = read_end(ends[1], names);
  const bool all = first.size() == names.nodes.size() || last.size() == names.nodes.size();
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& a : first) {
    for (const std::string& b : last) {
      if (a != b)
        pairs.emplace_back(a, b);
      else if (!all && !a.empty())
        reader.error(what + " between a node and itself");
    }
  }
  return pairs;
}

/// `between: [A, B]`, or `one_way: [A, B]`: only from A to B.
Ends read_ends(const Reader& reader, const Names& names, const std::string& what) {
  Ends ends;
  ends.one_way = reader.optional("one_way").present();
  if (ends.one_way && reader.optional("between").present()) {
    reader.optional("between").error(what + " has between beside one_way", "one of the two");
  }
  const std::vector<Reader> pair = reader.required(ends.one_way ? "one_way" : "between").items();
  if (pair.size() != 2) {
    reader.error(what + " is between two nodes", "between: [NODE, NODE]");
    return ends;
  }
  ends.pairs = pairs_of(reader, what, pair, names);
  return ends;
}

struct Window {
  MissionTime from, until = MissionTime::max();
};

void check_window(const Reader& reader, const std::string& what, const Window& window) {
  if (window.until <= window.from) reader.error(what + " that ends before it begins");
}

/// `down` and `up`: down for so long, then up, again and again; one window if there is neither.
std::vector<Window> read_windows(const Reader& reader) {
  const Window all{read_instant(reader.required("from")), read_instant(reader.required("until"))};
  check_window(reader, "a cut", all);
  const Reader down = reader.optional("down"), up = reader.optional("up");
  if (!down.present() && !up.present()) return {all};
  const auto length = [&](const char* key) {
    return Duration::seconds(reader.required(key).number(1, {0.05, 1e6, "s"}));
  };
  const Duration is_down = length("down"), is_up = length("up");
  std::vector<Window> windows;
  for (MissionTime from = all.from; from < all.until; from = from + is_down + is_up) {
    if (windows.size() == kMostCuts) {
      reader.error("a cut that comes too often", "at most 100,000 times");
      break;
    }
    windows.push_back({from, std::min(from + is_down, all.until)});
  }
  return windows;
}

void read_cuts(const Reader& reader, const Names& names, std::vector<CutSpec>& cuts) {
  const Ends ends = read_ends(reader, names, "a cut");
  for (const Window& window : read_windows(reader)) {
    for (const auto& [a, b] : ends.pairs)
      cuts.push_back({a, b, window.from, window.until, ends.one_way});
  }
}

void read_links(const Reader& reader, const Names& names, std::vector<LinkSpec>& links) {
  const Ends ends = read_ends(reader, names, "a link");
  Window window;
  if (const Reader from = reader.optional("from"); from.present()) window.from = read_instant(from);
  if (const Reader until = reader.optional("until"); until.present())
    window.until = read_instant(until);
  check_window(reader, "a link", window);
  LinkSpec spec;
  if (const Reader latency = reader.optional("latency"); latency.present())
    spec.latency = Duration::seconds(latency.number(0, {0, 60, "s"}));
  if (const Reader loss = reader.optional("loss"); loss.present())
    spec.loss = loss.number(0, {0, 0.99, ""});
  if (const Reader capacity = reader.optional("capacity"); capacity.present())
    spec.capacity = capacity.number(1e6, {1, 1e12, "bit/s"});
  for (const auto& [a, b] : ends.pairs) {
    links.push_back(
        {a, b, ends.one_way, window.from, window.until, spec.latency, spec.loss, spec.capacity});
  }
}

/// "all": whoever has the radio.
std::vector<std::string> read_relays(const Reader& reader, const Names& names) {
  if (!reader.present()) return {};
  if (!reader.is_sequence() && reader.text() == "all") return names.nodes;
  std::vector<std::string> relays;
  for (const Reader& item : reader.items()) {
    std::string name = item.name_among(names.nodes, "a UAV or ground");
    if (std::find(relays.begin(), relays.end(), name) != relays.end())
      item.error("'" + name + "' is there twice");
    relays.push_back(std::move(name));
  }
  return relays;
}

}  // namespace

void read_radio(const Reader& reader, const Names& names, RadioSpec& radio) {
  radio.model = world::read_radio(reader, "cuts", "links", "heartbeat", "relays", "silent");
  radio.heartbeat = Duration::seconds(reader.optional("heartbeat").number(1, {0.05, 60, "s"}));
  radio.relays = read_relays(reader.optional("relays"), names);
  radio.silent = reader.optional("silent").boolean();
  for (const Reader& cut : items_of(reader.optional("cuts"))) {
    if (cut.keys({"between", "one_way", "from", "until", "down", "up"}))
      read_cuts(cut, names, radio.cuts);
  }
  for (const Reader& link : items_of(reader.optional("links"))) {
    if (link.keys({"between", "one_way", "from", "until", "latency", "loss", "capacity"}))
      read_links(link, names, radio.links);
  }
}

}  // namespace skein::scenario
