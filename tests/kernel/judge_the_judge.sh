#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Spoils a transcript of the kernel test, each time in one place, and wants the judge to see it:
# judge_the_judge.sh JUDGE TRANSCRIPT
set -eu
judge=$1 transcript=$2
[ -f "$transcript" ] || { echo "SKIPPED: there is no transcript of a run"; exit 77; }
spoilt=$(mktemp)
trap 'rm -f "$spoilt"' EXIT
export TROCAR_KERNEL_TRANSCRIPT=$spoilt
failed=0

cp "$transcript" "$spoilt"
"$judge" >/dev/null 2>&1 || { echo "it refuses the transcript as it is"; failed=1; }

# refuses TEST SED: the test of this name fails when the transcript is edited so.
refuses() {
  local said
  sed -E "$2" "$transcript" >"$spoilt"
  if cmp -s "$transcript" "$spoilt"; then
    echo "nothing in it is as $2 expects"
    failed=1
  elif said=$("$judge" 2>&1); then
    echo "taken, though spoilt by $2"
    failed=1
  elif ! grep -q "^FAIL!.*$1" <<<"$said"; then
    echo "refused, but not by $1: $2"
    failed=1
  else
    echo "refused by $1: $2"
  fi
}

refuses everything_was_tried '/^@done/d'
refuses everything_was_tried 's/^@rate/@failed: it does not hold\n@rate/'
refuses the_device_is_found '/^@begin devices.json/,/^@end/s/1209/1208/'
refuses who_may_not_open_it_is_told_the_cure '/^@begin doctor_nobody/,/^@end/s/udevadm/other/g'
refuses limits_that_a_cure_raises_are_raised 's/^PASS   : TestDoctor::their/SKIP   : TestDoctor::their/'
refuses it_renders_undisturbed '/^@begin undisturbed.json/,/^@end/s/"lost": 0[.0]*/"lost": 400/'
refuses it_renders_undisturbed '/^@begin undisturbed.json/,/^@end/s/"skipped": [0-9]+/"skipped": 4000/'
refuses "over_in_time(silence)" '/^@begin faults.json/,/^@end/s/"no reports"/"reports repeated"/'
refuses "over_in_time(unplug)" 's/"unplugged"/"no reports"/'
refuses "over_in_time(stuck)" '/^@state stuck/s/zero [0-9.]+ ms/zero 10.25 ms/'
refuses "over_in_time(deaf)" '/^@state deaf/s/and [0-9.]+ ms/and 8.50 ms/'
refuses "over_in_time(jump)" '/^@state jump/s/, effort zero.*//'
refuses too_hot '/^@state heat/s/$/, effort zero 1.00 ms after the last good report and 1.00 ms after the last command/'
refuses "watchdog(killed)" '/^@state killed/s/of watchdog/of speed/'
refuses renders_again '/^@state again/s/engaged/ready/'
refuses nothing_else 's/^@asked deaf .*/@asked deaf 0.5/'
exit $failed
