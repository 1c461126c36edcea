#include <algorithm>
#include <array>

#include "idl/bus/backends.hpp"
#include "idl/bus/dds_bus.hpp"

namespace weft::bus {

Result<Vendor> parse_vendor(std::string_view text) {
  if (text == "fastdds") return Vendor::fastdds;
  if (text == "cyclonedds") return Vendor::cyclonedds;
  return fail(ErrorCode::invalid, "'" + std::string(text) + "' is no DDS vendor: fastdds or cyclonedds");
}

Result<std::unique_ptr<Bus>> open(Vendor vendor, const BusConfig& config) {
  return open(vendor, config, topics());
}

Result<std::unique_ptr<Bus>> open(Vendor vendor, const BusConfig& config, TopicTable table) {
  const bool fast = vendor == Vendor::fastdds;
  std::array<Topic, kTopics> own{};  // the caller's table may be gone when the link comes up
  std::copy(table.begin(), table.end(), own.begin());
  const auto join = [fast, config, own](const Addresses& at, Inbox& inbox) {
    return fast ? join_fastdds(config, own, at, inbox) : join_cyclonedds(config, own, at, inbox);
  };
  auto bus = std::make_unique<DdsBus>(config, table, fast ? "fastdds" : "cyclonedds", join);
  if (Result<void> started = bus->start(); !started) return fail(std::move(started.error()));
  return bus;
}

std::string library_version(Vendor vendor) {
  return vendor == Vendor::fastdds ? fastdds_version() : cyclonedds_version();
}

}  // namespace weft::bus
