#!/usr/bin/env bash
# Renders the pictures of the README and of resources/pictures: every built-in preset, the default look, and four presets that move.
#   render.sh <fumage-cli>
set -euo pipefail
cli=$1
here=$(cd "$(dirname "$0")" && pwd)
sky=(--set output.background=colour --set "output.background_colour=[0.05,0.1,0.18]")
"$cli" render default --frames 60 --size 960x640 --supersample 2 --set emitter.count=1000000 --set look.size=0.12 --set air.resolution=96 --set light.resolution=96 --set camera.distance=15.5 --set "camera.target=[0.43,5.2,0]" "${sky[@]}" --output "$here/default_wide.png"
for preset in "$here"/../presets/*.json; do
    name=$(basename "$preset" .json)
    frame=70
    case $name in
    torch) frame=10 ;;
    sand-impact) frame=22 ;;
    fire-ball) frame=24 ;;
    explosion) frame=32 ;;
    blast | breath) frame=40 ;;
    landing) frame=50 ;;
    dust) frame=55 ;;
    mushroom-cloud) frame=63 ;;
    rolling-dust) frame=72 ;;
    missile) frame=84 ;;
    gusty-chimney) frame=86 ;;
    chimney) frame=88 ;;
    lit-fire) frame=100 ;;
    ceiling) frame=110 ;;
    firework | rocket-launch) frame=120 ;;
    esac
    "$cli" render "$preset" --frames "$frame" --size 256x256 --supersample 2 "${sky[@]}" --output "$here/$name.png"
done

# A second of film is fifteen frames: every other one of the presets' thirty.
film=$(mktemp -d)
trap 'rm -rf "$film"' EXIT
moving=(campfire explosion mushroom-cloud plume)
for name in "${moving[@]}"; do
    "$cli" render "$name" --frames 0-119:2 --size 240 --set output.background=transparent --output "$film/${name}_###.png"
done
for number in $(seq -f %03g 0 2 118); do
    beside=("${moving[@]/#/$film/}")
    convert "${beside[@]/%/_$number.png}" -background '#1a212b' -alpha remove -alpha off +append +repage "$film/film_$number.png"
done
convert -delay 7 -loop 0 "$film"/film_*.png -ordered-dither o4x4,32 -layers optimize "$here/moving.gif"

# What was rendered: pictures_test holds it against the presets as they are.
cp "$here/../../tests/golden/golden.txt" "$here/rendered.txt"
