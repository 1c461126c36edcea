#include "clients/cli/map_clouds.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "agents/methods/topometric/content.hpp"
#include "storage/formats/cloud.hpp"
#include "tests/clients/cli/handed_in_run.hpp"

/// Lays the clouds of a small map together, writes and draws them as operators ask.
namespace weft::cli::test {
namespace {

constexpr double kApartM = 0.5;  // from place to place
constexpr std::uint32_t kCloudPlaces = 4;

/// Returns what a place at x = `map_x_m` sees of a wall at y = 1, 1 m tall, and of the floor before it.
Bytes beside_a_wall(double map_x_m) {
  agents::TopometricContent content;
  content.rig = {320, 240, 208.0, 160.0, 120.0, 0.12, {}};
  content.cloud.place_from_frames = {Pose3{}};
  content.cloud.cameras = {Eigen::Vector3f(0.0F, 0.0F, 0.5F)};
  for (int i = 0; i < 20; ++i) {
    const auto x = static_cast<float>(0.1 * i + kApartM - map_x_m);
    for (int k = 0; k < 10; ++k) content.cloud.points.emplace_back(x, 1.0F, 0.1F * static_cast<float>(k) + 0.15F);
    content.cloud.points.emplace_back(x, 0.5F, 0.0F);
  }
  content.cloud.frames.assign(content.cloud.points.size(), 0);
  return agents::encode_topometric_content(content);
}

void teach_beside_a_wall(Fleet& fleet, const ExperienceId& experience) {
  std::vector<Bytes> contents;
  for (std::uint32_t i = 0; i < kCloudPlaces; ++i) contents.push_back(beside_a_wall(kApartM * i));
  hand_in(fleet, {.experience = experience,
                  .method = "topometric",
                  .contents = contents,
                  .apart_m = kApartM,
                  .drivable = Drivable::both,
                  .label = "gate",
                  .labelled = 0});
}

TEST(MapClouds, ALineOfPlacesShowsOneWall) {
  Window network;
  formats::Poses poses;
  const ExperienceId experience{0xC1};
  std::vector<Bytes> contents;
  for (std::uint32_t i = 0; i < kCloudPlaces; ++i) {
    contents.push_back(beside_a_wall(kApartM * i));
    Place place;
    place.id = {experience, i};
    place.method = "topometric";
    place.content = {hash_bytes(contents.back()), contents.back().size()};
    network.places.emplace(place.id, place);
    poses[place.id] = Pose2{kApartM * i, 0.0, 0.0};
  }
  MapClouds clouds(network, poses);
  ASSERT_TRUE(clouds.wanted().has_value());
  EXPECT_EQ(clouds.wanted()->size(), kCloudPlaces);
  for (const Bytes& bytes : contents) ASSERT_TRUE(clouds.take(hash_bytes(bytes), bytes).has_value());
  EXPECT_EQ(clouds.places(), kCloudPlaces);
  const formats::Cloud cloud = clouds.cloud();
  // All places show the same points: of four that lie within a quantum of one another no more than two are kept.
  EXPECT_GE(cloud.points.size(), 20U * 11U);
  EXPECT_LE(cloud.points.size(), 2U * 20U * 11U);
  for (const Eigen::Vector3f& point : cloud.points) {
    const bool is_floor = point.z() < 0.05F;
    EXPECT_NEAR(point.y(), is_floor ? 0.5F : 1.0F, 0.006F);
  }
  EXPECT_EQ(clouds.take(hash_bytes(contents[0]), Bytes{1, 2, 3}).error().code, ErrorCode::corrupt);
}

TEST(MapClouds, FromAboveWallsAreDarkAndFloorIsPale) {
  std::vector<Eigen::Vector3f> points;
  for (int k = 0; k < 8; ++k) points.emplace_back(1.0F, 0.0F, 0.2F * static_cast<float>(k));
  points.emplace_back(0.0F, 1.0F, 0.0F);
  points.emplace_back(0.0F, 0.0F, 5.0F);
  const Mosaic picture = from_above(points, 0.1);
  const auto grey = [&](std::size_t row, std::size_t column) {
    return picture.greys.at(row * picture.columns + column);
  };
  ASSERT_EQ(picture.columns, 11U);
  ASSERT_EQ(picture.rows, 11U);
  EXPECT_EQ(grey(0, 0), 235);
  EXPECT_LT(grey(10, 10), 60);
  EXPECT_GT(grey(10, 10), 0);
  EXPECT_EQ(grey(10, 0), 0) << "what hangs above a robot";
}

TEST(MapClouds, AreRefusedWhereNoPlaceHasOne) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "export", (folder() / "hall.pcd").string()});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("only those that robots of method topometric were taught have"), std::string::npos)
      << said.err;
}

TEST(MapClouds, AreWrittenAndDrawnOfTheContentsThatTheServerHas) {
  Fleet fleet;
  teach_beside_a_wall(fleet, {0xC2});
  for (const char* const name : {"hall.pcd", "hall.ply"}) {
    const std::string file = (folder() / name).string();
    const Said said = fleet.weft({"map", "export", file});
    EXPECT_EQ(said.exit, Exit::done) << said.err;
    EXPECT_NE(said.out.find("clouds of 4 of"), std::string::npos) << said.out;
    const auto facts = fleet.weft({"file", "info", file, "--json"}).json();
    EXPECT_GE(facts["files"][0]["points"], 200);
  }
  const auto drawn = fleet.weft({"map", "draw", "--clouds", (folder() / "hall.png").string(), "--json"}).json();
  EXPECT_EQ(drawn["clouds"]["places"], 4);
  EXPECT_GT(std::filesystem::file_size(folder() / "hall.png"), 1000U);
  EXPECT_EQ(fleet.weft({"map", "draw", "--clouds", (folder() / "hall.gif").string()}).exit,
            exit_of(Error{ErrorCode::invalid, {}}));
}

}  // namespace
}  // namespace weft::cli::test
