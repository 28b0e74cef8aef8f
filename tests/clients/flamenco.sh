#!/usr/bin/env bash
# Has Node run the job type that `fumage-cli farm --for flamenco` writes, with a stand-in for what Flamenco Manager gives it, and does its tasks.
#   flamenco.sh <fumage-cli>
# Needs nodejs. What must hold: tasks have each frame once, the joining task depends on all others, all frames are there and `verify` finds nothing,
# though the folder has quotes, spaces and letters that are no ASCII in its name.
set -euo pipefail
cli=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
small=(thesis-2012 --size 48 --set emitter.count=500 --set noise.slices=4 --set noise.resolution=16)
folder="$work/it's a \"farm\" é"
for frames in 0-9 3-25:2; do
    rm -rf "$folder"
    "$cli" farm "${small[@]}" --for flamenco --frames "$frames" --chunk 4 --then flipbook --grid 3x2 --output "$folder/smoke_####.exr" > /dev/null 2>&1
    node "$here/flamenco.js" "$folder/smoke.flamenco.js" "$cli"
    "$cli" verify "$folder" --frames "$frames"
    test -s "$folder/smoke.sheet.png"
done
