#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "agents/bodies/body.hpp"
#include "core/result.hpp"

namespace weft::agents {

struct Options;
using Warn = std::function<void(const std::string&)>;

/// Describes a kind of body that a program has.
struct BodyKind {
  const char* name;  ///< as --body has it
  /// Makes one as the options say. Errors are its own: no such file, site, recording or robot in it.
  Result<std::unique_ptr<Body>> (*make)(const Options& options, const Warn& warn);
};

/// Names the kind that only weft-agent-sim has: it brings the libraries that render, which no robot needs.
inline constexpr const char* kSimulated = "sim";

/// Describes a program that is an agent. They differ in the bodies that are linked into them, and in nothing else.
struct Program {
  const char* name;
  std::span<const BodyKind> bodies;  ///< one or more; the first is the one that --body need not name
};

bool has_body(const Program& program, const std::string& kind);

/// Says that the program has no such body, and which one has it.
std::string without_body(const std::string& kind);

/// Makes the body that the options name. refused: the program has none of that kind; else its own errors.
Result<std::unique_ptr<Body>> make_body(const Program& program, const Options& options, const Warn& warn);

}  // namespace weft::agents
