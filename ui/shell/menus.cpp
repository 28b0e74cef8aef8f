#include "ui/shell/menus.h"

#include "ui/theme/language.h"
#include "ui/widgets/plain_text.h"
#include "ui/shell/action_table.h"
#include "ui/shell/document_files.h"
#include "ui/shell/app_services.h"
#include "ui/viewport/viewport.h"

#include <algorithm>

#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace fumage::ui {

namespace {

QString menuText(const char* text)
{
    return QCoreApplication::translate("Menus", text);
}

/// Offers a choice of which one is always made.
/// @param chosen is given the index of a name
QActionGroup& addChoices(QMenu& menu, const QStringList& names, int current, const std::function<void(int)>& chosen)
{
    auto* group = new QActionGroup(&menu);
    for (int i = 0; i < names.size(); ++i) {
        QAction* action = menu.addAction(names[i]);
        action->setCheckable(true);
        action->setChecked(i == current);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &menu, [chosen, i] { chosen(i); });
    }
    return *group;
}

} // namespace

void buildMenuBar(QMenuBar& bar, const ActionSet& actions)
{
    QMenu* menu = nullptr;
    const char* title = nullptr;
    for (const ActionSpec& spec : actionSpecs()) {
        if (spec.menu != title) {
            title = spec.menu;
            menu = bar.addMenu(actionText(title));
            menu->setToolTipsVisible(true);
        }
        if (spec.lineAbove) {
            menu->addSeparator();
        }
        menu->addAction(&actions.get(spec.id));
    }
}

void buildToolBar(QMainWindow& window, const ActionSet& actions)
{
    QToolBar* bar = window.addToolBar(menuText(QT_TRANSLATE_NOOP("Menus", "Tools")));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    constexpr QSize kIcons(20, 20);
    bar->setIconSize(kIcons);
    const auto add = [&](std::initializer_list<const char*> ids) {
        for (const char* id : ids) {
            bar->addAction(&actions.get(id));
        }
    };
    add({"file.new", "file.open", "file.save"});
    bar->addSeparator();
    add({"edit.undo", "edit.redo"});
    bar->addSeparator();
    add({"edit.variations", "edit.randomise", "compare.split"});
    bar->addSeparator();
    add({"view.frameAll", "view.grid", "view.gizmos", "view.trails", "view.frame", "view.checker"});
    auto* space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    add({"file.engine", "file.export"});
    // What one came for is in words.
    auto* engine = qobject_cast<QToolButton*>(bar->widgetForAction(&actions.get("file.engine")));
    engine->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

void fillRecentFiles(QMenu& menu, Settings& settings, DocumentFiles& files)
{
    menu.setToolTipsVisible(true); // where each lies
    const auto fill = [&] {
        menu.clear();
        for (const QString& path : settings.recentFiles()) {
            QAction* action = menu.addAction(
                plainMenuText(QFileInfo(path).fileName()), &files, [&files, path] { files.openFile(path); });
            action->setToolTip(plainToolTip(path));
            action->setData(path);
        }
        menu.setEnabled(!menu.isEmpty());
    };
    fill();
    QObject::connect(&settings, &Settings::recentFilesChanged, &menu, fill);
}

QStringList navigationNames()
{
    return {QStringLiteral("Blender"), QStringLiteral("Maya"), QStringLiteral("Unity")};
}

QStringList languageNames()
{
    QStringList names{menuText(QT_TRANSLATE_NOOP("Menus", "As the system"))};
    for (const Language& language : languages()) {
        names += language.name;
    }
    return names;
}

int languageIndex(const Settings& settings)
{
    const auto found = std::ranges::find(languages(), settings.language(), &Language::code);
    return found == languages().end() ? 0 : static_cast<int>(found - languages().begin()) + 1;
}

void setLanguage(Settings& settings, int index)
{
    settings.setLanguage(index == 0 ? QString() : languages()[index - 1].code);
}

QStringList themeNames()
{
    return {menuText(QT_TRANSLATE_NOOP("Menus", "As the desktop")), menuText(QT_TRANSLATE_NOOP("Menus", "Dark")),
        menuText(QT_TRANSLATE_NOOP("Menus", "Light"))};
}

void fillMouseHabits(QMenu& menu, Settings& settings, Viewport& viewport)
{
    const QActionGroup& choices = addChoices(menu, navigationNames(), static_cast<int>(settings.navigationStyle()),
        [&](int index) { settings.setNavigationStyle(static_cast<NavigationStyle>(index)); });
    // It may be chosen in another window.
    QObject::connect(&settings, &Settings::navigationStyleChanged, &viewport, &Viewport::setNavigationStyle);
    QObject::connect(&settings, &Settings::navigationStyleChanged, &choices,
        [&choices](NavigationStyle style) { choices.actions()[static_cast<int>(style)]->setChecked(true); });
}

void fillLanguages(QMenu& menu, Settings& settings, const std::function<void(const QString&)>& say)
{
    const QActionGroup& choices =
        addChoices(menu, languageNames(), languageIndex(settings), [&settings, say](int index) {
            setLanguage(settings, index);
            say(menuText(QT_TRANSLATE_NOOP("Menus", "The language changes when Fumage starts the next time.")));
        });
    QObject::connect(&settings, &Settings::languageChanged, &choices,
        [&choices, &settings] { choices.actions()[languageIndex(settings)]->setChecked(true); });
}

void fillThemes(QMenu& menu, AppServices& services)
{
    const QActionGroup& choices = addChoices(menu, themeNames(), static_cast<int>(services.settings().theme()),
        [&services](int index) { services.applyTheme(static_cast<Theme>(index)); });
    QObject::connect(&services.settings(), &Settings::themeChanged, &choices,
        [&choices](Theme theme) { choices.actions()[static_cast<int>(theme)]->setChecked(true); });
}

} // namespace fumage::ui
