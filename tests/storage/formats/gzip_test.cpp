#include "storage/formats/gzip.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace weft::formats {
namespace {

Bytes packed(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  Bytes out(deflateBound(&stream, text.size()) + 32);
  std::string in = text;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

TEST(Gzip, MembersOneAfterTheOther) {
  const std::string big(700'000, 'x');
  Bytes bytes = packed(big);
  const Bytes more = packed("end");
  bytes.insert(bytes.end(), more.begin(), more.end());
  EXPECT_TRUE(is_gzip(bytes));
  const auto out = gunzip(bytes, 1U << 20U);
  ASSERT_TRUE(out.has_value()) << out.error().message;
  EXPECT_EQ(std::string(out->begin(), out->end()), big + "end");
}

TEST(Gzip, EndsAndDamageAreFound) {
  const Bytes whole = packed(std::string(1000, 'y') + "zz");
  const Bytes cut(whole.begin(), whole.end() - 5);
  EXPECT_EQ(gunzip(cut, 1U << 20U).error().code, ErrorCode::corrupt);
  Bytes damaged = whole;
  damaged[damaged.size() - 6] ^= 1U;  // of the checksum
  EXPECT_EQ(gunzip(damaged, 1U << 20U).error().code, ErrorCode::corrupt);
}

TEST(Gzip, NeverMoreThanWasAllowed) {
  EXPECT_EQ(gunzip(packed(std::string(1'000'000, 'x')), 999'999).error().code, ErrorCode::exhausted);
  EXPECT_TRUE(gunzip(packed(std::string(1'000'000, 'x')), 1'000'000).has_value());
}

TEST(Gzip, PlainTextIsNone) {
  EXPECT_FALSE(is_gzip(Bytes{'P', '5'}));
  EXPECT_FALSE(is_gzip(Bytes{0x1f}));
}

}  // namespace
}  // namespace weft::formats
