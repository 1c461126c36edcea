#pragma once
#include <functional>
#include <optional>
#include <utility>

#include "storage/maintenance.hpp"

namespace weft::storage {

/// Does all of a job in its first step.
class OneStep final : public StoreJob {
 public:
  explicit OneStep(std::function<JobProgress()> work) : work_(std::move(work)) {}
  Result<JobProgress> step() override {
    if (!done_) {
      done_ = work_();
      done_->finished = true;
      return *done_;
    }
    done_->findings.clear();
    return *done_;
  }

 private:
  std::function<JobProgress()> work_;
  std::optional<JobProgress> done_;
};

}  // namespace weft::storage
