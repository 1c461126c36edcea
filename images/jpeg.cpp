#include "images/jpeg.hpp"

#include <turbojpeg.h>

#include <memory>
#include <string>

namespace weft::images {
namespace {

struct EndDecoder {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};

tl::unexpected<Error> damaged(std::string_view file, void* decoder) {
  return fail(ErrorCode::corrupt,
              std::string(file) + ": no JPEG that can be read (" + tjGetErrorStr2(decoder) + "); write it anew");
}

}  // namespace

bool is_jpeg(ByteView bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Result<Picture> decode_jpeg(ByteView bytes, std::string_view file, Shades shades) {
  const std::unique_ptr<void, EndDecoder> decoder(tjInitDecompress());
  if (decoder == nullptr) return damaged(file, nullptr);
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &width, &height, &subsampling, &colours) != 0) {
    return damaged(file, decoder.get());
  }
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) {
    return fail(ErrorCode::invalid, std::string(file) + ": is of four colours, for printing; save it with three");
  }
  Result<Picture> picture =
      blank_picture(file, shades, static_cast<std::size_t>(width), static_cast<std::size_t>(height));
  if (!picture) return picture;
  const int format = shades == Shades::grey ? TJPF_GRAY : TJPF_BGR;
  constexpr int kRefuseDamage = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
  if (tjDecompress2(decoder.get(), bytes.data(), bytes.size(), picture->samples.data(), width, 0, height, format,
                    kRefuseDamage) != 0) {
    return damaged(file, decoder.get());
  }
  return picture;
}

}  // namespace weft::images
