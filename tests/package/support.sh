# SPDX-License-Identifier: Apache-2.0
# Sourced by the tests here, with their arguments: cmake, the build, the folder of libraries, the version.
set -u
cmake=$1 build=$2 libdir=$3 version=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trocar=$folder/trocar
failures=0
unset LD_LIBRARY_PATH CMAKE_PREFIX_PATH Trocar_DIR CXXFLAGS

# Installed to one place and moved to another: nothing may know where it was.
install_trocar() {
  "$cmake" --install "$build" --prefix "$folder/first" >"$folder/install.txt" 2>&1 ||
    { cat "$folder/install.txt"; exit 1; }
  mv "$folder/first" "$trocar"
}

# expect WHAT STATUS PIECE COMMAND...: its status, and a piece of what it says; lines are joined,
# since CMake breaks them.
expect() {
  local what=$1 status=$2 piece=$3 said got=0
  shift 3
  said=$("$@" 2>&1 </dev/null) || got=$?
  if [ "$got" = "$status" ] && [[ $(tr -s ' \n' ' ' <<<"$said") == *"$piece"* ]]; then
    echo "PASS: $what"
  else
    echo "FAIL: $what: status $got, wanted $status and \"$piece\" in:"
    echo "$said"
    failures=$((failures + 1))
  fi
}

finish() {
  [ $failures = 0 ] || echo "$failures failed"
  exit $((failures > 0))
}
