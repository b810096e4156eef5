#!/usr/bin/env bash
# Runs once, when the autograder's image is made (choose Debian 12): installs the packages, builds the tool and draws the
# reference's pictures, so that no submission waits for that.
set -euo pipefail
source=${AUTOGRADER_ROOT:-/autograder}/source
cd "$source/ggrade"
./ggrade list >/dev/null
# Students' programs must not read the solution: see run_autograder.
chmod 700 "$source"
./ggrade grade @ID@ assignments/@ASSIGNMENT@ --out /tmp/warm >/dev/null || true
