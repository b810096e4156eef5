// How long a volume takes to build, by the number of triangles; and the search that compares every
// face with every other, as the lecture does, for comparison.

#include "volume.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

// A torus knot with about so many triangles; its texture seams are welded like any other mesh's.
gg::MeshData knot(std::int64_t triangles) {
  const int around = std::max(3, static_cast<int>(std::sqrt(static_cast<double>(triangles) / 20)));
  return gg::torusKnot(static_cast<int>(triangles / (2 * around)), around);
}

void closing(benchmark::State& state) {
  const gg::MeshData mesh = knot(state.range(0));
  for (auto _ : state) {
    gg::MeshData copy = mesh;
    std::vector<std::string> warnings;
    benchmark::DoNotOptimize(closedMesh(copy, warnings));
  }
  state.SetComplexityN(state.range(0));
}

void wholeVolume(benchmark::State& state) {
  const gg::MeshData mesh = knot(state.range(0));
  for (auto _ : state) {
    gg::MeshData copy = mesh;
    std::vector<std::string> warnings;
    for (const ClosedMesh& part : countableParts(closedMesh(copy, warnings)))
      benchmark::DoNotOptimize(shadowVolume(part));
  }
  state.SetComplexityN(state.range(0));
}

void silhouette(benchmark::State& state) {
  gg::MeshData mesh = knot(state.range(0));
  std::vector<std::string> warnings;
  const ClosedMesh closed = closedMesh(mesh, warnings);
  for (auto _ : state) benchmark::DoNotOptimize(silhouetteVolume(closed, {1, 5, 2}));
  state.SetComplexityN(state.range(0));
}

// Pairs of faces with two corners each within the lecture's radius of each other.
void allPairs(benchmark::State& state) {
  const gg::MeshData mesh = knot(state.range(0));
  const auto corner = [&](std::size_t face, std::size_t k) {
    return mesh.positions[mesh.indices[3 * face + k]];
  };
  const std::size_t faces = mesh.indices.size() / 3;
  for (auto _ : state) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < faces; ++i)
      for (std::size_t j = i + 1; j < faces; ++j) {
        int near = 0;
        for (std::size_t k = 0; k < 9; ++k) {
          const glm::vec3 between = corner(i, k / 3) - corner(j, k % 3);
          near += glm::dot(between, between) < 0.001f;
        }
        shared += near == 2;
      }
    benchmark::DoNotOptimize(shared);
  }
  state.SetComplexityN(state.range(0));
}

constexpr auto kUnit = benchmark::kMillisecond;
BENCHMARK(closing)->RangeMultiplier(10)->Range(1000, 1000000)->Complexity()->Unit(kUnit);
BENCHMARK(wholeVolume)->RangeMultiplier(10)->Range(1000, 1000000)->Complexity()->Unit(kUnit);
BENCHMARK(silhouette)->RangeMultiplier(10)->Range(1000, 1000000)->Complexity()->Unit(kUnit);
// The search takes about a minute for the most that is tried; closing() to compare with.
BENCHMARK(closing)->Arg(8000)->Arg(59000)->Unit(kUnit);
BENCHMARK(allPairs)->Arg(1000)->Arg(2000)->Arg(8000)->Arg(59000)->Complexity()->Unit(kUnit);

} // namespace

BENCHMARK_MAIN();
