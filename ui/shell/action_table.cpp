#include "ui/shell/action_table.h"

#include "ui/face/icons.h"

#include <array>

#include <QCoreApplication>
#include <QWidget>

namespace fumage::ui {

namespace {

constexpr const char* kFile = QT_TRANSLATE_NOOP("Actions", "&File");
constexpr const char* kEdit = QT_TRANSLATE_NOOP("Actions", "&Edit");
constexpr const char* kView = QT_TRANSLATE_NOOP("Actions", "&View");
constexpr const char* kPlay = QT_TRANSLATE_NOOP("Actions", "&Play");
constexpr const char* kCompare = QT_TRANSLATE_NOOP("Actions", "&Compare");
constexpr const char* kHelp = QT_TRANSLATE_NOOP("Actions", "&Help");

constexpr std::array kSpecs{
    ActionSpec{"file.new", kFile, QT_TRANSLATE_NOOP("Actions", "&New"), "Ctrl+N", "new"},
    ActionSpec{"file.newWindow", kFile, QT_TRANSLATE_NOOP("Actions", "New &window"), "Ctrl+Shift+N", ""},
    ActionSpec{"file.open", kFile, QT_TRANSLATE_NOOP("Actions", "&Open…"), "Ctrl+O", "open"},
    ActionSpec{"file.save", kFile, QT_TRANSLATE_NOOP("Actions", "&Save"), "Ctrl+S", "save", false, true},
    ActionSpec{"file.saveAs", kFile, QT_TRANSLATE_NOOP("Actions", "Save &as…"), "Ctrl+Shift+S", ""},
    ActionSpec{"file.saveToLibrary", kFile, QT_TRANSLATE_NOOP("Actions", "Save to the &library…"), "", "star"},
    ActionSpec{"file.revert", kFile, QT_TRANSLATE_NOOP("Actions", "&Revert"), "", ""},
    ActionSpec{"file.export", kFile, QT_TRANSLATE_NOOP("Actions", "&Export…"), "Ctrl+E", "export", false, true},
    ActionSpec{"file.exportAgain", kFile, QT_TRANSLATE_NOOP("Actions", "Export a&gain"), "F12", ""},
    ActionSpec{"file.close", kFile, QT_TRANSLATE_NOOP("Actions", "&Close"), "Ctrl+W", "", false, true},
    ActionSpec{"file.quit", kFile, QT_TRANSLATE_NOOP("Actions", "&Quit"), "Ctrl+Q", ""},

    ActionSpec{"edit.undo", kEdit, QT_TRANSLATE_NOOP("Actions", "&Undo"), "Ctrl+Z", "undo"},
    ActionSpec{"edit.redo", kEdit, QT_TRANSLATE_NOOP("Actions", "&Redo"), "Ctrl+Shift+Z; Ctrl+Y", "redo"},
    ActionSpec{"edit.copyPreset", kEdit, QT_TRANSLATE_NOOP("Actions", "&Copy the preset as JSON"), "Ctrl+Shift+C", "", false, true},
    ActionSpec{"edit.pastePreset", kEdit, QT_TRANSLATE_NOOP("Actions", "&Paste a preset"), "Ctrl+Shift+V", ""},
    ActionSpec{"edit.variations", kEdit, QT_TRANSLATE_NOOP("Actions", "&Variations…"), "Ctrl+R", "variations", false, true},
    ActionSpec{"edit.randomise", kEdit, QT_TRANSLATE_NOOP("Actions", "Randomise a &little"), "Ctrl+Shift+R", "dice"},
    ActionSpec{"edit.resetAll", kEdit, QT_TRANSLATE_NOOP("Actions", "Reset &all parameters"), "", ""},
    ActionSpec{"edit.search", kEdit, QT_TRANSLATE_NOOP("Actions", "&Search parameters"), "Ctrl+F", "search", false, true},
    ActionSpec{"edit.commands", kEdit, QT_TRANSLATE_NOOP("Actions", "Search c&ommands…"), "Ctrl+Shift+P", ""},

    ActionSpec{"view.frameAll", kView, QT_TRANSLATE_NOOP("Actions", "Frame &all"), "F", "frame-all"},
    ActionSpec{"view.front", kView, QT_TRANSLATE_NOOP("Actions", "From the &front"), "1", ""},
    ActionSpec{"view.right", kView, QT_TRANSLATE_NOOP("Actions", "From the &right"), "3", ""},
    ActionSpec{"view.top", kView, QT_TRANSLATE_NOOP("Actions", "From &above"), "7", ""},
    ActionSpec{"view.back", kView, QT_TRANSLATE_NOOP("Actions", "From the bac&k"), "Ctrl+1", ""},
    ActionSpec{"view.left", kView, QT_TRANSLATE_NOOP("Actions", "From the &left"), "Ctrl+3", ""},
    ActionSpec{"view.bottom", kView, QT_TRANSLATE_NOOP("Actions", "From &below"), "Ctrl+7", ""},
    ActionSpec{"view.grid", kView, QT_TRANSLATE_NOOP("Actions", "Ground &grid"), "G", "grid", true, true},
    ActionSpec{"view.emitter", kView, QT_TRANSLATE_NOOP("Actions", "&Emitter outline"), "", "", true},
    ActionSpec{"view.gizmos", kView, QT_TRANSLATE_NOOP("Actions", "Gi&zmos"), "Z", "gizmo", true},
    ActionSpec{"view.tracks", kView, QT_TRANSLATE_NOOP("Actions", "Motion &tracks"), "T", "tracks", true},
    ActionSpec{"view.frame", kView, QT_TRANSLATE_NOOP("Actions", "E&xport frame"), "X", "frame", true},
    ActionSpec{"view.readout", kView, QT_TRANSLATE_NOOP("Actions", "Rea&dout"), "", "", true},
    ActionSpec{"view.checker", kView, QT_TRANSLATE_NOOP("Actions", "&Checker behind the smoke"), "", "tiles", true, true},
    ActionSpec{"view.backdrop", kView, QT_TRANSLATE_NOOP("Actions", "&Backdrop colour…"), "", ""},
    ActionSpec{"view.fullScreen", kView, QT_TRANSLATE_NOOP("Actions", "F&ull screen"), "F11", "", true, true},
    ActionSpec{"view.resetLayout", kView, QT_TRANSLATE_NOOP("Actions", "Reset &layout"), "", ""},

    ActionSpec{"play.toggle", kPlay, QT_TRANSLATE_NOOP("Actions", "&Play or pause"), "Space", "play"},
    ActionSpec{"play.forward", kPlay, QT_TRANSLATE_NOOP("Actions", "One frame &on"), "Right", "step-forward", false, true},
    ActionSpec{"play.back", kPlay, QT_TRANSLATE_NOOP("Actions", "One frame &back"), "Left", "step-back"},
    ActionSpec{"play.start", kPlay, QT_TRANSLATE_NOOP("Actions", "To the &first frame"), "Home", "to-start"},
    ActionSpec{"play.end", kPlay, QT_TRANSLATE_NOOP("Actions", "To the &last frame"), "End", "to-end"},
    ActionSpec{"play.in", kPlay, QT_TRANSLATE_NOOP("Actions", "Range starts &here"), "I", "", false, true},
    ActionSpec{"play.out", kPlay, QT_TRANSLATE_NOOP("Actions", "Range &ends here"), "O", ""},
    ActionSpec{"play.wholeRange", kPlay, QT_TRANSLATE_NOOP("Actions", "&Whole range"), "Shift+I", ""},

    ActionSpec{"compare.remember", kCompare, QT_TRANSLATE_NOOP("Actions", "&Remember this as B"), "Ctrl+B", ""},
    ActionSpec{"compare.split", kCompare, QT_TRANSLATE_NOOP("Actions", "&Split view of A and B"), "S", "compare", true},
    ActionSpec{"compare.hold", kCompare, QT_TRANSLATE_NOOP("Actions", "Show &B (hold the key to look for a moment)"), "B", "", true},
    ActionSpec{"compare.adopt", kCompare, QT_TRANSLATE_NOOP("Actions", "&Adopt B"), "", ""},

    ActionSpec{"help.reference", kHelp, QT_TRANSLATE_NOOP("Actions", "&Parameter reference"), "F1", "help"},
    ActionSpec{"help.shortcuts", kHelp, QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts"), "?", ""},
    ActionSpec{"help.about", kHelp, QT_TRANSLATE_NOOP("Actions", "&About Fumage"), "", "", false, true},
};

} // namespace

std::span<const ActionSpec> actionSpecs()
{
    return kSpecs;
}

QString actionText(const char* key)
{
    return QCoreApplication::translate("Actions", key);
}

QString fullName(const ActionSpec& spec)
{
    const auto plain = [](const char* key) { return actionText(key).remove(QLatin1Char('&')).remove(QChar(0x2026)); };
    return QStringLiteral("%1: %2").arg(plain(spec.menu), plain(spec.text));
}

ActionSet::ActionSet(QWidget* window)
    : QObject(window)
{
    for (const ActionSpec& spec : kSpecs) {
        auto* action = new QAction(actionText(spec.text), this);
        action->setObjectName(QLatin1String(spec.id));
        if (spec.keys[0] != '\0') {
            action->setShortcuts(QKeySequence::listFromString(QLatin1String(spec.keys)));
        }
        action->setCheckable(spec.checkable);
        if (spec.icon[0] != '\0') {
            action->setIcon(themedIcon(QLatin1String(spec.icon)));
        }
        const QString plain = action->text().remove(QLatin1Char('&')).remove(QChar(0x2026));
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? plain : QStringLiteral("%1 (%2)").arg(plain, keys));
        window->addAction(action);
    }
}

QAction& ActionSet::get(const char* id) const
{
    auto* action = findChild<QAction*>(QLatin1String(id));
    Q_ASSERT_X(action != nullptr, "ActionSet::get", id);
    return *action;
}

} // namespace fumage::ui
