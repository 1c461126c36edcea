// Measures how often places of `topometric` are recognised by their signatures, how large they are, and what a
// kilometre of aisle takes in a store. Simulated runs through four sites. Usage: place_bench [--quick] [STORE]
#include <cstdio>
#include <string_view>

#include "tests/bench/topometric/aisle_store.hpp"
#include "tests/bench/topometric/place_runs.hpp"
#include "tests/bench/topometric/place_sizes.hpp"
#include "tests/bench/topometric/sign_recall.hpp"

int main(int count, char** arguments) {
  using namespace weft;
  constexpr std::size_t kPlacesOfAKilometre = 2000;
  bool is_quick = false;
  std::string_view store;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--quick") {
      is_quick = true;
    } else if (!argument.starts_with('-') && store.empty()) {
      store = argument;
    } else {
      std::fprintf(stderr, "place_bench: %s: usage is place_bench [--quick] [STORE]\n", arguments[i]);
      return 2;
    }
  }
  const Result<bench::PlaceRuns> runs = bench::drive_places(WEFT_SITES "/topometric", is_quick);
  if (!runs) {
    std::fprintf(stderr, "place_bench: %s\n", runs.error().message.c_str());
    return 1;
  }
  bench::print_place_sizes(runs->known);
  bench::print_sign_recall(*runs);
  if (store.empty()) return 0;
  if (const Result<void> written = bench::write_aisle(runs->known, kPlacesOfAKilometre, store); !written) {
    std::fprintf(stderr, "place_bench: %s\n", written.error().message.c_str());
    return 1;
  }
}
