#include "idl/bus/backends.hpp"

namespace weft::bus {

Result<Vendor> parse_vendor(std::string_view text) {
  if (text == "fastdds") return Vendor::fastdds;
  if (text == "cyclonedds") return Vendor::cyclonedds;
  return fail(ErrorCode::invalid, "'" + std::string(text) + "' is no DDS vendor: fastdds or cyclonedds");
}

Result<std::unique_ptr<Bus>> open(Vendor vendor, const BusConfig& config) {
  return vendor == Vendor::fastdds ? open_fastdds(config, topics()) : open_cyclonedds(config, topics());
}

std::string library_version(Vendor vendor) {
  return vendor == Vendor::fastdds ? fastdds_version() : cyclonedds_version();
}

}  // namespace weft::bus
