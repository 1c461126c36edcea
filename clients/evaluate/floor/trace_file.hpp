#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "clients/evaluate/floor/trace.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Writes a trace as CSV, a row a sample: for pictures, and for people who look into a number. `stamp`: of what it
/// was driven; one word. unavailable, exhausted: names the file.
Result<void> write_trace(const std::filesystem::path& file, const std::string& stamp, const Trace& trace);

/// Reads a trace, without refusals and time. None: there is no such file, or it has another stamp, or it is damaged;
/// then it is to be driven again, which gives the same.
std::optional<Trace> read_trace(const std::filesystem::path& file, const std::string& stamp);

}  // namespace weft::evaluate::floor
