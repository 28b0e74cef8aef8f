#include "ui/shell/action_table.h"

#include "ui/theme/icons.h"
#include "ui/widgets/gesture.h"
#include "ui/widgets/plain_text.h"

#include <string_view>

#include <QCoreApplication>
#include <QMenu>

namespace fumage::ui {

namespace {

constexpr const char* kFile = QT_TRANSLATE_NOOP("Actions", "&File");
constexpr const char* kEdit = QT_TRANSLATE_NOOP("Actions", "&Edit");
constexpr const char* kView = QT_TRANSLATE_NOOP("Actions", "&View");
constexpr const char* kPlay = QT_TRANSLATE_NOOP("Actions", "&Play");
constexpr const char* kCompare = QT_TRANSLATE_NOOP("Actions", "&Compare");
constexpr const char* kHelp = QT_TRANSLATE_NOOP("Actions", "&Help");

using enum ActionKind;

constexpr ActionSpec kSpecs[] = {
    {.id = "file.new",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&New"),
        .keys = "Ctrl+N",
        .icon = "new",
        .words = "create blank empty start"},
    {.id = "file.start",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "New from a p&reset…"),
        .words = "start begin welcome template gallery"},
    {.id = "file.newWindow",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "New &window"),
        .keys = "Ctrl+Shift+N"},
    {.id = "file.open",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Open…"),
        .keys = "Ctrl+O",
        .icon = "open",
        .words = "load import preset"},
    {.id = "file.recent",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "Open &recent"),
        .kind = Submenu,
        .words = "history last"},
    {.id = "file.save",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Save"),
        .keys = "Ctrl+S",
        .icon = "save",
        .lineAbove = true},
    {.id = "file.saveAs", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "Save &as…"), .keys = "Ctrl+Shift+S"},
    {.id = "file.saveToLibrary",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "Save to the &library…"),
        .icon = "star",
        .words = "preset store keep favourite"},
    {.id = "file.revert",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Revert"),
        .words = "discard reload undo all"},
    {.id = "file.export",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Export…"),
        .keys = "Ctrl+E",
        .icon = "export",
        .lineAbove = true,
        .words = "render unity unreal godot engine flipbook sheet video movie gif png exr picture vdb volume output "
                 "save image"},
    {.id = "file.engine",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Into my engine…"),
        .keys = "Ctrl+Shift+E",
        .icon = "engine",
        .words = "unity unreal godot web html effekseer game engine flipbook sheet export quick import"},
    {.id = "file.exportAgain", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "Export a&gain"), .keys = "F12"},
    {.id = "file.close",
        .menu = kFile,
        .text = QT_TRANSLATE_NOOP("Actions", "&Close"),
        .keys = "Ctrl+W",
        .lineAbove = true},
    {.id = "file.quit", .menu = kFile, .text = QT_TRANSLATE_NOOP("Actions", "&Quit"), .keys = "Ctrl+Q"},

    {.id = "edit.undo", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "&Undo"), .keys = "Ctrl+Z", .icon = "undo"},
    {.id = "edit.redo",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Redo"),
        .keys = "Ctrl+Shift+Z; Ctrl+Y",
        .icon = "redo"},
    {.id = "edit.copyPreset",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Copy the preset as JSON"),
        .keys = "Ctrl+Shift+C",
        .lineAbove = true},
    {.id = "edit.pastePreset",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Paste a preset"),
        .keys = "Ctrl+Shift+V"},
    {.id = "edit.cutLayers",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Cu&t the layers"),
        .keys = "Ctrl+X",
        .lineAbove = true},
    {.id = "edit.copyLayers",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "C&opy the layers"),
        .keys = "Ctrl+C"},
    {.id = "edit.pasteLayers",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Past&e layers"),
        .keys = "Ctrl+V",
        .words = "insert clipboard"},
    {.id = "edit.pasteParameters",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Paste para&meters…"),
        .keys = "Ctrl+Alt+V",
        .words = "attributes layer groups clipboard"},
    {.id = "edit.duplicateLayers",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Duplicate the layers"),
        .keys = "Ctrl+D"},
    {.id = "edit.deleteLayers",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Delete the la&yers"),
        .keys = "Del",
        .words = "remove"},
    {.id = "edit.variations",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Variations…"),
        .keys = "Ctrl+R",
        .icon = "variations",
        .lineAbove = true,
        .words = "random explore gallery evolve"},
    {.id = "edit.randomise",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Randomise s&lightly"),
        .keys = "Ctrl+Shift+R",
        .icon = "dice",
        .words = "random dice surprise mutate"},
    {.id = "edit.resetAll", .menu = kEdit, .text = QT_TRANSLATE_NOOP("Actions", "Reset &all parameters")},
    {.id = "edit.search",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "&Search parameters"),
        .keys = "Ctrl+F",
        .icon = "search",
        .lineAbove = true,
        .words = "find"},
    {.id = "edit.commands",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Search c&ommands…"),
        .keys = "Ctrl+Shift+P",
        .words = "palette command"},
    {.id = "edit.preferences",
        .menu = kEdit,
        .text = QT_TRANSLATE_NOOP("Actions", "Pre&ferences…"),
        .keys = "Ctrl+,",
        .lineAbove = true,
        .words = "settings options configuration theme language memory start welcome OpenGL recovery cache threads "
                 "thumbnails"},

    {.id = "view.frameAll",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Frame &all"),
        .keys = "F",
        .icon = "frame-all",
        .words = "zoom fit camera centre center reset"},
    {.id = "view.frameAnimation",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Frame the &whole animation"),
        .keys = "Shift+F",
        .words = "zoom fit camera centre center loop"},
    {.id = "view.frameWithoutOutliers",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Frame the animation without outlier&s"),
        .words = "zoom fit camera centre center loop ignore sparks stray crop"},
    {.id = "view.front", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &front"), .keys = "1"},
    {.id = "view.right", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &right"), .keys = "3"},
    {.id = "view.top", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From &above"), .keys = "7"},
    {.id = "view.back", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the bac&k"), .keys = "Ctrl+1"},
    {.id = "view.left", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From the &left"), .keys = "Ctrl+3"},
    {.id = "view.bottom", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "From &below"), .keys = "Ctrl+7"},
    {.id = "view.previous",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Pre&vious view"),
        .keys = "Alt+Left",
        .lineAbove = true,
        .words = "undo camera back"},
    {.id = "view.next",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Next view"),
        .keys = "Alt+Right",
        .words = "redo camera forward"},
    {.id = "view.resetCamera",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Reset the ca&mera"),
        .words = "view default home camera"},
    {.id = "view.endSolo",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "End s&olo"),
        .words = "layers isolate show all"},
    {.id = "view.copyFrame",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Cop&y the picture"),
        .words = "clipboard screenshot frame image"},
    {.id = "view.grid",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Ground &grid"),
        .keys = "G",
        .icon = "grid",
        .kind = Switch,
        .lineAbove = true},
    {.id = "view.emitter", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "&Emitter outline"), .kind = Switch},
    {.id = "view.gizmos",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Gi&zmos"),
        .keys = "Z",
        .icon = "gizmo",
        .kind = Switch,
        .words = "handles arrows labels overlay hide"},
    {.id = "view.trails",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Particle pa&ths"),
        .keys = "T",
        .icon = "trails",
        .kind = Switch},
    {.id = "view.air", .menu = kView, .text = QT_TRANSLATE_NOOP("Actions", "A&ir"), .keys = "A", .kind = Switch},
    {.id = "view.frame",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "E&xport frame"),
        .keys = "X",
        .icon = "frame",
        .kind = Switch},
    {.id = "view.readout",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Rea&dout"),
        .kind = Switch,
        .words = "fps statistics performance info"},
    {.id = "view.checker",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Checkerboard"),
        .icon = "tiles",
        .kind = Switch,
        .lineAbove = true,
        .words = "background transparent alpha"},
    {.id = "view.backdrop",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Backdrop colour…"),
        .words = "background"},
    {.id = "view.panels",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Panels"),
        .kind = Submenu,
        .lineAbove = true},
    {.id = "view.mouseHabits",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Navigation style"),
        .kind = Submenu,
        .words = "navigation preferences settings orbit blender maya unity"},
    {.id = "view.language",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Lan&guage"),
        .kind = Submenu,
        .words = "preferences settings translation swedish chinese english"},
    {.id = "view.theme",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "T&heme"),
        .kind = Submenu,
        .words = "preferences settings dark light colours colors"},
    {.id = "view.fullScreen",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "F&ull screen"),
        .keys = "F11",
        .kind = Switch,
        .lineAbove = true},
    {.id = "view.smokeOnly",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "&Hide panels"),
        .keys = "Shift+Space",
        .kind = Switch,
        .words = "hide panels presentation zen"},
    {.id = "view.resetLayout",
        .menu = kView,
        .text = QT_TRANSLATE_NOOP("Actions", "Reset &layout"),
        .words = "workspace windows docks panels default"},

    {.id = "play.toggle",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "&Play or pause"),
        .keys = "Space",
        .icon = "play",
        .words = "start stop animation playback"},
    {.id = "play.forward",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "&Next frame"),
        .keys = "Right",
        .icon = "step-forward",
        .lineAbove = true},
    {.id = "play.back",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "&Previous frame"),
        .keys = "Left",
        .icon = "step-back"},
    {.id = "play.start",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Go to &start"),
        .keys = "Home",
        .icon = "to-start"},
    {.id = "play.end",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Go to &end"),
        .keys = "End",
        .icon = "to-end"},
    {.id = "play.previousKey",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Previous &key frame"),
        .keys = "Ctrl+Left",
        .lineAbove = true,
        .words = "keyframe animation jump"},
    {.id = "play.nextKey",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Next ke&y frame"),
        .keys = "Ctrl+Right",
        .words = "keyframe animation jump"},
    {.id = "play.autoKey",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "&Auto-key: each edit sets a key frame"),
        .keys = "Shift+K",
        .kind = Switch,
        .words = "keyframe record animate automatic"},
    {.id = "play.addMarker",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Add a &marker"),
        .keys = "M",
        .lineAbove = true,
        .words = "event cue flag label timeline"},
    {.id = "play.previousMarker",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Pre&vious marker"),
        .keys = "Shift+Left",
        .words = "event cue flag jump"},
    {.id = "play.nextMarker",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Ne&xt marker"),
        .keys = "Shift+Right",
        .words = "event cue flag jump"},
    {.id = "play.graph",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "&Graph of key frames"),
        .keys = "Shift+G",
        .icon = "graph",
        .kind = Switch,
        .words = "keyframe curve animation editor bezier handle tangent f-curve"},
    {.id = "play.in",
        .menu = kPlay,
        .text = QT_TRANSLATE_NOOP("Actions", "Set &in point"),
        .keys = "I",
        .lineAbove = true},
    {.id = "play.out", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "Set &out point"), .keys = "O"},
    {.id = "play.wholeRange", .menu = kPlay, .text = QT_TRANSLATE_NOOP("Actions", "&Whole range"), .keys = "Shift+I"},

    {.id = "compare.remember",
        .menu = kCompare,
        .text = QT_TRANSLATE_NOOP("Actions", "&Store as B"),
        .keys = "Ctrl+B",
        .words = "ab a/b snapshot"},
    {.id = "compare.split",
        .menu = kCompare,
        .text = QT_TRANSLATE_NOOP("Actions", "&Split view of A and B"),
        .keys = "S",
        .icon = "compare",
        .kind = Switch,
        .words = "ab a/b side"},
    {.id = "compare.hold",
        .menu = kCompare,
        .text = QT_TRANSLATE_NOOP("Actions", "Show &B (hold the key to look for a moment)"),
        .keys = "B",
        .kind = Switch},
    {.id = "compare.adopt", .menu = kCompare, .text = QT_TRANSLATE_NOOP("Actions", "&Replace A with B")},

    {.id = "help.manual",
        .menu = kHelp,
        .text = QT_TRANSLATE_NOOP("Actions", "&Manual"),
        .keys = "F1",
        .icon = "help",
        .words = "parameter reference documentation tutorial guide learn how"},
    {.id = "help.tour",
        .menu = kHelp,
        .text = QT_TRANSLATE_NOOP("Actions", "&Tour"),
        .words = "tutorial begin introduction learn how first"},
    {.id = "help.shortcuts",
        .menu = kHelp,
        .text = QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts"),
        .keys = "?",
        .words = "hotkeys keys tutorial learn how preferences"},
    {.id = "help.about", .menu = kHelp, .text = QT_TRANSLATE_NOOP("Actions", "&About Fumage"), .lineAbove = true},
};

