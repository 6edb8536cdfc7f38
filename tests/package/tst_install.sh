#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The installed tree: what is in it, that it can be moved, and that each header compiles alone.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh"
install_trocar
cd "$trocar" || exit 1

there() { ls -d "$@" >/dev/null; }
not_there() { ! ls -d "$@" 2>/dev/null; }
names_nothing_of_the_build() { ! grep -rIlF -e "$build" -e "$folder" .; }

expect "the program says the version" 0 "trocar $version" bin/trocar --version
expect "its libraries are those beside it" 0 "$trocar/$libdir/libtrocar_components.so" \
  bash -c "ldd bin/trocar | sed 's|bin/../||'"
expect "what watches is beside it" 1 "nobody answers at ws://127.0.0.1:1" bin/trocar watch 127.0.0.1:1 --stop
expect "so is the dashboard, which starts the command beside it" 0 "" env -u DISPLAY XDG_RUNTIME_DIR="$folder" \
  bin/trocar-dashboard share/trocar/scripts/tutorial/01_feel_a_wall.lua --screenshot "$folder/window.png" --after 3 \
  -- --black-box off
expect "its picture is one" 0 "PNG image data, 1280 x 720" file "$folder/window.png"
expect "a tutorial runs" 0 "no faults" bin/trocar run share/trocar/scripts/tutorial/01_feel_a_wall.lua \
  --for 2s --clock simulated
expect "documents, licence and package files are there" 0 "" there share/doc/trocar/{README.md,LICENSE,copyright} \
  share/doc/trocar/docs/architecture.md "$libdir"/{libtrocar.so,cmake/Trocar/TrocarConfig.cmake,pkgconfig/trocar.pc}
expect "what only developers of Trocar use is not" 0 "" not_there share/trocar/scripts/dev include/trocar/cli \
  include/trocar/framework/{cmake,scripting/lua_value.hpp,scripting/script_context.hpp}
expect "no file names the build or where it was installed" 0 "" names_nothing_of_the_build

# Each header compiles alone: one that its own source includes first did so in the build, if what it
# includes is installed as well; the others do so here.
cd include/trocar || exit 1
unresolved() {
  find . -name '*.hpp' -exec grep -H '^#include "' {} + |
    while IFS=: read -r header include; do
      include=${include#*\"}
      [ -f "${include%\"*}" ] || echo "$header includes ${include%\"*}, which is not installed"
    done
}
private() { grep -rnE '^#include <(lua|lauxlib|fmt/|nlohmann/|zlib|hidapi|CLI/|Q)' . || echo none; }
expect "headers include what is installed" 0 "" eval '! unresolved | grep .'
expect "headers ask for no library but Eigen" 0 "none" private
headers_without_source() {
  find * -name '*.hpp' | while read -r header; do
    source=$here/../../${header%.hpp}.cpp
    [ -f "$source" ] && [ "$(grep -m 1 '^#include' "$source")" = "#include \"$header\"" ] || echo "$header"
  done
}
alone() {
  headers_without_source | EIGEN=$(pkg-config --cflags eigen3) xargs -I HEADER -P 2 sh -c \
    'g++ -std=c++20 -fsyntax-only -Wall -Werror -I. $EIGEN -include HEADER -x c++ /dev/null || exit 255'
}
expect "headers without a source compile alone" 0 "" alone
expect "there are such headers" 0 "framework/tick.hpp" headers_without_source
cd "$trocar" || exit 1

export PKG_CONFIG_PATH=$trocar/$libdir/pkgconfig
cat >"$folder/version.cpp" <<'CODE'
#include <cstdio>

#include "components/register.hpp"
#include "framework/version.hpp"

int main() {
  trocar::Registry registry;
  trocar::register_components(registry);
  std::printf("%s has Wall: %d\n", trocar::version().c_str(), registry.find("Wall") != nullptr);
}
CODE
by_pkg_config() {
  g++ -std=c++20 "$folder/version.cpp" -o "$folder/version" $(pkg-config --cflags --libs trocar) &&
    LD_LIBRARY_PATH=$trocar/$libdir "$folder/version"
}
expect "pkg-config is enough to compile and link" 0 "$version has Wall: 1" by_pkg_config
compile() { g++ "$@" -fsyntax-only -Iinclude/trocar $(pkg-config --cflags eigen3) -x c++ include/trocar/framework/types.hpp; }
expect "a header takes the compiler's own flags" 0 "" compile -std=c++20
expect "a header refuses C++17" 1 "Trocar needs C++20 or newer" compile -std=c++17
expect "a header refuses another alignment" 1 "alignment is not the 16 bytes of Trocar's libraries" \
  compile -std=c++20 -DEIGEN_DONT_VECTORIZE
finish
