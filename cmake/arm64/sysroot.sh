#!/usr/bin/env bash
# Unpacks Debian's arm64 packages into a folder, for cross-building: no root, and nothing of this machine's own packages is touched.
#   sysroot.sh <folder> <packages>...
set -euo pipefail
root=$(realpath -m "$1")
shift
wanted="$*"
[ "$(cat "$root/packages" 2>/dev/null)" != "$wanted" ] || exit 0
command -v apt-get > /dev/null && command -v dpkg-deb > /dev/null || { echo "Only Debian and its kin know where arm64 packages come from: apt-get is missing."; exit 1; }

echo "Fetching arm64 packages into $root"
apt=$root.apt
rm -rf "$root" "$apt"
mkdir -p "$root" "$apt"/{lists/partial,cache/archives/partial}
touch "$apt/status"
options=(-qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o APT::Install-Recommends=false -o Dir::State="$apt" -o Dir::State::status="$apt/status"
    -o Dir::State::Lists="$apt/lists" -o Dir::Cache="$apt/cache" -o Debug::NoLocking=true -o APT::Sandbox::User="$(id -un)")
apt-get "${options[@]}" update
apt-get "${options[@]}" --yes --download-only install "$@" > /dev/null
# The links of a merged /usr come first: packages still name /lib.
mkdir -p "$root"/usr/{lib,bin,sbin}
ln -s usr/lib usr/bin usr/sbin "$root"
for package in "$apt"/cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C "$root"
done
# Links to /usr/lib/... would lead out of the folder.
find "$root/usr/lib" -type l -lname '/*' | while read -r link; do
    ln -sfn "$(realpath -m --relative-to="$(dirname "$link")" "$root$(readlink "$link")")" "$link"
done
# Qt's own tools (moc) have to run here.
rm -rf "$root/usr/lib/qt6/libexec"
ln -s /usr/lib/qt6/libexec "$root/usr/lib/qt6/libexec"
echo "$wanted" > "$root/packages"
