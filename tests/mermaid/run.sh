#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Has Mermaid's own parser read flowcharts; check.mjs tells which.
#   run.sh FILE.md...                documents
#   run.sh FILE.mmd FILE.txt         a picture of one box with this text
#   run.sh TROCAR SCRIPT.lua...      what `trocar graph` draws of scripts
# Exit status: 0 all sound, 1 not, 77 (skipped) without node or npm unless CI=true.
set -eu
source_dir=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
work_dir=${TROCAR_NODE_DIR:-$source_dir/../../build/mermaid}
"$source_dir/../support/npm_packages.sh" "$source_dir" "$work_dir"

case $1 in
  *.md | *.mmd) exec node "$work_dir/check.mjs" "$@" ;;
esac
trocar=$1
shift
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT
for script in "$@"; do
  name=$(basename "$script" .lua)
  for format in mermaid:mmd json:json; do
    "$trocar" graph "$script" --format "${format%:*}" -o "$pictures/$name.${format#*:}"
  done
  node "$work_dir/check.mjs" "$pictures/$name.mmd" "$pictures/$name.json"
done
