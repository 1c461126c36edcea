#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "images/picture.hpp"

namespace weft::test {

/// Describes a PNG as its specification does, so that tests make each kind of it.
struct RawPng {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint8_t bits = 8;   ///< of a sample
  std::uint8_t kind = 0;   ///< 0 grey, 2 colours, 3 palette, 4 grey with opacity, 6 colours with opacity
  std::uint8_t weave = 0;  ///< 1: interlaced
  Bytes rows = {};         ///< samples; before each row the byte of its filter, 0
  std::vector<std::pair<std::string, Bytes>> parts = {};  ///< further chunks before the samples: PLTE, tRNS, gAMA
};

Bytes png_bytes(const RawPng& png);
Bytes png_bytes(const images::Picture& picture);

/// Writes it as a PNG; a test that cannot fails.
void write_png(const std::filesystem::path& file, const images::Picture& picture);

/// Returns a picture that is everywhere of the same grey.
images::Picture plain_picture(int width, int height, std::uint8_t grey);

}  // namespace weft::test
