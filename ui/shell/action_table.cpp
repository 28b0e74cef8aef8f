#include "ui/shell/action_table.h"

#include "ui/face/icons.h"

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

constexpr ActionSpec kSpecs[] = {
    {.id = "file.new", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&New"), .keys = "Ctrl+N", .icon = "new"},
    {.id = "file.newWindow", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "New &window"), .keys = "Ctrl+Shift+N"},
    {.id = "file.open", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Open…"), .keys = "Ctrl+O", .icon = "open"},
    {.id = "file.save", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Save"), .keys = "Ctrl+S", .icon = "save", .beginsSection = true},
    {.id = "file.saveAs", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "Save &as…"), .keys = "Ctrl+Shift+S"},
    {.id = "file.saveToLibrary", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "Save to the &library…"), .icon = "star"},
    {.id = "file.revert", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Revert")},
    {.id = "file.export", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Export…"), .keys = "Ctrl+E", .icon = "export", .beginsSection = true},
    {.id = "file.exportAgain", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "Export a&gain"), .keys = "F12"},
    {.id = "file.close", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Close"), .keys = "Ctrl+W", .beginsSection = true},
    {.id = "file.quit", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Quit"), .keys = "Ctrl+Q"},

    {.id = "edit.undo", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Undo"), .keys = "Ctrl+Z", .icon = "undo"},
    {.id = "edit.redo", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Redo"), .keys = "Ctrl+Shift+Z; Ctrl+Y", .icon = "redo"},
    {.id = "edit.copyPreset", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Copy the preset as JSON"), .keys = "Ctrl+Shift+C", .beginsSection = true},
    {.id = "edit.pastePreset", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Paste a preset"), .keys = "Ctrl+Shift+V"},
    {.id = "edit.variations", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Variations…"), .keys = "Ctrl+R", .icon = "variations", .beginsSection = true},
    {.id = "edit.randomise", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "Randomise a &little"), .keys = "Ctrl+Shift+R", .icon = "dice"},
    {.id = "edit.resetAll", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "Reset &all parameters")},
    {.id = "edit.search", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Search parameters"), .keys = "Ctrl+F", .icon = "search", .beginsSection = true},
    {.id = "edit.commands", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "Search c&ommands…"), .keys = "Ctrl+Shift+P"},

    {.id = "view.frameAll", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Frame &all"), .keys = "F", .icon = "frame-all"},
    {.id = "view.front", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &front"), .keys = "1"},
    {.id = "view.right", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &right"), .keys = "3"},
    {.id = "view.top", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From &above"), .keys = "7"},
    {.id = "view.back", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the bac&k"), .keys = "Ctrl+1"},
    {.id = "view.left", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &left"), .keys = "Ctrl+3"},
    {.id = "view.bottom", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From &below"), .keys = "Ctrl+7"},
    {.id = "view.grid", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Ground &grid"), .keys = "G", .icon = "grid", .checkable = true, .beginsSection = true},
    {.id = "view.emitter", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "&Emitter outline"), .checkable = true},
    {.id = "view.gizmos", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Gi&zmos"), .keys = "Z", .icon = "gizmo", .checkable = true},
    {.id = "view.tracks", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Motion &tracks"), .keys = "T", .icon = "tracks", .checkable = true},
    {.id = "view.frame", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "E&xport frame"), .keys = "X", .icon = "frame", .checkable = true},
    {.id = "view.readout", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Rea&dout"), .checkable = true},
    {.id = "view.checker", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "&Checker behind the smoke"), .icon = "tiles", .checkable = true, .beginsSection = true},
    {.id = "view.backdrop", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "&Backdrop colour…")},
    {.id = "view.fullScreen", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "F&ull screen"), .keys = "F11", .checkable = true, .beginsSection = true},
    {.id = "view.resetLayout", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "Reset &layout")},

    {.id = "play.toggle", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "&Play or pause"), .keys = "Space", .icon = "play"},
    {.id = "play.forward", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "One frame &on"), .keys = "Right", .icon = "step-forward", .beginsSection = true},
    {.id = "play.back", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "One frame &back"), .keys = "Left", .icon = "step-back"},
    {.id = "play.start", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "To the &first frame"), .keys = "Home", .icon = "to-start"},
    {.id = "play.end", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "To the &last frame"), .keys = "End", .icon = "to-end"},
    {.id = "play.in", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "Range starts &here"), .keys = "I", .beginsSection = true},
    {.id = "play.out", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "Range &ends here"), .keys = "O"},
    {.id = "play.wholeRange", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "&Whole range"), .keys = "Shift+I"},

    {.id = "compare.remember", .menu = kCompare, .text = QT_TRANSLATE_NOOP("Actions", "&Remember this as B"), .keys = "Ctrl+B"},
    {.id = "compare.split", .menu = kCompare, .text = QT_TRANSLATE_NOOP("Actions", "&Split view of A and B"), .keys = "S", .icon = "compare", .checkable = true},
    {.id = "compare.hold", .menu = kCompare, .text = QT_TRANSLATE_NOOP("Actions", "Show &B (hold the key to look for a moment)"), .keys = "B", .checkable = true},
    {.id = "compare.adopt", .menu = kCompare, .text = QT_TRANSLATE_NOOP("Actions", "&Adopt B")},

    {.id = "help.reference", .menu = kHelp, .text = QT_TRANSLATE_NOOP("Actions", "&Parameter reference"), .keys = "F1", .icon = "help"},
    {.id = "help.shortcuts", .menu = kHelp, .text = QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts"), .keys = "?"},
    {.id = "help.about", .menu = kHelp, .text = QT_TRANSLATE_NOOP("Actions", "&About Fumage"), .beginsSection = true},
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
