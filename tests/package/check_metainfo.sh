#!/usr/bin/env bash
# What software centres and Flatpak read is valid and agrees with the tree: versions, pictures, names, sources by checksum.
#   check_metainfo.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
fail() {
    echo "FAILED: $*" >&2
    exit 1
}
metainfo=resources/desktop/io.github.fumage.Fumage.metainfo.xml
manifest=cmake/flatpak/io.github.fumage.Fumage.yaml
id=$(sed -n 's/.*<id>\(.*\)<\/id>.*/\1/p' $metainfo)

# Without the network: whether its pages are there is for who publishes it. The pedantic word that is left is about the capital in the id.
complaints=$(appstreamcli validate --pedantic --no-net $metainfo) || fail "$complaints"
! grep -E '^ *[EWI]:' <<< "$complaints" || fail "the metainfo is not clean"
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
[ "$(sed -n 's/.*<release version="\([^"]*\)".*/\1/p' $metainfo | sed -n 1p)" = "$version" ] || fail "the newest release is not $version"
pictures=0
while read -r width height path; do
    file "$path" | grep -F "PNG image data, $width x $height," > /dev/null || fail "the screenshot $path is not one of $width x $height"
    pictures=$((pictures + 1))
done < <(sed -n 's/.*<image width="\([0-9]*\)" height="\([0-9]*\)">https:.*\/main\/\(.*\)<\/image>.*/\1 \2 \3/p' $metainfo)
# There are none before there is a home that has them.
[ $pictures -eq "$(grep -cE '<screenshot( |>)' $metainfo)" ] || fail "only $pictures screenshots are ours"

grep -qx "id: $id" $manifest || fail "the Flatpak is not called $id"
sources=$(grep -c 'type: archive' $manifest)
[ "$(grep -cE '^ +url: https://' $manifest)" -eq "$sources" ] && [ "$(grep -cE '^ +sha256: [0-9a-f]{64}$' $manifest)" -eq "$sources" ] ||
    fail "not each of $sources sources of the Flatpak has a checksum"
if command -v flatpak-builder > /dev/null; then
    state=$(mktemp -d)
    trap 'rm -rf "$state"' EXIT
    # In a folder of its own: it leaves its state where it is called.
    complaints=$(manifest=$PWD/$manifest; cd "$state"; flatpak-builder --show-manifest "$manifest" 2>&1 > /dev/null) || fail "$complaints"
    [ -z "$complaints" ] || fail "the manifest of the Flatpak: $complaints"
fi
echo "metainfo and Flatpak manifest are valid"
