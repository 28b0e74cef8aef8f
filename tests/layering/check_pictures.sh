#!/usr/bin/env bash
# Warns of a commit that adds more than a megabyte of pictures: the repository keeps every version of them for ever.
# It fails where one adds ten, which no set of pictures of this project needs, and where the pictures of the presets in
# the documents are not of the presets as they are: their checksums were written down when they were rendered.
set -u
cd "$1" || exit 1
if ! diff resources/pictures/rendered.txt tests/golden/golden.txt; then
    echo 'These presets have changed since their pictures were rendered: ./dev pictures'
    exit 1
fi
git rev-parse --verify -q 'HEAD^' > /dev/null 2>&1 || { echo 'no history here'; exit 0; }
total=0
while read -r _ _ _ blob status path; do
    case $status:$path in
    D* | R*) ;;
    *.png | *.jpg | *.gif | *.exr | *.tga) total=$((total + $(git cat-file -s "$blob"))) ;;
    esac
done < <(git diff-tree -r -M 'HEAD^' HEAD)
echo "$((total / 1024)) KiB of pictures in the last commit"
if [ "$total" -gt $((1024 * 1024)) ]; then
    echo 'WARNING: more than 1 MiB. Change pictures once, in one commit at the end.'
fi
[ "$total" -le $((10 * 1024 * 1024)) ]
