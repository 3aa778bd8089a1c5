#!/usr/bin/env bash
# run_fuzzers.sh FOLDER SECONDS: runs every fuzz target in FOLDER for SECONDS, each on the seeds
# in fuzz/corpus/NAME and with what it finds kept beside the program.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1 seconds=$2

shopt -s nullglob
for program in "$folder"/*_fuzz; do
  name=$(basename "$program")
  found=$folder/found/$name
  corpora=("$found")
  mkdir -p "$found"
  if [[ -d fuzz/corpus/$name ]]; then corpora+=("fuzz/corpus/$name"); fi
  echo "== $name"
  "$program" -max_total_time="$seconds" -timeout=10 -print_final_stats=1 \
    -artifact_prefix="$found/" "${corpora[@]}"
done
