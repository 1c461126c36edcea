#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/floor/bounds.hpp"

namespace weft::evaluate::floor {

/// Returns four tables: the promises; the medians of every column by floor and light; how often regions of 95 % held
/// the truth by floor; and how often views were refused and why.
std::string tables_of(const std::vector<Judged>& promises, const Rows& rows, Seeds seeds);

}  // namespace weft::evaluate::floor
