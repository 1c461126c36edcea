#include "images/png.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <string>

namespace weft::images {
namespace {

/// Reads a PNG step by step. libpng leaves a step that fails by a jump: what runs within one has no destructors.
class PngDecoder {
 public:
  PngDecoder(ByteView bytes, Shades shades) : bytes_(bytes), shades_(shades) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngDecoder::leave, &PngDecoder::overhear);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ != nullptr) png_set_read_fn(png_, this, &PngDecoder::hand_over);
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  bool read_header() { return info_ != nullptr && run(&PngDecoder::header_step); }
  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  /// Reads all rows into samples of that size.
  bool read_rows(std::uint8_t* samples) {
    samples_ = samples;
    return run(&PngDecoder::rows_step);
  }
  const char* problem() const { return problem_.data(); }

 private:
  bool run(void (PngDecoder::*step)()) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    (this->*step)();
    return true;
  }
  void header_step() { png_read_info(png_, info_); }
  void rows_step();
  void choose_samples();

  [[noreturn]] static void leave(png_structp png, png_const_charp problem);
  static void overhear(png_structp /*png*/, png_const_charp /*warning*/) {}
  static void hand_over(png_structp png, png_bytep into, std::size_t size);

  ByteView bytes_;
  Shades shades_;
  std::size_t at_ = 0;
  std::uint8_t* samples_ = nullptr;
  std::array<char, 128> problem_{"no memory"};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void PngDecoder::leave(png_structp png, png_const_charp problem) {
  auto& self = *static_cast<PngDecoder*>(png_get_error_ptr(png));
  std::snprintf(self.problem_.data(), self.problem_.size(), "%s", problem);
  png_longjmp(png, 1);
}

void PngDecoder::hand_over(png_structp png, png_bytep into, std::size_t size) {
  auto& self = *static_cast<PngDecoder*>(png_get_io_ptr(png));
  if (size > self.bytes_.size() - self.at_) png_error(png, "it ends too early");
  std::copy_n(self.bytes_.data() + self.at_, size, into);
  self.at_ += size;
}

void PngDecoder::choose_samples() {
  constexpr png_byte kSampleBits = 8;
  constexpr int kSilently = 1;  // a picture that has colours is no mistake
  constexpr double kRed = 0.299;
  constexpr double kGreen = 0.587;
  const png_byte kind = png_get_color_type(png_, info_);
  const png_byte bits = png_get_bit_depth(png_, info_);
  if (bits > kSampleBits) png_set_strip_16(png_);
  png_set_strip_alpha(png_);
  if (kind == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
  const bool has_colours = (kind & PNG_COLOR_MASK_COLOR) != 0;
  if (!has_colours && bits < kSampleBits) png_set_expand_gray_1_2_4_to_8(png_);
  if (shades_ == Shades::grey) {
    png_set_rgb_to_gray(png_, kSilently, kRed, kGreen);
  } else if (has_colours) {
    png_set_bgr(png_);
  } else {
    png_set_gray_to_rgb(png_);
  }
}

void PngDecoder::rows_step() {
  choose_samples();
  const int passes = png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  const std::size_t row = width() * static_cast<std::size_t>(shades_);
  if (png_get_rowbytes(png_, info_) != row) png_error(png_, "its rows are longer than its width");
  const std::size_t rows = height();
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < rows; ++y) png_read_row(png_, samples_ + y * row, nullptr);
  }
  png_read_end(png_, nullptr);
}

tl::unexpected<Error> damaged(std::string_view file, const PngDecoder& decoder) {
  return fail(ErrorCode::corrupt,
              std::string(file) + ": no PNG that can be read (" + decoder.problem() + "); write it anew");
}

}  // namespace

bool is_png(ByteView bytes) {
  constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

Result<Picture> decode_png(ByteView bytes, std::string_view file, Shades shades) {
  PngDecoder decoder(bytes, shades);
  if (!decoder.read_header()) return damaged(file, decoder);
  Result<Picture> picture = blank_picture(file, shades, decoder.width(), decoder.height());
  if (!picture) return picture;
  if (!decoder.read_rows(picture->samples.data())) return damaged(file, decoder);
  return picture;
}

}  // namespace weft::images
