#pragma once
#include "core/ids.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Draws the ids of new experiences.
class ExperienceIds {
 public:
  explicit ExperienceIds(const Random& random) : random_(random) {}

  ExperienceId next() {
    ExperienceId experience;
    while (!experience) experience = ExperienceId{random_.next()};
    return experience;
  }

 private:
  Random random_;
};

}  // namespace weft::agents
