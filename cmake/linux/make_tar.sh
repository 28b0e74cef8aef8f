#!/usr/bin/env bash
# Makes a folder that runs on any Linux, and a tar of it, from programs that are installed below <folder>/usr: their libraries
# beside them, found by $ORIGIN, Qt's plugins, licences, and what makes it an AppDir.  Needs patchelf and readelf.
#   make_tar.sh <folder> <version> <folder of packages>
set -euo pipefail
folder=$(realpath "$1")
version=$2
packages=$(realpath "$3")
here=$(realpath "$(dirname "$0")")
# shellcheck source=cmake/linux/libraries.sh
source "$here/libraries.sh"
architecture=$(uname -m)
usr=$folder/usr
name=fumage-$version-linux-$architecture
# What says where it comes from, and when: the same tree makes the same tar.
released=$(sed -n 's/.*<release version="'"$version"'" date="\([0-9-]*\)".*/\1/p' "$usr"/share/metainfo/*.xml)

# Qt looks for these by itself, so that no ldd names them. Not the ones for printers, databases and embedded devices.
plugins=(platforms/libq{xcb,offscreen}.so platforms/libqwayland-{egl,generic}.so xcbglintegrations/libqxcb-{egl,glx}-integration.so
    wayland-shell-integration/libxdg-shell.so wayland-decoration-client/libbradient.so
    wayland-graphics-integration-client/libqt-plugin-wayland-egl.so
    platforminputcontexts/lib{compose,ibus}platforminputcontextplugin.so
    imageformats/libq{jpeg,gif}.so)
qt_plugins=$(qmake6 -query QT_INSTALL_PLUGINS)
for plugin in "${plugins[@]}"; do
    [ -f "$qt_plugins/$plugin" ] || { echo "Qt's plugin $plugin is not here: is qt6-wayland installed?"; exit 1; }
    install -D --mode=644 "$qt_plugins/$plugin" "$usr/plugins/$plugin"
done
printf '[Paths]\nPrefix = ..\nPlugins = plugins\nTranslations = share/qt6/translations\n' > "$usr/bin/qt.conf"
for language in sv zh_CN; do # those that the editor speaks, and Qt's buttons with it
    file=$(qmake6 -query QT_INSTALL_TRANSLATIONS)/qtbase_$language.qm
    [ ! -f "$file" ] || install -D --mode=644 "$file" "$usr/share/qt6/translations/qtbase_$language.qm"
done

# Libraries, and the Debian packages that they and the plugins are from.
mkdir -p "$usr/lib" "$usr/spare" "$folder/licenses"
copies=("${plugins[@]/#/"$usr/plugins/"}")
files=("${plugins[@]/#/"$qt_plugins/"}")
mapfile -t originals < <(libraries_of "$usr"/bin/fumage "$usr"/bin/fumage-cli "${copies[@]}")
for library in "${originals[@]}"; do
    soname=${library##*/}
    is_glibc "$soname" && continue
    target=$usr/lib/$soname
    ! is_spare "$soname" || target=$usr/spare/$soname/$soname
    file=$(realpath "$library")
    install -D --mode=644 "$file" "$target"
    files+=("$file")
done
# Packages list some files below /lib, others below /usr/lib, where all of them are.
owned=$(dpkg-query --search "${files[@]}" "${files[@]#/usr}" 2> /dev/null || true)
for file in "${files[@]}"; do
    [[ $owned$'\n' == *": $file"$'\n'* || $owned$'\n' == *": ${file#/usr}"$'\n'* ]] ||
        { echo "no package has $file, so that its licence is not known"; exit 1; }
done
mapfile -t owners < <(sed 's/[:,].*//' <<< "$owned" | sort -u)
for owner in "${owners[@]}"; do
    copyright=/usr/share/doc/$owner/copyright
    cp "$copyright" "$folder/licenses/$owner.txt"
    # The texts that it refers to, which every Debian has.
    grep -oE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$copyright" || true
