#include "clients/cli/draw_mosaic.hpp"
#include "clients/cli/files.hpp"
#include "clients/cli/map_clouds.hpp"
#include "clients/cli/map_draw.hpp"
#include "clients/cli/table.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {
namespace {

/// Fetches the clouds of all places that have one, and returns them laid together.
Result<formats::Cloud> fetch_clouds(Session& session, MapClouds& clouds, const Invocation& invocation) {
  const Result<std::vector<ContentRef>> wanted = clouds.wanted();
  if (!wanted) return fail(wanted.error());
  ContentFetcher fetcher(*wanted,
                         [&](const ContentHash& hash, const Bytes& bytes) { return clouds.take(hash, bytes); });
  if (const Result<void> fetched = session.fetch(fetcher, patience(invocation)); !fetched)
    return fail(fetched.error());
  formats::Cloud cloud = clouds.cloud();
  if (!cloud.points.empty()) return cloud;
  return fail(ErrorCode::refused,
              "the clouds of all " + std::to_string(clouds.places()) + " places are empty: nothing was seen there");
}

Result<void> write_clouds(const formats::Cloud& cloud, const Laid& laid, const std::string& detail,
                          const Invocation& invocation) {
  const std::string& file = invocation.file;
  if (invocation.draws_clouds)
    return draw_mosaic(from_above(cloud.points, MapClouds::kVoxelM), laid.network, laid.layout, "Weft clouds", detail,
                       file);
  const auto coding = formats::CloudCoding::binary;
  return write_file(ending_of(file) == ".ply" ? formats::ply_bytes(cloud, coding) : formats::pcd_bytes(cloud, coding),
                    file);
}

}  // namespace

Exit run_map_clouds(Session& session, const Laid& laid, const Invocation& invocation, const Output& output) {
  if (invocation.draws_clouds) {
    if (const Result<void> good = drawing::check_picture_name(invocation.file); !good)
      return report(good.error(), invocation.json, output);
  }
  MapClouds clouds(laid.network, laid.layout.drawing_from_place);
  const Result<formats::Cloud> cloud = fetch_clouds(session, clouds, invocation);
  if (!cloud) return report(cloud.error(), invocation.json, output);
  const std::string detail = "clouds of " + std::to_string(clouds.places()) + " of " +
                             std::to_string(laid.network.places.size()) + " places, " +
                             std::to_string(cloud->points.size()) + " points" +
                             (laid.caption.empty() ? "" : ", " + laid.caption);
  if (const Result<void> written = write_clouds(*cloud, laid, detail, invocation); !written)
    return report(written.error(), invocation.json, output);
  const nlohmann::json more = {{"places", clouds.places()}, {"points", cloud->points.size()}};
  say_written(laid.network, laid.caption, {{"clouds", more}}, invocation, output);
  if (!invocation.json) output.out << detail << '\n';
  return Exit::done;
}

}  // namespace weft::cli
