#pragma once

#include <functional>

#include <QStringList>

class QMainWindow;
class QMenu;
class QMenuBar;

namespace fumage::ui {

class ActionSet;
class DocumentFiles;
class AppServices;
class Settings;
class Viewport;

/// The menus of the table of actions, in its order. What its submenus offer is filled in by the functions below.
void buildMenuBar(QMenuBar& bar, const ActionSet& actions);

/// The few actions that are needed often.
void buildToolBar(QMainWindow& window, const ActionSet& actions);

/// The files of last time; follows the settings for as long as the menu lives.
void fillRecentFiles(QMenu& menu, Settings& settings, DocumentFiles& files);
void fillMouseHabits(QMenu& menu, Settings& settings, Viewport& viewport);
/// @param say tells that the choice comes true later
void fillLanguages(QMenu& menu, Settings& settings, const std::function<void(const QString&)>& say);
/// The choices of these menus, in the order of their enumerators; languages after that of the system.
[[nodiscard]] QStringList navigationNames();
[[nodiscard]] QStringList languageNames();
[[nodiscard]] QStringList themeNames();
[[nodiscard]] int languageIndex(const Settings& settings);
void setLanguage(Settings& settings, int index);

void fillThemes(QMenu& menu, AppServices& services);

} // namespace fumage::ui
