#include "clients/cli/map_clouds.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "agents/methods/all.hpp"
#include "agents/perception/clouds/moved.hpp"
#include "agents/perception/clouds/voxel_grid.hpp"
#include "core/geometry/pose3.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::cli {
namespace {

using agents::AllMethods;
using agents::StoresClouds;

bool stores_clouds(const std::string& method) {
  bool does = false;
  AllMethods::for_each([&]<class M>() {
    if constexpr (StoresClouds<M>) does = does || method == M::name;
  });
  return does;
}

std::string methods_with_clouds() {
  std::string all;
  AllMethods::for_each([&]<class M>() {
    if constexpr (StoresClouds<M>) all += (all.empty() ? "" : ", ") + std::string(M::name);
  });
  return all;
}

}  // namespace

MapClouds::MapClouds(const Window& network, const formats::Poses& frame_from_place)
    : network_(network), frame_from_place_(frame_from_place) {
  for (const auto& [id, place] : network_.places) {
    if (stores_clouds(place.method) && frame_from_place_.contains(id)) places_of_.emplace(place.content.hash, id);
  }
}

Result<std::vector<ContentRef>> MapClouds::wanted() const {
  std::vector<ContentRef> contents;
  for (const auto& [hash, id] : places_of_) contents.push_back(network_.place(id)->content);
  if (!contents.empty()) return contents;
  return fail(ErrorCode::refused, "none of " + std::to_string(network_.places.size()) +
                                      " places has a cloud: only those that robots of method " +
                                      methods_with_clouds() + " were taught have");
}

Result<void> MapClouds::take(const ContentHash& hash, ByteView bytes) {
  constexpr std::size_t kThinFrom = 200'000;  // points
  const Result<clouds::LatticeCloud> read = clouds::decode_cloud(bytes);
  if (!read) return fail(read.error());
  const auto [first, last] = places_of_.equal_range(hash);
  for (auto of = first; of != last; ++of) {
    const PlaceId& id = of->second;
    const auto points = agents::moved(read->cloud.points, lift(frame_from_place_.at(id)));
    Laid& laid = laid_[id.experience];
    laid.points.insert(laid.points.end(), points.begin(), points.end());
    ++places_;
    if (laid.points.size() < 2 * laid.thinned_to + kThinFrom) continue;
    laid.points = agents::voxel_means(laid.points, kVoxelM);
    laid.thinned_to = laid.points.size();
  }
  return {};
}

formats::Cloud MapClouds::cloud() const {
  formats::Cloud all;
  float number = 0.0F;
  for (const auto& [experience, laid] : laid_) {
    const auto points = agents::voxel_means(laid.points, kVoxelM);
    all.points.insert(all.points.end(), points.begin(), points.end());
    all.intensities.resize(all.points.size(), number);
    number += 1.0F;
  }
  all.width = all.points.size();
  return all;
}

}  // namespace weft::cli
