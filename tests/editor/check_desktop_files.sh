#!/usr/bin/env bash
# Desktop entry, AppStream file and MIME type, each by its own validator.
set -eu
folder=$1/resources/desktop
desktop-file-validate "$folder/fumage.desktop"
appstreamcli validate --no-net "$folder"/*.metainfo.xml
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT
mkdir -p "$data/mime/packages"
cp "$folder/fumage.xml" "$data/mime/packages/"
complaints=$(XDG_DATA_HOME=$data update-mime-database "$data/mime" 2>&1)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }
grep -q ':application/x-fumage-preset+json:\*.fumage.json$' "$data/mime/globs2"
# What the entry says it opens is what the MIME file defines, and its icon is there.
grep -q 'MimeType=application/x-fumage-preset+json;' "$folder/fumage.desktop"
[ -f "$1/resources/icons/fumage.svg" ]
