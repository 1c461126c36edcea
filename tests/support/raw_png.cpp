#include "tests/support/raw_png.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <iterator>

namespace weft::test {
namespace {

constexpr int kFast = 1;

void append(Bytes& out, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<std::uint8_t>(number >> shift));
}

void append_chunk(Bytes& out, const std::string& name, const Bytes& content) {
  Bytes named(name.begin(), name.end());
  named.insert(named.end(), content.begin(), content.end());
  append(out, static_cast<std::uint32_t>(content.size()));
  out.insert(out.end(), named.begin(), named.end());
  append(out, static_cast<std::uint32_t>(crc32(0, named.data(), static_cast<uInt>(named.size()))));
}

Bytes packed(const Bytes& rows) {
  uLongf size = compressBound(rows.size());
  Bytes bytes(size);
  EXPECT_EQ(compress2(bytes.data(), &size, rows.data(), rows.size(), kFast), Z_OK);
  bytes.resize(size);
  return bytes;
}

}  // namespace

Bytes png_bytes(const RawPng& png) {
  Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append(header, png.width);
  append(header, png.height);
  for (const std::uint8_t byte : {png.bits, png.kind, std::uint8_t{0}, std::uint8_t{0}, png.weave})
    header.push_back(byte);
  append_chunk(out, "IHDR", header);
  for (const auto& [name, content] : png.parts) append_chunk(out, name, content);
  append_chunk(out, "IDAT", packed(png.rows));
  append_chunk(out, "IEND", {});
  return out;
}

Bytes png_bytes(const images::Picture& picture) {
  const bool is_grey = picture.shades == images::Shades::grey;
  RawPng png{.width = static_cast<std::uint32_t>(picture.width),
             .height = static_cast<std::uint32_t>(picture.height)};
  png.kind = is_grey ? 0 : 2;
  const auto each = static_cast<std::ptrdiff_t>(picture.shades);
  auto pixel = picture.samples.begin();
  for (int y = 0; y < picture.height; ++y) {
    png.rows.push_back(0);
    for (int x = 0; x < picture.width; ++x, pixel += each)
      png.rows.insert(png.rows.end(), std::make_reverse_iterator(pixel + each), std::make_reverse_iterator(pixel));
  }
  return png_bytes(png);
}

void write_png(const std::filesystem::path& file, const images::Picture& picture) {
  const Bytes bytes = png_bytes(picture);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_TRUE(out.good()) << file;
}

images::Picture plain_picture(int width, int height, std::uint8_t grey) {
  return {images::Shades::grey, width, height, Bytes(static_cast<std::size_t>(width * height), grey)};
}

}  // namespace weft::test
