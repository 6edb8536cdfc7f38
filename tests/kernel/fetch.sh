#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Brings a kernel of Debian's and a shell for it, without installing them: fetch.sh FLAVOUR DIR
#
# FLAVOUR is amd64 or rt-amd64. DIR keeps what was fetched; the folder of the kernel is printed. Exit
# status 77: this machine has no apt, or apt has no such package and cannot fetch one.
set -eu
flavour=$1 cache=$2
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/dev/setup"

skip() {
  echo "SKIPPED: $*" >&2
  exit 77
}

# The package without a version depends on the one that has it.
kernel_package() {
  apt-cache depends "linux-image-$flavour" 2>/dev/null |
    sed -n 's/^ *Depends: *\(linux-image-[0-9].*\)$/\1/p' | head -n 1
}

# unpack PACKAGE FOLDER: through a folder beside it, so that one that is there is whole.
unpack() {
  local package=$1 folder=$2 part
  [ ! -d "$folder" ] || return 0
  part=$(mktemp -d "$cache/part.XXXXXX")
  # shellcheck disable=SC2064  # the name as it is now
  trap "rm -rf '$part'" EXIT
  (cd "$part" && apt-get download -qq "$package" >log 2>&1 && dpkg -x ./*.deb root) ||
    skip "apt-get cannot download $package: $(tail -n 1 "$part/log" 2>/dev/null)"
  mv "$part/root" "$folder"
  rm -rf "$part"
}

mkdir -p "$cache"
command -v apt-get >/dev/null || skip "kernel and shell come as Debian packages, and this machine has no apt-get"
package=$(kernel_package)
if [ -z "$package" ] && words=$(root_words); then
  $words apt-get update -qq </dev/null >/dev/null 2>&1 || true
  package=$(kernel_package)
fi
[ -n "$package" ] || skip "apt knows no linux-image-$flavour; try apt-get update"
unpack busybox-static "$cache/busybox-static"
unpack "$package" "$cache/$package"
echo "$cache/$package"
