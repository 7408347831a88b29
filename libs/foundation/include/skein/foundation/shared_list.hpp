// SPDX-License-Identifier: Apache-2.0
// A list that many hold.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace skein {

/// An immutable list whose copies share one storage: what all nodes of a process know of each other
/// would else take the square of their number. Copies cost a reference count. Thread-safe as a
/// `const std::vector`.
template <class T>
class SharedList {
 public:
  using value_type = T;
  using const_iterator = typename std::vector<T>::const_iterator;

  SharedList() : values_(none()) {}
  SharedList(std::initializer_list<T> values) : SharedList(std::vector<T>(values)) {}
  SharedList(std::vector<T> values)  // NOLINT(google-explicit-constructor): the same list
      : values_(std::make_shared<const std::vector<T>>(std::move(values))) {}

  const std::vector<T>& values() const { return *values_; }
  const_iterator begin() const { return values_->begin(); }
  const_iterator end() const { return values_->end(); }
  std::size_t size() const { return values_->size(); }
  bool empty() const { return values_->empty(); }
  const T& operator[](std::size_t index) const { return (*values_)[index]; }
  /// Whether both are copies of one list.
  bool shares(const SharedList& other) const { return values_ == other.values_; }
  bool operator==(const SharedList& other) const { return values() == other.values(); }

 private:
  static const std::shared_ptr<const std::vector<T>>& none() {
    static const auto empty = std::make_shared<const std::vector<T>>();
    return empty;
  }

  std::shared_ptr<const std::vector<T>> values_;  ///< never null
};

}  // namespace skein
