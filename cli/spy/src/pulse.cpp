// SPDX-License-Identifier: Apache-2.0
#include "pulse.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace skein::spy_tool {

namespace {

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  Spread spread;
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  spread.least = values.front();
  spread.greatest = values.back();
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / count);
  const auto rank = static_cast<std::size_t>(std::ceil(0.99 * count));
  spread.late = values[std::max<std::size_t>(rank, 1) - 1];
  return spread;
}

}  // namespace

void Pulse::beat(Duration at, std::size_t bytes, double delay) {
  beats_.push_back({at, bytes, delay});
  if (beats_.size() > window_) beats_.pop_front();
}

std::optional<Spread> Pulse::intervals() const {
  std::vector<double> values;
  for (std::size_t i = 1; i < beats_.size(); ++i)
    values.push_back((beats_[i].at - beats_[i - 1].at).to_seconds());
  return spread_of(std::move(values));
}

std::optional<Spread> Pulse::sizes() const {
  std::vector<double> values;
  for (const Beat& beat : beats_) values.push_back(static_cast<double>(beat.bytes));
  return spread_of(std::move(values));
}

std::optional<Spread> Pulse::delays() const {
  std::vector<double> values;
  for (const Beat& beat : beats_) values.push_back(beat.delay);
  return spread_of(std::move(values));
}

double Pulse::span() const {
  return beats_.empty() ? 0 : (beats_.back().at - beats_.front().at).to_seconds();
}

double Pulse::bytes_per_second() const {
  if (span() <= 0) return 0;
  double bytes = 0;
  for (std::size_t i = 1; i < beats_.size(); ++i) bytes += static_cast<double>(beats_[i].bytes);
  return bytes / span();
}

}  // namespace skein::spy_tool
