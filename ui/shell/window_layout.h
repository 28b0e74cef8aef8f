#pragma once

class QMainWindow;

namespace fumage::ui {

class Docks;
class Settings;
class ViewActions;

/// Puts a window as the last one was left: size and place, panels, open groups, overlays.
void restoreLayout(QMainWindow& window, Docks& docks, ViewActions& view, const Settings& settings);
void saveLayout(const QMainWindow& window, const Docks& docks, const ViewActions& view, Settings& settings);

} // namespace fumage::ui
