// SPDX-License-Identifier: Apache-2.0
#include "companions.hpp"

#include <iterator>
#include <utility>

namespace skein::daemon_main {

void Companions::add(std::unique_ptr<node::Companion> companion) {
  if (companion) all_.push_back(std::move(companion));
}

void Companions::attach(std::function<void()> wake) {
  for (const auto& one : all_) one->attach(wake);
}

void Companions::detach() {
  for (const auto& one : all_) one->detach();
}

std::vector<wire::Sample> Companions::take() {
  std::vector<wire::Sample> said;
  for (const auto& one : all_) {
    auto more = one->take();
    std::move(more.begin(), more.end(), std::back_inserter(said));
  }
  return said;
}

void Companions::sees(const wire::Sample& sample) {
  for (const auto& one : all_) one->sees(sample);
}

void Companions::sees(const journal::Record& record) {
  for (const auto& one : all_) one->sees(record);
}

void Companions::turn(const node::DaemonState& state) {
  for (const auto& one : all_) one->turn(state);
}

}  // namespace skein::daemon_main
