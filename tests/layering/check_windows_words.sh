#!/usr/bin/env bash
# Headers of Windows, which Qt's bring along there, make macros of common words. They name nothing in headers of the core, nor anywhere in the editor:
# compilers for Linux see no fault in them, and nothing else would tell. What is for Windows alone means the macros.  check_windows_words.sh <source tree>
set -euo pipefail
cd "$1"
words='near|far|small|hyper|interface|pascal|cdecl|ERROR|NO_ERROR|IN|OUT|OPTIONAL|CALLBACK|CONST|VOID|TRUE|FALSE|DELETE|IGNORE|STRICT|OPAQUE|TRANSPARENT|ABSOLUTE|RELATIVE|DIFFERENCE|GetObject|SendMessage|CreateWindow|DrawText|LoadImage|GetMessage|PlaySound'
# Comments and texts may say what they like.
plain() {
    sed -E 's/"([^"\\]|\\.)*"//g; s|//.*||; s|^ *#.*||' "$1"
}
found=0
while IFS= read -r file; do
    if hits=$(plain "$file" | grep -nwE "$words"); then
        printf '%s\n' "$hits" | sed "s|^|$file:|"
        found=1
    fi
done < <(find core -name '*.h' -print; find ui app/editor \( -name '*.h' -o -name '*.cpp' \) ! -name '*_windows.cpp' -print)
((found == 0)) || { echo "Windows's headers make macros of these words: choose others."; exit 1; }
