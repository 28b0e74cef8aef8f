#!/usr/bin/env bash
# Unpacks the tar for any Linux into a folder with a space and uses it there: nothing in it refers to where it was built or needs
# a library that is neither in it nor glibc's; command line and editor run, on this system and in a root with nothing but glibc
# and a shell (as root, or where users have namespaces).
#   check_tar.sh <tar>
set -euo pipefail
tar=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
source=$(realpath "$here/../..")
# shellcheck source=cmake/linux/libraries.sh
source "$source/cmake/linux/libraries.sh"
# Debian 12's: who needs a newer one shuts people out, and should know that.
newest_glibc=2.36
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() {
    echo "FAILED: $*" >&2
    exit 1
}
mkdir "$root/a folder" "$root/home" "$root/work"
tar --extract --file "$tar" --directory "$root/a folder"
name=$(basename "$tar" .tar.gz)
[ "$(ls -A "$root/a folder")" = "$name" ] || fail "there is more in it than one folder $name"
app=$root/a\ folder/$name

echo "-- files"
for file in AppRun README.txt LICENSE.txt fumage.desktop fumage.svg fumage.png .DirIcon usr/bin/qt.conf licenses/packages.txt \
    usr/share/fumage/docs/manual/README.md usr/plugins/platforms/libq{xcb,offscreen,wayland-egl,wayland-generic}.so; do
    [ -s "$app/$file" ] || fail "there is no $file"
done
[ -z "$(find "$app" ! -perm -a+r -o -type d ! -perm -a+x)" ] || fail "not everybody may read it"
[ -z "$(find "$app" -type l -lname '/*')" ] || fail "links lead out of it"
desktop-file-validate "$app/fumage.desktop"
! grep -n '@[A-Z_]*@' "$app/README.txt" "$app/AppRun" || fail "a text was not filled in"
while read -r package _; do
    [ -s "$app/licenses/${package%:*}.txt" ] || fail "the licence of $package is missing"
done < "$app/licenses/packages.txt"
grep -q '^libqt6core6[: ]' "$app/licenses/packages.txt" || fail "the licences do not know Qt"
# A bare machine makes the same tar: all that is in it is of packages that ./dev package installs, or of what those need.
if command -v apt-cache > /dev/null; then
    program_packages=() package_packages=()
    eval "$(awk '/^(program|package)_packages=\(/ { inside = 1 } inside { print } /\)$/ { inside = 0 }' "$source/dev")"
    apt-cache depends --recurse --no-recommends --no-suggests --no-enhances --no-conflicts --no-breaks --no-replaces \
        "${program_packages[@]}" "${package_packages[@]}" > "$root/needed"
    while read -r package _; do
        grep -qxF "${package%:*}" "$root/needed" || fail "$package is in it, which only this machine happens to have"
    done < "$app/licenses/packages.txt"
fi

