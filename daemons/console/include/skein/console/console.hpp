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
  std::vector<std::string> names;     ///< by which browsers may call this machine, beside addresses
  std::string world = "{}";           ///< one JSON object: what does not change in a mission
  std::shared_ptr<Annex> annex = {};  ///< what else is served; none: nothing
  std::string start = {};             ///< of the page to begin with: "designer.html"
  /// What else a sample means for the page, as JSON objects by key, the last of which it is to
  /// have. Called from the daemon's thread.
  using Explain =
      std::function<std::vector<std::pair<std::string, std::string>>(const wire::Sample&)>;
  Explain explain = {};
};

/// "ADDR:PORT", "ADDR", ":PORT" or "PORT"; what is absent stays as in `config`.
Result<void, Failure> read_address(std::string_view text, ConsoleConfig& config);

/// Serves a page that shows what its node knows, as server-sent events, and takes operators'
/// requests by POST. What the page shows is what came to the node or what the node publishes.
///
/// Its server has a thread of its own; the daemon's thread only puts values into a store and takes
/// requests out of a queue. Memory is bounded whatever browsers do: they all read from the one
/// store, a slow one is given the latest of each value, and connections, streams, requests under
/// way and their sizes have limits (src/limits.hpp). Losing the page changes nothing in the
/// mission.
///
/// Source: ADR 16. Security: docs/threats.md.
class Console final : public node::Companion {
 public:
  /// Listens at once. The failure says why that is not possible.
  static Result<std::unique_ptr<Console>, Failure> open(ConsoleConfig config);
  ~Console() override;

  std::uint16_t port() const;
  /// What to open in a browser; with the token when one is needed.
  std::string url() const;

  /// Pages forget what they were told; what it sees from now on is a story from its beginning.
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
