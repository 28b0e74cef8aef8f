#!/usr/bin/env bash
# What the editor says and how it ends where it cannot start: check_start.sh FUMAGE
# A person reads one line that begins with the name of the program, and no core is dumped.
set -u
fumage=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
export HOME=$place XDG_CONFIG_HOME=$place/config XDG_DATA_HOME=$place/data XDG_CACHE_HOME=$place/cache XDG_RUNTIME_DIR=$place
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
failed=0
complain() {
    echo "$1"
    cat "$place/said"
    failed=1
}
refuses() { # <what> <codes> <command>...
    local what=$1 codes=$2
    shift 2
    "$@" > "$place/said" 2>&1
    local code=$?
    [[ " $codes " == *" $code "* ]] || complain "$what: ended with $code"
    grep -q '^fumage: ' "$place/said" || complain "$what: said nothing"
    ! grep -q terminate "$place/said" || complain "$what: was terminated"
}
refuses "no display" 1 timeout 60 "$fumage"
refuses "a display that is not there" 1 env DISPLAY=:9876 timeout 60 "$fumage"
refuses "a platform that is not there" 1 env QT_QPA_PLATFORM=nosuch timeout 60 "$fumage"
if ! "$fumage" --version > "$place/said" 2>&1 || ! grep -q '^Fumage ' "$place/said"; then
    complain "the version needs a display"
fi
export QT_QPA_PLATFORM=offscreen
# A program that is told to end takes its locks along.
for signal in TERM HUP; do # a shell has what runs behind it ignore INT
    export XDG_DATA_HOME=$place/data-$signal # without the locks of those that were killed
    "$fumage" > "$place/said" 2>&1 &
    editor=$!
    for ((i = 0; i < 600; ++i)); do
        compgen -G "$XDG_DATA_HOME/fumage/recovery/*.lock" > /dev/null && break
        sleep 0.1
    done
    kill -"$signal" "$editor"
    wait "$editor"
    code=$?
    [[ $code == $((128 + $(kill -l "$signal"))) ]] || complain "SIG$signal: ended with $code"
    left=$(find "$XDG_DATA_HOME/fumage" -type f)
    [[ -z $left ]] || complain "SIG$signal: left $left"
done
exit $failed
