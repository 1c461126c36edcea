#include <optional>
#include <utility>

#include "clients/cli/draw_mosaic.hpp"
#include "clients/cli/map_draw.hpp"
#include "clients/cli/mosaic.hpp"
#include "clients/cli/place_patches.hpp"
#include "clients/cli/table.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {
namespace {

/// Fetches the patches of all places that have one. refused: none has.
Result<void> fetch_patches(Session& session, PlacePatches& patches, const Invocation& invocation) {
  const Result<std::vector<ContentRef>> wanted = patches.wanted();
  if (!wanted) return fail(wanted.error());
  ContentFetcher fetcher(*wanted,
                         [&](const ContentHash& hash, const Bytes& bytes) { return patches.take(hash, bytes); });
  if (Result<void> fetched = session.fetch(fetcher, patience(invocation)); !fetched) return fetched;
  if (patches.count() > 0) return {};
  return fail(ErrorCode::refused, "the patches of all " + std::to_string(wanted->size()) +
                                      " places are empty: their cameras saw nothing of the plane");
}

std::vector<LaidPatch> laid_patches(const PlacePatches& patches, const Laid& laid) {
  std::vector<LaidPatch> all;
  for (const auto& [id, place] : laid.network.places) {
    const agents::PlanePatch* const patch = patches.find(place);
    const auto pose = laid.layout.drawing_from_place.find(id);
    if (patch != nullptr && pose != laid.layout.drawing_from_place.end()) all.push_back({pose->second, *patch});
  }
  return all;
}

/// Says how many patches it is of, and how fine it is.
std::string detail_of_mosaic(const Laid& laid, std::size_t patches, const Mosaic& mosaic) {
  constexpr double kCentimetres = 100.0;
  std::string detail = std::to_string(patches) + " of " + std::to_string(laid.network.places.size()) +
                       " places have a patch, " + fixed(kCentimetres * mosaic.metres_per_pixel, 1) + " cm a pixel";
  if (laid.layout.islands > 1) detail += ", " + std::to_string(laid.layout.islands) + " parts that nothing joins";
  return detail;
}

}  // namespace

Exit run_map_mosaic(Session& session, const Laid& laid, const Invocation& invocation, const Output& output) {
  if (const Result<void> good = drawing::check_picture_name(invocation.file); !good)
    return report(good.error(), invocation.json, output);
  PlacePatches patches(laid.network);
  if (const Result<void> fetched = fetch_patches(session, patches, invocation); !fetched)
    return report(fetched.error(), invocation.json, output);
  const Mosaic mosaic = lay_mosaic(laid_patches(patches, laid));
  const std::string detail = detail_of_mosaic(laid, patches.count(), mosaic);
  const std::string below_title = laid.caption.empty() ? detail : detail + ", " + laid.caption;
  const Result<void> drawn =
      draw_mosaic(mosaic, laid.network, laid.layout, "Weft mosaic", below_title, invocation.file);
  if (!drawn) return report(drawn.error(), invocation.json, output);
  const nlohmann::json more = {{"patches", patches.count()}, {"metres_per_pixel", mosaic.metres_per_pixel}};
  say_written(laid.network, laid.caption, {{"mosaic", more}}, invocation, output);
  if (!invocation.json) output.out << detail << '\n';
  return Exit::done;
}

}  // namespace weft::cli
