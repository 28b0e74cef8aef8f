#!/usr/bin/env bash
# Has compilers read the scripts that flipbooks bring for Unity and Unreal. Needs mono-mcs and python3.
#   syntax.sh <fumage-cli>
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for engine in unity unreal; do
    "$1" flipbook thesis-2012 --for "$engine" --size 32 --grid 2x2 --output "$folder/a \"b' é&.png" > /dev/null 2>&1
done
mcs --parse -define:UNITY_EDITOR "$folder"/Editor/*.cs
python3 -m py_compile "$folder"/*_unreal.py
echo "C# and Python read them."
