// SPDX-License-Identifier: Apache-2.0
// Drawn domains of a few facts, and all their plans by trying everything: states and networks are
// copied, nothing is undone, indexed or pruned.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace skein::htn::test {

/// Facts f0 to f3 as bits; `task` i is to be done by any of the ways of it, an operator by its one.
struct NaiveDomain {
  struct Way {
    int of = 0;              ///< the task that it does
    unsigned needs = 0;      ///< facts
    unsigned lacks = 0;      ///< facts that must not hold
    bool ordered = true;     ///< its parts
    std::vector<int> parts;  ///< tasks; below 0: operators -1, -2, …
  };
  struct Operator {
    unsigned needs = 0, removes = 0, adds = 0;
  };
  static constexpr int kTasks = 3, kOperators = 3, kFacts = 4;

  std::vector<Way> ways;
  std::vector<Operator> operators;

  static NaiveDomain drawn() {
    const auto facts = [] {
      return *rc::gen::inRange(0U, 1U << kFacts) & *rc::gen::inRange(0U, 16U);
    };
    NaiveDomain domain;
    for (int i = 0; i < kOperators; ++i)
      domain.operators.push_back({facts() & facts(), facts(), facts()});
    for (int task = 0; task < kTasks; ++task)
      for (int way = *rc::gen::inRange(1, 3); way > 0; --way) {
        Way made{task, facts() & facts(), facts() & facts(), *rc::gen::inRange(0, 3) > 0, {}};
        made.lacks &= ~made.needs;
        // Only of later tasks, so that every decomposition ends.
        for (int part = *rc::gen::inRange(0, 3); part > 0; --part) {
          const int later = task + 1 + *rc::gen::inRange(0, kTasks);
          made.parts.push_back(later < kTasks ? later : -1 - *rc::gen::inRange(0, kOperators));
        }
        domain.ways.push_back(made);
      }
    return domain;
  }

  std::string items() const;
  static std::string facts_text(unsigned facts, const std::string& before = "(",
                                const std::string& after = ")") {
    std::string text;
    for (int i = 0; i < kFacts; ++i)
      if ((facts >> i & 1U) != 0) text += before + "f" + std::to_string(i) + after;
    return text;
  }
};

inline std::string NaiveDomain::items() const {
  std::string text;
  for (std::size_t i = 0; i < operators.size(); ++i)
    text += "(:operator (!o" + std::to_string(i) + ") (" + facts_text(operators[i].needs) + ") (" +
            facts_text(operators[i].removes) + ") (" + facts_text(operators[i].adds) + "))\n";
  for (const Way& way : ways) {
    text += "(:method (t" + std::to_string(way.of) + ") (" + facts_text(way.needs) +
            facts_text(way.lacks, "(not (", "))") + ") (" + (way.ordered ? "" : ":unordered ");
    for (const int part : way.parts)
      text +=
          part < 0 ? "(!o" + std::to_string(-1 - part) + ")" : "(t" + std::to_string(part) + ")";
    text += "))\n";
  }
  return text;
}

/// All plans of t0, as the texts of their steps, by SHOP3's rules: the first task of a reduction is
/// done at once (of unordered parts any may be it); of equal tasks that may be begun, the one that
/// stands first in the network is taken.
class NaivePlanner {
 public:
  explicit NaivePlanner(const NaiveDomain& domain) : domain_(domain) {}

  /// Nothing: more than can be tried.
  std::optional<std::set<std::string>> plans(unsigned facts) {
    go(facts, {{0, false, {}, {}}}, "");
    if (tried_ > kMost) return std::nullopt;
    return found_;
  }

 private:
  struct Left {
    int task = 0;  ///< kDone once it is
    bool at_once = false;
    std::vector<int> place;  ///< in the network: which part of which part …
    std::set<int> after;     ///< what must be done before it begins
  };
  using Network = std::vector<Left>;
  static constexpr int kMost = 20'000, kDone = 1000;

  void go(unsigned facts, const Network& left, const std::string& steps) {
    if (++tried_ > kMost) return;
    if (std::all_of(left.begin(), left.end(), [](const Left& one) { return one.task == kDone; })) {
      found_.insert(steps);
      return;
    }
    for (const std::size_t i : choices(left))
      left[i].task < 0 ? take(facts, left, i, steps) : reduce(facts, left, i, steps);
  }

  static bool may_begin(const Network& left, std::size_t i) {
    return left[i].task != kDone &&
           std::all_of(left[i].after.begin(), left[i].after.end(), [&](int before) {
             return left[static_cast<std::size_t>(before)].task == kDone;
           });
  }

  static std::vector<std::size_t> choices(const Network& left) {
    std::map<int, std::size_t> first;  // of each task that may begin
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!may_begin(left, i)) continue;
      if (left[i].at_once) return {i};
      const auto [found, is_new] = first.emplace(left[i].task, i);
      if (!is_new && left[i].place < left[found->second].place) found->second = i;
    }
    std::vector<std::size_t> chosen;
    for (const auto& [task, i] : first) chosen.push_back(i);
    return chosen;
  }

  void take(unsigned facts, Network left, std::size_t i, const std::string& steps) {
    const int number = -1 - left[i].task;
    const auto& taken = domain_.operators[static_cast<std::size_t>(number)];
    if ((facts & taken.needs) != taken.needs) return;
    left[i].task = kDone;
    go((facts & ~taken.removes) | taken.adds, left,
       steps + (steps.empty() ? "" : " ") + "(!o" + std::to_string(number) + ")");
  }

  void reduce(unsigned facts, const Network& left, std::size_t i, const std::string& steps) {
    for (const NaiveDomain::Way& way : domain_.ways) {
      if (way.of != left[i].task || (facts & way.needs) != way.needs || (facts & way.lacks) != 0)
        continue;
      const std::size_t beginnings = way.ordered ? 1 : std::max<std::size_t>(1, way.parts.size());
      for (std::size_t first = 0; first < beginnings; ++first)
        go(facts, reduced(left, i, way, first), steps);
    }
  }

  static Network reduced(Network left, std::size_t i, const NaiveDomain::Way& way,
                         std::size_t first) {
    const std::size_t others = left.size();
    left[i].task = kDone;
    std::set<int> parts;
    for (std::size_t k = 0; k < way.parts.size(); ++k) {
      Left part{way.parts[k], k == first, left[i].place, left[i].after};
      part.place.push_back(static_cast<int>(k));
      if (way.ordered) part.after.insert(parts.begin(), parts.end());
      parts.insert(static_cast<int>(left.size()));
      left.push_back(part);
    }
    // What waits for the task waits for its parts.
    for (std::size_t k = 0; k < others; ++k)
      if (left[k].after.count(static_cast<int>(i)) > 0)
        left[k].after.insert(parts.begin(), parts.end());
    return left;
  }

  const NaiveDomain& domain_;
  std::set<std::string> found_;
  int tried_ = 0;
};

}  // namespace skein::htn::test
