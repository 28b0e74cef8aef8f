#!/usr/bin/env bash
# Completes some command lines as bash does at a press of Tab:  check_bash_completion.sh <script>
set -euo pipefail
# shellcheck source=/dev/null
source "$1"
compopt() { :; } # only allowed while bash itself completes
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
touch smoke.json

complete_line() { # <words>...; the last one is being typed
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    COMPREPLY=()
    _fumage_cli
    echo "${COMPREPLY[*]-}"
}
expect() { # <pattern> <words>...
    local pattern=$1 reply
    shift
    reply=$(complete_line "$@")
    # shellcheck disable=SC2053 # a pattern on purpose
    [[ " $reply " == $pattern ]] || { echo "'$*' is completed to '$reply', not $pattern"; exit 1; }
}
expect ' render ' fumage-cli rend
expect '* flipbook *' fumage-cli ''
expect ' campfire ' fumage-cli render camp
expect ' smoke.json ' fumage-cli render sm
expect ' --format ' fumage-cli render campfire --form
expect '*png16*exr*' fumage-cli render campfire --format ''
expect '* wind.strength= *' fumage-cli render campfire --set wind.
expect '* wind.strength= *' fumage-cli flipbook campfire -s wind.s
expect ' smoke.json ' fumage-cli render campfire --output sm
expect '  ' fumage-cli render campfire --size ''
expect ' --threads ' fumage-cli dump campfire --thr
expect ' bash ' fumage-cli completions ba
echo "bash completes"