QAction* makeAction(const ActionSpec& spec, QObject* parent)
{
    auto* action = new QAction(actionText(spec.text), parent);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.kind == Switch);
    if (spec.keys[0] != '\0') {
        action->setShortcuts(QKeySequence::listFromString(QLatin1String(spec.keys)));
    }
    if (spec.icon[0] != '\0') {
        action->setIcon(themedIcon(QLatin1String(spec.icon)));
        action->setIconVisibleInMenu(spec.kind != Switch); // the tick stands where the icon would
    }
    const QString plain = plainText(spec.text);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(plainToolTip(keys.isEmpty() ? plain : QStringLiteral("%1 (%2)").arg(plain, keys)));
    return action;
}

/// Whether an action may change the document under a hand that drags something of it. Undo and redo look after that.
bool endsDrag(const ActionSpec& spec)
{
    const std::string_view id = spec.id;
    return id.starts_with("file.") || (id.starts_with("edit.") && id != "edit.undo" && id != "edit.redo");
}

} // namespace

std::span<const ActionSpec> actionSpecs()
{
    return kSpecs;
}

QString actionText(const char* key)
{
    return QCoreApplication::translate("Actions", key);
}

QString plainText(const char* key)
{
    constexpr QChar kEllipsis(0x2026);
    return actionText(key).remove(QLatin1Char('&')).remove(kEllipsis);
}

QString fullName(const ActionSpec& spec)
{
    return QStringLiteral("%1: %2").arg(plainText(spec.menu), plainText(spec.text));
}

ActionSet::ActionSet(QWidget* window)
    : QObject(window)
{
    for (const ActionSpec& spec : kSpecs) {
        QAction* action = makeAction(spec, this);
        if (spec.kind == Submenu) {
            auto* menu = new QMenu(window);
            menu->setObjectName(action->objectName());
            action->setMenu(menu);
        } else {
            window->addAction(action);
        }
        if (endsDrag(spec)) {
            QObject::connect(action, &QAction::triggered, this, [] { endDrag(); }); // before all that it does
        }
    }
}

QAction& ActionSet::get(const char* id) const
{
    auto* action = findChild<QAction*>(QLatin1String(id));
    Q_ASSERT_X(action != nullptr, "ActionSet::get", id);
    return *action;
}

QMenu& ActionSet::submenu(const char* id) const
{
    auto* menu = get(id).menu<QMenu*>();
    Q_ASSERT_X(menu != nullptr, "ActionSet::submenu", id);
    return *menu;
}

} // namespace fumage::ui