echo "-- libraries"
mapfile -t files < <(elf_files "$app")
[ ${#files[@]} -gt 50 ] || fail "only ${#files[@]} programs and libraries"
for file in "${files[@]}"; do
    dynamic=$(readelf --dynamic --wide "$file")
    paths=$(sed -n 's/.*(R.*PATH).*\[\(.*\)\]/\1/p' <<< "$dynamic")
    ! grep -vE '^\$ORIGIN(/\.\./lib|/\.\./\.\./lib)?$' <<< "${paths:-\$ORIGIN}" || fail "${file#"$app/"} looks for libraries elsewhere"
    for library in $(sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' <<< "$dynamic"); do
        is_glibc "$library" || [ -f "$app/usr/spare/$library/$library" ] || [ -f "$app/usr/lib/$library" ] ||
            fail "${file#"$app/"} needs $library, which is not in it"
    done
done
for folder in "$app"/usr/lib/*; do
    library=$(basename "$folder")
    if is_glibc "$library" || is_spare "$library"; then fail "$library goes with the system"; fi
done
built_from=$(grep -rlF -e "$source" "$app" || true)
[ -z "$built_from" ] || fail "these refer to where it was built: $built_from"

echo "-- glibc"
glibc=$(symbol_floor GLIBC "$app"/usr/{bin,lib,plugins})
spare=$(symbol_floor GLIBC "$app/usr/spare")
[ "$(printf '%s\n' "$glibc" "$spare" "$newest_glibc" | sort -V | tail -1)" = "$newest_glibc" ] || fail "it needs glibc $glibc, its spares $spare"
grep -q "^glibc $glibc or newer" "$app/README.txt" || fail "README.txt does not say glibc $glibc"
grep -q "^needed=$glibc\$" "$app/AppRun" || fail "AppRun does not look for glibc $glibc"
echo "glibc $glibc, spares $spare"
# A system that is too old is told so.
mkdir "$root/old"
printf '#!/bin/sh\necho glibc 2.31\n' > "$root/old/getconf"
chmod +x "$root/old/getconf"
refusal=$(PATH=$root/old:$PATH "$app/fumage-cli" --version 2>&1) && fail "glibc 2.31 is not refused"
grep -F "needs Linux with glibc $glibc or newer (this system has 2.31)" <<< "$refusal" > /dev/null || fail "the refusal is: $refusal"

clean=(env -i HOME="$root/home" XDG_RUNTIME_DIR="$root/home" LANG=C.UTF-8 PATH=/usr/bin:/bin)
chmod 700 "$root/home"
cd "$root/work"
echo "-- command line"
ln -s "$app/fumage-cli" "$root/work/fumage-cli"
"${clean[@]}" ./fumage-cli render campfire --frames 20 --size 64 --output fire.png > /dev/null
file fire.png | grep 'PNG image data, 64 x 64' > /dev/null || fail "no picture was rendered"
# Libraries of the caller that are called as ours do not take their place.
mkdir "$root/work/other" "$root/work/drivers"
for library in "$app"/usr/lib/*; do
    touch "$root/work/other/${library##*/}" # the loader refuses an empty one
done
said=$("${clean[@]}" LD_LIBRARY_PATH="$root/work/drivers:$root/work/other::" ./fumage-cli presets 2>&1) || fail "it takes libraries of LD_LIBRARY_PATH for its own: $said"
case $said in *"error while loading"*) fail "AppRun's tools take libraries of LD_LIBRARY_PATH: $said" ;; esac
mkdir -p "$root"/asks/usr/{bin,lib,spare/libc.so.6} # a spare that every system has
cp "$app/AppRun" "$root/asks/fumage-cli"
touch "$root/asks/usr/lib/libours.so.1" "$root/work/other/libours.so.1"
printf '#!/bin/sh\necho "${LD_LIBRARY_PATH-unset}"\n' > "$root/asks/usr/bin/fumage-cli"
chmod +x "$root/asks/usr/bin/fumage-cli"
paths=$("${clean[@]}" LD_LIBRARY_PATH="$root/work/drivers:$root/work/other::" "$root/asks/fumage-cli")
[ "$paths" = "$root/work/drivers" ] || fail "of the caller's LD_LIBRARY_PATH it leaves: $paths"
# An AppImage calls AppRun, and says by which name it was called itself.
"${clean[@]}" ARGV0=./fumage-cli "$app/AppRun" presets | grep campfire > /dev/null || fail "an AppImage has no command line"

# With its spares in front nothing comes from elsewhere but glibc.
from_elsewhere() { # <program> <arguments>...
    local library
    "${clean[@]}" LD_LIBRARY_PATH="$(printf '%s:' "$app"/usr/spare/*)" LD_DEBUG=libs QT_QPA_PLATFORM=offscreen "$@" 2>&1 > /dev/null |
        sed -n 's/.*calling init: \(.*\)/\1/p' | grep -vF "$app/" | sort -u | while IFS= read -r library; do
        is_glibc "$(basename "$library")" || echo "$library"
    done
}
strangers=$(from_elsewhere "$app/usr/bin/fumage-cli" presets; from_elsewhere "$app/usr/bin/fumage" --keys)
[ -z "$strangers" ] || fail "these are loaded from the system: $strangers"

echo "-- editor"
# Opens the editor without a display, until it has a document, and ends it: as a system does that shuts down, and by force where
# it is too busy to hear that. How it ends, the tests of the editor ask.
cat > "$root/work/open.sh" <<'SCRIPT'
app=$1
export HOME=$2 XDG_RUNTIME_DIR=$2 LANG=C.UTF-8 QT_QPA_PLATFORM=offscreen
"$app/fumage" "$3" &
editor=$!
i=0
until ls "$HOME"/.local/share/fumage/recovery/*.lock > /dev/null 2>&1; do
    kill -0 $editor 2> /dev/null || { echo "the editor ended before it had a document"; exit 1; }
    i=$((i + 1))
    [ $i -lt 600 ] || { echo "no document within a minute"; kill -9 $editor; exit 1; }
    sleep 0.1
done
sleep 2
kill -TERM $editor || { echo "the editor ended by itself"; exit 1; }
i=0
while kill -0 $editor 2> /dev/null && [ $i -lt 100 ]; do
    i=$((i + 1))
    sleep 0.1
done
kill -9 $editor 2> /dev/null
wait $editor
case $? in 137 | 143) ;; *) echo "the editor ended with $?"; exit 1 ;; esac
rm -f "$HOME"/.local/share/fumage/recovery/*
SCRIPT
"${clean[@]}" ./fumage-cli presets --show campfire > campfire.json
"${clean[@]}" sh "$root/work/open.sh" "$app" "$root/home" campfire.json 2> "$root/errors" || { cat "$root/errors"; fail "the editor does not open offscreen"; }
if command -v Xvfb > /dev/null && command -v openbox > /dev/null && command -v xdotool > /dev/null; then
    "${clean[@]}" bash "$here/../editor/on_screen.sh" bash "$here/open_editor.sh" "$app/fumage" campfire.json
fi

echo "-- alone"
# A root with glibc, a shell, and the few tools that AppRun and open.sh call.
bare=$root/bare
mkdir -p "$bare/bin" "$bare/tmp" "$bare/home" "$bare/app" "$bare/dev"
chmod 700 "$bare/home"
touch "$bare/dev/null"
for tool in sh dirname readlink uname getconf grep sleep ls rm; do
    program=$(realpath "$(command -v $tool)")
    install -D --mode=755 "$program" "$bare/bin/$tool"
    for library in $(libraries_of "$program") $(ldd "$program" | sed -n 's/^\t\(\/[^ ]*\) .*/\1/p'); do
        install -D --mode=755 "$(realpath "$library")" "$bare$library"
    done
done
for library in libm.so.6 libdl.so.2 libpthread.so.0 librt.so.1 libresolv.so.2; do
    path=$(ldconfig -p 2> /dev/null | sed -n "s/.*${library//./\\.} .*x86-64.* => //p" | sed -n 1p)
    [ -z "$path" ] || install -D --mode=755 "$(realpath "$path")" "$bare$path"
done
mv "$app" "$bare/app/fumage"
cp campfire.json "$root/work/open.sh" "$bare/tmp/"
# $ORIGIN is what /proc says.
mkdir "$bare/proc"
enter=(unshare --mount --pid --fork)
[ "$(id -u)" -eq 0 ] || enter+=(--map-root-user)
enter+=(/bin/sh -c 'mount -t proc proc "$0/proc" && exec "$(PATH=/usr/sbin:/sbin command -v chroot)" "$0" "$@"' "$bare")
if ! "${enter[@]}" /bin/sh -c true 2> /dev/null; then
    echo "not tried in a root of its own: nobody may make one here"
else
    env -i PATH=/bin "${enter[@]}" /app/fumage/fumage-cli render campfire --frames 20 --size 64 --output /tmp/fire.png > /dev/null
    cmp "$bare/tmp/fire.png" fire.png || fail "the picture is another one there"
    env -i PATH=/bin "${enter[@]}" /bin/sh /tmp/open.sh /app/fumage /home /tmp/campfire.json > "$root/errors" 2>&1 ||
        { cat "$root/errors"; fail "the editor does not open in a root with glibc alone"; }
fi
echo "The tar works."
