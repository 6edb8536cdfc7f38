#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Puts the programs (*.mjs) of a folder beside the packages that they need:
# npm_packages.sh SOURCE WORK. The packages of SOURCE's lockfile are installed once
# into WORK, never into the source tree. Exit status: 0 ready, 77 (skipped) without
# node or npm unless CI=true.
set -eu
source_dir=$1 work_dir=$2

for tool in node npm; do
  command -v "$tool" >/dev/null && continue
  echo "$tool is missing; install it with: apt-get install nodejs npm" >&2
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
