#include "storage/formats/cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "storage/formats/lzf.hpp"
#include "tests/storage/formats/bytes_of.hpp"

namespace weft::formats {
namespace {

Cloud full() {
  Cloud cloud;
  cloud.points = {{1.0F, 2.0F, 0.1F}, {-3.5F, 0.0F, 1e-20F}};
  cloud.intensities = {0.5F, 7.0F};
  cloud.colours = {{255, 254, 1}, {127, 128, 0}};  // as a float's bits the first would be a NaN
  cloud.normals = {{0.0F, 0.0F, 1.0F}, {0.6F, 0.8F, 0.0F}};
  cloud.width = 2;
  cloud.world_from_sensor = {Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0), {1.0, 2.0, 3.0}};
  return cloud;
}

void expect_same(const Cloud& first, const Cloud& second) {
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.intensities, second.intensities);
  EXPECT_EQ(first.colours, second.colours);
  EXPECT_EQ(first.normals, second.normals);
  EXPECT_EQ(first.width, second.width);
  EXPECT_EQ(first.height, second.height);
}

TEST(Clouds, ReadBackWhatWasWritten) {
  for (const CloudCoding coding : {CloudCoding::text, CloudCoding::binary}) {
    const auto pcd = read_pcd(pcd_bytes(full(), coding), "a.pcd");
    ASSERT_TRUE(pcd.has_value()) << pcd.error().message;
    expect_same(pcd->value, full());
    EXPECT_EQ(pcd->value.world_from_sensor.translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(pcd->value.world_from_sensor.rotation.x(), 1.0);
    const auto ply = read_ply(ply_bytes(full(), coding), "a.ply");
    ASSERT_TRUE(ply.has_value()) << ply.error().message;
    expect_same(ply->value, full());
  }
}

TEST(Clouds, EmptyOnesAreCloudsToo) {
  EXPECT_TRUE(read_pcd(pcd_bytes(Cloud{}, CloudCoding::binary), "a.pcd").has_value());
  EXPECT_TRUE(read_ply(ply_bytes(Cloud{}, CloudCoding::text), "a.ply").has_value());
}

TEST(Lzf, LiteralsCopiesAndLongCopies) {
  // "abc", then 3 bytes from 3 back, then 9 + 3 bytes from 1 back: an overlapping run.
  const Bytes packed = {2, 'a', 'b', 'c', 0x20, 2, 0xe0, 3, 0};
  const auto plain = lzf_decompress(packed, 18);
  ASSERT_TRUE(plain.has_value()) << plain.error().message;
  EXPECT_EQ(std::string(plain->begin(), plain->end()), "abcabccccccccccccc");
}

TEST(Lzf, DamageIsSaidWithItsByte) {
  const std::vector<std::pair<Bytes, std::string>> table = {
      {{2, 'a'}, "compressed data at byte 1: it ends within literal bytes"},
      {{0, 'a', 0x20}, "compressed data at byte 3: it ends within a copy"},
      {{0, 'a', 0xe0, 1}, "compressed data at byte 3: it ends within a copy"},
      {{0, 'a', 0x20, 1}, "compressed data at byte 4: a copy begins before the data"},
      {{0, 'a'}, "compressed data at byte 2: 1 bytes come out, 4 were stated"},
      {{4, 'a', 'b', 'c', 'd', 'e'}, "compressed data at byte 1: more comes out than was stated"}};
  for (const auto& [packed, message] : table) {
    const auto plain = lzf_decompress(packed, 4);
    ASSERT_FALSE(plain.has_value()) << message;
    EXPECT_EQ(plain.error().message, message);
  }
}

const std::string kPcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\n";

TEST(Pcd, DoublesNansAndColoursAsFloatsAreRead) {
  const auto cloud = read_pcd(bytes_of("FIELDS x y z rgb ring\nSIZE 8 8 8 4 2\nTYPE F F F F U\nCOUNT 1 1 1 1 1\n"
                                       "WIDTH 1\nHEIGHT 2\nDATA ascii\n1 2 3 2.3418052e-38 4\nnan nan nan 0 5\n"),
                              "a.pcd");
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->value.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_TRUE(std::isnan(cloud->value.points[1].x()));
  EXPECT_EQ(cloud->value.colours[0], (std::array<std::uint8_t, 3>{255, 0, 0}));  // 0x00ff0000
  EXPECT_EQ(cloud->value.height, 2U);
  EXPECT_EQ(cloud->not_understood, (std::vector<NotUnderstood>{{"field ring", 1, 1}}));
}

TEST(Pcd, CompressedPointsStandFieldByField) {
  const std::string text = kPcd + "POINTS 1\nDATA binary_compressed\n";
  Bytes bytes = bytes_of(text);
  const Bytes data = {13, 0, 0, 0, 12, 0, 0, 0, 11, 0, 0, 0x80, 0x3f, 0, 0, 0, 0x40, 0, 0, 0x40, 0x40};
  bytes.insert(bytes.end(), data.begin(), data.end());
  const auto cloud = read_pcd(bytes, "a.pcd");
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->value.points[0], Eigen::Vector3f(1, 2, 3));
}

