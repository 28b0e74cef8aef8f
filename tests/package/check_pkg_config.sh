#!/usr/bin/env bash
# What pkg-config says of folders, wherever the installation goes and however its folders were named.  check_pkg_config.sh <source tree>
set -euo pipefail
source=$1
command -v pkg-config > /dev/null || { echo "not tried: there is no pkg-config"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/write.cmake" <<SCRIPT
include("$source/cmake/FumagePkgConfig.cmake")
fumage_pkg_config("\${OUTPUT}")
SCRIPT

expect() { # <folder of fumage.pc> <libdir> <includedir> <glsldir> <definitions>...
    local folder=$1 name said
    local -A wanted=([libdir]=$2 [includedir]=$3 [glsldir]=$4)
    mkdir -p "$folder"
    cmake -DOUTPUT="$folder/fumage.pc" -DPROJECT_VERSION=0.1.0 "${@:5}" -P "$work/write.cmake"
    for name in "${!wanted[@]}"; do
        said=$(PKG_CONFIG_PATH=$folder pkg-config --variable="$name" fumage)
        [ "$(realpath -m "$said")" = "${wanted[$name]}" ] || { echo "$name is $said instead of ${wanted[$name]}: ${*:5}"; exit 1; }
    done
}

echo "-- an installation that goes anywhere"
at=$(realpath "$work")/somewhere
for lib in lib lib/x86_64-linux-gnu; do
    expect "$at/$lib/pkgconfig" "$at/$lib" "$at/include" "$at/share/fumage/glsl" \
        -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_LIBDIR=$lib -DCMAKE_INSTALL_INCLUDEDIR=include -DCMAKE_INSTALL_DATADIR=share
done
echo "-- folders of a store"
expect "$work/store/pkgconfig" /store/a/lib /store/b/include /store/a/share/fumage/glsl \
    -DCMAKE_INSTALL_PREFIX=/store/a -DCMAKE_INSTALL_LIBDIR=/store/a/lib -DCMAKE_INSTALL_INCLUDEDIR=/store/b/include -DCMAKE_INSTALL_DATADIR=/store/a/share
expect "$work/mixed/pkgconfig" /store/c/lib /store/a/include /store/a/share/fumage/glsl \
    -DCMAKE_INSTALL_PREFIX=/store/a -DCMAKE_INSTALL_LIBDIR=/store/c/lib -DCMAKE_INSTALL_INCLUDEDIR=include -DCMAKE_INSTALL_DATADIR=share
