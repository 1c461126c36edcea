#include "images/picture.hpp"

#include <string>

namespace weft::images {

Result<Picture> blank_picture(std::string_view file, Shades shades, std::size_t width, std::size_t height) {
  if (width > kMostPixels || height > kMostPixels || width * height > kMostPixels) {
    return fail(ErrorCode::exhausted, std::string(file) + ": is " + std::to_string(width) + " x " +
                                          std::to_string(height) + " pixels, at most " + std::to_string(kMostPixels) +
                                          " in all are read; make it smaller");
  }
  return Picture{shades, static_cast<int>(width), static_cast<int>(height),
                 Bytes(width * height * static_cast<std::size_t>(shades))};
}

}  // namespace weft::images
