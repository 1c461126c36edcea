// What other programs write into clouds: the geometry is taken, whatever else is in the file.
#include <gtest/gtest.h>

#include "storage/formats/cloud.hpp"
#include "tests/storage/formats/bytes_of.hpp"

namespace weft::formats {
namespace {

using Colours = std::vector<std::array<std::uint8_t, 3>>;
using Listed = std::vector<NotUnderstood>;

Read<Cloud> pcd(const std::string& text) {
  auto read = read_pcd(bytes_of(text), "a.pcd");
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? *read : Read<Cloud>{};
}

/// Reads a PCD of one point, text, whose fields other than x y z are given by name, size and type.
Read<Cloud> pcd_with(const std::string& names, const std::string& sizes, const std::string& types,
                     const std::string& values) {
  return pcd("VERSION 0.7\nFIELDS x y z" + names + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types +
             "\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3" + values + "\n");
}

Read<Cloud> ply_with(const std::string& properties, const std::string& row) {
  auto read = read_ply(bytes_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                                "property float z\n" +
                                properties + "end_header\n" + row + "\n"),
                       "a.ply");
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? *read : Read<Cloud>{};
}

std::string three_of(const std::string& type) {
  return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
}

TEST(CloudVariants, WholeNumbersAreCoordinates) {
  for (const std::string type : {"I", "U"}) {
    for (const std::string size : {"1", "2", "4", "8"}) {
      const auto read = pcd("VERSION 0.7\nFIELDS x y z\nSIZE " + size + " " + size + " " + size + "\nTYPE " + type +
                            " " + type + " " + type + "\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n");
      ASSERT_EQ(read.value.points.size(), 2U) << type << size;
      EXPECT_EQ(read.value.points[1], Eigen::Vector3f(4, 5, 6));
      EXPECT_TRUE(read.not_understood.empty());
    }
  }
  const auto ply = read_ply(bytes_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty short y\n"
                                     "property uchar z\nend_header\n-1 2 3\n"),
                            "a.ply");
  ASSERT_TRUE(ply.has_value()) << ply.error().message;
  EXPECT_EQ(ply->value.points[0], Eigen::Vector3f(-1, 2, 3));
  EXPECT_EQ(ply_with("property int64 intensity\n", "1 2 3 -4").value.intensities, (std::vector<float>{-4.0F}));
}

TEST(CloudVariants, ColoursOfTwoBytesAreScaled) {
  const auto read = ply_with(three_of("ushort"), "1 2 3 65535 0 32768");
  EXPECT_EQ(read.value.colours, (Colours{{255, 0, 128}}));
  EXPECT_TRUE(read.not_understood.empty());
}

TEST(CloudVariants, ColoursOfAnUnknownScaleAreListed) {
  for (const std::string type : {"char", "short", "int", "uint", "float", "double"}) {
    const auto read = ply_with(three_of(type), "1 2 3 1 0 -0.5");
    ASSERT_EQ(read.value.points.size(), 1U) << type;
    EXPECT_TRUE(read.value.colours.empty());
    ASSERT_EQ(read.not_understood.size(), 3U) << type;
    EXPECT_EQ(read.not_understood[0].line, 7U);
  }
  EXPECT_EQ(ply_with(three_of("int"), "1 2 3 255 128 0").not_understood[2].what, "field blue of type I32");
  const auto packed = pcd_with(" rgb", " 8", " F", " 1e300");
  EXPECT_TRUE(packed.value.colours.empty());
  EXPECT_EQ(packed.not_understood, (Listed{{"field rgb of type F64", 2, 1}}));
}

TEST(CloudVariants, AColourWithOneChannelOfAnotherTypeIsListedAsAWhole) {
  const auto read = ply_with("property float red\nproperty uchar green\nproperty uchar blue\n", "1 2 3 0.5 4 5");
  EXPECT_TRUE(read.value.colours.empty());
  EXPECT_EQ(read.not_understood,
            (Listed{{"field red of type F32", 7, 1}, {"field green", 8, 1}, {"field blue", 9, 1}}));
}

TEST(CloudVariants, APackedColourMayBeSigned) {
  EXPECT_EQ(pcd_with(" rgba", " 4", " I", " -16776961").value.colours, (Colours{{0, 0, 255}}));  // 0xff0000ff
}

