#!/usr/bin/env bash
# Runs a program under a virtual X screen of its own with a window manager, which gives windows their focus.
# The server picks its number itself: xvfb-run -a looks for a free one first, and two that look at once share a screen.
set -u
exec {number}< <(exec Xvfb -displayfd 1 -screen 0 1920x1080x24 +extension GLX -nolisten tcp 2>/dev/null)
server=$!
read -r -t 60 -u "$number" screen || { echo "The virtual X server did not start." >&2; exit 1; }
export DISPLAY=:$screen
unset XAUTHORITY WAYLAND_DISPLAY
# A window that is there before its manager may never get the focus: wait until openbox is at work.
exec {ready}< <(exec openbox --startup "echo ready" 2>/dev/null)
manager=$!
read -r -t 60 -u "$ready" _ || { echo "The window manager did not start." >&2; exit 1; }
"$@"
code=$?
kill "$manager" "$server" 2>/dev/null
exit "$code"
