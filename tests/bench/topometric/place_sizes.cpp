#include "tests/bench/topometric/place_sizes.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include "storage/clouds/cloud.hpp"

namespace weft::bench {
namespace {

template <class T>
std::size_t bytes_of(const std::vector<T>& all) {
  return all.capacity() * sizeof(T);
}

std::size_t decoded_bytes(const agents::TopometricContent& content) {
  const agents::PlaceCloud& cloud = content.cloud;
  return sizeof(content) + bytes_of(cloud.points) + bytes_of(cloud.frames) + bytes_of(cloud.place_from_frames) +
         bytes_of(cloud.cameras) + bytes_of(cloud.clear_bearings) + bytes_of(content.features);
}

struct Sizes {
  std::vector<double> all;
  void print(const char* what, double unit = 1e3, const char* name = "kB") {
    std::sort(all.begin(), all.end());
    const auto at = [&](double share) {
      return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))] / unit;
    };
    std::printf("  %-28s %8.1f (90 %%: %.1f, most: %.1f) %s\n", what, at(0.5), at(0.9), at(1.0), name);
  }
};

/// Collects what places of one site have.
struct OfSite {
  Sizes points, features, canonical, kept, decoded;
  void add(const RunPlace& place) {
    points.all.push_back(static_cast<double>(place.content.cloud.points.size()));
    features.all.push_back(static_cast<double>(place.content.features.size()));
    canonical.all.push_back(static_cast<double>(place.bytes.size()));
    const Result<Bytes> compressed = clouds::compress_cloud(place.bytes);
    kept.all.push_back(compressed ? static_cast<double>(compressed->size()) : 0.0);
    decoded.all.push_back(static_cast<double>(decoded_bytes(place.content)));
  }
  void print() {
    points.print("points", 1.0, "");
    features.print("features", 1.0, "");
    canonical.print("canonical, sent up");
    kept.print("kept, sent down");
    decoded.print("decoded");
  }
};

}  // namespace

void print_place_sizes(const std::vector<RunPlace>& places) {
  std::map<std::string, OfSite> sites;
  OfSite all;
  for (const RunPlace& place : places) {
    sites[place.site].add(place);
    all.add(place);
  }
  if (places.empty()) return;
  for (auto& [site, sizes] : sites) {
    std::printf("%s, %zu places, medians\n", site.c_str(), sizes.points.all.size());
    sizes.print();
  }
  std::printf("all, %zu places, medians\n", places.size());
  all.print();
}

}  // namespace weft::bench
