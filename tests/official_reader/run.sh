#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Judges logs with the official readers: run.sh [--json] [--max-ratio R] FILE...
# The packages are installed once into $TROCAR_NODE_DIR (build/official_reader by
# default), never into the source tree. Exit status: 0 all sound, 1 not, 2 wrong
# usage, 77 (skipped) without node or npm unless CI=true.
set -eu
source_dir=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
work_dir=${TROCAR_NODE_DIR:-$source_dir/../../build/official_reader}

options=''
while [ $# -gt 0 ]; do
  case $1 in
    --json) options="$options --json"; shift ;;
    --max-ratio)
      [ $# -gt 1 ] || { echo "run.sh: --max-ratio needs a number, e.g. 1.1" >&2; exit 2; }
      options="$options --max-ratio $2"; shift 2 ;;
    -*) echo "run.sh: unknown option $1; there are --json and --max-ratio R" >&2; exit 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || { echo "usage: run.sh [--json] [--max-ratio R] FILE..." >&2; exit 2; }

"$source_dir/../support/npm_packages.sh" "$source_dir" "$work_dir"

status=0
for file in "$@"; do
  # shellcheck disable=SC2086  # options are words of ours
  node "$work_dir/check.mjs" $options -- "$file" || status=1
done
exit $status
