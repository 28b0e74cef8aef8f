#pragma once

class QMainWindow;

namespace fumage::ui {

class ActionSet;
class Tour;

/// Begins the tour of the editor: six steps from the smoke to its export. @return null: there is nothing to be seen
Tour* startWindowTour(QMainWindow& window, const ActionSet& actions);

} // namespace fumage::ui
