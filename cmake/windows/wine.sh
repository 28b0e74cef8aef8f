#!/usr/bin/env bash
# Runs a Windows program under Wine, in a Windows of its own beside the build.  wine.sh <program> [arguments]...
# FUMAGE_WINE_DISPLAY names the screen of a program with windows.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# Wine talks about what it lacks and sees here (a display, sound), on the standard error of the program that it runs.
export WINEDEBUG=-all WINEPREFIX=${FUMAGE_WINE_FOLDER:-$here/build/windows-wine} WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe=' DISPLAY=${FUMAGE_WINE_DISPLAY:-}
mkdir -p "$WINEPREFIX"
exec wine "$@"
