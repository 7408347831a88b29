// SPDX-License-Identifier: Apache-2.0
// The only file with OMPL headers.
#include "tree_search.hpp"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsSqrtApprox.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace skein::sampling {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using refiners::Countdown;
using refiners::Way;
using world::Vector3;

/// By which our planners' messages are told from others'.
constexpr const char* kName = "skein-sampling";

/// OMPL's messages go to one handler of the whole process. This one leaves out our planners', which
/// begin with their name, and gives the others to the handler there was before.
class WithoutOurs final : public ompl::msg::OutputHandler {
 public:
  static void install() {
    static WithoutOurs& installed = *new WithoutOurs;  // lives as long as the process
    static_cast<void>(installed);
  }
  void log(const std::string& text, ompl::msg::LogLevel level, const char* file,
           int line) override {
    if (next_ && text.find(kName) == std::string::npos) next_->log(text, level, file, line);
  }

 private:
  WithoutOurs() : next_(ompl::msg::getOutputHandler()) { ompl::msg::useOutputHandler(this); }
  ompl::msg::OutputHandler* next_;
};

using State = ob::RealVectorStateSpace::StateType;

Vector3 point_of(const ob::State* state) {
  const double* values = state->as<State>()->values;
  return {values[0], values[1], values[2]};
}
void set(ob::State* state, const Vector3& point) {
  std::copy(point.data(), point.data() + 3, state->as<State>()->values);
}

/// Draws from a generator of ours, since OMPL seeds its own from one that the whole process shares.
/// Every sample is a step of the countdown.
class Sampler final : public ob::StateSampler {
 public:
  using Draw = std::function<Vector3()>;
  Sampler(const ob::StateSpace* space, Draw draw) : StateSampler(space), draw_(std::move(draw)) {}
  void sampleUniform(ob::State* state) override { set(state, draw_()); }
  void sampleUniformNear(ob::State* state, const ob::State*, double) override {
    sampleUniform(state);
  }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  Draw draw_;
};

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& info, const SearchSpace& space)
      : StateValidityChecker(info), space_(space) {}
  bool isValid(const ob::State* state) const override { return space_.is_free(point_of(state)); }

 private:
  const SearchSpace& space_;
};

class Motions final : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& info, const SearchSpace& space)
      : MotionValidator(info), space_(space) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const Vector3 b = point_of(to);
    return space_.is_free(b) && space_.is_free_between(point_of(from), b);
  }
  /// None of the planners used asks how far it is free.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first) si_->copyState(last_valid.first, from);
    last_valid.second = 0;
    return false;
  }

 private:
  const SearchSpace& space_;
};

/// Whatever they draw themselves (RRT* draws when to aim at the goal) comes from a given seed.
template <class Planner>
class Seeded final : public Planner {
 public:
  Seeded(const ob::SpaceInformationPtr& info, Random& random) : Planner(info) {
    this->rng_.setLocalSeed(static_cast<std::uint32_t>(random.bits()) | 1U);
    this->setName(kName);
    // The default structure draws at random too; this one does not.
    this->template setNearestNeighbors<ompl::NearestNeighborsSqrtApprox>();
  }
};

ob::SpaceInformationPtr info_of(const SearchSpace& space, const Sampler::Draw& draw) {
  const auto states = std::make_shared<ob::RealVectorStateSpace>(3);
  ob::RealVectorBounds bounds(3);
  for (unsigned i = 0; i < 3; ++i) {
    bounds.setLow(i, space.low[i]);
    bounds.setHigh(i, space.high[i]);
  }
  states->setBounds(bounds);
  states->setStateSamplerAllocator(
      [draw](const ob::StateSpace* s) { return std::make_shared<Sampler>(s, draw); });
  const auto info = std::make_shared<ob::SpaceInformation>(states);
  info->setStateValidityChecker(std::make_shared<Validity>(info, space));
  info->setMotionValidator(std::make_shared<Motions>(info, space));
  info->setup();
  return info;
}

std::shared_ptr<ob::ProblemDefinition> problem_of(const ob::SpaceInformationPtr& info,
                                                  const SearchSpace& space) {
  const auto problem = std::make_shared<ob::ProblemDefinition>(info);
  ob::ScopedState<> from(info), to(info);
  set(from.get(), space.from);
  set(to.get(), space.to);
  problem->setStartAndGoalStates(from, to);
  return problem;
}

Way way_of(const ob::ProblemDefinition& problem) {
  Way way;
  const auto* path = problem.getSolutionPath()->as<og::PathGeometric>();
  for (unsigned i = 0; i < path->getStateCount(); ++i) way.push_back(point_of(path->getState(i)));
  return way;
}

/// Uniform in the ellipsoid of the points through which a way between the foci may be shorter than
/// `length`.
Vector3 within_ellipsoid(const Vector3& a, const Vector3& b, double length, Random& random) {
  const double apart = (b - a).norm();
  const double half = length / 2;
  const double across = std::sqrt(std::max(0.0, length * length - apart * apart)) / 2;
  Vector3 ball;
  do {
    for (double& axis : ball) axis = random.uniform(-1, 1);
  } while (ball.squaredNorm() > 1);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitX(), b - a);
  return (a + b) / 2 + turn * Vector3(half * ball.x(), across * ball.y(), across * ball.z());
}

double range_of(const SearchSpace& space) { return (space.high - space.low).norm() / 8; }

/// The way that a planner finds before the countdown is over.
std::optional<Way> solved(ob::Planner& planner, const ob::ProblemDefinitionPtr& problem,
                          const Countdown& countdown) {
  planner.setProblemDefinition(problem);
  planner.setup();
  const auto over = [&countdown] { return countdown.over(); };
  if (planner.solve(ob::PlannerTerminationCondition(over)) != ob::PlannerStatus::EXACT_SOLUTION)
    return std::nullopt;
  return way_of(*problem);
}

}  // namespace

std::optional<Way> first_way(const SearchSpace& space, Random& random, Countdown& countdown) try {
  WithoutOurs::install();
  const auto info = info_of(space, [&] {
    countdown.step();
    return space.any_point(random);
  });
  const auto problem = problem_of(info, space);
  Seeded<og::RRTConnect> planner(info, random);
  planner.setRange(range_of(space));
  return solved(planner, problem, countdown);
} catch (const ompl::Exception&) {
  return std::nullopt;
}

std::optional<Way> shorter_way(const SearchSpace& space, double length, Random& random,
                               Countdown& countdown) try {
  WithoutOurs::install();
  double best = length;
  const auto info = info_of(space, [&] {
    countdown.step();
    Vector3 point = within_ellipsoid(space.from, space.to, best, random);
    for (int i = 0; i < 3; ++i) point[i] = std::clamp(point[i], space.low[i], space.high[i]);
    return point;
  });
  const auto problem = problem_of(info, space);
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(info));
  problem->getOptimizationObjective()->setCostThreshold(ob::Cost(0));
  problem->setIntermediateSolutionCallback(
      [&best](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost cost) {
        best = std::min(best, cost.value());
      });
  Seeded<og::RRTstar> planner(info, random);
  planner.setRange(range_of(space));
  return solved(planner, problem, countdown);
} catch (const ompl::Exception&) {
  return std::nullopt;
}

}  // namespace skein::sampling
