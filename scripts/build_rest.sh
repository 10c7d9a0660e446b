#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build_rest.sh: builds the programs that demo.sh does not wait for, with what a running team leaves of the
# processors. Says only what fails. Ends when whoever started it with a signal at its own end has ended; what is
# missing then, the next build makes.
set -uo pipefail
cd "$(dirname "$0")/.."

ninja -C build -n programs | grep -q 'no work to do' && exit 0
exec 9>build/lock
flock 9
# First what the README's second command needs.
chrt --idle 0 setpriv --pdeathsig TERM ninja -C build galilean-swap programs >build/rest.log 2>&1 && exit 0
echo "demo.sh: the programs that the demo does not need were not all built:" >&2
grep -A20 -E 'FAILED|error' build/rest.log | head -40 >&2
exit 1
