#include "clients/cli/place_patches.hpp"

#include <algorithm>
#include <utility>

#include "agents/methods/all.hpp"

namespace weft::cli {
namespace {

using agents::AllMethods;
using agents::PicturesPlane;
using agents::PlanePatch;

bool has_patches(const std::string& method) {
  bool has = false;
  AllMethods::for_each([&]<class M>() {
    if constexpr (PicturesPlane<M>) has = has || method == M::name;
  });
  return has;
}

std::string methods_with_patches() {
  std::string all;
  AllMethods::for_each([&]<class M>() {
    if constexpr (PicturesPlane<M>) all += (all.empty() ? "" : ", ") + std::string(M::name);
  });
  return all;
}

Result<PlanePatch> patch_of(const std::string& method, ByteView bytes) {
  Result<PlanePatch> patch = fail(ErrorCode::invalid, "contents of " + method + " have no patch");
  AllMethods::for_each([&]<class M>() {
    if constexpr (PicturesPlane<M>) {
      if (method == M::name) patch = M::patch_of_bytes(bytes);
    }
  });
  return patch;
}

}  // namespace

PlacePatches::PlacePatches(const Window& network) : network_(network) {
  for (const auto& [id, place] : network.places) {
    if (has_patches(place.method)) method_of_.emplace(place.content.hash, place.method);
  }
}

Result<std::vector<ContentRef>> PlacePatches::wanted() const {
  std::vector<ContentRef> contents;
  for (const auto& [id, place] : network_.places) {
    if (method_of_.contains(place.content.hash)) contents.push_back(place.content);
  }
  if (!contents.empty()) return contents;
  return fail(ErrorCode::refused, "none of " + std::to_string(network_.places.size()) +
                                      " places has a patch to lay: only those that robots of method " +
                                      methods_with_patches() + " were taught have; weft map draw draws the others");
}

Result<void> PlacePatches::take(const ContentHash& hash, ByteView bytes) {
  const auto method = method_of_.find(hash);
  if (method == method_of_.end()) return {};
  Result<PlanePatch> patch = patch_of(method->second, bytes);
  if (!patch) return fail(patch.error());
  if (patch->width > 1 && patch->height > 1) patches_.insert_or_assign(hash, *std::move(patch));
  return {};
}

const PlanePatch* PlacePatches::find(const Place& place) const {
  const auto found = patches_.find(place.content.hash);
  return found == patches_.end() ? nullptr : &found->second;
}

std::size_t PlacePatches::count() const {
  return static_cast<std::size_t>(
      std::count_if(network_.places.begin(), network_.places.end(),
                    [this](const auto& of) { return patches_.contains(of.second.content.hash); }));
}

}  // namespace weft::cli
