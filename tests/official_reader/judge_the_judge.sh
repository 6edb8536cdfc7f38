#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Judges the judge, with the logs of make_logs in DIR: it reads the right values, and it
# can say no. judge_the_judge.sh DIR
set -eu
run=$(dirname -- "$0")/run.sh
failed=0

refuses() { # FILE REASON [OPTION...]
  file=$1 reason=$2
  shift 2
  status=0
  said=$("$run" "$@" "$file" 2>&1) || status=$?
  [ "$status" -eq 77 ] && { echo "$said"; exit 77; }
  case "$status $said" in
    "1 "*"$reason"*) echo "refused: $(basename "$file") ($reason)" ;;
    *) echo "status $status instead of 1, or not because of '$reason': $said"; failed=1 ;;
  esac
}

refuses "$1/cut.mcap" "ends early"
refuses "$1/flipped.mcap" "CRC"
refuses "$1/wrong_schema.mcap" "/rows: message 0 is not as its schema says"
refuses "$1/good.mcap" "times its payload" --max-ratio 1.01
refuses "$1/none.mcap" "no such file"

values=$(mktemp)
trap 'rm -f "$values"' EXIT
"$run" --json "$1/good.mcap" >"$values"
node "$(dirname -- "$0")/values.mjs" <"$values" || failed=1
exit $failed
