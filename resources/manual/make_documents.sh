#!/usr/bin/env bash
# Writes the documents that a package brings along: its changelog as Debian reads it, ours beside it, and pages as plain files in one folder, without
# pictures, which stay behind.  make_documents.sh <package> <version> <maintainer> <source tree> <folder> [pages]...
set -euo pipefail
package=$1
version=$2
maintainer=$3
source=$4
folder=$5
shift 5
released=$(sed -n 's/.*<release version="'"$version"'" date="\([0-9-]*\)".*/\1/p' "$source"/resources/desktop/*.metainfo.xml)
{
    printf 'fumage (%s) unstable; urgency=medium\n\n  * See NEWS.md.gz for what has changed in %s.\n\n' "$version" "$package"
    printf ' -- %s  %s\n' "$maintainer" "$(LC_ALL=C date --utc --date="${released:-1970-01-01}" '+%a, %d %b %Y 00:00:00 +0000')"
} | gzip -9n > "$folder/changelog.gz"
gzip -9n < "$source/CHANGELOG.md" > "$folder/NEWS.md.gz"
for page in "$source/README.md" "$@"; do
    # Lines with pictures go, and the heads of tables that held nothing else; links to pages lead to those beside this one.
    sed -E "/!\[/d; s#\]\((\.\./)*(resources/)?(docs/)?([A-Za-z_-]+\.md)#](\4#g; /^(\| )+\|$/,/^\|[-|]+$/d" "$page" > "$folder/$(basename "$page")"
done
