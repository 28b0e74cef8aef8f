#!/usr/bin/env bash
# What the core is made of, for Windows: headers and zlib from Debian's packages, the other libraries built from Debian's source packages.
# No root, and nothing of this machine's own packages is touched.  parts.sh <folder>
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
parts=$(realpath -m "$1")
headers=(libglm-dev nlohmann-json3-dev libkainjow-mustache-dev libcli11-dev libz-mingw-w64-dev)
sources=(libpng1.6 highway imath openexr onetbb)
wanted=$(cat "$here/parts.sh" "$here/toolchain.cmake" | sha256sum)
[ "$(cat "$parts/made" 2>/dev/null)" != "$wanted" ] || exit 0
command -v apt-get > /dev/null && command -v dpkg-source > /dev/null || { echo "Only Debian and its kin have these packages: apt-get or dpkg-source is missing."; exit 1; }

work=$parts.work
rm -rf "$parts" "$work"
mkdir -p "$parts" "$work"/apt/{lists/partial,cache/archives/partial,sources}
# The sources of where this machine's own packages come from.
apt-get indextargets --format 'deb-src $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' | sort -u > "$work/apt/sources/debian.list"
apt_sources() {
    apt-get -qq -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt/cache" -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/apt/sources" \
        -o Debug::NoLocking=true -o APT::Sandbox::User="$(id -un)" "$@"
}
cd "$work"
echo "Fetching packages and sources"
apt-get -qq -o APT::Sandbox::User="$(id -un)" download "${headers[@]}"
for package in *.deb; do
    dpkg-deb --extract "$package" packages
done
mkdir -p "$parts"/{include,share}
cp -r packages/usr/include packages/usr/x86_64-w64-mingw32/{include,lib} "$parts"
cp -r packages/usr/share/cmake "$parts/share"
rm "$parts"/lib/*.dll.a # a program is one file
apt_sources update
# Not every mirror keeps what it lists of the security updates; then it is the release itself.
apt_sources source --only-source "${sources[@]}" > source.log 2>&1 || apt_sources --target-release "$(. /etc/os-release && echo "$VERSION_CODENAME")" source --only-source "${sources[@]}" > source.log

part() { # <source package> [options of cmake]...
    echo "Building $1"
    { cmake -S "$work/$1"-[0-9]* -B "$work/build-$1" -G Ninja --toolchain "$here/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$parts" \
        -DCMAKE_C_COMPILER_LAUNCHER="$(command -v ccache || true)" -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF "${@:2}" \
        && cmake --build "$work/build-$1" --parallel 2 && cmake --install "$work/build-$1"; } > "$work/$1.log" 2>&1 || { tail -n 40 "$work/$1.log"; exit 1; }
}
part highway -DHWY_ENABLE_CONTRIB=OFF -DHWY_ENABLE_EXAMPLES=OFF
part libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF
part imath
part openexr -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF -DOPENEXR_INSTALL_TOOLS=OFF
part onetbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
# It would have what it is linked into export its functions.
x86_64-w64-mingw32-objcopy --remove-section .drectve "$parts/lib/libtbb12.a"
# What whoever passes a program on passes on with it.
mkdir -p "$parts/licences"
for package in packages/usr/share/doc/*/; do
    cp "$package/copyright" "$parts/licences/$(basename "$package").txt"
done
for source in "${sources[@]}"; do
    cp "$work/$source"-[0-9]*/debian/copyright "$parts/licences/$source.txt"
done
rm -rf "$work"
echo "$wanted" > "$parts/made"
