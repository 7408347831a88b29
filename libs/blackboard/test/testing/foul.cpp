// SPDX-License-Identifier: Apache-2.0
#include "testing/foul.hpp"

#include <algorithm>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace skein::blackboard::testing {

namespace {

constexpr std::size_t kKept = 200;        // names and numbers each
constexpr std::size_t kLongestList = 40;  // that is made here

template <class T>
void keep(std::deque<T>& kept, T value) {
  kept.push_back(std::move(value));
  if (kept.size() > kKept) kept.pop_front();
}

template <class T>
concept Number = std::is_integral_v<T> && !std::same_as<T, bool>;

}  // namespace

/// Notes the names and numbers of a record.
class Fouler::Gatherer {
 public:
  explicit Gatherer(Fouler& of) : of_(of) {}

  template <class T>
  void operator()(const char*, const T& value) {
    see(value);
  }

 private:
  template <class T>
  void see(const T& value) {
    if constexpr (std::same_as<T, wire::SampleHeader>) {
      if (of_.changes_ == Fouler::Changes::kAll) visit_fields(*this, value);
    } else if constexpr (std::same_as<T, bool> || wire::WireEnum<T>) {
    } else if constexpr (Number<T>) {
      keep(of_.numbers_, static_cast<std::uint64_t>(value));
    } else if constexpr (std::floating_point<T>) {
      keep(of_.figures_, static_cast<double>(value));
    } else if constexpr (std::same_as<T, std::string>) {
      keep(of_.names_, value);
    } else if constexpr (wire::kIsRecord<T>) {
      visit_fields(*this, value);
    } else {
      for (const auto& one : value) see(one);
    }
  }

  Fouler& of_;
};

/// Changes each field with one probability.
class Fouler::Changer {
 public:
  Changer(Fouler& of, double probability)
      : of_(of), random_(of.random_), probability_(probability) {}

  template <class T>
  void operator()(const char*, T& value) {
    if (!std::same_as<T, wire::SampleHeader> || of_.changes_ == Fouler::Changes::kAll) pass(value);
  }

 private:
  template <class T>
  void pass(T& value) {
    if constexpr (wire::kIsRecord<T>) {
      visit_fields(*this, value);
    } else if (random_.chance(probability_)) {
      change(value);
    }
  }
  template <class T>
  void pass(std::vector<T>& values) {
    if (random_.chance(probability_)) change(values);
    for (T& value : values) pass(value);
  }

  void change(bool& value) { value = !value; }
  template <wire::WireEnum E>
  void change(E& value) {
    value = static_cast<E>(random_.below(static_cast<std::uint64_t>(E::kCount)));
  }
  template <Number T>
  void change(T& value) {
    using Limits = std::numeric_limits<T>;
    switch (random_.below(7)) {
      case 0:
        value = T{0};
        break;
      case 1:
        value = Limits::max();
        break;
      case 2:
        value = Limits::min();
        break;
      case 3:
        value = static_cast<T>(static_cast<std::uint64_t>(value) + 1);
        break;
      case 4:
        value = static_cast<T>(static_cast<std::uint64_t>(value) - 1);
        break;
      case 5:
        value = static_cast<T>(random_.bits());
        break;
      default:
        value = static_cast<T>(one_of(of_.numbers_, std::uint64_t{1}));
    }
  }
  template <std::floating_point T>
  void change(T& value) {
    switch (random_.below(7)) {
      case 0:
        value = T{0};
        break;
      case 1:
        value = -value;
        break;
      case 2:
        value = std::numeric_limits<T>::max();
        break;
      case 3:
        value = std::numeric_limits<T>::min();
        break;
      case 4:
        value = static_cast<T>(value * random_.uniform(0, 1e3));
        break;
      case 5:
        value = static_cast<T>(random_.normal() * 1e6);
        break;
      default:
        value = static_cast<T>(one_of(of_.figures_, 1.0));
    }
  }
  void change(std::string& value) {
    value = random_.chance(0.2) ? std::string() : one_of(of_.names_, std::string("x"));
  }
  template <class T>
  void change(std::vector<T>& values) {
    if (values.empty() || random_.chance(0.2)) {
      values.resize(values.size() + 1);
      return;
    }
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(random_.below(values.size()));
    const auto other = values.begin() + static_cast<std::ptrdiff_t>(random_.below(values.size()));
    switch (random_.below(5)) {
      case 0:
        values.clear();
        break;
      case 1:
        values.erase(at);
        break;
      case 2:
        std::iter_swap(at, other);
        break;
      case 3:
        *at = T(*other);
        break;
      default:
        for (auto more = 1 + random_.below(8); more > 0 && values.size() < kLongestList; --more)
          values.push_back(T(values[random_.below(values.size())]));
    }
  }

  template <class T>
  T one_of(const std::deque<T>& kept, T otherwise) {
    return kept.empty() ? otherwise : kept[random_.below(kept.size())];
  }

  Fouler& of_;
  Random& random_;
  double probability_;
};

wire::Sample Fouler::foul(const wire::Sample& sample) {
  const wire::SampleVariant& fair = sample;
  std::visit([&](const auto& record) { visit_fields(Gatherer(*this), record); }, fair);
  wire::Sample changed = sample;
  wire::SampleVariant& foul = changed;
  const double probability = 0.3 / static_cast<double>(1 + random_.below(16));
  std::visit([&](auto& record) { visit_fields(Changer(*this, probability), record); }, foul);
  return wire::find_violation(changed) ? sample : changed;
}

}  // namespace skein::blackboard::testing
