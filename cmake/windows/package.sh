#!/usr/bin/env bash
# Packs what is built into a zip that needs no installation and an installer for one user, in <build>/packages.  package.sh <build>
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$here/../..
build=$(realpath "$1")
parts=$source/build/windows-parts
qt=$source/build/windows-qt
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=Fumage-$version-windows-x64
stage=$build/stage/Fumage-$version
packages=$build/packages
rm -rf "$build/stage" "$packages"
mkdir -p "$stage" "$packages"

for component in editor cli; do
    cmake --install "$build" --component "$component" --prefix "$stage" > "$build/install.log"
done
x86_64-w64-mingw32-strip "$stage"/*.exe
windows_text() { sed 's/\r*$/\r/' "$1"; }
windows_text "$source/LICENSE" > "$stage/LICENSE.txt"
mkdir "$stage/licences"
for text in "$parts"/licences/*.txt "$qt"/licences/*.txt; do
    windows_text "$text" > "$stage/licences/$(basename "$text")"
done
# GCC's and mingw-w64's libraries are within the programs, too.
for package in gcc-mingw-w64-base mingw-w64-common; do
    windows_text "/usr/share/doc/$package/copyright" > "$stage/licences/$package.txt"
done
windows_text <(sed "s/@VERSION@/$version/; s/@QT@/$(cat "$qt/made")/" "$here/README.txt.in") > "$stage/README.txt"
find "$stage" -type d -empty -delete

makensis -V2 -NOCD -INPUTCHARSET UTF8 -DVERSION="$version" -DSTAGE="$stage" -DICON="$build/app/editor/fumage.ico" -DOUT="$packages/$name-setup.exe" "$here/installer.nsi"

# What is in it stays the same while nothing changes: entries in order, with the time of the last commit.
mkdir "$stage/fumage-data"
windows_text "$here/fumage-data.txt" > "$stage/fumage-data/README.txt"
time=$(git -C "$source" log -1 --format=%ct 2> /dev/null || date +%s)
find "$build/stage" -exec touch --no-dereference --date="@$time" {} +
(cd "$build/stage" && find . -type f | sort | sed 's|^\./||' | TZ=UTC zip -q -9 -X "$packages/$name.zip" -@)
ls -l "$packages"
