#include "tests/containers/light/open_link.hpp"

#include <memory>
#include <utility>

namespace weft::light {

Result<std::optional<bus::Link>> open_link(const Options& options, const RobotId& self,
                                           const std::function<bool()>& stop,
                                           const std::function<void(const std::string&)>& warn) {
  bus::BusConfig config;
  config.role = msg::Role::agent;
  config.self = self;
  config.domain = options.domain;
  config.listen = options.listen;
  config.servers = options.servers;
  Result<std::unique_ptr<bus::Bus>> opened = bus::open(options.vendor, config);
  if (!opened) return fail(opened.error());
  std::optional<bus::Link> link(std::in_place, std::move(*opened));
  if (!bus::wait_until_open(*link, stop, warn)) link.reset();
  return link;
}

}  // namespace weft::light
