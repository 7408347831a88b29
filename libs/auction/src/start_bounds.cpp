// SPDX-License-Identifier: Apache-2.0
#include "start_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

namespace {

/// Of rounding, in a circle that adds up to nothing [s].
constexpr double kRounding = 1e-6;

std::string seconds(double value) { return to_text(Duration::seconds(value)) + " s"; }

/// `to` begins `after` seconds after `from`, or later. Both are tasks, or the origin of times.
struct StartBound {
  std::size_t from, to;
  double after;
  std::string text;
};

class StartBounds {
 public:
  explicit StartBounds(const Catalogue& catalogue)
      : catalogue_(catalogue), origin_(catalogue.size()), starts_(catalogue.size() + 1) {
    for (std::uint32_t task = 0; task < catalogue.size(); ++task) add_window(task);
    for (std::uint32_t first = 0; first < catalogue.size(); ++first)
      for (const std::uint32_t then : catalogue.after(first)) add_delay(first, then);
  }

  bool any_above() const { return any_above_; }

  // What still moves after as many passes as there are tasks moves for ever.
  std::vector<const StartBound*> circle() {
    std::vector<const StartBound*> cause(starts_.size());
    std::size_t moved = starts_.size();
    for (std::size_t pass = 0; pass <= starts_.size(); ++pass) {
      moved = starts_.size();
      for (const StartBound& bound : bounds_) {
        if (starts_[bound.from] + bound.after <= starts_[bound.to] + kRounding) continue;
        starts_[bound.to] = starts_[bound.from] + bound.after;
        cause[bound.to] = &bound;
        moved = bound.to;
      }
      if (moved == starts_.size()) return {};
    }
    for (std::size_t i = 0; i < starts_.size(); ++i) moved = cause[moved]->from;
    std::vector<const StartBound*> circle;
    std::size_t at = moved;
    do {
      circle.push_back(cause[at]);
      at = cause[at]->from;
    } while (at != moved);
    std::reverse(circle.begin(), circle.end());
    return circle;
  }

  Contradiction told(const std::vector<const StartBound*>& circle) const {
    Contradiction result;
    std::vector<std::string> texts;
    for (const StartBound* bound : circle) {
      texts.push_back(bound->text);
      if (bound->from != origin_)
        result.chain.push_back(catalogue_.task(static_cast<std::uint32_t>(bound->from)).number);
    }
    std::sort(result.chain.begin(), result.chain.end());
    result.why = "they have no dates: " + joined(texts, "; ");
    return result;
  }

 private:
  std::string name(std::uint32_t task) const { return to_text(catalogue_.task(task).number); }

  void add_window(std::uint32_t i) {
    const Task& task = catalogue_.task(i);
    bounds_.push_back({origin_, i, task.earliest,
                       name(i) + " begins at " + seconds(task.earliest) + " at the earliest"});
    if (!std::isfinite(task.deadline)) return;
    bounds_.push_back({i, origin_, task.duration - task.deadline,
                       name(i) + " lasts " + seconds(task.duration) + " and must end by " +
                           seconds(task.deadline)});
  }

  void add_delay(std::uint32_t first, std::uint32_t then) {
    const Delay delay = catalogue_.delay(first, then);
    const double lasts = catalogue_.task(first).duration;
    const std::string end = " the end of " + name(first) + ", which lasts " + seconds(lasts);
    const std::string after = delay.least > 0 ? seconds(delay.least) + " or more after" : "after";
    bounds_.push_back({first, then, lasts + delay.least, name(then) + " begins " + after + end});
    if (!delay.bounds_above()) return;
    any_above_ = true;
    bounds_.push_back({then, first, -delay.most - lasts,
                       name(then) + " begins within " + seconds(delay.most) + " of" + end});
  }

  const Catalogue& catalogue_;
  const std::size_t origin_;
  std::vector<double> starts_;
  std::vector<StartBound> bounds_;
  bool any_above_ = false;
};

}  // namespace

std::optional<Contradiction> tight_circle(const Catalogue& catalogue) {
  StartBounds bounds(catalogue);
  if (!bounds.any_above()) return std::nullopt;
  const auto circle = bounds.circle();
  if (circle.empty()) return std::nullopt;
  return bounds.told(circle);
}

}  // namespace skein::auction
