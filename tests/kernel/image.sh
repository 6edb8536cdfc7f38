#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Packs what the kernel finds when it starts: image.sh KERNEL BUSYBOX BUILD FILE
#
# KERNEL and BUSYBOX are unpacked packages, BUILD a build folder. Not compressed: an emulated
# processor would take longer to unpack it than this one to read it.
set -eu
kernel=$1 busybox=$(echo "$2"/*bin/busybox "$2"/usr/*bin/busybox | tr ' ' '\n' | grep -v '\*' | head -n 1)
build=$3 file=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(mktemp -d)
chmod 755 "$root"  # the guest's other users go through it
trap 'rm -rf "$root"' EXIT

# In the order in which they need each other; the USB gadget, its controller that is its own cable,
# and the host's side.
modules="configfs usb-common usbcore udc-core libcomposite usb_f_hid dummy_hcd hid hid-generic usbhid"

mkdir -p "$root"/{bin,dev,etc,lib64,proc,root,sys,tmp,trocar}
echo 'root:x:0:0::/root:/bin/sh
nobody:x:65534:65534::/:/bin/sh' >"$root/etc/passwd"
echo 'root:x:0:
plugdev:x:46:
nogroup:x:65534:' >"$root/etc/group"
cp "$busybox" "$root/bin/busybox"
for module in $modules; do
  found=$(find "$kernel" -name "$module.ko*" | head -n 1)
  [ -n "$found" ] || { echo "$(basename "$kernel") has no module $module" >&2; exit 1; }
  case $found in
    *.xz) xz -dc "$found" >"$root/trocar/$module.ko" ;;
    *) cp "$found" "$root/trocar/$module.ko" ;;
  esac
  echo "$module" >>"$root/trocar/modules"
done

# Programs, and the libraries that the loader of this machine finds for them, at the same places but
# for those of the build.
for program in trocar tst_doctor; do
  cp "$build/bin/$program" "$root/bin/"
  ldd "$build/bin/$program" | sed -nE 's/^.*(=> |\t)(\/[^ ]+) \(0x.*$/\2/p'
done | sort -u >"$root/trocar/libraries"
while read -r library; do
  case $library in
    */ld-linux*) cp -L "$library" "$root/lib64/" ;;
    *) cp -L "$library" "$root/trocar/" ;;
  esac
done <"$root/trocar/libraries"
cp "$here"/guest/* "$here/../../scripts/tutorial/01_feel_a_wall.lua" "$root/trocar/"
mv "$root/trocar/init" "$root/init"
chmod +x "$root/init"
(cd "$root" && find . | "$root/bin/busybox" cpio -o -H newc 2>/dev/null) >"$file"
