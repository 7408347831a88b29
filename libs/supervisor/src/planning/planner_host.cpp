// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/planner_host.hpp"

#include "planning/host_services.hpp"

namespace skein::supervisor {

PlannerHost::PlannerHost(std::shared_ptr<const Knowledge> knowledge,
                         std::shared_ptr<const world::World> world, MissionTime origin,
                         std::uint64_t seed, refiners::Budget budget)
    : services_(std::make_shared<Services>(Gazetteer(std::move(knowledge), std::move(world)),
                                           origin, seed, std::move(budget))) {}

PlannerHost::~PlannerHost() = default;

void PlannerHost::flies_on(const world::Vector3& position, double heading) {
  services_->start().flies_on(position, heading);
}

void PlannerHost::stands_at(const world::Vector3& position) {
  services_->start().stands_at(position);
}

void PlannerHost::offer(htn::Functions& functions) const {
  for (const Services::Entry& entry : Services::table()) {
    functions.add(entry.name, entry.arguments, entry.arguments,
                  [services = services_, &entry](htn::TermStore& store,
                                                 std::span<const htn::Term> arguments) {
                    return services->call(entry, store, arguments);
                  });
  }
}

void PlannerHost::declare(htn::Functions& functions) {
  for (const Services::Entry& entry : Services::table()) {
    functions.add(entry.name, entry.arguments, entry.arguments,
                  [](htn::TermStore&, std::span<const htn::Term>) -> Result<htn::Term, Failure> {
                    return failure("there is no world to ask");
                  });
  }
}

PlannerHost::Desk::Desk() : seat_(std::make_shared<Seat>()) {}

void PlannerHost::Desk::offer(htn::Functions& functions) const {
  for (const Services::Entry& entry : Services::table()) {
    functions.add(
        entry.name, entry.arguments, entry.arguments,
        [seat = seat_, &entry](htn::TermStore& store,
                               std::span<const htn::Term> arguments) -> Result<htn::Term, Failure> {
          if (!seat->taken) return failure("there is no world to ask");
          return seat->taken->call(entry, store, arguments);
        });
  }
}

void PlannerHost::Desk::seat(const PlannerHost& host) { seat_->taken = host.services_; }
void PlannerHost::Desk::leave() { seat_->taken.reset(); }

void PlannerHost::begin() { services_->begin(); }
const std::vector<std::string>& PlannerHost::refusals() const { return services_->refusals(); }
std::uint64_t PlannerHost::refinements() const { return services_->refinements(); }

}  // namespace skein::supervisor
