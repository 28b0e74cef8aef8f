#!/usr/bin/env bash
# Installs the library into a temporary folder, builds a small program against the installed package and runs it.
set -euo pipefail
build=$1
source=$2
compiler=$3
flags=$4
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$build" --prefix "$prefix/installed" > "$prefix/log"
cmake -S "$source" -B "$prefix/build" -DCMAKE_PREFIX_PATH="$prefix/installed" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" > "$prefix/log" || { cat "$prefix/log"; exit 1; }
cmake --build "$prefix/build" > "$prefix/log" || { cat "$prefix/log"; exit 1; }
"$prefix/build/consumer"
"$prefix/installed/bin/fumage-cli" --version
