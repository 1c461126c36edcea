// How long a grid of 12 clouds, an update of 2000 particles by 60 beams, and a local plan take, each beside the same
// as it is usually written, alternately in one run. Usage: grid_bench [ROUNDS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "agents/control/grid/costmap.hpp"
#include "agents/control/grid/local_plan.hpp"
#include "agents/perception/particles/particle_filter.hpp"
#include "tests/bench/times.hpp"
#include "tests/bench/topometric/baselines.hpp"
#include "tests/bench/topometric/made_room.hpp"

namespace weft::bench {
namespace {

using namespace agents;

const Raster kChart = square_raster({0.0, 0.0}, 10.0, 0.05);

/// Collects processor times, milliseconds.
struct Milliseconds {
  std::vector<double> all;

  double at(double share) {
    std::sort(all.begin(), all.end());
    return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  }
};

void print(const char* what, Milliseconds& ours, Milliseconds& baseline) {
  std::printf("%-34s %8.3f ms (90 %%: %.3f)   baseline %8.3f ms   ratio %.3f\n", what, ours.at(0.5), ours.at(0.9),
              baseline.at(0.5), ours.at(0.5) / baseline.at(0.5));
}

std::size_t points_of(const std::vector<SeenCloud>& clouds) {
  std::size_t points = 0;
  for (const SeenCloud& cloud : clouds) points += cloud.points.size();
  return points;
}

/// Returns the grid of all clouds, by the product.
OccupancyGrid our_grid(const std::vector<SeenCloud>& clouds) {
  RayCaster caster(kChart, {});
  for (const SeenCloud& cloud : clouds) {
    const Result<void> cast = caster.cast(cloud);
    if (!cast) std::printf("%s\n", cast.error().message.c_str());
  }
  return caster.grid();
}

OccupancyGrid bench_grid(const std::vector<SeenCloud>& clouds, int rounds) {
  Milliseconds ours;
  Milliseconds baseline;
  OccupancyGrid grid;
  OccupancyGrid other;
  for (int i = 0; i < rounds; ++i) {
    ours.all.push_back(timed([&] { grid = our_grid(clouds); }).processor_ms);
    baseline.all.push_back(timed([&] { other = bresenham_grid(kChart, {}, clouds); }).processor_ms);
  }
  std::size_t known = 0;
  std::size_t same = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == CellState::unknown && other.cells[i] == CellState::unknown) continue;
    ++known;
    same += grid.cells[i] == other.cells[i] ? 1U : 0U;
  }
  print("grid 200 x 200 of 12 clouds", ours, baseline);
  std::printf("  %zu points; of %zu cells known to either %.1f %% are the same\n", points_of(clouds), known,
              100.0 * static_cast<double>(same) / static_cast<double>(known));
  return grid;
}

ParticleSet particles_about(const Pose2& pose, std::size_t count, Random& random) {
  ParticleSet particles;
  for (std::size_t i = 0; i < count; ++i) particles.add(pose, 1.0 / static_cast<double>(count));
  move(particles, {{}, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal()}, random);
  return particles;
}

/// Weighs as ParticleFilter::update() does: ends, logarithms, weights.
void our_weigh(const LikelihoodField& field, const Scan& scan, ParticleSet& particles) {
  const std::vector<BeamEnd> ends = field.ends_of(scan);
  std::vector<float> logs(particles.size(), 0.0F);
  field.weigh(ends, particles, logs);
  const float most = *std::max_element(logs.begin(), logs.end());
  const double power = field.config().worth_beams / static_cast<double>(ends.size());
  double all = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    particles.weight[i] *= std::exp(power * static_cast<double>(logs[i] - most));
    all += particles.weight[i];
  }
  for (double& weight : particles.weight) weight /= all;
}

void bench_particles(const OccupancyGrid& grid, int rounds) {
  constexpr std::size_t count = 2000;
  const DistanceMap distances = distance_to_occupied(grid, 1.0);
  DistanceMap known = distances;
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if (grid.cells[i] == CellState::unknown) known.metres[i] = -1.0F;
  const LikelihoodField field({}, kChart, known.metres);
  Random random(5);
  const Pose2 pose{-0.5, 0.1, 0.05};
  const Scan scan = crossing_scan(pose, random);
  const ParticleSet start = particles_about(pose, count, random);
  ParticleFilterConfig config;
  config.kld.least = config.kld.most = static_cast<int>(count);
  ParticleFilter filter(config, 6);
  filter.begin_at(pose, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal(), count);
  Milliseconds ours;
  Milliseconds baseline;
  Milliseconds whole;
  for (int i = 0; i < 5 * rounds; ++i) {
    ParticleSet particles = start;
    ours.all.push_back(timed([&] { our_weigh(field, scan, particles); }).processor_ms);
    particles = start;
    baseline.all.push_back(timed([&] { amcl_weigh(distances, scan, 60, 0.1, particles); }).processor_ms);
    filter.advance({{}, Eigen::Vector3d(4e-4, 4e-4, 4e-4).asDiagonal()});
    whole.all.push_back(timed([&] { filter.update(field, scan, {}); }).processor_ms);
  }
  print("weights of 2000 particles, 60 beams", ours, baseline);
  print("the same, moved, estimated, resampled", whole, baseline);
}

void bench_steering(const OccupancyGrid& grid, int rounds) {
  Random random(9);
  const LocalPlanConfig config;
  Costmap costmap({});
  Milliseconds took;
  std::size_t plans = 0;
  LocalTask task;
  task.chart_goal = {2.5, 0.2};
  task.moving = {0.3, 0.0};
  for (int i = 0; i < 5 * rounds; ++i) {
    task.chart_from_robot = {random.uniform(-2.0, -1.0), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    const Scan scan = crossing_scan(task.chart_from_robot, random);
    const SensorTime now(from_seconds(0.1 * i));
    took.all.push_back(timed([&] {
                         costmap.take(task.chart_from_robot, scan, now);
                         plans += plan_locally(config, grid, costmap.grid(now), task) ? 1U : 0U;
                       }).processor_ms);
  }
  std::printf("%-34s %8.3f ms (90 %%: %.3f, 99 %%: %.3f)   %zu of %zu with a plan\n",
              "steering: costmap, A*, 315 arcs", took.at(0.5), took.at(0.9), took.at(0.99), plans, took.all.size());
}

}  // namespace
}  // namespace weft::bench

int main(int argc, char** argv) {
  using namespace weft;
  const long rounds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 40;
  if (rounds < 3 || rounds > 10'000) {
    std::fprintf(stderr, "grid_bench: %s: rounds are from 3 to 10000\n", argv[1]);
    return 2;
  }
  Random random(1);
  const std::vector<agents::SeenCloud> clouds = bench::crossing_clouds(12, 20'000, random);
  const agents::OccupancyGrid grid = bench::bench_grid(clouds, static_cast<int>(rounds));
  bench::bench_particles(grid, static_cast<int>(rounds));
  bench::bench_steering(grid, static_cast<int>(rounds));
}
