#!/usr/bin/env bash
# What the editor for Windows is made of: Qt of Debian's source package, as libraries that go into the program, of the version whose tools this machine has.
# An hour on two cores, once: it is kept in the user's cache folder for every checkout, and <link> points to it. What was broken off goes on where it was.
# qt.sh <link>
#
# Static: a program is one file, as fumage-cli.exe is. Qt is under the LGPL, which then asks that everybody can link the program anew with a Qt of theirs:
# Fumage's whole source is there for them under the MIT licence, and this script says how that Qt is built; cmake/windows/package.sh says so to users.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
link=$(realpath -ms "$1")
wanted=$(cat "$here/qt.sh" "$here/toolchain.cmake" | sha256sum | cut -c1-16)
qt=${FUMAGE_WINDOWS_QT:-${XDG_CACHE_HOME:-$HOME/.cache}/fumage/windows-qt-$wanted}
mkdir -p "$(dirname "$link")"
ln -sfn "$qt" "$link"
[ ! -f "$qt/made" ] || exit 0
command -v apt-get > /dev/null && command -v dpkg-source > /dev/null || { echo "Only Debian and its kin have these packages: apt-get or dpkg-source is missing."; exit 1; }
host=/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/cmake
[ -d "$host/Qt6WidgetsTools" ] || { echo "The tools of Qt are missing: apt install qt6-base-dev"; exit 1; }

work=$qt.work
mkdir -p "$work"
# Every checkout would build in this folder: the second waits for the first, and takes what it has made.
exec {lock}> "$qt.lock"
flock --nonblock "$lock" || { echo "Another checkout is building Qt: waiting for it"; flock "$lock"; }
[ ! -f "$qt/made" ] || exit 0
mkdir -p "$work"/apt/{lists/partial,cache/archives/partial,sources}
cd "$work"
# A stamp says that something is whole: what was broken off while it was unpacked has some of its files already.
if [ ! -f source.made ]; then
    echo "Fetching Qt's source"
    rm -rf qt6-base-* # or apt takes the folder for unpacked
    # The sources of where this machine's own packages come from.
    apt-get indextargets --format 'deb-src $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' | sort -u > apt/sources/debian.list
    apt_sources() {
        apt-get -qq -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt/cache" -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/apt/sources" \
            -o Debug::NoLocking=true -o APT::Sandbox::User="$(id -un)" "$@"
    }
    apt_sources update
    # Not every mirror keeps what it lists of the security updates; then it is the release itself.
    apt_sources source --only-source qt6-base > source.log 2>&1 || apt_sources --target-release "$(. /etc/os-release && echo "$VERSION_CODENAME")" source --only-source qt6-base > source.log
    touch source.made
fi
if [ ! -f packages.made ]; then
    apt-get -qq -o APT::Sandbox::User="$(id -un)" download qt6-translations-l10n
    for package in qt6-translations-l10n_*.deb; do
        dpkg-deb --extract "$package" packages
    done
    touch packages.made
fi

# Nothing of Fumage's own folders: every checkout takes this Qt.
cat > toolchain.cmake <<EOF
include("$here/toolchain.cmake")
set(CMAKE_FIND_ROOT_PATH "$qt" /usr/x86_64-w64-mingw32)
EOF
off=(sql dbus network xml concurrent printsupport tabletevent vulkan zstd icu glib openssl qmake androiddeployqt system_zlib accessibility_atspi_bridge direct2d1_1) # without direct2d 1.0 DirectWrite misses a source
within=(freetype harfbuzz pcre doubleconversion libpng libjpeg)
features=()
for feature in "${off[@]}"; do
    features+=("-DFEATURE_$feature=OFF")
done
for library in "${within[@]}"; do
    features+=("-DINPUT_$library=qt")
done
ccache=$(command -v ccache || true)
# That ccache may keep what comes from a precompiled header.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
if [ ! -f build-qt6-base/build.ninja ]; then
    echo "Configuring Qt"
    cmake -S qt6-base-[0-9]* -B build-qt6-base -G Ninja --toolchain "$work/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$qt" \
        -DQT_HOST_PATH=/usr -DQT_HOST_PATH_CMAKE_DIR="$host" -DCMAKE_C_COMPILER_LAUNCHER="$ccache" -DCMAKE_CXX_COMPILER_LAUNCHER="$ccache" -DCMAKE_CXX_FLAGS=-fpch-preprocess \
        -DBUILD_SHARED_LIBS=OFF -DQT_BUILD_EXAMPLES=OFF -DQT_BUILD_TESTS=OFF -DQT_BUILD_BENCHMARKS=OFF -DBUILD_WITH_PCH=ON \
        "${features[@]}" -DINPUT_opengl=dynamic -DINPUT_libb2=no > configure.log 2>&1 || { tail -n 40 configure.log; rm -f build-qt6-base/build.ninja; exit 1; }
fi
echo "Building Qt ($work/build.log)"
cmake --build build-qt6-base --parallel 2 > build.log 2>&1 || { tail -n 40 build.log; exit 1; }
cmake --install build-qt6-base > install.log 2>&1 || { tail -n 40 install.log; exit 1; }
mkdir -p "$qt/translations" "$qt/licences"
cp packages/usr/share/qt6/translations/qtbase_*.qm "$qt/translations"
cp qt6-base-[0-9]*/debian/copyright "$qt/licences/qt6-base.txt"
cp qt6-base-[0-9]*/LICENSES/{LGPL-3.0-only,GPL-3.0-only}.txt "$qt/licences"
basename qt6-base-[0-9]*.dsc .dsc > "$qt/made"
rm -rf "$work"
