#!/usr/bin/env bash
# ./dev on machines that are not as it would like them: no root, no sudo, no apt, no compiler.  check_dev.sh <source tree>
set -euo pipefail
source=$1
machine=$(mktemp -d)
trap 'rm -rf "$machine"' EXIT

tool() { # <name> <what it does>
    printf '#!/bin/bash\n%s\n' "$2" > "$machine/$1"
    chmod +x "$machine/$1"
}
expect() { # <exit code> <text>...
    local code=0 output
    output=$(PATH=$machine "$machine/bash" "$source/dev" setup 2>&1) || code=$?
    [ "$code" -eq "$1" ] || { echo "exit code $code instead of $1: $output"; exit 1; }
    shift
    for text in "$@"; do
        [[ $output == *"$text"* ]] || { echo "it does not say '$text': $output"; exit 1; }
    done
}

for each in bash dirname grep mkdir ln touch ls cat chmod tail; do
    ln -s "$(command -v $each)" "$machine/$each"
done
tool id 'echo 1000'
tool cmake ''
tool ninja ''

echo "-- no apt, but the tools are there"
expect 0 'This system has no apt' 'libpng-dev'
echo "-- nothing is installed, and there is no sudo"
tool dpkg-query 'exit 1'
tool apt-get 'echo apt-get was called; exit 1'
expect 0 'As root:  apt-get install --no-install-recommends cmake ninja-build' 'Going on'
echo "-- sudo does not let one in"
tool sudo 'echo no >&2; exit 1'
expect 0 'That did not work. As root:  apt-get install' 'Going on'
echo "-- everything is installed"
tool dpkg-query 'echo install ok installed'
expect 0
echo "-- no cmake"
rm "$machine/cmake"
expect 1 'needs cmake, which is not here'

# A tree of its own, in which cmake builds a program that says its words.
tree=$machine/tree
mkdir "$tree"
cp "$source/dev" "$tree"
touch "$tree/CMakePresets.json"
tool cmake '
case $* in
"--preset "*) mkdir -p "build/$2"; touch "build/$2/build.ninja" "build/$2/CMakeCache.txt" ;;
"--build --preset "*)
    mkdir -p "build/$3/bin"
    printf "#!/bin/bash\necho $3 \"\$@\"\nmkdir -p out/demo\ntouch out/demo/picture.png\n" > "build/$3/bin/fumage-cli"
    chmod +x "build/$3/bin/fumage-cli"
    ;;
esac'
says() { # <text> <command>...
    local text=$1 output
    shift
    output=$(cd "$tree" && env -i PATH="$machine" "$machine/bash" -c "$*" 2>&1) || { echo "$* failed: $output"; exit 1; }
    [[ $output == *"$text"* ]] || { echo "$* does not say '$text': $output"; exit 1; }
}
echo "-- the programs are where the README says, whatever was built"
says 'build/bin/fumage-cli presets' ./dev run
says 'package presets' build/bin/fumage-cli presets
says '' ./dev build
says 'release presets' build/bin/fumage-cli presets
says 'release render' ./dev run
says '' ./dev build debug
says 'release presets' build/bin/fumage-cli presets

echo "-- called from another folder"
tool fumage 'echo "opens $*"'
cp "$machine/fumage" "$tree/build/release/bin"
says "opens $tree/build/../smoke.json /smoke.json --verbose" 'cd build; DISPLAY=:9 ../dev run ../smoke.json /smoke.json --verbose'
mkdir -p "$machine/decoy/tree"
says "opens /smoke.json" 'cd ..; export CDPATH=$PWD/decoy DISPLAY=:9; tree/dev run /smoke.json'
for call in 'tree/dev' 'bash tree/dev'; do
    says 'build_consumer.sh: No such file' "cd ..; $call check subproject || cat tree/build/check/subproject.log"
done
echo "-- presets without tests are not said to be good"
for each in 'package package' 'fuzz fuzz' 'windows test-windows' 'windows-editor test-windows --editor'; do
    code=0
    output=$(cd "$tree" && env -i PATH="$machine" ./dev test "${each%% *}" 2>&1) || code=$?
    [ "$code" -eq 2 ] || { echo "./dev test ${each%% *} ends with $code: $output"; exit 1; }
    [[ $output == "The preset ${each%% *} has no tests."*"./dev ${each#* }" ]] || { echo "./dev test ${each%% *} says: $output"; exit 1; }
done
# Those that build none are these.
awk -F'"' '/"name":/ { name = $4 } /"FUMAGE_BUILD_TESTS": "OFF"/ { print name }' "$source/CMakePresets.json" > "$machine/without"
[ "$(sort "$machine/without" | tr '\n' ' ')" = 'fuzz package windows ' ] || { echo "presets without tests: $(cat "$machine/without")"; exit 1; }
echo "-- under a sanitizer run the tests that can, with what it has to be told"
for each in comm sed sort; do
    ln -s "$(command -v $each)" "$machine/$each"
done
tool ctest 'echo "ctest $* $TSAN_OPTIONS"'
says '-LE unsanitized|unthreaded suppressions=' './dev test tsan'
echo "-- packages are everybody's to read, whatever is usual here"
for each in help2man rsvg-convert dpkg-shlibdeps xdotool man zsh readelf file lintian patchelf qmake6 rm; do
    tool $each ''
done
tool cpack 'umask; exit 1'
says '0022' 'umask 077; ./dev package || true'
