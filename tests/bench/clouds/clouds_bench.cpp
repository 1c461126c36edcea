// Recorded clouds through the store's codec, beside PCL's octree coder and Draco with the same bound, one core, in
// one run. MB/s are of raw floats, 12 bytes a point; `ratio` is raw floats to compressed bytes.
//   clouds_bench FOLDER|FILE... [--benchmark_...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "tests/bench/clouds/read_cloud.hpp"
#include "tests/bench/clouds/rivals.hpp"

namespace weft::clouds {
namespace {

constexpr double kMetres = 1e-6;

/// Describes one way to encode, and how many points come out again.
struct Codec {
  std::string name;
  std::function<std::string(const Cloud&, std::uint32_t quantum_um)> encode;
  std::function<std::size_t(const std::string&)> decode;
};

std::string weft_compressed(const Cloud& cloud, std::uint32_t quantum_um) {
  const auto canonical = canonical_bytes(cloud, quantum_um);
  if (!canonical) return {};
  const auto compressed = compress_cloud(*canonical);
  return compressed ? std::string(compressed->begin(), compressed->end()) : std::string();
}

std::size_t weft_point_count(const std::string& compressed) {
  const auto canonical = expand_cloud({reinterpret_cast<const std::uint8_t*>(compressed.data()), compressed.size()});
  if (!canonical) return 0;
  const auto decoded = decode_cloud(*canonical);
  return decoded ? decoded->cloud.points.size() : 0;
}

std::vector<Codec> codecs() {
  std::vector<Codec> all{{"weft", weft_compressed, weft_point_count}};
  for (const int voxel_steps : {10, 100}) {
    all.push_back({"pcl_octree_voxel_" + std::to_string(voxel_steps),
                   [voxel_steps](const Cloud& cloud, std::uint32_t quantum_um) {
                     return pcl_compressed(cloud, quantum_um * kMetres, voxel_steps);
                   },
                   pcl_point_count});
  }
  for (const int speed : {0, 10}) {
    all.push_back({"draco_speed_" + std::to_string(speed),
                   [speed](const Cloud& cloud, std::uint32_t quantum_um) {
                     return draco_compressed(cloud, quantum_um * kMetres, speed);
                   },
                   draco_point_count});
  }
  return all;
}

void count(benchmark::State& state, const Cloud& cloud, std::size_t compressed_size) {
  const auto raw = static_cast<double>(cloud.points.size() * sizeof(Eigen::Vector3f));
  state.counters["MB/s"] =
      benchmark::Counter(raw * 1e-6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["ratio"] = raw / static_cast<double>(compressed_size);
}

void register_benches(const Codec& codec, const std::string& file, const Cloud& cloud, std::uint32_t quantum_um) {
  const std::string what = file + "/" + std::to_string(quantum_um) + "um/" + codec.name;
  benchmark::RegisterBenchmark(("encode/" + what).c_str(), [=, &cloud](benchmark::State& state) {
    std::string compressed;
    for (auto _ : state) compressed = codec.encode(cloud, quantum_um);
    if (compressed.empty()) state.SkipWithError("not encoded");
    count(state, cloud, compressed.size());
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("decode/" + what).c_str(), [=, &cloud](benchmark::State& state) {
    const std::string compressed = codec.encode(cloud, quantum_um);
    for (auto _ : state) {
      if (codec.decode(compressed) != cloud.points.size()) state.SkipWithError("points are missing");
    }
    count(state, cloud, compressed.size());
  })->Unit(benchmark::kMillisecond);
}

std::vector<std::filesystem::path> cloud_files(const std::filesystem::path& place) {
  if (!std::filesystem::is_directory(place)) return {place};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(place)) {
    const auto kind = entry.path().extension();
    if (kind == ".vtk" || kind == ".ply" || kind == ".pcd") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  std::vector<std::pair<std::string, Cloud>> clouds;
  for (int at = 1; at < argc; ++at) {
    for (const auto& file : cloud_files(argv[at])) {
      auto cloud = read_cloud(file);
      if (!cloud) {
        std::fprintf(stderr, "clouds_bench: %s\n", cloud.error().message.c_str());
        return 1;
      }
      clouds.emplace_back(file.filename().string(), std::move(*cloud));
    }
  }
  if (clouds.empty()) {
    std::fprintf(stderr, "usage: clouds_bench FOLDER|FILE... [--benchmark_filter=...]\n");
    return 2;
  }
  for (const auto& [file, cloud] : clouds) {
    for (const std::uint32_t quantum_um : {kFineQuantum_um, 2000U}) {
      for (const Codec& codec : codecs()) register_benches(codec, file, cloud, quantum_um);
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace weft::clouds

int main(int argc, char** argv) {
  return weft::clouds::run(argc, argv);
}
