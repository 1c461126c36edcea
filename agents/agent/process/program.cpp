#include "agents/agent/process/program.hpp"

#include <algorithm>

#include "agents/agent/process/options.hpp"

namespace weft::agents {
namespace {

std::span<const BodyKind>::iterator find_body(const Program& program, const std::string& kind) {
  return std::ranges::find_if(program.bodies, [&](const BodyKind& body) { return body.name == kind; });
}

}  // namespace

bool has_body(const Program& program, const std::string& kind) {
  return find_body(program, kind) != program.bodies.end();
}

std::string without_body(const std::string& kind) {
  return "there is no body " + kind + " in this program" +
         (kind == kSimulated ? "; start weft-agent-sim, with the same words" : "");
}

Result<std::unique_ptr<Body>> make_body(const Program& program, const Options& options, const Warn& warn) {
  const auto body = find_body(program, options.body);
  if (body == program.bodies.end()) return fail(ErrorCode::refused, without_body(options.body));
  return body->make(options, warn);
}

}  // namespace weft::agents
