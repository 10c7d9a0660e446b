#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# page.sh SCRIPT: runs a script of web/package.json, by Node 18.
set -euo pipefail
cd "$(dirname "$0")"
shell=$PWD/node18.sh
cd ../web && exec npm run "$1" --script-shell "$shell"
