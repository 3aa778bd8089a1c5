// How much memory something takes.
#ifndef TAUTLINE_BENCH_MEMORY_H_
#define TAUTLINE_BENCH_MEMORY_H_

#include <cstddef>

namespace tautline {

/// The bytes that the program has allocated and not freed. glibc only; 0 elsewhere.
std::size_t AllocatedBytes();

/// The largest number of bytes of memory that the program has held at a time since ResetPeak(), as the system counts
/// them. Linux only; 0 elsewhere.
std::size_t PeakResidentBytes();

/// Forgets the peak so far, and gives memory that was freed back to the system.
void ResetPeak();

}  // namespace tautline

#endif  // TAUTLINE_BENCH_MEMORY_H_
