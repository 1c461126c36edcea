#pragma once
#include "server/base/context.hpp"
#include "server/base/figures.hpp"
#include "server/contents/content_server.hpp"
#include "server/dispatcher/dispatcher.hpp"
#include "server/dispatcher/standstills.hpp"
#include "server/fleet/fleet.hpp"
#include "server/intake/intake.hpp"
#include "server/recognise/recognition.hpp"
#include "server/windows/window_publisher.hpp"

namespace weft::server {

/// Names the parts of the server that figures are taken of.
struct Measured {
  const Context& context;
  const Fleet& fleet;
  const Intake& intake;
  const WindowPublisher& window_publisher;
  const ContentServer& content_server;
  const Recognition& recognition;
  const Dispatcher& dispatcher;
  const Standstills& standstills;
};

/// Returns how all of them are at that moment.
Figures figures_of(const Measured& measured, Now now);

}  // namespace weft::server
