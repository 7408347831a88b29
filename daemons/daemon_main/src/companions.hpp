// SPDX-License-Identifier: Apache-2.0
// Several companions of one daemon.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/node/companion.hpp"

namespace skein::daemon_main {

/// Forwards everything to all companions; their samples are published in the name of the first, in
/// their order. So only companions with the same name can be combined.
class Companions final : public node::Companion {
 public:
  /// Adds a companion; null is ignored.
  void add(std::unique_ptr<node::Companion> companion);
  bool empty() const { return all_.empty(); }

  void attach(std::function<void()> wake) override;
  void detach() override;
  /// Precondition: not empty.
  std::string speaks_as() const override { return all_.front()->speaks_as(); }
  std::vector<wire::Sample> take() override;
  void sees(const wire::Sample& sample) override;
  void sees(const journal::Record& record) override;
  void turn(const node::DaemonState& state) override;

  Companions() = default;
  Companions(Companions&& other) noexcept : all_(std::move(other.all_)) {}

 private:
  std::vector<std::unique_ptr<node::Companion>> all_;
};

}  // namespace skein::daemon_main
