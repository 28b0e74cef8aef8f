#include "ui/shell/window_layout.h"

#include "ui/panels/effect_panel.h"
#include "ui/shell/docks.h"
#include "ui/shell/settings.h"
#include "ui/shell/view_actions.h"

#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>

namespace fumage::ui {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kLayout = QStringLiteral("window/layout");
const QString kOpenGroups = QStringLiteral("panels/open");
const QString kOverlays = QStringLiteral("window/overlays");
constexpr int kLayoutVersion = 1;

} // namespace

void restoreLayout(QMainWindow& window, Docks& docks, ViewActions& view, const Settings& settings)
{
    constexpr QSize kUsual(1440, 900);
    window.resize(kUsual.boundedTo(QGuiApplication::primaryScreen()->availableSize()));
    // Qt moves a window whose screen is gone onto one that is there.
    window.restoreGeometry(settings.bytes(kGeometry));
    if (!window.restoreState(settings.bytes(kLayout), kLayoutVersion)) {
        // Panels can be given their sizes once the window has its own.
        QMetaObject::invokeMethod(&docks, &Docks::arrange, Qt::QueuedConnection);
    }
    docks.effectPanel().setOpenGroups(settings.list(kOpenGroups, EffectPanel::usualGroups()));
    view.showOverlays(settings.list(kOverlays, view.shownOverlays()));
}

void saveLayout(const QMainWindow& window, const Docks& docks, const ViewActions& view, Settings& settings)
{
    settings.setBytes(kGeometry, window.saveGeometry());
    settings.setBytes(kLayout, window.saveState(kLayoutVersion));
    settings.setList(kOpenGroups, docks.effectPanel().openGroups());
    settings.setList(kOverlays, view.shownOverlays());
}

} // namespace fumage::ui
