#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Three robots clean an office: installs what is missing, builds, starts the simulator, the robots
# and the monitor, and prints the page's address. Ctrl-C ends all of it.
#   ./demo.sh [--robots N] [--port P] [--scenario S] [--headless-for SECONDS] …  (./demo.sh --help)
set -euo pipefail
cd "$(dirname "$0")"
scripts/install.sh build
scripts/build.sh demo
# The programs that the demo does not run are built while it runs, and no longer than that.
setpriv --pdeathsig TERM scripts/build_rest.sh &
exec build/bin/galilean demo "$@"
