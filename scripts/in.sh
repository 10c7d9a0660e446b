#!/usr/bin/env bash
# in.sh FOLDER COMMAND…: runs the command there.
cd "$(dirname "$0")/../$1" && shift && exec "$@"
