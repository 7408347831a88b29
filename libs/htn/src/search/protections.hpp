// SPDX-License-Identifier: Apache-2.0
// Atoms that no step may make false, counted, with undo.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "skein/htn/term.hpp"

namespace skein::htn {

class Protections {
 public:
  void add(Term atom) { change(atom, count(atom) + 1); }
  /// Protecting twice needs releasing twice; releasing what is not protected does nothing.
  void release(Term atom) {
    if (count(atom) > 0) change(atom, count(atom) - 1);
  }
  std::uint32_t count(Term atom) const {
    const auto known = counts_.find(atom);
    return known == counts_.end() ? 0 : known->second;
  }
  bool empty() const { return counts_.empty(); }

  using Mark = std::uint32_t;
  Mark mark() const { return static_cast<Mark>(trail_.size()); }
  void undo(Mark mark) {
    while (trail_.size() > mark) {
      set(trail_.back().atom, trail_.back().count);
      trail_.pop_back();
    }
  }
  void forget_trail() { trail_.clear(); }

  /// Every protected atom, in no particular order.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const auto& [atom, count] : counts_) visit(atom);
  }

 private:
  struct Undo {
    Term atom;
    std::uint32_t count;
  };
  void change(Term atom, std::uint32_t to) {
    trail_.push_back({atom, count(atom)});
    set(atom, to);
  }
  void set(Term atom, std::uint32_t to) {
    if (to == 0) {
      counts_.erase(atom);
    } else {
      counts_[atom] = to;
    }
  }
  std::unordered_map<Term, std::uint32_t> counts_;
  std::vector<Undo> trail_;
};

}  // namespace skein::htn
