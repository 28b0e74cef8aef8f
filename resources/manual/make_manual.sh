#!/usr/bin/env bash
# Writes the manual pages of a program from its own help, one for each subcommand:  make_manual.sh <program> <what it is> <folder>
set -euo pipefail
program=$(realpath "$1")
what=$2
folder=$3
name=$(basename "$program")
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

page() { # <page> <what it is> <see also> [subcommand]
    local page=$1 sentence=$2 also=$3
    shift 3
    # help2man asks the program under the name of the page.
    cat > "$work/$page" <<SCRIPT
#!/bin/sh
[ "\$1" = --version ] && echo "$page $version" && exit
"$program" $* --help | sed -f "$work/style.sed"
SCRIPT
    chmod +x "$work/$page"
    printf '[SEE ALSO]\n%s\n' "$also" > "$work/include"
    help2man --no-info --source="Fumage $version" --manual="User Commands" --name="$sentence" --include="$work/include" --output="$work/$page.1" "$work/$page"
    mkdir -p "$folder"
    gzip -9n < "$work/$page.1" > "$folder/$page.1.gz"
}

references() { # man's macro for one reference a line, with commas between
    printf '%s\n' "$@" | sed 's/.*/.BR & (1),/; $s/,$//'
}

# The subcommands as the help lists them: a name and a sentence a line, up to the next empty line.
mapfile -t subcommands < <("$program" --help | sed -n '/^Subcommands:$/,/^$/{s/^  \([a-z][a-z-]*\) .*/\1/p}')
others=("${subcommands[@]/#/$name-}")
[ "$name" != fumage ] || others=(fumage-cli)
page "$name" "$what" "$(references "${others[@]}")"
for subcommand in "${subcommands[@]}"; do
    sentence=$("$program" "$subcommand" --help | sed -n 1p)
    page "$name-$subcommand" "${sentence,}" "$(references "$name")" "$subcommand"
done
