#pragma once

#include "ui/viewport/camera_fit.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace fumage::ui {

class ActionSet;
class Viewport;

/// The actions that change how the smoke is looked at.
class ViewActions : public QObject {
    Q_OBJECT

public:
    /// @param window that becomes as large as the screen
    ViewActions(const ActionSet& actions, Document& document, Viewport& viewport, QWidget& window);

    [[nodiscard]] CameraFit& cameraFit() { return m_fit; }

    /// What is drawn over the smoke, as the ids of its switches; without what comes and goes by itself.
    [[nodiscard]] QStringList shownOverlays() const;
    void showOverlays(const QStringList& ids);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectOverlays();
    void connectBackdrop();
    void connectFullScreen();
    /// What the right button offers over the picture.
    void showMenu(QPoint global);

    const ActionSet& m_actions;
    Viewport& m_viewport;
    QWidget& m_window;
    CameraFit m_fit;
};

} // namespace fumage::ui
