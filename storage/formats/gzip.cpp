#include "storage/formats/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace weft::formats {
namespace {

constexpr int kGzipOnly = 16 + MAX_WBITS;
constexpr std::size_t kStep = 1U << 18U;

struct End {
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

struct EndPacking {
  void operator()(z_stream* stream) const { deflateEnd(stream); }
};

/// Gives zlib what is left of the bytes and room for one step, and lets it take one. `act`: inflate or deflate, told
/// whether all that is left was given. Returns what `act` says.
template <class Act>
int step(z_stream& stream, ByteView bytes, std::size_t& taken, Bytes& out, const Act& act) {
  const std::size_t held = out.size();
  out.resize(held + kStep);
  const std::size_t give = std::min<std::size_t>(bytes.size() - taken, std::numeric_limits<uInt>::max());
  stream.next_in = const_cast<Bytef*>(bytes.data() + taken);  // zlib's interface; it does not write there
  stream.avail_in = static_cast<uInt>(give);
  stream.next_out = out.data() + held;
  stream.avail_out = static_cast<uInt>(kStep);
  const int state = act(taken + give == bytes.size());
  taken += give - stream.avail_in;
  out.resize(held + kStep - stream.avail_out);
  return state;
}

}  // namespace

bool is_gzip(ByteView bytes) {
  return bytes.size() >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

Result<Bytes> gunzip(ByteView bytes, std::size_t at_most) {
  z_stream stream{};
  if (inflateInit2(&stream, kGzipOnly) != Z_OK) return fail(ErrorCode::internal, "zlib cannot begin");
  const std::unique_ptr<z_stream, End> ended(&stream);
  Bytes out;
  std::size_t taken = 0;
  while (taken < bytes.size()) {
    const int state = step(stream, bytes, taken, out, [&](bool /*is_all*/) { return inflate(&stream, Z_NO_FLUSH); });
    if (out.size() > at_most) {
      return fail(ErrorCode::exhausted, "more than " + std::to_string(at_most) + " bytes come out of it");
    }
    if (state == Z_STREAM_END) {
      if (taken == bytes.size()) return out;
      if (inflateReset(&stream) != Z_OK) break;  // the next member
    } else if (state != Z_OK) {
      return fail(ErrorCode::corrupt, "damaged gzip data at byte " + std::to_string(taken));
    }
  }
  // All is taken, and more may be due to come out only if the last member has not ended.
  return fail(ErrorCode::corrupt, "the gzip data ends early, after " + std::to_string(taken) + " bytes");
}

Result<Bytes> gzip(ByteView bytes) {
  constexpr int usual_memory = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipOnly, usual_memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    return fail(ErrorCode::exhausted, "zlib has no memory to pack with");
  }
  const std::unique_ptr<z_stream, EndPacking> ended(&stream);
  Bytes out;
  std::size_t taken = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    state = step(stream, bytes, taken, out,
                 [&](bool is_all) { return deflate(&stream, is_all ? Z_FINISH : Z_NO_FLUSH); });
    if (state == Z_STREAM_ERROR) return fail(ErrorCode::internal, "zlib cannot pack");
  }
  return out;
}

}  // namespace weft::formats
