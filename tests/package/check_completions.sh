#!/usr/bin/env bash
# Completes command lines with the scripts that the program prints:  check_completions.sh <fumage-cli>
set -euo pipefail
here=$(dirname "$0")
scripts=$(mktemp -d)
trap 'rm -rf "$scripts"' EXIT
"$1" completions bash > "$scripts/fumage-cli"
"$1" completions zsh > "$scripts/_fumage-cli"
bash "$here/check_bash_completion.sh" "$scripts/fumage-cli"
if command -v zsh > /dev/null; then
    zsh "$here/check_zsh_completion.zsh" "$scripts/_fumage-cli"
fi
