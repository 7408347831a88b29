// SPDX-License-Identifier: Apache-2.0
// A dispatchable form as text, for executors of others.
#pragma once

#include <string>

#include "skein/foundation/result.hpp"
#include "skein/temporal/dispatchable_network.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {

/// In kJson: `{"origin", "nodes", "edges": [{"from", "to", "max"}, …], "contingent": [{"from",
/// "to", "min", "max"}, …], "waits": [{"node", "from", "to", "delay"}, …]}` in seconds: `to` comes
/// no later than `max` after `from`; `node` comes no earlier than `delay` after the activation
/// `from` of the link, unless its end `to` has come. In kGraphml: edges of type requirement and
/// contingent, waits as edges of type derived with the labelled value `UC(end):-delay` (which
/// read_network() leaves out: they follow). Fails for the other formats, which have no waits, and
/// as write_network() does.
Result<std::string, Failure> write_dispatchable(const DispatchableNetwork& network, Format format);

}  // namespace skein::temporal
