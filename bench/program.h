// What every benchmark program defines; main.cc does the rest.
#ifndef TAUTLINE_BENCH_PROGRAM_H_
#define TAUTLINE_BENCH_PROGRAM_H_

namespace tautline {

/// Registers the program's benchmarks with Google Benchmark. `tiny`: so small that each ends at once; for tests.
void RegisterBenchmarks(bool tiny);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PROGRAM_H_
