// SPDX-License-Identifier: Apache-2.0
// --console: the operators' page and the designer of interaction models beside it.
#pragma once

#include <string>
#include <vector>

#include "skein/daemon_main/daemon_main.hpp"

namespace skein::ground_companions {

class OperatorsPage final : public daemon_main::CompanionSource {
 public:
  void declare(CLI::App& app) override;
  Result<Opened, Failure> open(const daemon_main::Surroundings& surroundings) override;

 private:
  std::string address_;  ///< ADDRESS:PORT; empty: no page
  std::vector<std::string> names_;
};

}  // namespace skein::ground_companions
