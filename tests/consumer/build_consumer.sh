#!/usr/bin/env bash
# Installs the library into a temporary folder, builds a small program against the installed package and runs it, a game where SDL is there, and one in C
# against the shared library where there is one; then builds the first program with the library as a part of its tree.
#   build_consumer.sh <build tree> <consumer> <compiler> <its flags> <source tree> [whole]
# A part of a tree is compiled as far as the program's own code; "whole" links and runs that too, which compiles the library once more.
set -euo pipefail
build=$1
consumer=$2
compiler=$3
flags=$4
source=$5
whole=${6:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly() {
    "$@" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
}
configure() { # <build folder> <definitions>...
    quietly cmake -G Ninja -S "$consumer" -B "$@" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags"
}

echo "-- installed"
quietly cmake --install "$build" --prefix "$work/installed"
headers=$(cd "$work/installed/include" && find fumage -name '*.h' | sort | paste -sd ';')
configure "$work/find" -DCMAKE_PREFIX_PATH="$work/installed" -DHEADERS="$headers"
quietly cmake --build "$work/find"
"$work/find/consumer"
if [ -x "$work/installed/bin/fumage-cli" ]; then
    "$work/installed/bin/fumage-cli" --version
fi
strangers=$(find "$work/installed/include" -name '*-inl.h' -o -name '*_kernel.h' -o -path '*/core/*')
[ -z "$strangers" ] || { echo "headers that are nobody's business: $strangers"; exit 1; }
if grep -rn '#include "core/' "$work/installed/include"; then
    exit 1
fi

for shader in sprite.vert sprite.frag; do
    cmp "$source/resources/shaders/$shader" "$work/installed/share/fumage/glsl/$shader"
done

if [ -x "$work/find/game" ]; then
    echo "-- a game with SDL"
    for frames in 1 90; do
        SDL_VIDEODRIVER=dummy "$work/find/game" chimney $frames "$work/$frames.bmp"
        [ "$(head -c 2 "$work/$frames.bmp")" = BM ] || { echo "the game has kept no picture"; exit 1; }
    done
    if cmp -s "$work/1.bmp" "$work/90.bmp"; then
        echo "the game shows no smoke"
        exit 1
    fi
fi

pc=$(find "$work/installed" -name fumage.pc)
if [ -n "$pc" ]; then
    echo "-- in C"
    export PKG_CONFIG_PATH=${pc%/*}
    library=$(pkg-config --variable=libdir fumage)
    # shellcheck disable=SC2046 # options are words
    quietly "${CC:-cc}" -std=c11 -Wall -Wextra -pedantic -Werror "$consumer/smoke.c" -o "$work/smoke" $(pkg-config --cflags --libs fumage)
    LD_LIBRARY_PATH=$library "$work/smoke"
    # shellcheck disable=SC2046 # options are words
    quietly "${CC:-cc}" -std=c11 -Wall -Wextra -pedantic -Werror "$consumer/torch.c" -o "$work/torch" $(pkg-config --cflags --libs fumage) -lm
    LD_LIBRARY_PATH=$library "$work/torch" > "$work/torch.txt" || { cat "$work/torch.txt"; exit 1; }
    for letter in '#' '[.]' '[*]'; do
        grep -q "$letter" "$work/torch.txt" || { echo "the torch lacks $letter:"; cat "$work/torch.txt"; exit 1; }
    done
    [ -f "$(pkg-config --variable=glsldir fumage)/sprite.frag" ] || { echo "pkg-config does not know where the shaders are"; exit 1; }
    if LD_LIBRARY_PATH=$library "$work/smoke" chimny 2> "$work/log" || ! grep -q chimney "$work/log"; then
        echo "a wrong name is not told with the right one:"
        cat "$work/log"
        exit 1
    fi
    readelf -d "$work/smoke" | grep 'NEEDED.*libfumage\.so\.[0-9]' > /dev/null || { echo "the shared library has no version in its name"; exit 1; }
    strangers=$(nm -D --defined-only "$library/libfumage.so" | awk '$2 != "A" && $3 !~ /^fumage_/')
    [ -z "$strangers" ] || { echo "the shared library exports what is nobody's business: $strangers"; exit 1; }
fi

echo "-- as a part of a tree"
configure "$work/part" -DFUMAGE_AS_SUBPROJECT="$source"
if grep -E '^FUMAGE_(BUILD_.*|INSTALL):BOOL=(ON|TRUE)' "$work/part/CMakeCache.txt"; then
    echo "programs, tests and installation are on although the project is not top level"
    exit 1
fi
if grep -rq -e -Werror "$work/part/build.ninja"; then
    echo "warnings are errors although nobody asked for it"
    exit 1
fi
if [ -n "$whole" ]; then
    quietly cmake --build "$work/part"
    "$work/part/consumer"
else
    quietly cmake --build "$work/part" --target consumer_code
fi
