#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs driver and emulated device on a kernel of Debian's, in QEMU: boot.sh BUILD TRANSCRIPT
#
# What the guest writes to its serial line goes to the file TRANSCRIPT. From the environment:
#   TROCAR_KERNEL_FLAVOUR  amd64, or rt-amd64: PREEMPT_RT
#   TROCAR_KERNEL_SECONDS  how long it renders undisturbed, 10 at first
#   TROCAR_KERNEL_CLOCK    counted: the guest's time is that of its instructions, 1 ns each, whatever
#                          this machine does beside it; host: this machine's time
# Exit status 77: QEMU or the packages cannot be had here.
set -eu
build=$(cd "$1" && pwd) transcript=$2
flavour=${TROCAR_KERNEL_FLAVOUR:-amd64} seconds=${TROCAR_KERNEL_SECONDS:-10} clock=${TROCAR_KERNEL_CLOCK:-counted}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cache=$build/kernel

command -v qemu-system-x86_64 >/dev/null || {
  echo "SKIPPED: there is no qemu-system-x86_64 (Debian's qemu-system-x86; scripts/dev/setup kernel)" >&2
  exit 77
}
case $clock in
  counted) clock_options="-icount shift=0,sleep=off" ;;
  host) clock_options= ;;
  *) echo "TROCAR_KERNEL_CLOCK=$clock: counted and host are possible" >&2; exit 2 ;;
esac

kernel=$("$here/fetch.sh" "$flavour" "$cache")
image=$(mktemp "$cache/image.XXXXXX")
trap 'rm -f "$image" "$transcript.part"' EXIT
"$here/image.sh" "$kernel" "$cache/busybox-static" "$build" "$image"

# The generic emulation and not KVM: that may be there and still not start this kernel, and its time
# cannot be counted.
# shellcheck disable=SC2086
timeout "$((1200 + 60 * seconds))" qemu-system-x86_64 -accel tcg -cpu qemu64 -smp 1 -m 512 -M pc $clock_options \
  -nodefaults -display none -no-reboot -serial "file:$transcript.part" \
  -kernel "$(echo "$kernel"/boot/vmlinuz-*)" -initrd "$image" \
  -append "console=ttyS0 quiet edd=off panic=-1 reboot=t mitigations=off trocar.seconds=$seconds" \
  </dev/null || echo "QEMU ended with $?, or did not end in time" >&2
tr -d '\r' <"$transcript.part" >"$transcript"
