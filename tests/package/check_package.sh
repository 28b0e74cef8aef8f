#!/usr/bin/env bash
# Unpacks the Debian packages into a clean folder and uses what is in there: the command line, its manual and completions, the desktop's files,
# the library's headers, and the editor, which is opened once.
#   check_package.sh <folder of packages>
set -euo pipefail
packages=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() {
    echo "FAILED: $*" >&2
    exit 1
}
package() {
    local found=("$packages/$1"_*.deb)
    [ -f "${found[0]}" ] && [ ${#found[@]} -eq 1 ] || fail "there is not one package $1 in $packages"
    echo "${found[0]}"
}

libraries=("$packages"/libfumage[0-9]*.deb)
[ ${#libraries[@]} -eq 1 ] && [ -f "${libraries[0]}" ] || fail "there is not one package of the shared library"
library=$(dpkg-deb --field "${libraries[0]}" Package)
for name in fumage fumage-cli "$library" libfumage-dev; do
    file=$(package "$name")
    dpkg-deb --extract "$file" "$root"
    echo "-- $name depends on: $(dpkg-deb --field "$file" Depends)"
    for document in copyright changelog.gz NEWS.md.gz README.md; do
        [ -s "$root/usr/share/doc/$name/$document" ] || fail "$name has no $document"
    done
    zcat "$root/usr/share/doc/$name/changelog.gz" > "$root/changelog"
    complaints=$(dpkg-parsechangelog --file "$root/changelog" --all 2>&1 > /dev/null) && [ -z "$complaints" ] || fail "the changelog of $name: $complaints"
    [ "$(grep -c '^  \* ' "$root/changelog")" -eq "$(grep -c '^- ' "$here/../../CHANGELOG.md")" ] || fail "the changelog of $name lacks some changes"
done
for file in "$packages"/*.deb; do
    private=$(dpkg-deb --contents "$file" | grep -vE '^(drwxr-xr-x|-rw[x-]r-[x-]r-[x-]|l[rwx]{9}) root/root ' || true)
    [ -z "$private" ] || fail "not everybody may read these of ${file##*/}, or others may write them: $private"
done
for page in fumage/farm.md fumage/games.md fumage/editor.md fumage/exporting.md fumage/presets.md fumage-cli/command-line.md fumage-cli/exporting.md fumage-cli/farm.md fumage-cli/parameters.md libfumage-dev/games.md; do
    [ -s "$root/usr/share/doc/$page" ] || fail "there is no $page"
done
# The manual that the editor shows, with what its first page and its pictures lead to.
for file in docs/manual/README.md docs/manual/recipes.md docs/manual/parameters/look.md docs/manual/strips/look.opacity.jpg docs/editor.md parameters.md pictures/campfire.png; do
    [ -s "$root/usr/share/fumage/$file" ] || fail "the manual has no $file"
done
[ -s "$root/usr/share/doc/fumage/manual/manual/README.md" ] || fail "who looks for documents does not find the manual"
[ -z "$(find "$root/usr/share/fumage" -name '*.py' -o -name '*.json')" ] || fail "the manual has what only makes it"
# A game needs no headers where it runs, and finds the library by the name that it was linked with.
soname=$(readelf -d "$root"/usr/lib/*/libfumage.so | sed -n 's/.*SONAME.*\[\(.*\)\].*/\1/p')
[ "$library" = "libfumage${soname#libfumage.so.}" ] || fail "$library is not named after $soname"
dpkg-deb --contents "${libraries[0]}" | grep "/$soname" > /dev/null || fail "$library has no $soname"
[ -z "$(dpkg-deb --contents "${libraries[0]}" | grep -E '/include/|libfumage\.so$|\.a$')" ] || fail "$library has what is for those who compile"
dpkg-deb --field "$(package libfumage-dev)" Depends | grep -F "$library (=" > /dev/null || fail "libfumage-dev does not depend on $library"
if command -v lintian > /dev/null; then
    echo "-- lintian"
    lintian --allow-root --fail-on error,warning --no-tag-display-limit "$packages"/*.deb || fail "lintian complains"
fi
# The programs know every library that they load, and one that no display needs loads no Qt.
dpkg-deb --field "$(package fumage)" Depends | grep libqt6widgets6 > /dev/null || fail "the editor does not depend on Qt"
dpkg-deb --field "$(package fumage-cli)" Depends | grep 'libpng16-16.*libtbb12\|libtbb12.*libpng16-16' > /dev/null || fail "the command line's dependencies are not found"
if dpkg-deb --field "$(package fumage-cli)" Depends | grep qt > /dev/null; then
    fail "the command line depends on Qt"
fi
for program in fumage fumage-cli; do
    if readelf -d "$root/usr/bin/$program" | grep -E 'RPATH|RUNPATH'; then
        fail "$program looks for libraries where it was built"
    fi
done
if apt-get --version > /dev/null 2>&1; then
    apt-get --simulate -qq install "$(package fumage)" "$(package fumage-cli)" "${libraries[0]}" "$(package libfumage-dev)" > "$root/apt" 2>&1 || { cat "$root/apt"; fail "the packages cannot be installed"; }
fi

echo "-- command line"
mkdir "$root/home" "$root/work"
clean=(env -i HOME="$root/home" XDG_RUNTIME_DIR="$root/home" LANG=C.UTF-8 PATH="$root/usr/bin:/usr/bin:/bin")
cd "$root/work"
"${clean[@]}" fumage-cli render campfire --frames 20 --size 64 --output fire.png > /dev/null
file fire.png | grep 'PNG image data, 64 x 64' > /dev/null || fail "no picture was rendered"
[ "$(readelf -h "$root/usr/bin/fumage-cli" | grep -c 'Advanced Micro Devices X86-64\|AArch64')" -eq 1 ] || fail "what machine is this for?"

echo "-- manual"
pages=("$root"/usr/share/man/man1/*.gz)
[ ${#pages[@]} -ge 10 ] || fail "there are only ${#pages[@]} pages"
for page in "${pages[@]}"; do
    complaints=$(LC_ALL=C.UTF-8 MANROFFSEQ='' man --warnings --local-file "$page" 2>&1 > "$root/page")
    [ -z "$complaints" ] || fail "$page: $complaints"
    grep -q SYNOPSIS "$root/page" || fail "$page has no synopsis"
done
for text in 'Ctrl+Shift+P' '/recovery/' 'FUMAGE_OPENGL'; do
    LC_ALL=C.UTF-8 man --local-file "$root/usr/share/man/man1/fumage.1.gz" 2> /dev/null | grep -F "$text" > /dev/null || fail "the manual of the editor says nothing of $text"
done
for subcommand in $("${clean[@]}" fumage-cli --help | sed -n '/^Subcommands:/,/^$/{s/^  \([a-z-]*\) .*/\1/p}'); do
    [ -f "$root/usr/share/man/man1/fumage-cli-$subcommand.1.gz" ] || fail "$subcommand has no manual page"
done

echo "-- completions"
bash "$here/check_bash_completion.sh" "$root/usr/share/bash-completion/completions/fumage-cli"
zsh "$here/check_zsh_completion.zsh" "$root/usr/share/zsh/vendor-completions/_fumage-cli"

echo "-- desktop"
share=$root/usr/share
desktop-file-validate "$share/applications/fumage.desktop"
cmp "$share"/metainfo/*.metainfo.xml "$here"/../../resources/desktop/*.metainfo.xml || fail "the metainfo is another one"
bash "$here/check_metainfo.sh"
XDG_DATA_HOME=$root/home XDG_DATA_DIRS=$share update-mime-database "$share/mime"
grep -q ':application/x-fumage-preset+json:\*.fumage.json$' "$share/mime/globs2" || fail "the MIME type has no glob"
for size in 16 24 32 48 64 128 256 512; do
    file "$share/icons/hicolor/${size}x$size/apps/fumage.png" | grep "PNG image data, $size x $size" > /dev/null || fail "no icon of $size pixels"
done
[ -f "$share/icons/hicolor/scalable/apps/fumage.svg" ] || fail "no scalable icon"

echo "-- headers"
[ -f "$root/usr/include/fumage/effect/effect.h" ] || fail "no headers"
[ "$(ls "$root/usr/include")" = fumage ] || fail "there are headers outside of fumage: $(ls "$root/usr/include")"

echo "-- editor"
"${clean[@]}" fumage-cli presets --show campfire > campfire.json
"${clean[@]}" bash "$here/../editor/on_screen.sh" bash "$here/open_editor.sh" "$root/usr/bin/fumage" campfire.json
echo "The packages work."
