// The ceiling method beside plain OpenCV on the same rendered views, one thread. Not part of ctest; run
// build/<preset>/bin/ceiling_bench.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
