#!/usr/bin/env bash
# Opens a preset in the editor on the present X screen, waits for its window and closes it again:  open_editor.sh <fumage> <preset>
set -euo pipefail
"$1" "$2" &
editor=$!
trap 'kill $editor 2> /dev/null || true' EXIT
for ((i = 0; i < 600; i++)); do
    kill -0 $editor 2> /dev/null || { echo "the editor ended before its window was there"; exit 1; }
    window=$(xdotool search --onlyvisible --pid $editor --name "$(basename "$2" .json)" 2> /dev/null | sed -n 1p || true)
    [ -n "$window" ] && break
    sleep 0.1
done
[ -n "$window" ] || { echo "no window within a minute"; exit 1; }
echo "window: $(xdotool getwindowname "$window"), $(xdotool getwindowgeometry "$window" | tail -1 | xargs)"
xdotool windowactivate --sync "$window" key --window "$window" ctrl+q
trap - EXIT
wait $editor
