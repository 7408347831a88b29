// SPDX-License-Identifier: Apache-2.0
// The operators' page, served from the process of the ground station.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/console/annex.hpp"
#include "skein/foundation/result.hpp"
#include "skein/node/companion.hpp"

namespace skein::console {

struct ConsoleConfig {
  std::string address = "127.0.0.1";  ///< IPv4 to listen on; anything but 127.x needs the token
  std::uint16_t port = 8080;          ///< 0: any that is free
  std::vector<std::string> names;     ///< host names permitted in requests, beside addresses
  std::string world = "{}";           ///< one JSON object: the static part of the mission
  std::shared_ptr<Annex> annex = {};  ///< additional requests; null: none
  std::string start = {};             ///< page that url() opens: "designer.html"
  /// Additional values for the page from a sample, as JSON objects by key; the last one of each key
  /// is kept. Called from the daemon's thread.
  using Explain =
      std::function<std::vector<std::pair<std::string, std::string>>(const wire::Sample&)>;
  Explain explain = {};
};

/// "ADDR:PORT", "ADDR", ":PORT" or "PORT"; what is absent stays as in `config`.
Result<void, Failure> read_address(std::string_view text, ConsoleConfig& config);

/// Serves the operators' page: sends it the inputs and outputs of the node as server-sent events,
/// and takes operators' requests by POST.
///
/// Its server has a thread of its own; the daemon's thread only puts values into a store and takes
/// requests out of a queue. Memory is bounded whatever browsers do: they all read from one store, a
/// slow one gets the latest of each value, and connections, streams, open requests and their sizes
/// have limits (src/limits.hpp). Losing the page does not affect the mission.
///
/// Source: ADR 16. Security: docs/threats.md.
class Console final : public node::Companion {
 public:
  /// Begins to listen; the failure has the reason why that is not possible.
  static Result<std::unique_ptr<Console>, Failure> open(ConsoleConfig config);
  ~Console() override;

  std::uint16_t port() const;
  /// The address to open in a browser, with the token if one is needed.
  std::string url() const;

  /// Clears all pages; the samples from now on are shown as a new mission.
  void begin_again();

  void attach(std::function<void()> wake) override;
  void detach() override;
  std::string speaks_as() const override { return "operator"; }
  std::vector<wire::Sample> take() override;
  void sees(const wire::Sample& sample) override;
  void sees(const journal::Record& record) override;
  void turn(const node::DaemonState& state) override;

 private:
  class Impl;
  explicit Console(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::console