TEST(Pcd, WhatIsWrongIsSaid) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"ply\n", "a.pcd:1: the header has no DATA line; is this a PCD file?"},
      {kPcd + "DATA zipped\n", "a.pcd:7: DATA must be ascii, binary or binary_compressed"},
      {"VERSION 0.8\n", "a.pcd:1: version 0.8 is not read, 0.5 to 0.7 are"},
      {"FIELDS x y z\nSIZE 4 4\n", "a.pcd:2: SIZE must have a number for each of FIELDS, which stands before it"},
      {"FIELDS x y z\nFIELDS x\n", "a.pcd:2: 'FIELDS' stands there a second time"},
      {"FIELDS x y z\nSIZE 4 4 0\n", "a.pcd:2: '0' is no number in [1, 65536]"},
      {kPcd + "POINTS 2\nDATA ascii\n", "a.pcd:8: WIDTH 1 times HEIGHT 1 is not POINTS 2"},
      {kPcd + "DATA ascii\n1 2\n1 2 3\n", "a.pcd:8: a point has 2 numbers, it needs 3"},
      {kPcd + "DATA ascii\n1 2 x\n", "a.pcd:8: 'x' cannot be z"},
      {kPcd + "DATA ascii\n1 2 inf\n", "a.pcd:8: 'inf' cannot be z"},
      {kPcd + "DATA ascii\n# nothing\n", "a.pcd:8: the file ends after 0 of 1 points"},
      {"FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n1 2\n", "a.pcd:1: a cloud needs the fields x, y and z"},
      {"FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nWIDTH 0\nDATA ascii\n",
       "a.pcd:1: field z has type F of 3 bytes, which is no number"},
      {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 3\nWIDTH 0\nDATA ascii\n",
       "a.pcd:1: a cloud needs the fields x, y and z"},
      {"VERSION 0.7\nFIELDS x y z\nWIDTH 0\nDATA ascii\n",
       "a.pcd:4: the header has no SIZE, which version 0.7 needs"},
      {"VERSION .5\nCOLUMNS x y z\nDATA ascii\n", "a.pcd:3: the header has neither WIDTH nor POINTS"},
      {"FIELDS x y z\nCOLUMNS x y z\n", "a.pcd:2: 'COLUMNS' stands there a second time"},
      {"VERSION .5\nCOLUMNS x y z\nHEIGHT 2\nPOINTS 3\nDATA ascii\n",
       "a.pcd:5: WIDTH 1 times HEIGHT 2 is not POINTS 3"},
      {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 4000000000\nDATA binary\n",
       "a.pcd: the header states 4000000000 points, the 0 bytes after it cannot hold them"},
      {kPcd + "DATA binary_compressed\nabc", "a.pcd: the compressed points end within their sizes"}};
  for (const auto& [text, message] : table) {
    const auto cloud = read_pcd(bytes_of(text), "a.pcd");
    ASSERT_FALSE(cloud.has_value()) << message;
    EXPECT_EQ(cloud.error().message, message);
  }
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty double y\nproperty float z\n";

TEST(Ply, BigEndianIsRead) {
  Bytes bytes = bytes_of(
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "property short intensity\nend_header\n");
  const Bytes data = {0x3f, 0x80, 0, 0, 0x40, 0, 0, 0, 0x40, 0x40, 0, 0, 0xff, 0xfe};
  bytes.insert(bytes.end(), data.begin(), data.end());
  const auto cloud = read_ply(bytes, "a.ply");
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->value.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(cloud->value.intensities[0], -2.0F);
}

TEST(Ply, OtherPropertiesAndFacesAreListed) {
  const auto cloud = read_ply(bytes_of(kPly + "property uchar alpha\nelement face 1\nproperty list uchar int "
                                              "vertex_indices\nend_header\n1 2 3 255\n3 0 0 0\n"),
                              "a.ply");
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->not_understood, (std::vector<NotUnderstood>{{"element face of 1", 8, 1}, {"field alpha", 7, 1}}));
}

TEST(Ply, WhatIsWrongIsSaid) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"plx\n", "a.ply:1: the file does not begin with the line 'ply'"},
      {"ply\nformat ascii 2.0\n",
       "a.ply:2: the format must be ascii, binary_little_endian or binary_big_endian, version 1.0"},
      {"ply\nelement vertex -1\n", "a.ply:2: an element has a name and a count up to 2^32"},
      {"ply\nelement face 2\n", "a.ply:2: element 'face' stands before vertex; files with vertex first are read"},
      {"ply\nelement vertex 0\nproperty list uchar int l\n", "a.ply:3: a vertex with a list is not read"},
      {"ply\nelement vertex 0\nproperty real x\n", "a.ply:3: a property has a type, such as float, and a name"},
      {"ply\nend_header\n", "a.ply:2: the header has no format"},
      {"ply\nformat ascii 1.0\n", "a.ply:2: the header has no end_header"},
      {kPly + "end_header\n1 2\n1 2 3\n", "a.ply:8: a point has 2 numbers, it needs 3"},
      {kPly + "end_header\n1 2 -inf\n", "a.ply:8: '-inf' cannot be z"},
      {kPly + "end_header\n     \n", "a.ply:8: the file ends after 0 of 1 points"},
      {kPly + "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n1 2 3 4 5 256\n",
       "a.ply:11: '256' cannot be blue"},
      {"ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\n"
       "property float z\nend_header\nabc",
       "a.ply: the header states 9 points, the 3 bytes after it cannot hold them"}};
  for (const auto& [text, message] : table) {
    const auto cloud = read_ply(bytes_of(text), "a.ply");
    ASSERT_FALSE(cloud.has_value()) << message;
    EXPECT_EQ(cloud.error().message, message);
  }
}

}  // namespace
}  // namespace weft::formats
