#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The live stream before the client of its protocol's authors: run.sh TROCAR SCRIPT [SECONDS]
# Exit status: 0 sound, 1 not, 77 (skipped) without node or npm unless CI=true.
set -eu
source_dir=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
work_dir=${TROCAR_NODE_DIR:-$source_dir/../../build/stream_client}
trocar=$1 script=$2 seconds=${3:-10}

"$source_dir/../support/npm_packages.sh" "$source_dir" "$work_dir"
cd "$work_dir"
rm -f stream.mcap served.txt
"$trocar" run "$script" --serve 127.0.0.1:0 --wait --record stream.mcap --black-box off >report.txt 2>served.txt &
process=$!
trap 'kill $process 2>/dev/null || true' EXIT
until grep -q '^serving ws:' served.txt; do
  kill -0 $process || { cat served.txt; exit 1; }
  sleep 0.1
done
url=$(sed -n 's/^serving \(ws:[^ ]*\).*/\1/p' served.txt)
status=0
timeout $((seconds + 60)) node client.mjs "$url" stream.mcap "$seconds" || status=1
wait $process || true
cat report.txt
exit $status
