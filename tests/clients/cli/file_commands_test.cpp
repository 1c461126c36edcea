#include <gtest/gtest.h>

#include <fstream>

#include "clients/cli/files.hpp"
#include "storage/formats/cloud.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

std::string written(const std::string& name, const std::string& text) {
  const std::string file = (folder() / name).string();
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

/// Runs `weft` without any server.
Said weft(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv = {"weft"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const auto parsed = parse(static_cast<int>(argv.size()), argv.data(), {});
  if (const auto* const not_run = std::get_if<NotRun>(&parsed)) {
    return {static_cast<Exit>(not_run->exit_code), {}, not_run->text};
  }
  std::ostringstream out;
  std::ostringstream err;
  const Exit exit = run_file(std::get<Invocation>(parsed), {out, err});
  return {exit, out.str(), err.str()};
}

const std::string kGraph =
    "VERTEX_SE2 0 0 0 0\nVERTEX_XY 5 1 1\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";
const std::string kCloud =
    "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n1 2 3\n4 5 6\n";

TEST(FileInfo, SaysWhatIsThereAndWhatIsNotUnderstood) {
  const std::string graph = written("a.g2o", kGraph);
  const std::string cloud = written("a.pcd", kCloud);
  const Said said = weft({"file", "info", graph, cloud});
  EXPECT_EQ(said.exit, Exit::done);
  EXPECT_NE(said.out.find("a.g2o: pose graph, vertices 2, edges 1"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("a.pcd: cloud, points 2"), std::string::npos) << said.out;
  EXPECT_EQ(said.err, "weft: not understood: " + graph + ":2: VERTEX_XY, once\n");
  const auto json = weft({"file", "info", graph, "--json"}).json();
  EXPECT_EQ(json["files"][0]["edges"], 1);
  EXPECT_EQ(json["files"][0]["not_understood"][0]["line"], 2);
}

TEST(FileInfo, WhatIsWrongIsUsageWithItsLine) {
  const Said said = weft({"file", "info", written("b.tum", "1 2 3\n")});
  EXPECT_EQ(said.exit, Exit::usage);
  EXPECT_NE(said.err.find("b.tum:1: 3 numbers"), std::string::npos);
  EXPECT_EQ(weft({"file", "info", "/nowhere/x.g2o"}).exit, Exit::usage);
  EXPECT_EQ(weft({"file", "info", written("b.foo", "")}).exit, Exit::usage);
  EXPECT_EQ(weft({"file", "info"}).exit, Exit::usage);
}

TEST(FileInfo, DamagedGzipDataIsNamedWithItsFileAndWhatToDo) {
  const std::string not_packed = written("b.g2o.gz", kGraph);
  const Said said = weft({"file", "info", not_packed});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.err.find(not_packed + ": damaged gzip data at byte "), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("copy the file again, or name it without .gz if it is not packed"), std::string::npos);
  EXPECT_TRUE(said.out.empty()) << said.out;

  const Said cut = weft({"file", "info", written("c.g2o.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10))});
  EXPECT_EQ(cut.exit, Exit::failed);
  EXPECT_NE(cut.err.find("c.g2o.gz: the gzip data ends early, after 10 bytes; copy the file again"),
            std::string::npos)
      << cut.err;
}

TEST(FileConvert, CloudsBothWays) {
  const std::string ply = (folder() / "c.ply").string();
  const std::string pcd = (folder() / "c.pcd").string();
  ASSERT_EQ(weft({"file", "convert", written("a.pcd", kCloud), "--to", ply, "--text"}).exit, Exit::done);
  EXPECT_NE(read_text(ply)->find("format ascii"), std::string::npos);
  ASSERT_EQ(weft({"file", "convert", ply, "--to", pcd}).exit, Exit::done);
  const auto cloud = formats::read_pcd(*read_file(pcd), pcd);
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->value.points, (std::vector<Eigen::Vector3f>{{1, 2, 3}, {4, 5, 6}}));
}

/// Returns a PCD of a row of 40 points 1 cm apart with intensities, and one point far from all others.
std::string row_of_points() {
  formats::Cloud cloud;
  for (int at = 0; at < 40; ++at) {
    cloud.points.emplace_back(0.005F + 0.01F * static_cast<float>(at), 0.02F, 0.02F);
    cloud.intensities.push_back(static_cast<float>(at));
  }
  cloud.points.emplace_back(5.0F, 5.0F, 5.0F);
  cloud.intensities.push_back(99.0F);
  cloud.width = cloud.points.size();
  const Bytes bytes = formats::pcd_bytes(cloud, formats::CloudCoding::binary);
  return written("row.pcd", std::string(bytes.begin(), bytes.end()));
}

TEST(FileConvert, CloudsOfOthersAreThinned) {
  const std::string pcd = (folder() / "thin.pcd").string();
  const auto converted = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> words = {"file", "convert", row_of_points(), "--to", pcd};
    words.insert(words.end(), flags.begin(), flags.end());
    EXPECT_EQ(weft(words).exit, Exit::done);
    return formats::read_pcd(*read_file(pcd), pcd)->value;
  };
  const formats::Cloud without = converted({"--alone", "0.1"});
  EXPECT_EQ(without.points.size(), 40U);
  EXPECT_EQ(without.intensities.back(), 39.0F);
  const formats::Cloud means = converted({"--voxel", "0.1"});
  EXPECT_EQ(means.points.size(), 5U);
  EXPECT_TRUE(means.intensities.empty());
  EXPECT_EQ(converted({"--voxel", "0.1", "--alone", "0.1"}).points.size(), 4U);
}

TEST(FileConvert, ThinningIsForCloudsAndWithinBounds) {
  const std::string pcd = (folder() / "thin.pcd").string();
  const Said graph = weft({"file", "convert", written("a.g2o", kGraph), "--to", "b.g2o", "--voxel", "1"});
  EXPECT_EQ(graph.exit, Exit::usage);
  EXPECT_NE(graph.err.find("thin clouds, this is none"), std::string::npos) << graph.err;
  EXPECT_EQ(weft({"file", "convert", row_of_points(), "--to", pcd, "--voxel", "0"}).exit, Exit::usage);
  const std::string wide =
      written("wide.pcd",
              "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n"
              "0 0 0\n9000 9000 9000\n");
  const Said small = weft({"file", "convert", wide, "--to", pcd, "--voxel", "0.001"});
  EXPECT_EQ(small.exit, Exit::usage);
  EXPECT_NE(small.err.find("take larger ones"), std::string::npos) << small.err;
}

TEST(FileConvert, TrajectoriesAndJoinedGraphs) {
  const std::string tum = (folder() / "t.tum").string();
  ASSERT_EQ(weft({"file", "convert", written("t.csv", "1500000000,1,2,3,1,0,0,0\n"), "--to", tum}).exit, Exit::done);
  EXPECT_EQ(*read_text(tum), "# t x y z qx qy qz qw\n1.5 1 2 3 0 0 0 1\n");
  const std::string graph = written("a.g2o", kGraph);
  const std::string more = written("b.g2o", "VERTEX_SE2 7 0 0 0\nVERTEX_SE2 8 0 0 0\n");
  const std::string all = (folder() / "all.g2o").string();
  const Said said = weft({"file", "convert", graph, more, "--to", all, "--json"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.json()["vertices"], 4);
}

TEST(FileConvert, OtherKindsAreRefused) {
  const std::string graph = written("a.g2o", kGraph);
  EXPECT_EQ(weft({"file", "convert", graph, "--to", "a.ply"}).exit, Exit::usage);
  EXPECT_EQ(weft({"file", "convert", graph, written("a.pcd", kCloud), "--to", "a.g2o"}).exit, Exit::usage);
  EXPECT_EQ(weft({"file", "convert", graph, "--to", "/nowhere/a.g2o"}).exit, Exit::failed);
}

TEST(EndingOf, LeavesGzOut) {
  EXPECT_EQ(ending_of("/a.b/C.G2O.gz"), ".g2o");
  EXPECT_EQ(ending_of("/a.b/c"), "");
}

}  // namespace
}  // namespace weft::cli::test