TEST(CloudVariants, ASecondFieldForTheSameIsListed) {
  const auto twice = pcd_with(" intensity intensity", " 4 4", " F F", " 4 5");
  EXPECT_EQ(twice.value.intensities, (std::vector<float>{4.0F}));
  EXPECT_EQ(twice.not_understood, (Listed{{"field intensity beside an earlier one for the same", 2, 1}}));
  const auto both = pcd_with(" rgb rgba", " 4 4", " U U", " 66051 5");
  EXPECT_EQ(both.value.colours, (Colours{{1, 2, 3}}));
  EXPECT_EQ(both.not_understood, (Listed{{"field rgba beside an earlier one for the same", 2, 1}}));
  const auto x = pcd_with(" x", " 4", " F", " 9");
  EXPECT_EQ(x.value.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(x.not_understood.size(), 1U);
}

TEST(CloudVariants, FieldsOfSeveralNumbersAndOddNormalsAreListed) {
  const auto read =
      pcd("VERSION 0.7\nFIELDS x y z intensity normal_x normal_y normal_z\nSIZE 4 4 4 4 1 1 1\n"
          "TYPE F F F F I I I\nCOUNT 1 1 1 2 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n"
          "1 2 3 4 5 6 7 8\n");
  EXPECT_EQ(read.value.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_TRUE(read.value.intensities.empty());
  EXPECT_TRUE(read.value.normals.empty());
  ASSERT_EQ(read.not_understood.size(), 4U);
  EXPECT_EQ(read.not_understood[0].what, "field intensity of type F32 x 2");
}

TEST(CloudVariants, FieldsThatAreNoNumbersAreSkippedByTheirSize) {
  Bytes bytes = bytes_of(
      "VERSION 0.7\nFIELDS half x y z long intensity\nSIZE 2 4 4 4 16 2\nTYPE F F F F F F\n"
      "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n");
  bytes.insert(bytes.end(), {9, 9, 0, 0, 0x80, 0x3f, 0, 0, 0, 0x40, 0, 0, 0x40, 0x40});
  bytes.insert(bytes.end(), 18, 9);
  const auto read = read_pcd(bytes, "a.pcd");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_TRUE(read->value.intensities.empty());
  EXPECT_EQ(read->not_understood,
            (Listed{{"field half", 2, 1}, {"field long", 2, 1}, {"field intensity of type F16", 2, 1}}));
}

TEST(CloudVariants, OldHeadersLeaveOutWhatWasClearThen) {
  for (const std::string header :
       {"VERSION .5\nCOLUMNS x y z\nPOINTS 2\n", "VERSION .5\nFIELDS x y z\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n",
        "VERSION 0.6\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\n", "COLUMNS x y z\nWIDTH 2\n"}) {
    const auto read = pcd(header + "DATA ascii\n1 2 3\n4 5 6\n");
    ASSERT_EQ(read.value.points.size(), 2U) << header;
    EXPECT_EQ(read.value.points[1], Eigen::Vector3f(4, 5, 6));
    EXPECT_EQ(read.value.width, 2U);
    EXPECT_EQ(read.value.height, 1U);
    EXPECT_TRUE(read.not_understood.empty());
  }
}

TEST(CloudVariants, RowsBeyondTheStatedOnesAreListed) {
  const auto read = pcd("VERSION .5\nCOLUMNS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n# more\n4 5 6\n\n7 8\n");
  EXPECT_EQ(read.value.points.size(), 1U);
  EXPECT_EQ(read.not_understood, (Listed{{"a row after the last point", 7, 2}}));
  EXPECT_EQ(ply_with("", "1 2 3\n4 5 6").not_understood, (Listed{{"a row after the last point", 9, 1}}));
  const auto face = ply_with("element face 1\nproperty list uchar int vertex_indices\n", "1 2 3\n3 0 0 0\n4 5 6");
  EXPECT_EQ(face.not_understood, (Listed{{"element face of 1", 7, 1}, {"a row after the last point", 12, 1}}));
}

TEST(CloudVariants, BytesBeyondTheStatedOnesAreListed) {
  Cloud cloud;
  cloud.points = {{1.0F, 2.0F, 3.0F}};
  cloud.width = 1;
  Bytes bytes = pcd_bytes(cloud, CloudCoding::binary);
  bytes.insert(bytes.end(), 12, 0);  // as PCL fills the last page of memory up
  EXPECT_TRUE(read_pcd(bytes, "a.pcd").value().not_understood.empty());
  bytes.back() = 1;
  const auto read = read_pcd(bytes, "a.pcd");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  ASSERT_EQ(read->not_understood.size(), 1U);
  EXPECT_EQ(read->not_understood[0].what, "12 bytes after the last point");
}

}  // namespace
}  // namespace weft::formats
