// Every reader on files that are cut short or have a byte changed: it answers, whatever that makes of the file, and
// never takes more than the file can hold.
#include <gtest/gtest.h>

#include <functional>

#include "storage/formats/cloud.hpp"
#include "storage/formats/floor_plan.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/lines.hpp"
#include "storage/formats/route_graph.hpp"
#include "storage/formats/trajectory.hpp"
#include "tests/storage/formats/small_network.hpp"

namespace weft::formats::test {
namespace {

/// Returns whether a reader took the bytes.
using Reading = std::function<bool(ByteView)>;

void damage(const Bytes& whole, const Reading& read) {
  ASSERT_TRUE(read(whole));
  std::size_t refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) refused += read({whole.data(), size}) ? 0 : 1;
  EXPECT_GT(refused, 0U);
  Bytes changed = whole;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const std::uint8_t byte : {std::uint8_t{0}, std::uint8_t{255}, std::uint8_t{'9'}, std::uint8_t{'\n'}}) {
      changed[i] = byte;
      refused += read(changed) ? 0 : 1;
    }
    changed[i] = whole[i];
  }
  EXPECT_GT(refused, whole.size() / 2);
}

Bytes bytes_in(const std::string& text) {
  return {text.begin(), text.end()};
}

Cloud two_points() {
  Cloud cloud;
  cloud.points = {{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}};
  cloud.colours = {{1, 2, 3}, {4, 5, 6}};
  cloud.width = 2;
  return cloud;
}

TEST(Damage, Graphs) {
  const SmallNetwork small = small_network(true);
  damage(bytes_in(g2o_text(*pose_graph_of(small.network, small.frame_from_place))),
         [](ByteView bytes) { return read_g2o(text_in(bytes), "f").has_value(); });
  damage(bytes_in(route_graph_text(*route_graph_of(small.network, small.frame_from_place))),
         [](ByteView bytes) { return read_route_graph(text_in(bytes), "f").has_value(); });
}

TEST(Damage, Trajectories) {
  damage(bytes_in("1 1 2 3 0 0 0 1\n2 1 2 3 0 0 0 1\n"),
         [](ByteView bytes) { return read_tum(text_in(bytes), "f").has_value(); });
}

TEST(Damage, Clouds) {
  for (const CloudCoding coding : {CloudCoding::text, CloudCoding::binary}) {
    damage(pcd_bytes(two_points(), coding), [](ByteView bytes) { return read_pcd(bytes, "f").has_value(); });
    damage(ply_bytes(two_points(), coding), [](ByteView bytes) { return read_ply(bytes, "f").has_value(); });
  }
}

TEST(Damage, FloorPlans) {
  damage(bytes_in("P2 2 2 9\n1 2 3 4"), [](ByteView bytes) { return read_pgm(bytes, "f").has_value(); });
  damage(bytes_in("image: a\nresolution: 1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n"),
         [](ByteView bytes) { return read_map_server(text_in(bytes), "f").has_value(); });
}

}  // namespace
}  // namespace weft::formats::test
