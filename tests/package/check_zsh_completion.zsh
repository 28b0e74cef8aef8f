#!/usr/bin/env zsh
# Completes some command lines in an interactive zsh at a press of Tab:  check_zsh_completion.zsh <script>
zmodload zsh/zpty || exit 1
script=${1:A}
work=$(mktemp -d)
trap 'rm -rf $work' EXIT
cp $script $work/_fumage-cli
cd $work

# A zsh of its own, in which Tab ends the program and prints what the line has become.
zpty shell "env -i HOME=$work TERM=dumb LANG=C.UTF-8 zsh -f -i"
zpty -w shell "PS1= PS2=; fpath=($work \$fpath); autoload -Uz compinit; compinit -u -d $work/dump; zstyle ':completion:*' menu no; LISTMAX=1000
show() { zle complete-word; print -r -- \"<line>\$BUFFER</line>\"; BUFFER=; zle accept-line }; zle -N show; bindkey '^I' show; print READ\Y"
zpty -r shell output '*READY*'

expect() { # <line> <what it becomes>
    local output
    zpty -w -n shell "$1"$'\t'
    zpty -r shell output '*</line>*' || { print "zsh has ended"; exit 1; }
    output=${${output##*<line>}%%</line>*}
    [[ $output == ${~2} ]] || { print -r -- "'$1' is completed to '$output', not '$2'"; exit 1; }
}
expect 'fumage-cli rend' 'fumage-cli render *'
expect 'fumage-cli render campf' 'fumage-cli render campfire *'
expect 'fumage-cli render campfire --form' 'fumage-cli render campfire --format *'
expect 'fumage-cli render campfire --format png1' 'fumage-cli render campfire --format png16 *'
expect 'fumage-cli render campfire --set motion.grav' 'fumage-cli render campfire --set motion.gravity=*'
expect 'fumage-cli completions ba' 'fumage-cli completions bash *'
zpty -d shell
print "zsh completes"
