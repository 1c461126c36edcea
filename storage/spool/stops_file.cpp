#include "storage/spool/stops_file.hpp"

#include <string>
#include <string_view>

namespace weft::storage {
namespace {

constexpr std::string_view kHead = "weft-stops 1\n";
constexpr std::string_view kOperator = "operator\n";
constexpr std::string_view kEmergencyStop = "emergency_stop\n";
constexpr std::string_view kEnd = "end\n";

/// Takes the line off the text if it begins with that.
bool take(std::string_view& text, std::string_view line) {
  const bool is_there = text.starts_with(line);
  if (is_there) text.remove_prefix(line.size());
  return is_there;
}

}  // namespace

Bytes encode(const Stops& stops) {
  std::string text(kHead);
  if (stops.by_operator) text += kOperator;
  if (stops.by_emergency_stop) text += kEmergencyStop;
  text += kEnd;
  return {text.begin(), text.end()};
}

Result<Stops> decode_stops(ByteView bytes) {
  const std::string whole(bytes.begin(), bytes.end());
  std::string_view text = whole;
  if (!take(text, kHead)) {
    return text.starts_with("weft-stops ") ? fail(ErrorCode::newer, "of a later format than 1")
                                           : fail(ErrorCode::corrupt, "does not begin with weft-stops 1");
  }
  Stops stops;
  stops.by_operator = take(text, kOperator);
  stops.by_emergency_stop = take(text, kEmergencyStop);
  if (text != kEnd) return fail(ErrorCode::corrupt, "not understood after what keeps the robot standing");
  return stops;
}

}  // namespace weft::storage
