#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A stranger's plugin: the installed example, copied to a folder elsewhere, built there and loaded by
# the installed trocar; and what becomes of one that was built otherwise.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh"
install_trocar
cp -r "$trocar/share/trocar/plugins/example" "$folder/example"
cd "$folder/example" || exit 1
unset TROCAR_PLUGIN_PATH
program=$trocar/bin/trocar

# build FOLDER [ARGUMENT...]
build_plugin() {
  local into=$1
  shift
  "$cmake" -S . -B "$into" -DCMAKE_PREFIX_PATH="$trocar" -DCMAKE_BUILD_TYPE=Release "$@" >"$into.txt" 2>&1 &&
    "$cmake" --build "$into" >>"$into.txt" 2>&1 || { cat "$into.txt"; return 1; }
}
with() { TROCAR_PLUGIN_PATH=$1 "${@:2}"; }
exported() { nm -D --defined-only "$1" | awk '{ print "<" $3 ">" }' | paste -sd ' '; }
only_exported() { [ "$(exported "$1")" = "<$2>" ] || { exported "$1"; return 1; }; }

expect "it builds" 0 "" build_plugin build
expect "it exports one function" 0 "" only_exported build/example.so trocar_plugin
expect "it is not loaded unasked" 2 "there is no trocar.Groove" "$program" run groove.lua --clock simulated
expect "it is listed" 0 "example 1.0.0: A fixture and a simulated device" with build "$program" list plugins
expect "with what it brings" 0 "components Groove, Slider" with build "$program" list plugins
expect "its component runs" 0 "no faults" with build "$program" run groove.lua --clock simulated
expect "its device runs behind the gate" 0 "no faults" with build "$program" run slider.lua --clock simulated

# Installed under the same prefix it is found by itself, also when all of it is moved.
expect "it is installed" 0 "/$libdir/trocar/plugins/example.so" "$cmake" --install build --prefix "$trocar"
expect "and found" 0 "no faults" "$program" run groove.lua --clock simulated
mv "$trocar" "$folder/moved"
expect "and found elsewhere" 0 "$folder/moved/$libdir/trocar/plugins/example.so" "$folder/moved/bin/trocar" list plugins
mv "$folder/moved" "$trocar"
rm "$trocar/$libdir/trocar/plugins/example.so"

# Built against the headers of a newer Trocar, as if one was installed beside ours.
mkdir -p newer/framework
sed 's/\(VERSION_MINOR\) .*/\1 99/' "$trocar/include/trocar/framework/version.hpp" >newer/framework/version.hpp
expect "one of another version builds" 0 "" build_plugin newer/build -DCMAKE_CXX_FLAGS="-I$PWD/newer"
refusal="built with Trocar ${version%%.*}.99.${version##*.}, this is $version: rebuild it with find_package(Trocar ${version%.*})"
expect "it is refused with the cure" 0 "$refusal" with newer/build "$program" list plugins
expect "a script that needs it is told so" 2 "$refusal" with newer/build "$program" run groove.lua --clock simulated
expect "any other runs" 0 "no faults" with newer/build "$program" run \
  "$trocar/share/trocar/scripts/tutorial/01_feel_a_wall.lua" --for 1s --clock simulated

if command -v clang++-14 >/dev/null && [ "$("$cmake" -LA -N "$build" | sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' | grep -c clang)" = 0 ]; then
  expect "one of another compiler builds" 0 "" build_plugin clang -DCMAKE_CXX_COMPILER=clang++-14
  expect "it is refused as well" 0 "built with Clang 14, Trocar with GNU " with clang "$program" list plugins
fi
finish
