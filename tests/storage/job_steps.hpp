#pragma once
#include <functional>
#include <memory>

#include "storage/maintenance.hpp"

namespace weft::storage {

/// Steps a job to its end, `between` two steps each; returns its last progress with all findings, or its error.
inline Result<JobProgress> finish(
    StoreJob& job, const std::function<void()>& between = [] {}) {
  std::vector<std::string> findings;
  for (;;) {
    auto progress = job.step();
    if (!progress) return progress;
    findings.insert(findings.end(), progress->findings.begin(), progress->findings.end());
    if (progress->finished) {
      progress->findings = std::move(findings);
      return progress;
    }
    between();
  }
}

}  // namespace weft::storage
