#include "clients/evaluate/topometric/scenes.hpp"

#include <array>
#include <utility>

#include "clients/evaluate/files.hpp"
#include "core/random.hpp"

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Blackout;
using agents::sim::Site;

constexpr std::uint64_t kBlackoutsOfSeed = 71;

/// Widens the pair's images: as many degrees are seen, by more pixels.
void widen(Site& site, int width_px) {
  agents::sim::StereoCameraSetup& pair = site.stereo_camera;
  const double times = static_cast<double>(width_px) / pair.width;
  pair.width = width_px;
  pair.height = static_cast<int>(pair.height * times);
  pair.focal_px *= times;
}

}  // namespace

Result<Scenes> read_scenes(const std::filesystem::path& folder, const Extent& extent) {
  std::string texts;
  Result<Scene> level11 = read_scene(folder, "level11", "level11", texts);
  if (!level11) return fail(level11.error());
  Result<Scene> hall = read_scene(folder, "hall", "hall", texts);
  if (!hall) return fail(hall.error());
  Result<Scene> aisles = read_scene(folder, "aisles", "aisles-r1", texts);
  if (!aisles) return fail(aisles.error());
  Result<Scene> others = read_scene(folder, "aisles", "aisles-r2", texts);
  if (!others) return fail(others.error());
  for (Scene* const scene : {&*level11, &*hall, &*aisles}) {
    if (const Result<void> good = check_robots(folder, scene->site, {"r1", "r2"}); !good) return fail(good.error());
    widen(scene->site, extent.width_px);
  }
  return Scenes{std::move(*level11), std::move(*hall), std::move(*aisles), std::move(others->line), sha256_of(texts)};
}

Rider rider_of(const Site& site, const std::string& robot, const Driven& driven, std::uint64_t day) {
  return {site, robot, driven.seed, day, driven.scratch, driven.asked_to_stop, {}};
}

std::vector<Blackout> blackouts(std::size_t count, double from_s, double to_s, std::uint64_t seed) {
  constexpr std::array kinds = {Blackout::Kind::dark, Blackout::Kind::covered, Blackout::Kind::left_covered,
                                Blackout::Kind::frozen};
  constexpr double shortest_s = 1.0;
  constexpr double longest_s = 2.0;
  Random random = Random(seed).fork(kBlackoutsOfSeed);
  const double apart_s = (to_s - from_s) / static_cast<double>(count);
  std::vector<Blackout> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double begins_s = from_s + apart_s * (static_cast<double>(i) + random.uniform(0.2, 0.8));
    Blackout blackout;
    blackout.kind = kinds[i % kinds.size()];
    blackout.from_s = begins_s;
    blackout.to_s = begins_s + random.uniform(shortest_s, longest_s);
    all.push_back(blackout);
  }
  return all;
}

}  // namespace weft::evaluate::topometric