done | sort -u | while IFS= read -r text; do
    [ ! -f "$text" ] || cp "$text" "$folder/licenses/$(basename "$text")"
done
dpkg-query --show --showformat '${binary:Package} ${Version}, source ${source:Package} ${source:Version}\n' "${owners[@]}" |
    sort -u > "$folder/licenses/packages.txt"
cp "$usr/share/doc/fumage/copyright" "$folder/LICENSE.txt"

# Every file finds the others from where it lies itself: by RUNPATH, which libraries of the system do not inherit. LD_LIBRARY_PATH
# goes before it; AppRun leaves nothing in there that has the name of one of ours.
origin() { # <run path> <files>...
    local path=$1
    shift
    [ $# -eq 0 ] || patchelf --set-rpath "$path" "$@"
}
origin '$ORIGIN/../lib' "$usr"/bin/fumage "$usr"/bin/fumage-cli
origin '$ORIGIN' "$usr"/lib/*.so*
origin '$ORIGIN/../../lib' "${copies[@]}" "$usr"/spare/*/*

# What the system must have. A spare may ask for a newer one: it is only taken where a system of our own age has no such library.
ours=("$usr/bin" "$usr/lib" "$usr/plugins")
glibc=$(symbol_floor GLIBC "${ours[@]}")
glibc_spare=$(symbol_floor GLIBC "$usr/spare")
glibcxx=GLIBCXX_$(symbol_floor GLIBCXX "${ours[@]}")
case $glibc in # the first release of others that has it
2.34) ubuntu=22.04 fedora=35 ;;
2.35) ubuntu=22.04 fedora=36 ;;
2.36) ubuntu=22.10 fedora=37 ;;
*) echo "glibc $glibc: which releases of Ubuntu and Fedora have that? Say it in $0." && exit 1 ;;
esac

# AppDir: what starts it, and what a desktop shows of it.
icu=$(du --bytes --block-size=MB "$usr"/lib/libicudata.so.* | sed 's/MB.*/ MB/')
size=$(du --apparent-size --summarize --block-size=MB "$folder" | sed 's/MB.*/ MB/')
fill() { # <file>: its text with what is known by now
    sed -e "s/@VERSION@/$version/g; s/@ARCHITECTURE@/$architecture/g; s/@GLIBC@/$glibc/g; s/@GLIBCXX@/$glibcxx/g; s/@GLIBC_SPARE@/$glibc_spare/g" \
        -e "s/@MULTIARCH@/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/g; s/@QT@/$(qmake6 -query QT_VERSION)/g" \
        -e "s/@UBUNTU@/$ubuntu/g; s/@FEDORA@/$fedora/g; s/@ICU@/$icu/g; s/@SIZE@/$size/g" "$1"
}
fill "$here/AppRun" > "$folder/AppRun"
fill "$here/README.txt" > "$folder/README.txt"
chmod 755 "$folder/AppRun"
ln -sf AppRun "$folder/fumage"
ln -sf AppRun "$folder/fumage-cli"
cp "$usr/share/applications/fumage.desktop" "$folder/fumage.desktop"
cp "$usr/share/icons/hicolor/scalable/apps/fumage.svg" "$folder/fumage.svg"
cp "$usr/share/icons/hicolor/256x256/apps/fumage.png" "$folder/fumage.png"
ln -sf fumage.png "$folder/.DirIcon"

# Folders are everybody's to read whatever the umask was.
chmod -R u=rwX,go=rX "$folder"
tar --create --use-compress-program="gzip -n" --file "$packages/$name.tar.gz" --sort=name --owner=0 --group=0 --numeric-owner --mtime="${released:-1970-01-01} UTC" \
    --transform "s,^\./,$name/,;s,^\.$,$name," --directory "$folder" .
echo "$name.tar.gz: $(du --block-size=MB "$packages/$name.tar.gz" | sed 's/MB.*/ MB/'), unpacked $size ($icu of it ICU's data), glibc $glibc or newer"
