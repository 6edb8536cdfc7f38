#!/bin/busybox sh
# SPDX-License-Identifier: Apache-2.0
# What happens on the emulated machine, and what was seen of it: scenario.sh UDC
#
# Lines that begin with @ are for the judge, tst_kernel: "@state NAME" with what the emulated device
# said of itself, "@asked NAME TIME" with the time of the run at which something was done to it, and
# files between "@begin NAME" and "@end NAME". All else is for people.
udc=$1
seconds=$(sed -n 's/.*trocar[.]seconds=\([0-9]*\).*/\1/p' /proc/cmdline)
cd /tmp || exit

# How far it got, for who watches.
now() { echo "@time $(cut -d" " -f1 /proc/uptime)"; }

show() { # NAME: the file of that name
  echo "@begin $1"
  cat "$1"
  echo
  echo "@end $1"
}

# wait_for SECONDS COMMAND...: until it succeeds.
wait_for() {
  local left=$(($1 * 20))
  shift
  until "$@"; do
    left=$((left - 1))
    [ $left -gt 0 ] || return 1
    usleep 50000
  done
}

# --- The device: orders go through descriptor 8.
start_device() { # [TROCAR EMULATE ARGUMENTS]
  rm -f orders
  mkfifo orders
  exec 8<>orders
  trocar emulate --gadget /dev/hidg0 --udc "$udc" --period "$((1000000 / rate))us" "$@" <orders >device.txt 2>&1 &
  device=$!
  wait_for 10 grep -qs quit device.txt
}
stop_device() {
  order quit
  wait $device
  exec 8>&-
}
order() { echo "$1" >&8; }
answered() { [ "$(wc -l <device.txt)" -gt "$lines" ]; }
state() {
  lines=$(wc -l <device.txt)
  order state
  wait_for 5 answered || echo "@failed: the device does not answer"
  tail -n 1 device.txt
}
state_is() { # PATTERN
  case $(state) in $1) return 0 ;; esac
  return 1
}
holds() {
  case $(state) in
    *braked* | *"effort zero"*) return 1 ;;
    ready*) return 0 ;;
  esac
  return 1
}

# --- The run: lines for its console go through descriptor 9.
start_run() { # NAME
  rm -f console
  mkfifo console
  exec 9<>console
  trocar run /trocar/render.lua --clock device --console --black-box off --set laparoscope.device=hid \
    --set rate="\"$rate Hz\"" --set duration='"3000 s"' --json "$1.json" <console >"$1.txt" 2>&1 &
  run=$!
  said=$1.txt
  wait_for 10 run_time >/dev/null || { echo "@failed: the run $1 does not begin"; cat "$said"; }
}
ask() { echo "$1" >&9; }
rows() { grep -c ' at [0-9.]* s$' "$said"; }
told() { [ "$(rows)" -gt "$known" ]; }
run_time() { # of the run, as the row of a signal tells it
  known=$(rows)
  ask laparoscope.device.scale
  wait_for 1 told || return 1
  sed -n 's/.* at \([0-9.]*\) s$/\1/p' "$said" | tail -n 1
}
end_run() {
  ask end
  wait $run
  exec 9>&-
}

# From whatever there is to rendering, as an operator would do it.
engage() {
  if state_is "unhomed*" || state_is "fault of encoder jump*"; then
    ask home
    wait_for 5 state_is "ready*" || echo "@failed: it is not homed: $(state)"
  fi
  local tries=0
  until holds; do
    ask acknowledge
    usleep 300000
    tries=$((tries + 1))
    [ $tries -lt 20 ] || { echo "@failed: it does not hold: $(state)"; return; }
  done
  ask acknowledge
  usleep 100000
  ask engage
  wait_for 10 state_is "engaged*" || echo "@failed: it does not render: $(state)"
  usleep 600000
}

# What is done to a device that renders, and undone. fault NAME DO UNDO, both in this shell.
fault() {
  now
  echo "@asked $1 $(run_time)"
  eval "$2"
  usleep 200000
  echo "@state $1 $(state)"
  eval "$3"
  engage
}

# Undisturbed: the hand pushes the tool into the wall.
undisturbed() {
  start_device --set hand=push --set "push_start=2 s"
  trocar run /trocar/render.lua --clock device --black-box off --set laparoscope.device=hid --set engage=true \
    --set rate="\"$rate Hz\"" --set duration="\"$((seconds + 4)) s\"" --json undisturbed.json </dev/null >undisturbed.txt 2>&1
  local status=$?
  echo "@state undisturbed $(state)"
  stop_device
  return $status
}

echo "@kernel $(uname -r) $(uname -v)"
wait_for 10 test -e /dev/hidraw0 || echo "@failed: the kernel sees no device"
trocar devices --json >devices.json
trocar doctor --json >doctor.json
su nobody -c 'trocar doctor --json' >doctor_nobody.json
chmod 0666 /dev/hidraw0
su nobody -c 'trocar doctor --json' >doctor_cured.json
chmod 0600 /dev/hidraw0
for name in devices doctor doctor_nobody doctor_cured; do show $name.json; done
tst_doctor their_cures_work >cures.txt 2>&1
show cures.txt

# The fastest that this machine can do.
for rate in 1000 500; do
  undisturbed && break
  echo "@slower $rate"
  sed 's/^/  /' undisturbed.txt
done
now
echo "@rate $rate"
show undisturbed.txt
show undisturbed.json

start_device --set hand=firm
start_run faults
engage
fault silence 'order "loss 100%"' 'order "loss 0%"'
fault corruption 'order "corrupt 100%"' 'order "corrupt 0%"'
fault delay 'order "delay 9ms"' 'order "delay 0ms"'
fault stuck 'order "stuck on"' 'order "stuck off"'
fault jump 'order "jump 2 40000"' ''
fault heat 'order "heat 130"' 'order "heat 30"'
fault deaf 'order "deaf on"' 'order "deaf off"'
fault unplug 'order unplug' 'order plug; wait_for 5 test -e /dev/hidraw0; usleep 500000'
fault stopped 'kill -STOP $run' 'kill -CONT $run'
echo "@state again $(state)"
end_run
show faults.json
tail -n 5 faults.txt

start_run killed
engage
echo "@state rendering $(state)"
kill -KILL $run
wait $run
usleep 300000
echo "@state killed $(state)"
stop_device
now
echo "@done"
