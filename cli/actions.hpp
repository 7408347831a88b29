// SPDX-License-Identifier: Apache-2.0
// The functions that carry out the commands of the command line.
#pragma once

#include <any>
#include <functional>
#include <map>
#include <typeindex>
#include <utility>

namespace skein::cli {

/// What is done for each command, by the type of its options; returns exit codes. All programs of
/// `skein` have the same command line, each carries out some commands.
class Actions {
 public:
  template <class Options>
  using Action = std::function<int(const Options&)>;

  /// Commands that are not added come to `otherwise`.
  explicit Actions(std::function<int()> otherwise) : otherwise_(std::move(otherwise)) {}

  template <class Options>
  void add(Action<Options> action) {
    actions_[typeid(Options)] = std::move(action);
  }

  template <class Options>
  int carry_out(const Options& options) const {
    const auto action = actions_.find(typeid(Options));
    if (action == actions_.end()) return otherwise_();
    return std::any_cast<const Action<Options>&>(action->second)(options);
  }

 private:
  std::function<int()> otherwise_;
  std::map<std::type_index, std::any> actions_;
};

}  // namespace skein::cli
