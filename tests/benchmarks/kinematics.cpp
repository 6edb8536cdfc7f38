// SPDX-License-Identifier: Apache-2.0
// The laparoscope's mathematics, each part alone, at poses all over the workspace.
#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "components/kinematics/laparoscope_gravity.hpp"

namespace trocar::bench {
namespace {

struct Place {
  PoseCoordinates pose;
  LaparoscopeConfiguration configuration;
  LaparoscopeRates rates;
};

/// Poses that the mechanism reaches, so many that no branch is learnt by heart.
const std::vector<Place>& places() {
  static const std::vector<Place> all = [] {
    const LaparoscopeModel model;
    std::vector<Place> found;
    for (double x = -0.02; x <= 0.02; x += 0.01)
      for (double y = -0.02; y <= 0.02; y += 0.01)
        for (double z = 0.075; z <= 0.095; z += 0.01)
          for (const double tilt : {-0.2, 0.0, 0.2}) {
            Place place{{{x, y, z}, tilt, -0.5 * tilt, 3.0 * tilt}, {}, {}};
            Vector6d q;
            if (model.inverse(place.pose, q) != AssemblyStatus::ok ||
                model.forward(q, place.configuration) != AssemblyStatus::ok)
              throw std::logic_error("a pose of the benchmark is out of reach");
            place.rates = model.rates(place.configuration);
            found.push_back(place);
          }
    return found;
  }();
  return all;
}

/// One place after the other.
void at_places(benchmark::State& state, const auto& compute) {
  const std::vector<Place>& all = places();
  std::size_t i = 0;
  for (auto _ : state) {
    auto result = compute(all[i]);
    benchmark::DoNotOptimize(result);
    if (++i == all.size()) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

void forward_kinematics(benchmark::State& state) {
  const LaparoscopeModel model;
  at_places(state, [&](const Place& place) {
    LaparoscopeConfiguration configuration;
    model.forward(place.configuration.q, configuration);
    return configuration;
  });
}

void inverse_kinematics(benchmark::State& state) {
  const LaparoscopeModel model;
  at_places(state, [&](const Place& place) {
    Vector6d q;
    model.inverse(place.pose, q);
    return q;
  });
}

void jacobian(benchmark::State& state) {
  const LaparoscopeModel model;
  at_places(state, [&](const Place& place) { return model.rates(place.configuration); });
}

void gravity(benchmark::State& state) {
  const LaparoscopeGravity weight({}, {});
  at_places(state, [&](const Place& place) {
    return weight.effort(place.configuration, place.rates, standard_gravity);
  });
}

BENCHMARK(forward_kinematics);
BENCHMARK(inverse_kinematics);
BENCHMARK(jacobian);
BENCHMARK(gravity);

}  // namespace
}  // namespace trocar::bench
