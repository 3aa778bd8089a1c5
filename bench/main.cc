// The main function of every benchmark program: Google Benchmark's options, and --tiny.
#include <benchmark/benchmark.h>

#include <cstring>

#include "bench/program.h"

int main(int argc, char** argv) {
  bool tiny = false;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--tiny") == 0) {
      tiny = true;
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  tautline::RegisterBenchmarks(tiny);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
