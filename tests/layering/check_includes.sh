#!/usr/bin/env bash
# Greps the includes: rooms of the core may look only the allowed way, and nothing of it at Qt or OpenGL.
set -u
here=$(cd "$(dirname "$0")" && pwd)
cd "$1" || exit 1
failed=0
forbid() { # <folder> <pattern of includes> <why>
    local found
    found=$(grep -rnP "#include *[<\"]($2)" "$1" --include='*.h' --include='*.cpp' || true)
    if [ -n "$found" ]; then
        printf '%s\n%s\n' "$3:" "$found"
        failed=1
    fi
}
forbid core 'Q[A-Z]|Qt|GL/|epoxy' 'core knows no Qt and no OpenGL'
forbid core 'ui/|app/' 'core does not know the editor or the programs'
forbid app/cli 'Q[A-Z]|Qt|ui/' 'the command line knows no Qt'
forbid ui 'app/' 'the editor library does not know the programs'
forbid ui/document 'ui/(panels|preview|viewport|noise_preview|timeline|presets|export|help|shell)/' 'the document does not know what shows it'
forbid ui/widgets 'ui/(document|panels|preview|viewport|noise_preview|timeline|presets|export|help|shell|theme)/' 'widgets do not know who uses them'
forbid ui/theme 'ui/(document|panels|preview|viewport|noise_preview|timeline|presets|export|help|shell)/' 'the theme does not know who wears it'
forbid ui/help 'ui/(?!help/|widgets/|theme/)' 'the manual knows pages and no document'
forbid ui/concurrency 'ui/(document|panels|preview|viewport|noise_preview|timeline|presets|export|help|shell|widgets|theme)/' 'threads do not know what they are for'
forbid ui/panels 'ui/(preview|viewport|noise_preview|timeline|presets|export|help|shell)/' 'panels know the document alone'
forbid ui/timeline 'ui/(preview|viewport|noise_preview|presets|export|help|shell)/' 'the timeline knows the document alone'
forbid ui/preview 'ui/(?!preview/|concurrency/)' 'pictures know values and the core alone'
forbid ui/preview 'Q(?!(Object|Timer|ElapsedTimer|List|Image|Size|RectF|MetaType)>)' 'pictures know no widgets'
forbid ui/viewport 'ui/(panels|noise_preview|presets|export|help|shell)/' 'the viewport knows document, pictures and timeline'
forbid ui/noise_preview 'ui/(panels|preview|viewport|timeline|presets|export|help|shell)/' 'the noise pane knows the document alone'
forbid ui/presets 'ui/(viewport|noise_preview|timeline|export|help|shell)/' 'presets know document and pictures'
forbid ui/export 'ui/(preview|viewport|noise_preview|presets|help|shell)/' 'export knows document, panels and timeline'
boxes=$(grep -rn '#include <QMessageBox>' ui --include='*.h' --include='*.cpp' | grep -v '^ui/widgets/message_box' || true)
if [ -n "$boxes" ]; then
    printf '%s\n%s\n' 'texts of files are shown by MessageBox, which takes nothing for HTML:' "$boxes"
    failed=1
fi
# What fills templates is written as their language has it: TemplateFacts lets nothing else in, and templates have no other way to ask.
fillers=$(grep -rln 'kainjow' core ui app --include='*.h' --include='*.cpp' | grep -v '^core/export/templates/template_facts.cpp$' || true)
raw=$(grep -rn -e '{{{' -e '{{ *&' resources/engines resources/farm || true)
if [ -n "$fillers$raw" ]; then
    printf '%s\n%s%s\n' 'names from outside become code only by core/export/templates:' "$fillers" "$raw"
    failed=1
fi
statements=$(python3 "$here/statements.py" ui)
search() { # <pattern> <files that may> <why>
    local found
    found=$(grep -P "$1" <<< "$statements" | grep -vP "^($2)" || true)
    if [ -n "$found" ]; then
        printf '%s\n%s\n' "$3:" "$found"
        failed=1
    fi
}
search '#include <(thread|future)>|\bQThread\b|QtConcurrent' 'ui/concurrency/' 'threads of the editor are of ui/concurrency, where nothing that is thrown ends the program'
# A literal, a choice of two, or what makes plain text of anything.
literal='tr\("([^"\\]|\\.)*"\)'
plain="($literal|[^()]* \? $literal : $literal|(plainToolTip|titledToolTip|toolTipOf)\(.*\))"
search "(setToolTip|setWhatsThis|setStatusTip)\((?!$plain\);)|QToolTip::showText\((?!.*plainToolTip|.*,\$)|(ToolTip|WhatsThis|StatusTip)Role(?!: return plainToolTip\()" 'ui/widgets/plain_text' 'tool tips are literals, or go through plain_text.h'
search 'Qt::RichText|Qt::AutoText|Qt::MarkdownText|setHtml|insertHtml|setMarkdown' 'ui/widgets/plain_text|ui/shell/help|ui/help/manual_document' 'only the help is HTML'
forbid core/base 'core/(system|image_io|effect|preset|noise|flow|simulation|lighting|rendering|export|live|c)/' 'base stands below everything'
forbid core/system 'core/(image_io|effect|preset|noise|flow|simulation|lighting|rendering|export|live|c)/' 'what systems do differently knows only base'
forbid core/scene 'core/(preset|noise|flow|simulation|lighting|rendering|export|live|c)/' 'a scene is plain data above effects'
forbid core/image_io 'core/(effect|scene|preset|noise|flow|simulation|lighting|rendering|export|live|c)/' 'files of pictures know only base'
forbid core/effect 'core/(scene|preset|noise|flow|simulation|lighting|rendering|export|live|c)/' 'effect knows base, and files of pictures, which it may hold'
forbid core/preset 'core/(noise|flow|simulation|lighting|rendering|export|live|c)/' 'preset knows effect, files of pictures and base'
forbid core/noise 'core/(preset|flow|simulation|lighting|rendering|export|live|c)/' 'noise does not know what uses it'
forbid core/flow 'core/(preset|simulation|lighting|rendering|export|live|c)/' 'the air knows no particles'
forbid core/simulation 'core/(preset|lighting|rendering|export|live|c)/' 'simulation does not know rendering'
forbid core/lighting 'core/(preset|rendering|export|live|c)/' 'lighting does not know rendering'
forbid core/rendering 'core/(preset|export|live|c)/' 'rendering does not know files'
forbid core/export 'core/(live|c)/' 'files know no game'
forbid core/live 'core/(preset|rendering|export|c)/' 'live smoke knows no files and no pictures'
exit $failed
