#!/usr/bin/env bash
# Takes the pictures of the editor for the README, under a virtual screen: ./dev screenshots
set -eu
editor=$1
out=$(cd "$(dirname "$0")" && pwd)
home=$(mktemp -d)
presets=/tmp/smoke # is read in the export dialog
mkdir "$presets"
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$home" "$presets"' EXIT
chmod 700 "$home"
export HOME=$home XDG_CONFIG_HOME=$home XDG_DATA_HOME=$home XDG_RUNTIME_DIR=$home

open_editor() { # <theme: 1 dark, 2 light> <preset>
    mkdir -p "$home/fumage"
    printf '[face]\ntheme=%s\n[start]\nshown=false\n' "$1" > "$home/fumage/fumage.ini"
    "$editor" "$2" &
    pid=$!
    window=$(timeout 20 sh -c 'until xdotool search --onlyvisible --name "Fumage" 2>/dev/null | sed -n 1p | grep .; do sleep 0.2; done')
    xdotool windowsize "$window" 1920 1056 windowmove "$window" 0 0
    sleep 2
}
keys() {
    for key in "$@"; do
        xdotool key "$key"
        sleep 1.2
    done
}
# Until the editor has nothing to do any more: air is baked, pictures are whole, previews are there.
settle() {
    local before=-100 now
    for _ in {1..100}; do
        now=$(awk '{print $14 + $15}' "/proc/$pid/stat") # hundredths of a second
        [ $((now - before)) -gt 10 ] || return 0
        before=$now
        sleep 2.5
    done
}
# Stored in 256 colours at most: a sixth of the size, and no difference that one sees at this scale.
take() { import -window root -crop 1920x1056+0+0 +repage -resize "${2:-1440}x" -dither FloydSteinberg -colors 255 PNG8:"$out/$1.png"; }
close_editor() {
    kill "$pid"
    wait "$pid" 2>/dev/null || true
    rm -rf "$home/fumage"
}

# Stops at a frame, whose air may take seconds to bake.
pause() {
    keys space
    sleep 10
    settle
}

cp "$out"/../presets/{volcano,tyre-fire,lit-fire}.json "$presets"
open_editor 1 "$presets/volcano.json"
pause
keys Right Right Right Right Right
settle
take editor_dark
keys ctrl+e Down
xdotool search --onlyvisible --name '^Export$' windowmove 420 240 || true # nobody places windows here
settle
take editor_export
keys Escape ctrl+r
settle
take editor_variations
close_editor

open_editor 2 "$presets/tyre-fire.json"
pause
keys ctrl+b ctrl+shift+p
xdotool type 'wind angle'
keys Return
xdotool type '180'
keys Return
xdotool mousemove 900 500 click 1
keys s
settle
take editor_light
close_editor

open_editor 1 "$presets/lit-fire.json"
pause
keys Home ctrl+Right ctrl+Right ctrl+Right m shift+g
settle
take editor_keys
close_editor
