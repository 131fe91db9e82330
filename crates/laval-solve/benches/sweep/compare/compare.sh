#!/usr/bin/env bash
# The sweep benchmark by laval and by other programs, one after the other on the same processor.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
echo "== laval"
(cd "$here/../../../../.." && cargo bench -p laval-solve --bench sweep)
echo "== Rust crates"
(cd "$here" && cargo run --release --quiet)
echo "== Python"
if python3 -c 'import scipy' 2>/dev/null; then
    python3 "$here/sweep.py"
else
    echo "SciPy is not installed"
fi
