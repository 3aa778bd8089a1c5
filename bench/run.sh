#!/usr/bin/env bash
# run.sh BUILD [FILTER]: runs the benchmarks of a build folder, or those whose names match the regular expression, and
# writes the tables and pictures of docs/performance.md.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1 filter=${2:-.}
results=$build/bench/results

rm -rf "$results"
mkdir -p "$results"
for program in triangulation visibility funnel cdt2025 real_maps growth workspace fleet manifold cable learning; do
  "$build/bench/${program}_bench" --benchmark_filter="$filter" --benchmark_counters_tabular=false \
    --benchmark_out="$results/$program.json" --benchmark_out_format=json
done
python3 -B bench/report.py "$results"
