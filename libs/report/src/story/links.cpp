// SPDX-License-Identifier: Apache-2.0
#include "story/links.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <tuple>

namespace skein::report {

namespace {

// Turns a series of on/off records into spans.
void extend(std::vector<Span>& spans, bool& open, double t, bool on) {
  if (on && !open) spans.push_back({t, t});
  if (!on && open) spans.back().to = t;
  open = on;
}

class LinkTable {
 public:
  // The story of a pair, and which of its two directions `from` → `to` is.
  std::pair<LinkStory&, std::size_t> find(const std::string& from, const std::string& to) {
    const std::size_t direction = from < to ? 0 : 1;
    LinkStory& story = stories_[std::minmax(from, to)];
    story.first = std::min(from, to);
    story.second = std::max(from, to);
    return {story, direction};
  }
  std::map<std::pair<std::string, std::string>, LinkStory>& all() { return stories_; }

 private:
  std::map<std::pair<std::string, std::string>, LinkStory> stories_;
};

using Openness = std::map<std::tuple<std::string, std::string>, bool>;

}  // namespace

std::vector<Flight> pair_messages(const std::vector<MessageRecord>& records) {
  using Key = std::tuple<std::string_view, std::string_view, std::string_view, std::uint64_t>;
  std::vector<Flight> flights;
  std::map<Key, std::size_t> indices;
  for (const MessageRecord& r : records) {
    const auto [it, added] =
        indices.try_emplace(Key{r.slot, r.from, r.to, r.sequence}, flights.size());
    if (added) flights.push_back({r.slot, r.from, r.to, r.sequence, {}, {}, r.session});
    Flight& flight = flights[it->second];
    std::optional<double>& when = r.direction == Direction::kSent ? flight.sent : flight.received;
    const double t = seconds(r.stamp);
    when = std::min(when.value_or(t), t);
  }
  return flights;
}

std::vector<Flight> pair_syncs(const std::vector<SyncRecord>& records) {
  using Key = std::tuple<std::string_view, std::string_view, std::string_view>;
  std::vector<Flight> flights;
  std::map<Key, std::deque<std::size_t>> waiting[2];
  for (const SyncRecord& r : records) {
    const bool received = r.direction == Direction::kReceived;
    const Key key{r.id, r.from, r.to};
    std::deque<std::size_t>& partners = waiting[received ? 0 : 1][key];
    const double t = seconds(r.stamp);
    std::size_t index = flights.size();
    if (partners.empty()) {
      waiting[received ? 1 : 0][key].push_back(index);
      flights.push_back({r.id, r.from, r.to, 0, {}, {}});
    } else {
      index = partners.front();
      partners.pop_front();
    }
    (received ? flights[index].received : flights[index].sent) = t;
  }
  return flights;
}

std::vector<LinkStory> tell_links(const Journal& journal, double end) {
  LinkTable table;
  Openness up, believed, relayed;
  for (const LinkRecord& r : journal.links) {
    if (r.from == r.to) continue;  // also of all links together
    auto [story, direction] = table.find(r.from, r.to);
    story.truth[direction] = true;
    extend(story.up[direction], up[{r.from, r.to}], seconds(r.stamp), r.up);
  }
  for (const ReachRecord& r : journal.reaches) {
    if (r.stamp.node == r.peer) continue;
    auto [story, direction] = table.find(r.stamp.node, r.peer);
    story.belief[direction] = true;
    extend(story.believed[direction], believed[{r.stamp.node, r.peer}], seconds(r.stamp),
           r.reachable);
  }
  for (const RouteRecord& r : journal.routes) {
    if (r.stamp.node == r.peer) continue;
    auto [story, direction] = table.find(r.stamp.node, r.peer);
    extend(story.relayed[direction], relayed[{r.stamp.node, r.peer}], seconds(r.stamp),
           !r.via.empty());
  }
  std::vector<LinkStory> links;
  for (auto& [pair, story] : table.all()) {
    // Where the truth is told, a pair without any is not a radio link (a node and the simulator).
    if (!journal.links.empty() && !story.truth[0] && !story.truth[1]) continue;
    for (const std::size_t d : {0U, 1U}) {
      const auto key =
          d == 0 ? std::tuple{story.first, story.second} : std::tuple{story.second, story.first};
      if (up[key]) story.up[d].back().to = std::max(end, story.up[d].back().from);
      if (relayed[key]) story.relayed[d].back().to = std::max(end, story.relayed[d].back().from);
      if (believed[key]) story.believed[d].back().to = std::max(end, story.believed[d].back().from);
    }
    links.push_back(std::move(story));
  }
  return links;
}

double total(const std::vector<Span>& spans) {
  double sum = 0.0;
  for (const Span& s : spans) sum += s.to - s.from;
  return sum;
}

double disagreement(const std::vector<Span>& a, const std::vector<Span>& b) {
  double common = 0.0;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    common += std::max(0.0, std::min(a[i].to, b[k].to) - std::max(a[i].from, b[k].from));
    if (a[i].to < b[k].to) {
      ++i;
    } else {
      ++k;
    }
  }
  return total(a) + total(b) - 2.0 * common;
}

}  // namespace skein::report
