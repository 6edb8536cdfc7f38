#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian package: what it says of itself, and that what is in it runs where it is unpacked.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh"
cd "$folder" || exit 1
umask 077  # the package must not inherit it

deb=$folder/trocar_${version}_$(dpkg --print-architecture).deb
expect "cpack makes it" 0 "${deb##*/} generated." "$(dirname "$cmake")/cpack" -G DEB --config "$build/CPackConfig.cmake" -B "$folder"
expect "section" 0 "science" dpkg-deb -f "$deb" Section
expect "version" 0 "$version" dpkg-deb -f "$deb" Version
expect "maintainer has an address" 0 "Trocar maintainers <" dpkg-deb -f "$deb" Maintainer
expect "description" 0 "wired in Lua A Lua script says" dpkg-deb -f "$deb" Description
expect "the loader learns of the libraries" 0 "ldconfig" dpkg-deb -I "$deb" postinst
expect "everybody may read the folders" 0 "drwxr-xr-x root/root" dpkg-deb -c "$deb"
listed() { dpkg-deb -c "$deb" | awk '{ print $6 }'; }
for file in bin/trocar bin/trocar-dashboard "$libdir/libtrocar.so.$version" "$libdir/cmake/Trocar/TrocarConfig.cmake" \
  share/doc/trocar/copyright share/trocar/scripts/tutorial/01_feel_a_wall.lua include/trocar/framework/component.hpp; do
  expect "it holds $file" 0 " ./usr/$file " bash -c "echo \" \$($(declare -f listed); deb=$deb; listed) \""
done

dpkg -x "$deb" "$folder/root" || exit 1
cd "$folder/root/usr" || exit 1
expect "a tutorial runs from it" 0 "no faults" bin/trocar run share/trocar/scripts/tutorial/01_feel_a_wall.lua \
  --for 2s --clock simulated

# Each library that its files ask for belongs to a package that Depends names; what those libraries
# ask for in turn is the business of their packages.
depends=$(dpkg-deb -f "$deb" Depends)
files=(bin/trocar bin/trocar-dashboard "$libdir"/libtrocar*.so."$version")
asked=$(objdump -p "${files[@]}" | awk '/NEEDED/ && !/libtrocar/ { print $2 }' | sort -u)
for library in $(ldd "${files[@]}" | awk -v asked="$asked" 'index(asked, $1) && /=> \// { print $3 }' | sort -u); do
  # dpkg knows a file by the name that it was packed under, with /usr or without.
  package=$(dpkg -S "$library" "/usr$library" 2>/dev/null | sed -n '1s/:.*//p')
  expect "${library##*/} is in Depends as ${package:-?}" 0 "${package:-?} (" echo "$depends"
done
[ -n "${package:-}" ] || { echo "FAIL: ldd names no library"; failures=1; }
finish
