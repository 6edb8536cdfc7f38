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

for tool in node npm; do
  command -v "$tool" >/dev/null && continue
  echo "run.sh: $tool is missing; install it with: apt-get install nodejs npm" >&2
  [ "${CI:-}" = true ] && exit 1
  exit 77
done

mkdir -p "$work_dir"
exec 9>"$work_dir/.lock"  # tests may run side by side
flock 9
wanted=$(cd "$source_dir" && cat package.json package-lock.json .npmrc | sha256sum)
if [ "$(cat "$work_dir/.installed" 2>/dev/null || true)" != "$wanted" ]; then
  rm -f "$work_dir/.installed"
  cp "$source_dir/package.json" "$source_dir/package-lock.json" "$source_dir/.npmrc" "$work_dir/"
  (cd "$work_dir" && npm ci --ignore-scripts --loglevel=error >&2)
  echo "$wanted" >"$work_dir/.installed"
fi
cp "$source_dir"/*.mjs "$work_dir/"  # node looks for packages beside the program
exec 9>&-

status=0
for file in "$@"; do
  # shellcheck disable=SC2086  # options are words of ours
  node "$work_dir/check.mjs" $options -- "$file" || status=1
done
exit $status
