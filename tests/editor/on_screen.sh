#!/usr/bin/env bash
# Runs a program under a virtual X screen of its own with a window manager, which gives windows their focus.
exec xvfb-run -a -s "-screen 0 1920x1080x24 +extension GLX" sh -c 'openbox 2>/dev/null & manager=$!; "$@"; code=$?; kill $manager; exit $code' sh "$@"
