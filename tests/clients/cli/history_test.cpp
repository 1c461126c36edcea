#include <gtest/gtest.h>

#include <filesystem>

#include "clients/cli/difference.hpp"
#include "clients/cli/draw_difference.hpp"
#include "clients/cli/exit.hpp"
#include "tests/clients/cli/fleet.hpp"

/// Tests the map's past, as an operator asks for it.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

TEST(MapLog, NamesEachRevisionNewestFirstWithWhoAskedForIt) {
  Fleet fleet;
  const auto before = fleet.weft({"map", "log", "--json"}).json()["revisions"];
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(before[0]["kind"], "label") << "batches and labels of one transaction are one revision";
  EXPECT_EQ(fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "gate"}).exit, Exit::done);
  const auto log = fleet.weft({"map", "log", "--json"}).json()["revisions"];
  ASSERT_EQ(log.size(), before.size() + 1);
  EXPECT_EQ(log[0]["who"], "tester");
  EXPECT_EQ(log[0]["kind"], "label");
  EXPECT_EQ(log[0]["cause"], "gate is " + to_string(PlaceId{fleet.first, 3}));
  EXPECT_TRUE(log[0].contains("at"));
  EXPECT_EQ(fleet.weft({"map", "log", "--most", "1", "--json"}).json()["revisions"].size(), 1U);
  EXPECT_NE(fleet.weft({"map", "log"}).out.find("gate is"), std::string::npos);
}

TEST(MapDiff, SaysWhatCameAndWhatWent) {
  Fleet fleet;
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  EXPECT_EQ(fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "gate"}).exit, Exit::done);
  const auto found = fleet.weft({"map", "diff", std::to_string(before), "--json"}).json();
  EXPECT_EQ(found["labels"]["came"], nlohmann::json::array({"gate"}));
  EXPECT_TRUE(found["places"]["came"].empty());
  const Said same = fleet.weft({"map", "diff", std::to_string(before), std::to_string(before)});
  EXPECT_NE(same.out.find("the same map"), std::string::npos) << same.err;
}

TEST(MapDiff, ARevisionThatIsNotThereIsRefusedNamingTheNewest) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "diff", "900", "901"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("no revision 901; its newest is"), std::string::npos) << said.err;
  EXPECT_EQ(fleet.weft({"map", "diff", "0", "1"}).exit, Exit::usage);
}

TEST(MapExport, CanBeOfThePast) {
  Fleet fleet;
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  EXPECT_EQ(fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "gate"}).exit, Exit::done);
  const std::string file = (folder() / "past.json").string();
  const Said said = fleet.weft({"map", "export", file, "--at", std::to_string(before)});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(said.out.find("revision " + std::to_string(before)), std::string::npos) << said.out;
}

Window at(const std::vector<Batch>& batches, std::size_t count) {
  Snapshot snapshot;
  for (std::size_t i = 0; i < count; ++i) snapshot = with(snapshot, batches[i]);
  return make_window(snapshot, WindowDefinition{});
}

TEST(Compare, FindsPlacesStitchesAndLabels) {
  const std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  Window from = at(batches, batches.size() - 1);
  const Window to = at(batches, batches.size());
  from.labels["dock"] = from.places.begin()->first;
  const NetworkDifference found = compare(from, to);
  EXPECT_EQ(found.places_added.size(), batches.back().places.size());
  EXPECT_TRUE(found.places_removed.empty());
  EXPECT_FALSE(found.stitches_added.empty());
  EXPECT_EQ(found.labels_removed, std::vector<std::string>{"dock"});
  const NetworkDifference back = compare(to, from);
  EXPECT_EQ(back.places_removed, found.places_added);
  EXPECT_EQ(back.stitches_removed, found.stitches_added);
  EXPECT_EQ(united(from, to).places.size(), to.places.size());
}

TEST(Compare, FindsPlacesThatAreKnownAnew) {
  const std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  const Window from = at(batches, batches.size());
  EXPECT_TRUE(compare(from, from).empty());
  Window to = from;
  Place anew = from.places.begin()->second;
  ++anew.entity_version;
  anew.content.hash.bytes[0] ^= 1U;
  to.places.insert_or_assign(anew.id, anew);
  const NetworkDifference found = compare(from, to);
  EXPECT_EQ(found.places_anew, std::vector{anew.id});
  EXPECT_FALSE(found.empty());
  EXPECT_TRUE(found.places_added.empty());
}

TEST(DrawDifference, MakesAPicture) {
  const std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  Window from = at(batches, batches.size() - 1);
  const Window to = at(batches, batches.size());
  from.labels["dock"] = from.places.begin()->first;
  Place older = from.places.begin()->second;
  older.content.hash.bytes[0] ^= 1U;
  from.places.insert_or_assign(older.id, older);
  const std::filesystem::path file = folder() / "difference.png";
  const Result<void> drawn = draw_difference(from, to, "", file.string());
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_GT(std::filesystem::file_size(file), 5000U);
  EXPECT_EQ(draw_difference(from, to, "", (folder() / "difference.txt").string()).error().code, ErrorCode::invalid);
}

}  // namespace
}  // namespace weft::cli::test
