#!/usr/bin/env bash
# Writes the manual pages of a program from its own help, one for each subcommand:  make_manual.sh <program> <what it is> <folder>
set -euo pipefail
program=$(realpath "$1")
what=$2
folder=$3
name=$(basename "$program")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8 HOME=$work XDG_RUNTIME_DIR=$work
version=$("$program" --version | sed 's/.* //')

# The help as help2man likes it: headings between stars, examples behind a dollar, no types that only the parser of options knows.
cat > "$work/style.sed" <<'SED'
s/^\(Positionals\|Arguments\):$/*Arguments*/
s/^Subcommands:$/*Subcommands*/
s/^\(Examples\|Start with\):$/\nExamples:/
s/^  \(fumage[a-z-]* \)/  $ \1/
s/^Exit codes: /*Exit status*\n\n/
s/^  -\([a-zA-Z]\),--/  -\1, --/
s/\(INT\|UINT\|FLOAT\|TEXT\):\({[^}]*}\|[A-Z]* in \[[^]]*\]\)/\2/
s/\(INT\|UINT\|FLOAT\) in \[\([0-9.]*\) - \([0-9.]*\)\]/\2..\3/
s/^\(  .*\) REQUIRED\( \|$\)/\1\2/
SED

page() { # <page> <what it is> <see also> <more sections> [subcommand]
    local page=$1 sentence=$2 also=$3 more=$4
    shift 4
    # help2man asks the program under the name of the page.
    cat > "$work/$page" <<SCRIPT
#!/bin/sh
[ "\$1" = --version ] && echo "$page $version" && exit
"$program" $* --help | sed -f "$work/style.sed"
SCRIPT
    chmod +x "$work/$page"
    printf '%s[SEE ALSO]\n%s\n' "${more:+$more$'\n\n'}" "$also" > "$work/include"
    help2man --no-info --source="Fumage $version" --manual="User Commands" --name="$sentence" --include="$work/include" --output="$work/$page.1" "$work/$page"
    mkdir -p "$folder"
    gzip -9n < "$work/$page.1" > "$folder/$page.1.gz"
}

references() { # man's macro for one reference a line, with commas between
    printf '%s\n' "$@" | sed 's/.*/.BR & (1),/; $s/,$//'
}

# What only the page of the whole program has: keys, where the program prints them, files and environment.
sections() {
    if grep -e '--keys' <<< "$help" > /dev/null; then
        printf '[KEYS]\n'
        "$program" --keys | sed 's/\\/\\e/g; s/^\(.*\)\t\(.*\)$/.TP\n.B \1\n\2/'
        printf '\n'
    fi
    if [ -f "$here/$name.h2m" ]; then
        cat "$here/$name.h2m"
        printf '\n\n'
    fi
}

# The subcommands as the help lists them: a name and a sentence a line, up to the next empty line.
help=$("$program" --help)
mapfile -t subcommands < <(sed -n '/^Subcommands:$/,/^$/{s/^  \([a-z][a-z-]*\) .*/\1/p}' <<< "$help")
others=("${subcommands[@]/#/$name-}")
[ "$name" != fumage ] || others=(fumage-cli)
page "$name" "$what" "$(references "${others[@]}")" "$(sections)"
for subcommand in "${subcommands[@]}"; do
    sentence=$("$program" "$subcommand" --help | sed -n 1p)
    page "$name-$subcommand" "${sentence,}" "$(references "$name")" '' "$subcommand"
done
