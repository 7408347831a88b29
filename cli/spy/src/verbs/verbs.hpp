// SPDX-License-Identifier: Apache-2.0
// The verbs of `skein spy`, with an open listener.
#pragma once

#include <functional>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "../listener.hpp"

namespace skein::spy_tool {

int show_table(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);
int show_topics(const SpyOptions& options, Listener& listener, std::ostream& out,
                std::ostream& err);
int show_nodes(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);
int echo(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);
int show_events(const SpyOptions& options, Listener& listener, std::ostream& out,
                std::ostream& err);
/// hz, bw and delay.
int show_rates(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);
int show_links(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);
int examine(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err);

/// Errors of the options for the verb echo.
Diagnostics check_echo(const SpyOptions& options, const Listener& listener);

/// When to stop listening: after the duration, or `fallback` seconds without one.
Duration end_of(const SpyOptions& options, double fallback);
/// Says why, and gives the exit code of a time-out.
int nothing_heard(const SpyOptions& options, const Listener& listener, std::uint64_t passed_over,
                  std::ostream& err);
/// Listens until `end`, and calls `show` every `options.every` seconds and at the end; without
/// `every` at the end only.
void listen_and_show(const SpyOptions& options, Listener& listener, Duration end,
                     const Listener::Use& use, const std::function<void()>& show);
/// One JSON object on a line of its own, whatever bytes are in its strings.
void print_line(const nlohmann::ordered_json& object, std::ostream& out);
std::string destination_name(const Graph& graph, std::uint32_t destination);
std::string_view name_of(wire::SlotClass slot_class);

}  // namespace skein::spy_tool
