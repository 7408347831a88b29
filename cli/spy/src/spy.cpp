// SPDX-License-Identifier: Apache-2.0
#include "skein/spy_tool/spy.hpp"

#include <memory>
#include <ostream>

#include "skein/blackboard/fastdds_observer.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs/verbs.hpp"

namespace skein::spy_tool {

namespace {

int show(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err) {
  switch (options.verb) {
    case Verb::kTable:
      return show_table(options, listener, out, err);
    case Verb::kTopics:
      return show_topics(options, listener, out, err);
    case Verb::kNodes:
      return show_nodes(options, listener, out, err);
    case Verb::kEcho:
      return echo(options, listener, out, err);
    case Verb::kEvents:
      return show_events(options, listener, out, err);
    case Verb::kRate:
    case Verb::kBandwidth:
    case Verb::kDelay:
      return show_rates(options, listener, out, err);
    case Verb::kLinks:
      return show_links(options, listener, out, err);
    case Verb::kDoctor:
      break;
  }
  return examine(options, listener, out, err);
}

}  // namespace

int spy(const SpyOptions& options, std::ostream& out, std::ostream& err) {
  Listener listener(options,
                    std::make_unique<blackboard::FastDdsObserver>(
                        blackboard::ObserverConfig{options.domain, "spy", options.network}));
  // ls looks at topics of anybody.
  Diagnostics wrong = options.verb == Verb::kTopics ? Diagnostics() : listener.check();
  if (options.verb == Verb::kEcho) wrong.append(check_echo(options, listener));
  if (!wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  const auto opened = listener.open();
  // The doctor says what is wrong with the options.
  if (!opened && options.verb != Verb::kDoctor) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  return show(options, listener, out, err);
}

}  // namespace skein::spy_tool
