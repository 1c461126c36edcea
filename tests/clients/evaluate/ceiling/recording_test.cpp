#include "clients/evaluate/ceiling/frames/recording.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <string>

#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::ceiling {
namespace {

constexpr const char* kSetup =
    "width = 64\nheight = 64\nfx = 20.0\nfy = 20.0\ncx = 31.5\ncy = 31.5\nk1 = 0.01\nceiling_height_m = 2.5\n";

class ARecording : public testing::Test {
 protected:
  ARecording() {
    write("ceiling.toml", kSetup);
    write("golden_0_3.txt", "0 0 0\n0.1 0.2 0.3\n0.2 0.4 0.6\n");
    pack("frames_0_3_64x64_u8.raw.gz", 3 * 64 * 64);
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder.path() / name) << text; }
  void pack(const std::string& name, std::size_t bytes) const {
    const std::string raw(bytes, '\x7f');
    gzFile out = gzopen((folder.path() / name).c_str(), "wb");
    ASSERT_NE(out, nullptr);
    EXPECT_EQ(gzwrite(out, raw.data(), static_cast<unsigned>(bytes)), static_cast<int>(bytes));
    gzclose(out);
  }
  std::string refusal() const {
    const Result<Recording> read = read_recording(folder.path());
    return read ? "not refused" : read.error().message;
  }
  bool refuses_with(const std::string& file, const std::string& what) const {
    return refusal().find(file) != std::string::npos && refusal().find(what) != std::string::npos;
  }
  storage::TemporaryDirectory folder;
};

TEST_F(ARecording, IsReadWithPosesInMetres) {
  const Result<Recording> read = read_recording(folder.path());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->frames.size(), 3U);
  EXPECT_EQ(read->frames[2].pixels->size(), 64U * 64U);
  EXPECT_EQ(read->camera.lens, LensModel::equidistant);
  EXPECT_EQ(read->golden_from_camera[1], (Pose2{0.25, 0.5, -0.3}));
}

TEST_F(ARecording, WhatIsMissingIsNamed) {
  std::filesystem::remove(folder.path() / "golden_0_3.txt");
  EXPECT_TRUE(refuses_with(folder.path().string(), "golden_*.txt")) << refusal();
  std::filesystem::remove(folder.path() / "frames_0_3_64x64_u8.raw.gz");
  EXPECT_TRUE(refuses_with(folder.path().string(), "frames_*.raw.gz")) << refusal();
  EXPECT_EQ(read_recording(folder.path() / "none").error().code, ErrorCode::not_found);
}

TEST_F(ARecording, TwoOfOneKindAreRefused) {
  write("golden_3_6.txt", "0 0 0\n");
  EXPECT_TRUE(refuses_with(folder.path().string(), "2 files golden_*.txt")) << refusal();
}

TEST_F(ARecording, RowsAreHeldAgainstFrames) {
  write("golden_0_3.txt", "0 0 0\n0.1 0.2 0.3\n");
  EXPECT_TRUE(refuses_with("golden_0_3.txt", "2 rows for 3 frames")) << refusal();
  write("golden_0_3.txt", "0 0 0\n0.1 x 0.3\n0 0 0\n");
  EXPECT_TRUE(refuses_with("golden_0_3.txt:2", "three finite numbers")) << refusal();
  write("golden_0_3.txt", "0 0 0\n0.1 0 0.3 7\n0 0 0\n");
  EXPECT_TRUE(refuses_with("golden_0_3.txt:2", "three finite numbers")) << refusal();
}

TEST_F(ARecording, FramesAreWhole) {
  pack("frames_0_3_64x64_u8.raw.gz", 3 * 64 * 64 - 1);
  EXPECT_TRUE(refuses_with("frames_0_3_64x64_u8.raw.gz", "64x64")) << refusal();
  write("frames_0_3_64x64_u8.raw.gz", "no gzip");
  EXPECT_TRUE(refuses_with("frames_0_3_64x64_u8.raw.gz", "gzip")) << refusal();
}

TEST_F(ARecording, KeysHaveBounds) {
  write("ceiling.toml", std::string(kSetup) + "height_of_it = 3\n");
  EXPECT_TRUE(refuses_with("ceiling.toml", "height_of_it")) << refusal();
  write("ceiling.toml", "width = 64\n");
  EXPECT_TRUE(refuses_with("ceiling.toml", "ceiling_height_m")) << refusal();
  std::string near = kSetup;
  near.replace(near.find("2.5"), 3, "0.2");
  write("ceiling.toml", near);
  EXPECT_TRUE(refuses_with("ceiling.toml", "ceiling_height_m")) << refusal();
}

}  // namespace
}  // namespace weft::evaluate::ceiling
