// SPDX-License-Identifier: MIT
#include "remesh/quads/map/loop_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "base/fires.h"
#include "mesh/topology.h"
#include "remesh/quads/map/map_loops.h"

namespace remesher {

namespace {

// So many changes are tried at most, and so many of them measured.
constexpr int kMostChanges = 800, kMostMeasured = 240;
// After so many changes lines pass each other elsewhere.
constexpr int kBeforeNewPasses = 20;
// Lines up to so many quads apart are changed, over so many quads of their length.
constexpr int kMostAcross = 2;
constexpr double kMostAlong = 60;
// Singular vertices as near as this are watched, so that they do not fall together.
constexpr double kWatched = 4;
// The first changes may raise the cost by twice this.
constexpr double kHeat = 0.03;
// Loops as short as this, and that cross themselves in so few quads, are short enough.
constexpr double kShortLoop = 0.15, kFewCrossings = 0.06;
// Of the quadratic beside the loops, per quad; and how much it may rise.
constexpr double kDistortion = 20, kMostRisen = 0.003;
// As many numbers as are held at most for how places move: beyond, loops stay as they are.
constexpr double kMostMoves = 8e6;

class LoopSearch {
 public:
  LoopSearch(const LineInput& input, const Rounding& rounding, const LoopStart& start,
             const LoopGoal& goal)
      : input_(input),
        rounding_(rounding),
        start_(start),
        goal_(goal),
        meter_(input.mesh.mesh(), input.system, input.cut),
        factor_(1 / start.length) {
    const SeamlessSystem& system = input.system;
    const auto reals = Eigen::Index(system.realCount());
    const Eigen::MatrixXd response = rounding.response();
    moves_ = Eigen::MatrixXd::Zero(2 * Eigen::Index(system.copyCount()), start.integers.size());
    for (Index i = 0; i < system.copyCount(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (const auto& [variable, x] : system.sumsOf(i)[axis]) {
          const Eigen::Index row = 2 * Eigen::Index(i) + Eigen::Index(axis);
          if (Eigen::Index(variable) < reals)
            moves_.row(row) += x * response.row(variable);
          else
            moves_(row, variable - reals) += x;
        }
  }

  std::vector<Eigen::VectorXd> run() {
    State now{start_.integers, placesOf(rounding_.withReals(start_.integers, factor_))};
    judge(now);
    mostRisen_ = now.risen + kMostRisen * goal_.vertices;
    shortSums_ = rounding_.shortSums(now.integers);
    lookForPasses(now);
    double least = now.cost;
    std::vector<Eigen::VectorXd> found;
    int measured = 0, taken = 0;
    bool isEnough = false;
    for (int i = 0; i < kMostChanges && measured < kMostMeasured && !isEnough; ++i) {
      if (passes_.empty()) break;
      const double done = std::max(double(i) / kMostChanges, double(measured) / kMostMeasured);
      const double most = now.cost + 2 * kHeat * (1 - done) * random();
      State next;
      next.integers = changed(now);
      next.risen = rounding_.risen(next.integers, factor_);
      if (!isAllowed(next, now, most)) continue;
      next.places = moved(now, next.integers);
      judge(next);
      ++measured;
      if (next.cost > most) continue;
      now = std::move(next);
      if (++taken % kBeforeNewPasses == 0) lookForPasses(now);
      if (now.cost >= least || missed(now) > goal_.slack) continue;
      least = now.cost;
      found.push_back(now.integers);
      isEnough = now.loops.longest <= kShortLoop && now.loops.selfCrossing <= kFewCrossings;
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

 private:
  using Places = std::vector<std::array<double, 2>>;

  struct State {
    Eigen::VectorXd integers;
    Places places = {};  // of the copies
    MapLoops loops = {};
    double count = 0, risen = 0, cost = 0;
  };

  // From 0 to 1, in an order that is always the same.
  double random() {
    seed_ = seed_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return double(seed_ >> 11) * 0x1p-53;
  }

  double missed(const State& state) const { return std::abs(state.count / goal_.vertices - 1); }

  Places placesOf(const Eigen::VectorXd& values) const {
    Places places(input_.system.copyCount(), {0, 0});
    for (Index i = 0; i < places.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (const auto& [variable, x] : input_.system.sumsOf(i)[axis])
          places[i][axis] += x * values[variable];
    return places;
  }

  Places moved(const State& state, const Eigen::VectorXd& integers) const {
    Places places = state.places;
    for (Eigen::Index c = 0; c < integers.size(); ++c) {
      const double change = integers[c] - state.integers[c];
      if (change == 0) continue;
      const double* move = moves_.col(c).data();
      for (std::array<double, 2>& place : places)
        for (double& x : place) x += change * *move++;
    }
    return places;
  }

  // Loops, and beside them the distortion and a number that is nearly missed.
  void judge(State& state) const {
    constexpr double kNearlyMissed = 0.8, kPerMissed = 20;
    const MapLoops& loops = state.loops = meter_.measure(state.places);
    state.risen = rounding_.risen(state.integers, factor_);
    state.count = double(eulerCharacteristic(input_.mesh.mesh())) + loops.area + loops.boundary / 2;
    state.cost = loops.squares + (loops.selfCrossing + loops.longest) / 2 +
                 kDistortion * state.risen / goal_.vertices +
                 kPerMissed * std::max(0.0, missed(state) - kNearlyMissed * goal_.slack);
  }

  // One of the lines a quad nearer to the singular vertex, or now and then farther from it.
  Eigen::VectorXd changed(const State& state) {
    constexpr double kEitherWay = 0.3;
    const auto which = std::size_t(random() * double(passes_.size()));
    const IntegerSum& across = passes_[which].across;
    const double now = rounding_.valueOf(across, state.integers);
    const bool isUp = now < -0.5 || (now < 0.5 && rounding_.relaxed(across, factor_) > 0);
    const bool isEither = random() < kEitherWay, isOther = random() < 0.5;
    const int step = (isEither ? isOther : isUp) ? 1 : -1;
    return rounding_.nudged(state.integers, factor_, {across, int(std::lround(now)) + step});
  }

  bool isAllowed(const State& next, const State& now, double most) const {
    return next.risen <= mostRisen_ && kDistortion * next.risen / goal_.vertices <= most &&
           next.integers != now.integers && rounding_.shortSums(next.integers) <= shortSums_ &&
           !areTogether(next.integers);
  }

  // Whether two singular vertices are at the same place.
  bool areTogether(const Eigen::VectorXd& integers) const {
    const auto isZero = [&](const IntegerSum& sum) {
      return std::abs(rounding_.valueOf(sum, integers)) < 0.5;
    };
    return std::any_of(watched_.begin(), watched_.end(),
                       [&](const auto& sums) { return isZero(sums.first) && isZero(sums.second); });
  }

  void lookForPasses(const State& state) {
    const SeamlessMap map = start_.mapOf(rounding_.withReals(state.integers, factor_));
    passes_ = nearPasses(input_, map, {kMostAcross, kMostAlong});
    for (const NearPass& pass : passes_)
      if (pass.quads < kWatched) watched_.insert({pass.across, pass.along});
  }

  const LineInput& input_;
  const Rounding& rounding_;
  const LoopStart& start_;
  const LoopGoal goal_;
  const LoopMeter meter_;
  const double factor_;
  Eigen::MatrixXd moves_;  // of the places, u and v in turn, with each integer variable
  double mostRisen_ = 0;
  std::size_t shortSums_ = 0;  // of the map at the start
  std::vector<NearPass> passes_;
  std::set<std::pair<IntegerSum, IntegerSum>> watched_;
  std::uint64_t seed_ = 1;
};

}  // namespace

std::vector<Eigen::VectorXd> searchShorterLoops(const LineInput& input, const Rounding& rounding,
                                                const LoopStart& start, const LoopGoal& goal) {
  if (2.0 * input.system.copyCount() * double(start.integers.size()) > kMostMoves) {
    fires("quads: loops are not shortened");
    return {};
  }
  return LoopSearch(input, rounding, start, goal).run();
}

}  // namespace remesher
