#!/usr/bin/env bash
# Writes the documents that a package brings along: its changelog as Debian reads it, ours beside it, and pages as plain files in one folder, without
# pictures, which stay behind.  make_documents.sh <version> <maintainer> <source tree> <folder> [pages]...
set -euo pipefail
version=$1
maintainer=$2
source=$3
folder=$4
shift 4
bash "$(dirname "$0")/make_changelog.sh" "$version" "$maintainer" "$source" | gzip -9n > "$folder/changelog.gz"
gzip -9n < "$source/CHANGELOG.md" > "$folder/NEWS.md.gz"
for page in "$source/README.md" "$@"; do
    # Lines with pictures go, and the heads of tables that held nothing else; links to pages lead to those beside this one.
    sed -E "/!\[/d; s#\]\((\.\./)*(resources/)?(docs/)?([A-Za-z_-]+\.md)#](\4#g; /^(\| )+\|$/,/^\|[-|]+$/d" "$page" > "$folder/$(basename "$page")"
done
