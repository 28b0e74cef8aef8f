#!/usr/bin/env bash
# Every environment variable that the programs read is in a manual page.  check_manual.sh <source tree>
set -euo pipefail
cd "$1"
failed=0
mapfile -t variables < <(grep -rhoE '(getenv|qEnvironmentVariableIsSet|qgetenv|environmentVariable)\("FUMAGE_[A-Z_]+"' app core ui | sed 's/.*"\(.*\)"/\1/' | sort -u)
((${#variables[@]} > 1)) || { echo "no variables are found: has their reader another name?"; exit 1; }
for variable in "${variables[@]}"; do
    grep -qF "$variable" resources/manual/*.h2m || { echo "no manual page tells of $variable"; failed=1; }
done
exit $failed
