#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# show_failures.sh LOG: the part of a test log that says what failed.
log=$1
grep -nE 'FAILED|: Failure$|not ok|SKIP|Skipped|# TODO|Disabled|DISABLED|✖|AssertionError|error:|ERROR|\*\*\*' "$log" | head -40
echo "…"
tail -40 "$log"
