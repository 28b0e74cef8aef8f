#!/usr/bin/env bash
# Writes CHANGELOG.md as Debian reads changelogs, one entry a version; what is not released yet is the version that is built.
#   make_changelog.sh <version> <maintainer> <source tree>
set -euo pipefail
version=$1
maintainer=$2
source=$3
metainfo=("$source"/resources/desktop/*.metainfo.xml)

entry() { # <version>: the section on standard input as an entry
    local released line
    released=$(sed -n 's/.*<release version="'"$1"'" date="\([0-9-]*\)".*/\1/p' "${metainfo[0]}")
    printf 'fumage (%s) unstable; urgency=medium\n' "$1"
    while IFS= read -r line; do
        case $line in
        '### '*) printf '\n  [ %s ]\n' "${line#'### '}" ;;
        '- '*) fold -s -w 74 <<< "${line#- }" | sed 's/ *$//; 1s/^/  * /; 1!s/^/    /' ;;
        esac
    done
    printf '\n -- %s  %s\n\n' "$maintainer" "$(LC_ALL=C date --utc --date="${released:-1970-01-01}" '+%a, %d %b %Y 00:00:00 +0000')"
}

# Items and headings, a line each, however they are wrapped.
unwrapped=$(awk '/^  / { sub(/^ +/, " "); item = item $0; next }
    { if (item != "") print item; item = "" }
    /^- / { item = $0; next }
    /^##/ { print }
    END { if (item != "") print item }' "$source/CHANGELOG.md")
mapfile -t versions < <(sed -n 's/^## \([^ ]*\).*/\1/p' <<< "$unwrapped")
for each in "${versions[@]}"; do
    awk -v heading="$each" '/^## / { inside = $2 == heading; next } inside' <<< "$unwrapped" | entry "${each/Unreleased/$version}"
done
