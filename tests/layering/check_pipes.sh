#!/usr/bin/env bash
# No script, template or example pipes into a program that leaves before it has read all: whoever still writes dies of SIGPIPE, which under pipefail is a
# failure that comes and goes with the load of the machine.  check_pipes.sh <source tree>
set -euo pipefail
cd "$1"
leaves='(?<![|\\])\|&? *(?:[A-Z_]+=\S* )*(?:head\b|(?:z|e|f)?grep (?:[^|;]* )?-(?:[a-zA-Z]*[qm]|-quiet|-silent|-max-count)|sed [^|]*[0-9$/ ;{\x27"]q(?:[\x27"};]|$)|awk [^|]*\bexit\b)'
texts=(dev .ci/run README.md .github/CONTRIBUTING.md)
while IFS= read -r text; do
    texts+=("$text")
done < <(find app core ui cmake resources tests -type f \( -name '*.sh' -o -name '*.zsh' -o -name '*.mustache' -o -name '*.md' -o -name '*.cmake' -o -name CMakeLists.txt -o -name '*.py' \) |
    grep -v '^tests/layering/check_pipes.sh$' | sort)
for bad in 'a | head -1' 'a | grep -q b' 'a | grep -E -m 1 b' 'a | LC_ALL=C grep -iq b' 'a | sed 1q' 'a | sed -n "/b/{p;q}"' "a | awk '{ print; exit }'"; do
    grep -P "$leaves" <<< "$bad" > /dev/null || { echo "the rule does not see: $bad"; exit 1; }
done
for good in 'a | sed -n 1p' 'a | grep b > /dev/null' 'grep -q b file' 'a || grep -q b file' "a | grep 'b\\|head'" 'a | sed "s/q/p/"' 'a | tail -1'; do
    if grep -P "$leaves" <<< "$good"; then
        echo "the rule finds fault with what is good"
        exit 1
    fi
done
if grep -nP "$leaves" "${texts[@]}"; then
    echo "Whoever writes into these dies of SIGPIPE when the reader leaves early: sed -n 1p instead of head -1, grep > /dev/null instead of grep -q."
    exit 1
fi
