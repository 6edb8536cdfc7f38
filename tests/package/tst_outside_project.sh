#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A project of somebody else's, in a folder of its own, with a component of its own: built against
# an installed Trocar and run. docs/architecture.md shows its files.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh"
install_trocar
cp -r "$here/ball" "$folder/ball"
cd "$folder/ball" || exit 1

expect "it is configured" 0 "" "$cmake" -S . -B build -DCMAKE_PREFIX_PATH="$trocar" -DCMAKE_BUILD_TYPE=Release
expect "it compiles" 0 "" "$cmake" --build build
expect "it uses the installed libraries" 0 "$trocar/$libdir/libtrocar.so" ldd build/ball
expect "its script runs" 0 "no faults" build/ball ball.lua
expect "the report names the component's force" 0 "ball pushed hardest at" build/ball ball.lua

# The report ends with the published table: a line of names, a line of numbers.
same_force() {
  build/ball ball.lua | awk '
    { print }
    /^ball$/ { getline; split($0, name); getline; split($0, value) }
    END { exit !(name[1] == "expected" && name[2] == "force" && value[2] > 1 && value[1] == value[2]) }'
}
expect "the force is what the equation says" 0 "" same_force

sed 's/radius = "20 mm"/radius = "80 mm"/' ball.lua >wide.lua
expect "a parameter out of its range is refused" 2 'ball.radius = "80 mm": must be within 1–50 mm' build/ball wide.lua
sed 's/stiffness =/stifness =/' ball.lua >misspelt.lua
expect "a misspelt parameter is refused" 2 'did you mean "stiffness"?' build/ball misspelt.lua
expect "no script" 2 "usage: build/ball SCRIPT" build/ball
finish
