// Measures what a pair sees beside plain OpenCV on the same rendered pairs, one thread. Not part of ctest; run
// build/<preset>/bin/stereo_bench.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
