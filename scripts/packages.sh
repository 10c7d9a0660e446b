#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# packages.sh FOLDER: fetches what FOLDER/package-lock.json lists into FOLDER/node_modules. Does only what changed.
set -euo pipefail
cd "$1"
[ node_modules/.package-lock.json -nt package-lock.json ] && exit 0

# By itself npm asks again for minutes where nothing answers.
patience=(--fetch-retries 2 --fetch-retry-mintimeout 1000 --fetch-retry-maxtimeout 5000 --fetch-timeout 60000)
log=$(mktemp)
trap 'rm -f "$log"' EXIT
fetch() { npm "$@" --no-audit --no-fund --loglevel error "${patience[@]}" >"$log" 2>&1; }

# npm 11 misses other systems' optional packages in a lock without addresses, and `ci` then refuses it.
fetch ci || fetch install --no-save || {
  tail -n 20 "$log" >&2
  echo "packages.sh: npm could not fetch the packages of $1. See its words above; where they name the network, connect this machine and start again." >&2
  exit 1
}
