#!/usr/bin/env bash
# Builds all fuzz targets and runs each for a fixed number of runs, beginning with its corpus:
#
#     fuzz/run.sh [RUNS [TARGET…]]
#     fuzz/run.sh still [RUNS] [TARGET…]    until coverage stands still: in rounds of RUNS (20,000), until three in a row reach no new code
#     FOUND=FOLDER fuzz/run.sh …            the same, with the inputs that reach new code kept in a folder, from which the next run goes on
#
# Exit status: 0 nothing was found; 1 something was; 2 misuse.
#
# With cargo-fuzz and a nightly toolchain the targets have coverage feedback and, but for `still`, AddressSanitizer. Without, they are built as
# plain binaries: libFuzzer then replays the corpus and mutates it blindly, which is less, but needs stable Rust only.
set -euo pipefail
found=${FOUND:+$(realpath -m "$FOUND")}
cd "$(dirname "$0")"

all=(programs in_step stale_keys validator_total certificates segments noding edits history geojson layer flatgeobuf shapefile topojson postgis)
misused() {
  printf '%s\nusage: fuzz/run.sh [RUNS|still [RUNS] [TARGET…]]\ntargets: %s\n' "$1" "${all[*]}" >&2
  exit 2
}

runs=${1:-2000}
shift || true
[[ $runs =~ ^[0-9]+$ || $runs == still ]] || misused "not a number of runs: $runs"
round_of=20000
if [[ $runs == still && ${1:-} =~ ^[1-9][0-9]*$ ]]; then
  round_of=$1
  shift
fi
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  targets=("${all[@]}")
fi
for target in "${targets[@]}"; do
  [[ " ${all[*]} " == *" $target "* ]] || misused "no such target: $target"
done
build=${CARGO_TARGET_DIR:-$PWD/target}

if cargo fuzz --version >/dev/null 2>&1 && cargo +nightly --version >/dev/null 2>&1; then
  sanitizer=address
  # It finds faults of memory, and has no part in what is reached.
  [ "$runs" != still ] || sanitizer=none
  echo "==> cargo-fuzz, nightly: coverage feedback, sanitizer: $sanitizer"
  # With dead code, functions are instantiated once and not inlined from one crate into another.
  cargo +nightly fuzz build --fuzz-dir . --target-dir "$build" --strip-dead-code --sanitizer "$sanitizer"
  binaries=$build/$(rustc -vV | sed -n 's/^host: //p')/release
else
  [ "$runs" != still ] || misused 'coverage is only known with cargo-fuzz and a nightly toolchain'
  echo '==> no cargo-fuzz with a nightly toolchain: plain build, no coverage feedback'
  RUSTFLAGS='--cfg fuzzing' cargo build --bins --target-dir "$build"
  binaries=$build/debug
fi

# New inputs go to a folder of their own, so that the corpus stays small.
if [ -z "$found" ]; then
  found=$(mktemp -d)
  trap 'rm -rf "$found"' EXIT
fi
mkdir -p artifacts

# A number of runs of one target. The last line of its log has the coverage.
run() {
  local target=$1 runs=$2 seed=$3
  # After each run, libFuzzer's entropic schedule goes through all inputs that it keeps, which takes longer than the run.
  local options=(-runs="$runs" -timeout=20 -seed="$seed" -entropic=0 -print_final_stats=0 -artifact_prefix="artifacts/$target-")
  if [ -f "dictionaries/$target.dict" ]; then
    options+=(-dict="dictionaries/$target.dict")
  fi
  "$binaries/$target" "${options[@]}" "$found/$target" "corpus/$target" 2>"$found/$target.log" || {
    cat "$found/$target.log"
    echo "==> $target failed; see artifacts/"
    exit 1
  }
}

for target in "${targets[@]}"; do
  mkdir -p "$found/$target"
  if [ "$runs" != still ]; then
    echo "==> $target, $runs runs"
    run "$target" "$runs" 1
    tail -n 1 "$found/$target.log"
    continue
  fi
  echo "==> $target, until coverage stands still"
  # A run that goes on from what was found takes other random numbers.
  reached=0 since=0 round=0 known=$(find "$found/$target" -type f | wc -l)
  while [ "$since" -lt 3 ]; do
    round=$((round + 1))
    run "$target" "$round_of" $((known + round))
    now=$(sed -n 's/^#[0-9]*[[:space:]]DONE[[:space:]]*cov: \([0-9]*\) .*/\1/p' "$found/$target.log")
    since=$((now > reached ? 0 : since + 1))
    reached=$((now > reached ? now : reached))
    echo "$((round * round_of)) runs: $now edges of the program's code reached"
  done
done
