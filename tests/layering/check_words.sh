#!/usr/bin/env bash
# Looks for names that have made room for those of the field, and for lines that are too wide to be read beside another file.
set -u
cd "$1" || exit 1
failed=0
complain() { # <what is wrong> <where>
    [ -z "$2" ] && return
    printf '%s:\n%s\n' "$1" "$2"
    failed=1
}
sources=(--include='*.h' --include='*.cpp')
gone='Haste|Studio|PictureFeed|PictureRequest|SpriteScene|LatestJob|AnswerJob|HandGuard|ViewportHand|ExportDesk|ExportEntry'
gone+='|ExportClash|OnClash|NumberOn|KeyGuard|AirShelf|AirRun|KeptSteps|SlotRing|BirthPlace|bear\w*|bury|PictureNotes'
gone+='|growLoneParticles|fixedPart|kEssentials|kOtherGroups|kCosts|k(Most|Least|Fewest)([A-Z]\w*)?|m_ear|knowsQueue'
gone+='|mayLeave|proveHarmless|giveWay|putAside|setPutAway|mostAlphaOnTheBorder'
complain 'names that the field has other words for' \
    "$(grep -rnwE "($gone)" core ui app tests "${sources[@]}" || true)"
complain 'messages are made by makeMessage() and translated by translated()' \
    "$(grep -rnE '\b(said|told)\(' core ui app "${sources[@]}" || true)"
complain 'layers are those of a scene, of which these rooms know nothing: rows of noise lie in planes' \
    "$(grep -rnE '\w*(Layer|layer)s?\b' core/base core/system core/image_io core/noise core/flow "${sources[@]}" || true)"
complain 'texts that artists know otherwise' "$(grep -rnE "\"(Start warm|Moving air|Raggedness|Uneven heat|Mouse habits\
|Put into this document|Begin with a smoke|Steps a frame|Only the smoke|Adopt B|Throw the dice.*|One frame (on|back).*)\"" \
    core ui app "${sources[@]}" || true)"
complain 'lines of more than 120 columns' "$(grep -rnE '^.{121,}' core ui app tests "${sources[@]}" \
    | grep -vE 'R"|^tests/[^:]*:[0-9]+: *(R?"|\\)' || true)"
exit $failed
