#!/usr/bin/env bash
# Qt for Windows is made whole, whatever its making was broken off at: cmake/windows/qt.sh with tools that only say that
# they have done their work.  check_qt.sh <source tree>
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
source="$work/a tree"
mkdir -p "$source/cmake" "$work/tools"
cp -r "$1/cmake/windows" "$source/cmake"

tool() { # <name> <what it does>
    printf '#!/bin/bash\n%s\n' "$2" > "$work/tools/$1"
    chmod +x "$work/tools/$1"
}
# A source that is unpacked lacks its patches at first; apt leaves alone what it finds unpacked.
tool apt-get '
folder=qt6-base-6.4.2
case "$*" in
*indextargets*) echo deb-src ;;
*download*) touch qt6-translations-l10n_6_all.deb ;;
*" source "*)
    [ ! -d $folder ] || exit 0
    mkdir -p $folder
    touch $folder/CMakeLists.txt qt6-base-6.4.2.dsc
    [ ! -e "$BREAK/source" ] || { kill -9 $PPID; exit 1; }
    mkdir -p $folder/{debian,LICENSES}
    touch $folder/{patched,debian/copyright,LICENSES/LGPL-3.0-only.txt,LICENSES/GPL-3.0-only.txt}
    ;;
esac'
tool dpkg-deb '
mkdir -p $3/usr/share/qt6/translations
touch $3/usr/share/qt6/translations/qtbase_de.qm
[ ! -e "$BREAK/package" ] || { kill -9 $PPID; exit 1; }
touch $3/usr/share/qt6/translations/qtbase_sv.qm'
tool cmake '
case $1 in
-S) [ -e qt6-base-6.4.2/patched ] && /usr/bin/env -i "$CMAKE" -P toolchain.cmake > /dev/null && mkdir -p build-qt6-base && touch build-qt6-base/build.ninja ;;
--build) echo built >> "$BREAK/builds" ;;
esac'
tool dpkg-source ''
tool dpkg-architecture 'gcc -print-multiarch'
mkdir "$work/break"
make_qt() {
    env PATH="$work/tools:$PATH" CMAKE="$(command -v cmake)" BREAK="$work/break" FUMAGE_WINDOWS_QT="$work/a cache/qt" bash "$source/cmake/windows/qt.sh" "$source/build/windows-qt"
}
for step in source package; do
    touch "$work/break/$step"
    if make_qt > "$work/log" 2>&1; then
        echo "it goes on without its $step"
        exit 1
    fi
    rm "$work/break/$step"
done
# Two checkouts at a time: one builds.
make_qt > "$work/first" 2>&1 &
first=$!
make_qt > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
wait $first || { cat "$work/first"; exit 1; }
[ "$(cat "$work/break/builds")" = built ] || { echo "it was built more than once"; exit 1; }
qt=$(realpath "$source/build/windows-qt")
for file in made licences/qt6-base.txt translations/qtbase_sv.qm; do
    [ -f "$qt/$file" ] || { echo "Qt has no $file"; exit 1; }
done
[ ! -e "$qt.work" ] || { echo "the folder that it was built in is left"; exit 1; }
echo "Qt is made whole"
