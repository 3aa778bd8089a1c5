#!/usr/bin/env bash
# run_fuzzers.sh FOLDER SECONDS [JOBS]: runs every fuzz target in FOLDER for SECONDS, JOBS (default 2) at a time, each on
# the seeds in fuzz/corpus/NAME and with what it finds, and its log, kept in FOLDER/found/NAME. Prints one line for each;
# the exit status is 1 when one found a fault.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1 seconds=$2 jobs=${3:-2}

run_one() {
  local program=$1 name found
  name=$(basename "$program")
  found=$folder/found/$name
  mkdir -p "$found/inputs"
  if "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$found/" "$found/inputs" "fuzz/corpus/$name" >"$found/log" 2>&1; then
    echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$found/log") inputs, no fault"
  else
    echo "$name: FAULT, see $found"
    tail -n 40 "$found/log"
    return 1
  fi
}
export -f run_one
export folder seconds

find "$folder" -maxdepth 1 -type f -name '*_fuzz' -print0 | sort -z |
  xargs -0 -r -n 1 -P "$jobs" bash -c 'run_one "$1"' run_one
