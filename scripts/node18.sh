#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# node18.sh SCRIPT [ARGUMENT…] | -c COMMANDS: bash, in which `node` is Node 18, as Debian 12 has it. Where PATH
# has another, npm brings it: a test must not pass on what only a newer Node has. npm takes this file as the
# --script-shell of what it runs.
set -euo pipefail
place=$(cd "$(dirname "$0")/../tests/node18" && pwd)

major() { "$1" -p 'process.versions.node.split(".")[0]'; }
if [ "$(major node)" != 18 ]; then
  "$place/../../scripts/packages.sh" "$place" >&2
  if [ "$(major "$place/node_modules/.bin/node" 2>&1)" != 18 ]; then
    echo "node18.sh: npm has no Node 18 that runs on this $(uname -m); put Debian's first on PATH: apt-get install nodejs" >&2
    exit 1
  fi
  PATH=$place/node_modules/.bin:$PATH
fi
exec bash "$@"
